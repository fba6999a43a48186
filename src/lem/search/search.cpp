// SPDX-License-Identifier: MIT
// The search for the critical slip surface: trial circles, their factors, local minima, local optimisation, warnings.
#include "lem/search/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "lem/search/block_search.hpp"
#include "lem/search/optimise.hpp"
#include "lem/search/reflection.hpp"
#include "lem/search/search_findings.hpp"
#include "lem/search/trial_circles.hpp"

namespace talus::lem {

// Evaluator returns the objective function of the minimisers: F, or F with the penalty (T18.12) for polylines whose
// factor lies below their wedge mechanism.

double Evaluator::operator()(const Surface& surface) {
  throw_if_search_is_interrupted(ends_at_signal_);
  ++count_;
  cut_surface(*slope_, surface, slices_, checks_, cut_);
  if (cut_.refusal != Refusal::none) return refused;
  const Solution solution = solve(*slope_, cut_, method_, checks_, false);
  if (solution.refusal != Refusal::none || !(solution.factor > 0)) return refused;
  const double factor = solution.factor;
  if (factor >= passing_.factor) return factor;
  if (has_wedge_check(*slope_, cut_, method_) && std::isfinite(most_below_wedges_)) {
    const double allowed = 1 - most_below_wedges_;
    const Section& section = slope_->section();
    wedges_.set(*slope_, cut_, section.turn_to_sliding(section.horizontal_acceleration, cut_.slides_left));
    if (wedges_.compute_net_power(factor / allowed) < 0) {
      const double bound = std::min(allowed * wedges_.search_factor(factor / allowed), 10 * factor);
      // The penalty factor exceeds 1: otherwise a polyline further below its mechanism could have a smaller value.
      if (bound > factor) return factor + penalty_ * (bound - factor);
    }
  }
  passing_ = {surface, factor, count_};
  return factor;
}

bool Evaluator::passes_all_checks(const Surface& surface) {
  cut_surface(*slope_, surface, slices_, strict_, cut_);
  if (cut_.refusal != Refusal::none) return false;
  return solve(*slope_, cut_, method_, strict_, false).refusal == Refusal::none;
}

void solve_trials(const Slope& slope, const SearchOptions& options, const TrialCircles& circles, SearchResult& result) {
  const std::size_t methods = options.methods.size(), count = circles.surfaces.size();
  constexpr std::size_t per_piece = 64;
  const int pieces = static_cast<int>((count + per_piece - 1) / per_piece);
  using Counts = std::array<long, static_cast<std::size_t>(Refusal::count)>;
  std::vector<std::vector<Counts>> counts(static_cast<std::size_t>(pieces), std::vector<Counts>(methods, Counts{}));
  result.trials.resize(count);
  parallel_tasks(pieces, options.threads, [&](int piece) {
    throw_if_search_is_interrupted(options.ends_at_signal);
    CutSurface cut;
    auto& own = counts[static_cast<std::size_t>(piece)];
    const std::size_t first = static_cast<std::size_t>(piece) * per_piece;
    for (std::size_t i = first; i < std::min(count, first + per_piece); ++i) {
      TriedCircle& trial = result.trials[i];
      trial.surface = circles.surfaces[i];
      trial.factors.assign(methods, 0);
      cut_surface(slope, trial.surface, options.slices, options.checks, cut);
      for (std::size_t m = 0; m < methods; ++m) {
        Refusal refusal = cut.refusal;
        if (refusal == Refusal::none) {
          const Solution s = solve(slope, cut, options.methods[m], options.checks, false);
          refusal = s.refusal;
          if (refusal == Refusal::none) trial.factors[m] = static_cast<float>(s.factor);
        }
        if (refusal != Refusal::none) ++own[m][static_cast<std::size_t>(refusal)];
      }
    }
  });
  result.refused.resize(methods);
  for (const auto& piece : counts)
    for (std::size_t m = 0; m < methods; ++m)
      for (std::size_t r = 0; r < piece[m].size(); ++r)
        if (piece[m][r] > 0) result.refused[m][static_cast<Refusal>(r)] += piece[m][r];
  result.tried = static_cast<long>(count);
}

namespace {

/// Returns distinct local minima of each method, the best first, optimised if the options say so.
std::vector<std::vector<OptimisedSurface>> find_minima(const Slope& slope, const SearchOptions& options,
                                                       const Arcs& arcs, const TrialCircles& circles,
                                                       const SearchResult& result, std::vector<int>& best_trials) {
  struct Start {
    std::size_t method;
    Surface surface;
  };
  const std::size_t methods = options.methods.size();
  std::vector<std::vector<Surface>> own_starts(methods);
  best_trials.assign(methods, -1);
  parallel_tasks(static_cast<int>(methods), options.threads, [&](int i) {
    const auto m = static_cast<std::size_t>(i);
    std::vector<float> factors(result.trials.size());
    for (std::size_t t = 0; t < factors.size(); ++t) factors[t] = result.trials[t].factors[m];
    const auto found = find_local_minima(slope, circles, factors, options.kept_minima + 3, 0.8);
    if (!found.empty()) best_trials[m] = found.front();
    for (int trial : found) own_starts[m].push_back(circles.surfaces[static_cast<std::size_t>(trial)]);
    const auto regions = arcs.regions().size();
    if (!options.optimise_circle || regions < 2) return;
    Evaluator evaluate(slope, options.methods[m], options.checks, options.slices, options.ends_at_signal);
    const bool is_quick = !is_rigorous(options.methods[m]) && !has_given_inclinations(options.methods[m]);
    Evaluator quick(slope, is_quick ? options.methods[m] : Method::bishop, options.checks, options.slices,
                    options.ends_at_signal);
    const int most = std::max(50, static_cast<int>(3000 / regions));
    for (const Surface& s : find_touching_circles(evaluate, quick, arcs, circles, most)) own_starts[m].push_back(s);
  });
  std::vector<Start> starts;
  for (std::size_t m = 0; m < methods; ++m)
    for (const Surface& s : own_starts[m]) starts.push_back({m, s});
  std::vector<OptimisedSurface> optimised(starts.size());
  const CircleRanges ranges{circles.left, circles.right, circles.step};
  parallel_tasks(static_cast<int>(starts.size()), options.threads, [&](int i) {
    const Start& start = starts[static_cast<std::size_t>(i)];
    Evaluator evaluate(slope, options.methods[start.method], options.checks, options.slices, options.ends_at_signal);
    optimised[static_cast<std::size_t>(i)] = options.optimise_circle
                                                 ? optimise_circle(evaluate, arcs, start.surface, ranges)
                                                 : OptimisedSurface{start.surface, evaluate(start.surface), 1};
  });
  std::vector<std::vector<OptimisedSurface>> minima(options.methods.size());
  for (std::size_t m = 0; m < options.methods.size(); ++m) {
    std::vector<OptimisedSurface> own;
    for (std::size_t i = 0; i < starts.size(); ++i)
      if (starts[i].method == m && optimised[i].factor < Evaluator::refused) own.push_back(optimised[i]);
    std::stable_sort(own.begin(), own.end(), [](auto& a, auto& b) { return a.factor < b.factor; });
    for (const auto& candidate : own) {
      const bool separate = std::none_of(minima[m].begin(), minima[m].end(), [&](const OptimisedSurface& other) {
        return measure_overlap(slope, candidate.surface, other.surface) > 0.6;
      });
      if (separate && static_cast<int>(minima[m].size()) < options.kept_minima) minima[m].push_back(candidate);
    }
  }
  return minima;
}

SearchOptions settle(const Slope& slope, const SearchOptions& asked) {
  SearchOptions options = asked;
  options.checks.composite = asked.composite;
  constexpr double share = 0.02, thickest = 0.5;  // smallest depth: fraction of the relief, at most this [m]
  options.ends_at_signal = options.ends_at_signal && !is_interrupted();
  if (!options.finds_skins)
    options.checks.smallest_depth =
        std::max(options.checks.smallest_depth, std::min(share * find_relief(slope.section()), thickest));
  return options;
}

[[noreturn]] void fail_without_surface(const SearchOptions& options, const SearchResult& result) {
  const bool is_block = options.kind == SearchKind::block;
  std::string reasons = is_block ? "no line through the windows or along the layer meets the ground at both ends"
                                 : "no circle enters and leaves the ground inside the model";
  std::size_t m = 0;
  while (is_block && m + 1 < options.methods.size() && !suits_polylines(options.methods[m])) ++m;
  if (result.tried > 0)
    reasons =
        fmt::format("{} by {}", describe_refusals(result.refused[m], result.tried), get_title(options.methods[m]));
  fail_input(
      "no admissible slip surface was found: {}; check the ranges of the search, the bottom of the model and the "
      "limits (smallest_depth, smallest_m_alpha, most_tension)",
      reasons);
}

/// Surfaces of a search, without their slices and messages.
struct FoundSurfaces {
  TrialCircles circles;
  std::vector<int> best_trials;                       ///< by method
  std::vector<std::vector<OptimisedSurface>> minima;  ///< circles by method, the best first
  std::vector<OptimisedSurface> polylines;            ///< by method; empty if none are searched
};

/// Searches polylines in the section and in its mirror image and keeps the lower factor of each method: a minimiser
/// takes another path in each, and a single path can end at a higher minimum.
std::vector<OptimisedSurface> find_polylines_both_ways(const Slope& slope, const SearchOptions& options,
                                                       const FoundSurfaces& circles, const SearchResult& trials) {
  std::vector<OptimisedSurface> polylines = find_polylines(slope, options, circles.circles, trials, circles.minima);
  // The polylines of a similar slope were searched in both; they are followed in one.
  if (!options.known.empty()) return polylines;
  const Reflection mirror(slope.section());
  std::vector<std::vector<OptimisedSurface>> minima = circles.minima;
  for (auto& own : minima)
    for (OptimisedSurface& s : own) s.surface = mirror.reflect(std::move(s.surface));
  auto others = find_polylines(Slope(mirror.reflect(slope.section())), mirror.reflect(options),
                               mirror.reflect(circles.circles), trials, minima);
  for (std::size_t m = 0; m < polylines.size(); ++m)
    if (others[m].factor < polylines[m].factor) {
      others[m].surface = mirror.reflect(std::move(others[m].surface));
      polylines[m] = std::move(others[m]);
    }
  return polylines;
}

/// Also sets the trials, their numbers and the ranges of `result`.
FoundSurfaces find_surfaces(const Slope& slope, const SearchOptions& options, SearchResult& result) {
  FoundSurfaces found;
  const Arcs arcs(slope, options.checks.smallest_depth, options.composite, options.tangent);
  if (options.kind == SearchKind::grid) {
    found.circles = make_grid_circles(slope, options, result.grid.emplace());
  } else {
    found.circles = make_entry_exit_circles(slope, arcs, options, result.entry_exit.emplace());
  }
  solve_trials(slope, options, found.circles, result);
  found.minima = find_minima(slope, options, arcs, found.circles, result, found.best_trials);
  if (std::all_of(found.minima.begin(), found.minima.end(), [](auto& m) { return m.empty(); }))
    fail_without_surface(options, result);
  if (options.optimise_surface && !options.tangent)
    found.polylines = find_polylines_both_ways(slope, options, found, result);
  return found;
}

/// The same in the mirror image of the section, with its results reflected.
FoundSurfaces find_reflected_surfaces(const Slope& slope, const SearchOptions& options, SearchResult& result) {
  const Reflection mirror(slope.section());
  FoundSurfaces found = find_surfaces(Slope(mirror.reflect(slope.section())), mirror.reflect(options), result);
  found.circles = mirror.reflect(std::move(found.circles));
  const auto turn = [&](OptimisedSurface& s) { s.surface = mirror.reflect(std::move(s.surface)); };
  for (auto& minima : found.minima) std::for_each(minima.begin(), minima.end(), turn);
  std::for_each(found.polylines.begin(), found.polylines.end(), turn);
  for (std::size_t i = 0; i < result.trials.size(); ++i) result.trials[i].surface = found.circles.surfaces[i];
  if (result.grid) result.grid = mirror.reflect(*result.grid);
  if (result.entry_exit) result.entry_exit = mirror.reflect(*result.entry_exit);
  return found;
}

SearchResult search_settled(const Slope& slope, const SearchOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  SearchResult result;
  result.smallest_depth = options.checks.smallest_depth;
  if (options.kind == SearchKind::block) {
    search_blocks(slope, options, result);
    if (result.noncircular.empty()) fail_without_surface(options, result);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
  }
  const auto [circles, best_trials, minima, polylines] = is_searched_reflected(slope.section())
                                                             ? find_reflected_surfaces(slope, options, result)
                                                             : find_surfaces(slope, options, result);
  result.minima.resize(options.methods.size());
  for (std::size_t m = 0; m < options.methods.size(); ++m) {
    const Method method = options.methods[m];
    for (const auto& found : minima[m])
      result.minima[m].push_back(make_critical(slope, options, found.surface, method));
    if (result.minima[m].empty()) {
      result.limit_hits.push_back(
          {method, fmt::format("no admissible circle, {}", describe_refusals(result.refused[m], result.tried))});
      continue;
    }
    Critical& critical = result.minima[m].front();
    const auto hits = find_limit_hits(slope, options, result, circles, critical, best_trials[m]);
    result.limit_hits.insert(result.limit_hits.end(), hits.begin(), hits.end());
    result.circular.push_back(critical);
  }
  for (std::size_t m = 0; m < polylines.size(); ++m) {
    if (polylines[m].surface.line.empty()) continue;
    Critical critical = make_critical(slope, options, polylines[m].surface, options.methods[m]);
    const auto hits = find_limit_hits(slope, options, result, circles, critical, -1);
    result.limit_hits.insert(result.limit_hits.end(), hits.begin(), hits.end());
    result.noncircular.push_back(std::move(critical));
  }
  const Arcs arcs(slope, options.checks.smallest_depth, options.composite, options.tangent);
  search_cracked_circles(slope, options, arcs, circles, result);
  warn_of_lost_circles(slope, options, result);
  for (std::size_t m = 0; m < options.methods.size(); ++m) {
    const int columns = result.grid ? result.grid->columns : 40, rows = result.grid ? result.grid->rows : 40;
    result.maps.push_back(map_centres(result, m, columns, rows));
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

/// Searches with masses that slide in one direction only, so that they leave the ground in the range of exits.
SearchResult search_towards(const Slope& slope, SearchOptions options, int direction) {
  SurfaceLimits limits = options.checks.limits ? *options.checks.limits : SurfaceLimits{};
  limits.direction = direction;
  options.checks.limits = std::make_shared<const SurfaceLimits>(std::move(limits));
  return search_settled(slope, options);
}

double find_least(const SearchResult& result) {
  double least = Evaluator::refused;
  for (const auto* list : {&result.circular, &result.noncircular})
    for (const Critical& c : *list) least = std::min(least, c.solution.factor);
  return least;
}

}  // namespace

SearchResult search(const Slope& slope, const SearchOptions& asked) {
  const SearchOptions options = settle(slope, asked);
  const bool has_direction = options.checks.limits && options.checks.limits->direction != 0;
  if (options.kind != SearchKind::entry_exit || !options.entry_exit || options.entry_exit->is_whole_ground() ||
      has_direction)
    return search_settled(slope, options);
  std::optional<SearchResult> best;
  std::vector<double> factors;
  std::string why = "no exit of [lem.entry_exit] is lower than an entry";
  for (const int direction : list_directions(slope, *options.entry_exit)) {
    try {
      SearchResult found = search_towards(slope, options, direction);
      factors.push_back(find_least(found));
      if (!best || factors.back() < find_least(*best)) best = std::move(found);
    } catch (const Error& error) {
      if (error.code() != ExitCode::wrong_input) throw;
      why = error.what();
    }
  }
  if (!best) fail_input("{}", why);
  if (factors.size() > 1)
    best->warnings.push_back(fmt::format(
        "masses of the ranges in [lem.entry_exit] slide to both sides, with {:.3f} to the left and {:.3f} to the "
        "right, and only those of the smaller factor are listed; 'slides' in [lem] selects the other side",
        factors[0], factors[1]));
  return *best;
}

Critical make_critical(const Slope& slope, const SearchOptions& options, const Surface& surface, Method method) {
  Critical critical;
  critical.method = method;
  critical.surface = surface;
  critical.circular = surface.circle.has_value();
  critical.cut = cut_surface(slope, surface, options.slices, options.checks);
  critical.solution = solve(slope, critical.cut, method, options.checks, true);
  critical.warnings = find_warnings(slope, options.checks, critical);
  return critical;
}

Critical optimise(const Slope& slope, const Surface& start, Method method, const SearchOptions& asked) {
  const SearchOptions options = settle(slope, asked);
  // Free vertices would leave the windows.
  if (options.kind == SearchKind::block && !start.circle) return make_critical(slope, options, start, method);
  Evaluator evaluate(slope, method, options.checks, options.slices);
  const std::array<double, 2> ground{slope.left(), slope.right()};
  if (!start.circle) {
    const auto found = optimise_polyline(evaluate, start, {ground, ground, options.vertices});
    return make_critical(slope, options, found.surface, method);
  }
  const Arcs arcs(slope, options.checks.smallest_depth, options.composite, options.tangent);
  const double step = 0.05 * (start.to - start.from);
  return make_critical(slope, options, optimise_circle(evaluate, arcs, start, {ground, ground, {step, step}}).surface,
                       method);
}

}  // namespace talus::lem
