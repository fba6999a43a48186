// SPDX-License-Identifier: MIT
// Local minima among the trial circles, circles with a tension crack where a method has no solution, and warnings of a
// search.
#include "lem/search/search_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/numbers.hpp"
#include "base/parallel.hpp"
#include "lem/search/optimise.hpp"
#include "lem/section/strips.hpp"

namespace talus::lem {

// Local minima among the trial circles.

std::array<double, 2> find_ends(const Surface& surface) {
  if (surface.circle) return {surface.from, surface.to};
  return {surface.line.front()[0], surface.line.back()[0]};
}

bool falls_left(const Slope& slope, const Surface& surface) {
  const auto [left, right] = find_ends(surface);
  return slope.lower_ground(left) <= slope.lower_ground(right);
}

double find_elevation(const Slope& slope, const Surface& surface, double x) {
  if (surface.circle) {
    const Circle& c = *surface.circle;
    const double off = std::min(std::abs(x - c.centre[0]), c.radius);
    const double y = c.centre[1] - std::sqrt(c.radius * c.radius - off * off);
    return std::max(y, slope.floor(x));  // a composite circle follows the base or impenetrable soil
  }
  const auto& line = surface.line;
  auto q = std::upper_bound(line.begin(), line.end(), x, [](double v, const Point& p) { return v < p[0]; });
  if (q == line.begin()) return line.front()[1];
  if (q == line.end()) return line.back()[1];
  const Point &a = *(q - 1), &b = *q;
  return std::max(a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]), slope.floor(x));
}

double measure_overlap(const Slope& slope, const Surface& a, const Surface& b) {
  const auto ea = find_ends(a), eb = find_ends(b);
  const double left = std::min(ea[0], eb[0]), right = std::max(ea[1], eb[1]);
  if (ea[1] <= eb[0] || eb[1] <= ea[0]) return 0;
  constexpr int samples = 100;
  double common = 0, together = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = left + (right - left) * (i + 0.5) / samples, top = slope.ground(x);
    const double da = x > ea[0] && x < ea[1] ? std::max(0.0, top - find_elevation(slope, a, x)) : 0;
    const double db = x > eb[0] && x < eb[1] ? std::max(0.0, top - find_elevation(slope, b, x)) : 0;
    common += std::min(da, db), together += std::max(da, db);
  }
  return together > 0 ? common / together : 1;
}

std::vector<int> find_local_minima(const Slope& slope, const TrialCircles& circles, const std::vector<float>& factors,
                                   int count, double most_overlap) {
  const auto [ni, nj, nk] = circles.size;
  constexpr float none = std::numeric_limits<float>::infinity();
  auto factor_of = [&](int s) {
    const float f = factors[static_cast<std::size_t>(s)];
    return f > 0 ? f : none;
  };
  auto cell_of = [nj = static_cast<std::size_t>(nj), nk = static_cast<std::size_t>(nk)](int i, int j, int k) {
    return (static_cast<std::size_t>(i) * nj + static_cast<std::size_t>(j)) * nk + static_cast<std::size_t>(k);
  };
  std::vector<int> minima;
  for (int i = 0; i < ni; ++i)
    for (int j = 0; j < nj; ++j)
      for (int k = 0; k < nk; ++k)
        for (int s = circles.first[cell_of(i, j, k)]; s < circles.first[cell_of(i, j, k) + 1]; ++s) {
          const float own = factor_of(s);
          if (own == none) continue;
          const Surface& surface = circles.surfaces[static_cast<std::size_t>(s)];
          bool smallest = true;
          for (int n = 0; n < 27 && smallest; ++n) {
            const int a = i + n / 9 - 1, b = j + n / 3 % 3 - 1, c = k + n % 3 - 1;
            if (n == 13 || a < 0 || b < 0 || c < 0 || a >= ni || b >= nj || c >= nk) continue;
            for (int t = circles.first[cell_of(a, b, c)]; t < circles.first[cell_of(a, b, c) + 1]; ++t) {
              const Surface& other = circles.surfaces[static_cast<std::size_t>(t)];
              if (other.to <= surface.from || other.from >= surface.to) continue;  // on another slope face
              // The first one of equal factors counts.
              if (factor_of(t) < own || (factor_of(t) == own && t < s)) smallest = false;
            }
          }
          if (smallest) minima.push_back(s);
        }
  std::stable_sort(minima.begin(), minima.end(), [&](int a, int b) { return factor_of(a) < factor_of(b); });
  // Minima with more than twice the smallest factor are left out.
  constexpr float most_ratio = 2;
  std::vector<int> kept;
  for (int s : minima) {
    if (static_cast<int>(kept.size()) >= count || factor_of(s) > most_ratio * factor_of(minima.front())) break;
    const bool separate = std::none_of(kept.begin(), kept.end(), [&](int other) {
      return measure_overlap(slope, circles.surfaces[static_cast<std::size_t>(s)],
                             circles.surfaces[static_cast<std::size_t>(other)]) > most_overlap;
    });
    if (separate) kept.push_back(s);
  }
  return kept;
}

namespace {

/// A lost circle is treated if Bishop's factor on it is below this fraction of the method's own smallest factor.
constexpr double noticeable = 0.98;

/// Number of crack depths that are tried, from a fraction of Rankine's depth up to all of it.
constexpr int crack_steps = 8;

struct LostCircle {
  const Surface* surface = nullptr;
  double bishop = Evaluator::refused;  ///< Bishop's factor on this circle
};

const Critical* find_circle(const SearchResult& result, Method method) {
  for (const Critical& c : result.circular)
    if (c.method == method) return &c;
  return nullptr;
}

/// Returns the trial circle with the smallest factor by Bishop among those on which method number `m` has no solution.
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

/// Returns Rankine's depth of the tension zone below the crest of a mass, with the strength divided by `factor`, less
/// the effect of the load on the crest [m]; 0 where there is no tension.
double compute_crack_depth(const Slope& slope, const CutSurface& cut, double factor) {
  if (cut.slices.empty()) return 0;
  const Slice& crest = cut.slides_left ? cut.slices.back() : cut.slices.front();
  const Soil& soil = slope.section().soils[static_cast<std::size_t>(crest.soil)];
  const double load = std::max(0.0, crest.surface_load) / (crest.right - crest.left),
               angle = std::atan((soil.law ? crest.tan_friction : std::tan(soil.friction_angle)) / factor);
  const double height =
      (2 * crest.cohesion / factor * std::tan(std::numbers::pi / 4 + angle / 2) - load) / soil.unit_weight;
  return std::max(0.0, height);
}

/// Returns true if the pore pressure at the bottom of the crack is positive, so that the crack would not be dry.
bool is_wet(const Slope& slope, const CutSurface& cut) {
  return slope.pore_pressure(cut.slides_left ? cut.slices.back().base_right : cut.slices.front().base_left) > 0;
}

/// Returns the trial circle with the smallest factor when each ends in a crack; a surface without a circle if none has
/// a factor.
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
        fmt::format("ends in a dry tension crack of {}: without one {} has no solution on the circles around Bishop's "
                    "critical one (factor {:.3f})",
                    format_value(best.surface.crack, slope.section().units.length, 2), get_title(method), lost.bishop));
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
        "missed. The soil at the crest may be in tension to a depth of {}: give that as [lem.tension_crack] depth",
        get_title(method), f, name_refusal(solution.refusal),
        best != nullptr ? fmt::format("The smallest factor with complete equilibrium is {:.3f}", best->solution.factor)
                        : std::string("No other surface has one"),
        format_value(compute_crack_depth(slope, cut, f), slope.section().units.length, 2)));
    return;
  }
}

namespace {

constexpr double close = 0.002;  ///< tolerance for a limit, over the width of the ground [-]

/// Tolerance within which λ counts as at its limit [-].
constexpr double close_to_gate = 2e-3;

std::string group_digits(long n) {
  std::string s = std::to_string(n);
  for (int i = static_cast<int>(s.size()) - 3; i > 0; i -= 3) s.insert(static_cast<std::size_t>(i), ",");
  return s;
}

/// Returns true if a base comes near the bottom of the soil, apart from impenetrable soil.
bool reaches_floor(const Slope& slope, const CutSurface& cut, double near) {
  return std::any_of(cut.slices.begin(), cut.slices.end(), [&](const Slice& slice) {
    const double x = 0.5 * (slice.left + slice.right), y = 0.5 * (slice.base_left[1] + slice.base_right[1]);
    return !slope.strips().strip(slope.strips().find(x)).is_firm && y < slope.floor(x) + near;
  });
}

}  // namespace

std::string describe_refusals(const std::map<Refusal, long>& refused, long tried) {
  std::vector<std::pair<long, Refusal>> reasons;
  for (const auto& [reason, count] : refused)
    if (reason != Refusal::none && count > 0) reasons.push_back({count, reason});
  std::sort(reasons.begin(), reasons.end(), [](auto& a, auto& b) { return a.first > b.first; });
  std::string text;
  for (const auto& [count, reason] : reasons)
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", name_refusal(reason), group_digits(count));
  return fmt::format("of {} surfaces tried, rejected: {}", group_digits(tried), text.empty() ? "none" : text);
}

std::vector<LimitHit> find_limit_hits(const Slope& slope, const SearchOptions& options, const SearchResult& result,
                                      const TrialCircles& circles, const Critical& critical, int best_trial) {
  std::vector<LimitHit> hits;
  const auto add = [&](std::string limit) { hits.push_back({critical.method, std::move(limit)}); };
  const std::string what = critical.circular ? "circle" : "non-circular surface";
  const ShownUnit& length = slope.section().units.length;
  const double near = close * (slope.right() - slope.left());
  const auto ends = find_ends(critical.surface);
  const bool slides_left = critical.cut.slides_left;
  auto check = [&](double x, const std::array<double, 2>& range, const char* end, const char* key) {
    for (double limit : range) {
      if (std::abs(x - limit) > near) continue;
      const bool edge = std::abs(limit - slope.left()) < near || std::abs(limit - slope.right()) < near;
      add(edge ? fmt::format(
                     "the {} of the critical {} lies at x = {}, the edge of the model; extend the ground beyond it",
                     end, what, format_coordinate(x, length))
               : fmt::format("the {} of the critical {} lies at x = {}, an end of the range searched ({} to {}); widen "
                             "[lem.entry_exit] {}",
                             end, what, format_coordinate(x, length), format_coordinate(range[0] / length.si),
                             format_coordinate(range[1], length), key));
    }
  };
  check(ends[slides_left ? 0 : 1], slides_left ? circles.left : circles.right, "exit", "exit");
  check(ends[slides_left ? 1 : 0], slides_left ? circles.right : circles.left, "entry", "entry");
  if (critical.surface.circle) {
    const Circle& c = *critical.surface.circle;
    const double bottom = c.centre[1] - c.radius, base = slope.section().base;
    const bool is_lowest_in = c.centre[0] > ends[0] && c.centre[0] < ends[1];
    if (slope.strips().raised) {
      if (reaches_floor(slope, critical.cut, near))
        add(
            fmt::format("the critical circle {} the bottom of the section; a deeper model may give a smaller factor "
                        "unless firm ground begins there",
                        critical.cut.composite ? "continues along" : "touches"));
    } else if (bottom < base + near && slope.floor(c.centre[0]) <= base && is_lowest_in) {
      add(
          fmt::format("the critical circle {} the base at {}; a deeper model may give a smaller factor unless firm "
                      "ground begins there",
                      bottom < base - near ? "is cut level at" : "touches", format_coordinate(base, length)));
    }
  }
  if (options.checks.smallest_depth > 0 && critical.cut.depth < 1.005 * options.checks.smallest_depth)
    add(fmt::format("the critical {} is as shallow as the smallest depth of {} allows; the factor depends on it",
                    critical.surface.circle ? "circle" : "polyline",
                    format_value(options.checks.smallest_depth, length, 4)));
  if (result.grid && best_trial >= 0 && critical.circular) {
    const Circle& c = *circles.surfaces[static_cast<std::size_t>(best_trial)].circle;
    const GridSearch& g = *result.grid;
    for (const int axis : {0, 1}) {
      const auto a = static_cast<std::size_t>(axis);
      const double low = std::min(g.from[a], g.to[a]), high = std::max(g.from[a], g.to[a]),
                   tolerance = 1e-6 * (high - low);
      if (c.centre[a] < low + tolerance || c.centre[a] > high - tolerance)
        add(
            fmt::format("the best trial circle has its centre on the border of the grid, at {} = {} ({:.4g} to {} "
                        "searched); enlarge the corners of [lem.grid]",
                        axis == 0 ? "x" : "y", format_value(c.centre[a], length, 4), low / length.si,
                        format_value(high, length, 4)));
    }
    const double bottom = c.centre[1] - c.radius, tolerance = 1e-6 * std::abs(*g.highest - *g.lowest);
    if (bottom<*g.lowest + tolerance&& * g.lowest> slope.section().base + near)
      add(fmt::format(
          "the best trial circle reaches down to {}, the lowest level searched; lower the levels of [lem.grid]",
          format_value(bottom, length, 4)));
  }
  return hits;
}

std::vector<std::string> find_warnings(const Slope& slope, const Checks& checks, const Critical& critical) {
  std::vector<std::string> warnings = critical.cut.warnings;
  const Solution& s = critical.solution;
  const bool forces = is_rigorous(critical.method);
  if (critical.method != Method::fellenius && s.smallest_m_alpha < checks.smallest_m_alpha)
    warnings.push_back(
        fmt::format("m_alpha falls to {:.2f}, below {:.2f}: the normal force at the passive end is unreliable",
                    s.smallest_m_alpha, checks.smallest_m_alpha));
  if (s.tensile_share > 0.5 * checks.most_tension)
    warnings.push_back(
        fmt::format("effective normal forces are tensile over {:.0f} % of the surface: consider a tension crack",
                    100 * s.tensile_share));
  if (forces && s.thrust_outside > 0.5 * checks.most_thrust_outside)
    warnings.push_back(
        fmt::format("{:.0f} % of the interslice forces act outside the sliding mass", 100 * s.thrust_outside));
  if (forces && s.factor > 0)
    for (const auto& [limit, key] : {std::pair{checks.smallest_lambda, "smallest"}, {checks.largest_lambda, "largest"}})
      if (std::abs(s.lambda - limit) < close_to_gate)
        warnings.push_back(fmt::format(
            "λ = {:.3f} rests on [lem] {}_lambda = {:g}: the factor depends on that limit, and not on the slope alone",
            s.lambda, key, limit));
  if (critical.cut.depth < 0.02 * find_relief(slope.section()))
    warnings.push_back(fmt::format(
        "the surface is a skin of {}: without cohesion the shallowest surface is critical; give a smallest_depth",
        format_value(critical.cut.depth, slope.section().units.length, 2)));
  const double near = close * (slope.right() - slope.left());
  const auto ends = find_ends(critical.surface);
  if (ends[0] < slope.left() + near || ends[1] > slope.right() - near)
    warnings.push_back("the surface reaches the edge of the model");
  return warnings;
}

}  // namespace talus::lem
