// SPDX-License-Identifier: MIT
// Sentences about refusals, limits and doubtful critical surfaces.

#include "lem/search/search_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "lem/search/local_minima.hpp"

namespace talus::lem {

namespace {

constexpr double close = 0.002;  ///< of the width of the ground: as good as at a limit

/// λ this near to its limit rests on it [-].
constexpr double close_to_gate = 2e-3;

std::string group_digits(long n) {
  std::string s = std::to_string(n);
  for (int i = static_cast<int>(s.size()) - 3; i > 0; i -= 3) s.insert(static_cast<std::size_t>(i), ",");
  return s;
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
  const double near = close * (slope.right() - slope.left());
  const auto ends = find_ends(critical.surface);
  const bool slides_left = critical.cut.slides_left;
  auto check = [&](double x, const std::array<double, 2>& range, const char* end, const char* key) {
    for (double limit : range) {
      if (std::abs(x - limit) > near) continue;
      const bool edge = std::abs(limit - slope.left()) < near || std::abs(limit - slope.right()) < near;
      add(edge ? fmt::format("the {} of the critical {} lies at x = {} m, the edge of the model; "
                             "extend the ground beyond it",
                             end, what, format_coordinate(x))
               : fmt::format("the {} of the critical {} lies at x = {} m, an end of the range "
                             "searched ({} to {} m); widen [lem.entry_exit] {}",
                             end, what, format_coordinate(x), format_coordinate(range[0]), format_coordinate(range[1]),
                             key));
    }
  };
  check(ends[slides_left ? 0 : 1], slides_left ? circles.left : circles.right, "exit", "exit");
  check(ends[slides_left ? 1 : 0], slides_left ? circles.right : circles.left, "entry", "entry");
  if (critical.surface.circle) {
    const Circle& c = *critical.surface.circle;
    const double bottom = c.centre[1] - c.radius, base = slope.section().base;
    if (bottom < base + near && c.centre[0] > ends[0] && c.centre[0] < ends[1])
      add(
          fmt::format("the critical circle {} the base at {} m; a deeper model may give a smaller "
                      "factor unless firm ground begins there",
                      bottom < base - near ? "is cut level at" : "touches", format_coordinate(base)));
  }
  if (options.checks.smallest_depth > 0 && critical.cut.depth < 1.005 * options.checks.smallest_depth)
    add(
        fmt::format("the critical {} is as shallow as the smallest depth of {:.4g} m allows; the "
                    "factor depends on it",
                    critical.surface.circle ? "circle" : "polyline", options.checks.smallest_depth));
  if (result.grid && best_trial >= 0 && critical.circular) {
    const Circle& c = *circles.surfaces[static_cast<std::size_t>(best_trial)].circle;
    const GridSearch& g = *result.grid;
    for (const int axis : {0, 1}) {
      const auto a = static_cast<std::size_t>(axis);
      const double low = std::min(g.from[a], g.to[a]), high = std::max(g.from[a], g.to[a]),
                   tolerance = 1e-6 * (high - low);
      if (c.centre[a] < low + tolerance || c.centre[a] > high - tolerance)
        add(
            fmt::format("the best trial circle has its centre on the border of the grid, at {} = {:.4g} "
                        "m ({:.4g} to {:.4g} m searched); enlarge the corners of [lem.grid]",
                        axis == 0 ? "x" : "y", c.centre[a], low, high));
    }
    const double bottom = c.centre[1] - c.radius, tolerance = 1e-6 * std::abs(*g.highest - *g.lowest);
    if (bottom<*g.lowest + tolerance&& * g.lowest> slope.section().base + near)
      add(
          fmt::format("the best trial circle reaches down to {:.4g} m, the lowest level searched; lower the levels "
                      "of [lem.grid]",
                      bottom));
  }
  return hits;
}

std::vector<std::string> find_warnings(const Slope& slope, const Checks& checks, const Critical& critical) {
  std::vector<std::string> warnings = critical.cut.warnings;
  const Solution& s = critical.solution;
  const bool forces = is_rigorous(critical.method);
  if (critical.method != Method::fellenius && s.smallest_m_alpha < checks.smallest_m_alpha)
    warnings.push_back(
        fmt::format("m_alpha falls to {:.2f}, below {:.2f}: the normal force at the passive end is "
                    "unreliable",
                    s.smallest_m_alpha, checks.smallest_m_alpha));
  if (s.tensile_share > 0.5 * checks.most_tension)
    warnings.push_back(
        fmt::format("effective normal forces are tensile over {:.0f} % of the surface: consider a tension "
                    "crack",
                    100 * s.tensile_share));
  if (forces && s.thrust_outside > 0.5 * checks.most_thrust_outside)
    warnings.push_back(
        fmt::format("{:.0f} % of the interslice forces act outside the sliding mass", 100 * s.thrust_outside));
  if (forces && s.factor > 0)
    for (const auto& [limit, key] : {std::pair{checks.smallest_lambda, "smallest"}, {checks.largest_lambda, "largest"}})
      if (std::abs(s.lambda - limit) < close_to_gate)
        warnings.push_back(
            fmt::format("λ = {:.3f} rests on [lem] {}_lambda = {:g}: the factor depends on that limit, and not on the "
                        "slope alone",
                        s.lambda, key, limit));
  if (critical.cut.depth < 0.02 * find_relief(slope.section()))
    warnings.push_back(
        fmt::format("the surface is a skin of {:.2g} m: without cohesion the shallowest surface is critical; "
                    "give a smallest_depth",
                    critical.cut.depth));
  const double near = close * (slope.right() - slope.left());
  const auto ends = find_ends(critical.surface);
  if (ends[0] < slope.left() + near || ends[1] > slope.right() - near)
    warnings.push_back("the surface reaches the edge of the model");
  return warnings;
}

}  // namespace talus::lem
