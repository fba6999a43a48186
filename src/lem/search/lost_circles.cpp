// SPDX-License-Identifier: MIT
#include "lem/search/lost_circles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "lem/search/optimise_circle.hpp"
#include "lem/search/search_findings.hpp"

namespace talus::lem {
namespace {

/// A lost circle counts where Bishop's factor on it is below this fraction of the least factor that the method found.
constexpr double noticeable = 0.98;

/// Cracks that are tried, from a fraction of Rankine's depth to all of it.
constexpr int crack_steps = 8;

struct LostCircle {
  const Surface* surface = nullptr;
  double bishop = Evaluator::refused;  ///< Bishop's factor on it
};

const Critical* find_circle(const SearchResult& result, Method method) {
  for (const Critical& c : result.circular)
    if (c.method == method) return &c;
  return nullptr;
}

/// The trial circle with Bishop's least factor among those that method number `m` has no solution on.
LostCircle find_lost_circle(const Slope& slope, const SearchOptions& options, const SearchResult& result,
                            std::size_t m) {
  const auto bishop = std::find(options.methods.begin(), options.methods.end(), Method::bishop);
  Evaluator evaluate(slope, Method::bishop, options.checks, options.slices, options.ends_at_signal);
  LostCircle least;
  for (const TriedCircle& trial : result.trials) {
    if (trial.factors[m] > 0) continue;
    const double factor = bishop == options.methods.end()
                              ? evaluate(trial.surface)
                              : trial.factors[static_cast<std::size_t>(bishop - options.methods.begin())];
    if (factor > 0 && factor < least.bishop) least = {&trial.surface, factor};
  }
  return least;
}

/// Rankine's depth of tension below the crest of a mass, with the strength divided by F; the load on the crest closes
/// the crack. 0: the soil bears no tension there.
double compute_crack_depth(const Slope& slope, const CutSurface& cut, double factor) {
  if (cut.slices.empty()) return 0;
  const Slice& crest = cut.slides_left ? cut.slices.back() : cut.slices.front();
  const Soil& soil = slope.section().soils[static_cast<std::size_t>(crest.soil)];
  const double load = std::max(0.0, crest.surface_load) / (crest.right - crest.left),
               angle = std::atan(std::tan(soil.friction_angle) / factor);
  const double height =
      (2 * crest.cohesion / factor * std::tan(std::numbers::pi / 4 + angle / 2) - load) / soil.unit_weight;
  return std::max(0.0, height);
}

/// The bottom of the crack that ends the mass lies in soil with positive pore pressure: the crack would not be dry.
bool is_wet(const Slope& slope, const CutSurface& cut) {
  return slope.pore_pressure(cut.slides_left ? cut.slices.back().base_right : cut.slices.front().base_left) > 0;
}

/// The trial circle with the least factor where each ends in a crack; one without a circle where none has a factor.
Surface select_cracked_trial(const Slope& slope, const SearchOptions& options, const SearchResult& result,
                             Method method, double crack) {
  constexpr std::size_t per_piece = 64;
  const std::size_t count = result.trials.size(), pieces = (count + per_piece - 1) / per_piece;
  std::vector<std::pair<double, std::size_t>> least(pieces, {Evaluator::refused, count});
  parallel_tasks(static_cast<int>(pieces), options.threads, [&](int i) {
    const std::size_t piece = static_cast<std::size_t>(i), first = piece * per_piece;
    Evaluator evaluate(slope, method, options.checks, options.slices, options.ends_at_signal);
    for (std::size_t t = first; t < std::min(count, first + per_piece); ++t) {
      Surface surface = result.trials[t].surface;
      surface.crack = crack;
      least[piece] = std::min(least[piece], {evaluate(surface), t});
    }
  });
  const auto [factor, trial] = *std::min_element(least.begin(), least.end());
  if (factor >= Evaluator::refused) return {};
  Surface surface = result.trials[trial].surface;
  surface.crack = crack;
  return surface;
}

}  // namespace

void search_cracked_circles(const Slope& slope, const SearchOptions& options, const Arcs& arcs,
                            const TrialCircles& circles, SearchResult& result) {
  if (slope.section().crack && slope.section().crack->depth > 0) return;
  for (std::size_t m = 0; m < options.methods.size(); ++m) {
    const Method method = options.methods[m];
    if (!is_rigorous(method)) continue;
    const Critical* own = find_circle(result, method);
    const LostCircle lost = find_lost_circle(slope, options, result, m);
    if (lost.surface == nullptr || (own != nullptr && lost.bishop > noticeable * own->solution.factor)) continue;
    Evaluator evaluate(slope, method, options.checks, options.slices, options.ends_at_signal);
    const CutSurface cut = cut_surface(slope, *lost.surface, options.slices, options.checks);
    const double deepest = compute_crack_depth(slope, cut, lost.bishop);
    OptimisedSurface best{{}, Evaluator::refused, 0};
    for (int step = 1; step <= crack_steps && deepest > 0 && noticeable * best.factor > lost.bishop; ++step) {
      const double crack = deepest * step / crack_steps;
      const Surface start = select_cracked_trial(slope, options, result, method, crack);
      if (start.circle) best = optimise_circle(evaluate, arcs, start, {circles.left, circles.right, circles.step});
    }
    if (best.factor >= (own != nullptr ? own->solution.factor : Evaluator::refused)) continue;
    Critical found = make_critical(slope, options, best.surface, method);
    if (is_wet(slope, found.cut)) continue;
    found.warnings.push_back(
        fmt::format("ends in a dry tension crack of {:.2g} m: without one {} has no solution on the circles around "
                    "Bishop's critical one (factor {:.3f})",
                    best.surface.crack, get_title(method), lost.bishop));
    found.yield_acceleration = find_yield_acceleration(slope, found.cut, method, options.checks);
    result.minima[m].insert(result.minima[m].begin(), found);
    if (own != nullptr)
      result.circular[static_cast<std::size_t>(own - result.circular.data())] = std::move(found);
    else
      result.circular.push_back(std::move(found));
  }
}

void warn_of_lost_circles(const Slope& slope, const SearchOptions& options, SearchResult& result) {
  constexpr double below = 0.95;
  const Critical* bishop = find_circle(result, Method::bishop);
  if (bishop == nullptr) return;
  const Critical* best = nullptr;
  for (const auto* list : {&result.circular, &result.noncircular})
    for (const Critical& c : *list)
      if (is_rigorous(c.method) && c.solution.factor > 0 &&
          (best == nullptr || c.solution.factor < best->solution.factor))
        best = &c;
  if (best != nullptr && bishop->solution.factor > below * best->solution.factor) return;
  for (const Method method : options.methods) {
    if (!is_rigorous(method)) continue;
    CutSurface cut = bishop->cut;
    const Solution solution = solve(slope, cut, method, options.checks, false);
    if (solution.refusal == Refusal::none) return;
    const double f = bishop->solution.factor;
    result.warnings.push_back(fmt::format(
        "{} has no solution on Bishop's critical circle (factor {:.3f}): {}. {}, so its own critical surface may be "
        "missed. The soil at the crest may be in tension to a depth of {:.2g} m: give that as [lem.tension_crack] "
        "depth",
        get_title(method), f, name_refusal(solution.refusal),
        best != nullptr ? fmt::format("The smallest factor with complete equilibrium is {:.3f}", best->solution.factor)
                        : std::string("No other surface has one"),
        compute_crack_depth(slope, cut, f)));
    return;
  }
}

}  // namespace talus::lem
