// SPDX-License-Identifier: MIT
#include "run/lem/run_lem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "lem/section/uplift.hpp"
#include "run/common/section_of_case.hpp"
#include "run/lem/slice_run.hpp"

namespace talus::run {
namespace {

/// Smaller relative differences of a depth are not reported.
constexpr double least_limit = 1e-3;

bool is_check(lem::Refusal refusal) {
  return refusal == lem::Refusal::m_alpha || refusal == lem::Refusal::tension || refusal == lem::Refusal::thrust ||
         refusal == lem::Refusal::steep_toe || refusal == lem::Refusal::too_shallow || refusal == lem::Refusal::kinks ||
         refusal == lem::Refusal::too_small || refusal == lem::Refusal::excluded || refusal == lem::Refusal::passage ||
         refusal == lem::Refusal::direction;
}

/// Moves the centre of a circle so that the arc of this radius meets the ground at both given ends, since published
/// circles are rounded. Throws if that would be another circle.
void lead_through_ends(const lem::Slope& slope, const std::string& name, lem::Surface& surface) {
  constexpr double farthest = 0.02;  // over the radius
  const ShownUnit& length = slope.section().units.length;
  lem::Circle& circle = *surface.circle;
  // At a vertical step of the ground the end is the point of it that is nearest to the circle.
  const auto find_end = [&](double x) {
    const double hair = 1e-9 * (slope.right() - slope.left()), off = std::abs(x - circle.centre[0]);
    const auto [low, high] = std::minmax({slope.ground(x - hair), slope.ground(x + hair)});
    const double y =
        circle.centre[1] - (off < circle.radius ? std::sqrt(circle.radius * circle.radius - off * off) : 0);
    return lem::Point{x, std::clamp(y, low, high)};
  };
  const lem::Point a = find_end(surface.from), b = find_end(surface.to);
  const double dx = b[0] - a[0], dy = b[1] - a[1], chord = std::hypot(dx, dy), r = circle.radius,
               height = r > chord / 2 ? std::sqrt(r * r - chord * chord / 4) : -1;
  const lem::Point centre{(a[0] + b[0]) / 2 - height * dy / chord, (a[1] + b[1]) / 2 + height * dx / chord};
  if (height < 0 || std::hypot(centre[0] - circle.centre[0], centre[1] - circle.centre[1]) > farthest * r)
    throw Error(ExitCode::wrong_input,
                fmt::format("the circle '{}' about {} with radius {} does not meet the ground at its ends, "
                            "x = {} and {}",
                            name, format_point(circle.centre, length), format_value(r, length),
                            format_coordinate(a[0], length), format_coordinate(b[0], length)));
  circle.centre = centre;
}

std::vector<results::CriticalSurface> solve_given(const input::Case& data, const lem::Slope& slope,
                                                  const lem::SearchOptions& options) {
  std::vector<results::CriticalSurface> list;
  for (const input::SlipSurface& given : data.lem.surfaces) {
    const lem::Surface surface = make_surface(slope, given);
    for (const lem::Method method : options.methods) {
      lem::Critical critical = solve_surface(slope, surface, method, options);
      if (data.lem.yield_acceleration && critical.solution.factor > 0)
        critical.yield_acceleration = lem::find_yield_acceleration(slope, critical.cut, method, options.checks);
      list.push_back(make_critical_result(slope, critical));
    }
  }
  return list;
}

/// Returns a warning of a tension crack that is less deep than given, or deeper than the slope is high; empty
/// otherwise.
std::string describe_crack(const lem::Slope& slope) {
  const auto& crack = slope.section().crack;
  if (!crack) return "";
  const ShownUnit& length = slope.section().units.length;
  const std::vector<lem::Point>& ground = slope.section().ground;
  const auto [low, high] = std::minmax_element(ground.begin(), ground.end(),
                                               [](const lem::Point& a, const lem::Point& b) { return a[1] < b[1]; });
  if (!crack->limited)
    return crack->depth <= (*high)[1] - (*low)[1]
               ? ""
               : fmt::format("the tension crack is {} deep, and the slope {} high",
                             format_value(crack->depth, length, 3), format_value((*high)[1] - (*low)[1], length, 3));
  // For a level crest the end towards the slope counts, not that of the section.
  const double middle = 0.5 * (slope.left() + slope.right());
  double crest = (*high)[0];
  for (const lem::Point& p : ground)
    if (p[1] == (*high)[1] && std::abs(p[0] - middle) < std::abs(crest - middle)) crest = p[0];
  const double depth = slope.crack_depth(crest);
  if (depth > (1 - least_limit) * crack->depth) return "";
  return fmt::format(
      "the tension crack of {} ends at {} at the crest (x = {}): deeper down the soil beside it is "
      "not in tension{}. limit = false in [lem.tension_crack] keeps the depth that is given",
      format_value(crack->depth, length, 3), format_value(depth, length, 3), format_coordinate(crest, length),
      crack->water > 0 ? ". A surface keeps the given depth where the water in the crack then makes it weaker" : "");
}

}  // namespace

PreparedSlope prepare_slope(const site::Site& site) {
  SectionOfCase made = make_section(site);
  auto slope = std::make_shared<const lem::Slope>(std::move(made.section));
  if (std::string sentence = describe_crack(*slope); !sentence.empty()) made.notes.push_back(std::move(sentence));
  return {std::move(slope), std::move(made.notes), std::move(made.water)};
}

std::string describe_uplift(const lem::Slope& slope) {
  const std::optional<lem::Uplift> uplift = lem::find_uplift(slope);
  if (!uplift) return "";
  const ShownUnits& units = slope.section().units;
  return fmt::format(
      "Hydraulic uplift: at {} {} the pore pressure, {}, exceeds the weight of soil and water above, {} (factor "
      "{:.2f}). "
      "The soil there floats, and factors of safety of slip surfaces do not include this failure.",
      format_point(uplift->at, units.length), units.length.name, format_value(uplift->pressure, units.stress, 3),
      format_value(uplift->stress, units.stress, 3), uplift->factor());
}

lem::Surface make_surface(const lem::Slope& slope, const input::SlipSurface& given) {
  lem::Surface surface;
  surface.name = given.name;
  if (!given.centre || !given.radius) {
    surface.line.assign(given.points.begin(), given.points.end());
    if (!surface.line.empty()) {
      surface.from = surface.line.front()[0];
      surface.to = surface.line.back()[0];
    }
    return surface;
  }
  surface.circle = lem::Circle{*given.centre, *given.radius};
  if (given.ends.size() == 2) {
    surface.from = std::min(given.ends[0], given.ends[1]);
    surface.to = std::max(given.ends[0], given.ends[1]);
    lead_through_ends(slope, given.name, surface);
    return surface;
  }
  const auto arcs = lem::find_arcs(slope, *surface.circle);
  const ShownUnit& length = slope.section().units.length;
  if (arcs.empty())
    throw Error(ExitCode::wrong_input,
                fmt::format("the circle '{}' about {} with radius {} does not enter and leave the ground "
                            "between x = {} and {}",
                            given.name, format_point(*given.centre, length), format_value(*given.radius, length),
                            format_coordinate(slope.left(), length), format_coordinate(slope.right(), length)));
  const auto widest = std::max_element(arcs.begin(), arcs.end(),
                                       [](const auto& a, const auto& b) { return a[1] - a[0] < b[1] - b[0]; });
  surface.from = (*widest)[0];
  surface.to = (*widest)[1];
  return surface;
}

lem::Critical solve_surface(const lem::Slope& slope, const lem::Surface& surface, lem::Method method,
                            const lem::SearchOptions& options) {
  lem::Critical result;
  result.method = method;
  result.surface = surface;
  result.circular = surface.circle.has_value();
  lem::Checks checks = options.checks;
  result.cut = lem::cut_surface(slope, surface, options.slices, checks);
  lem::Refusal refusal = result.cut.refusal;
  if (refusal == lem::Refusal::none) {
    result.solution = lem::solve(slope, result.cut, method, checks, true);
    refusal = result.solution.refusal;
  }
  if (checks.reject && is_check(refusal)) {
    checks.reject = false;
    checks.smallest_depth = 0;
    checks.limits = nullptr;
    result.cut = lem::cut_surface(slope, surface, options.slices, checks);
    if (result.cut.refusal == lem::Refusal::none) result.solution = lem::solve(slope, result.cut, method, checks, true);
  }
  result.warnings = result.cut.warnings;
  if (refusal != lem::Refusal::none) {
    const bool may_continue = refusal == lem::Refusal::below_base && result.circular && !checks.composite;
    result.warnings.push_back(fmt::format("{}{}", lem::name_refusal(refusal),
                                          result.solution.factor > 0 ? "; a search would refuse this surface"
                                          : may_continue ? "; with composite = true in [lem] it continues along it"
                                                         : ""));
    if (result.solution.refusal == lem::Refusal::none) result.solution.refusal = refusal;
  }
  return result;
}

SliceOutcome run_lem(const input::Case& data, const PreparedSlope& prepared, int threads) {
  const auto start = std::chrono::steady_clock::now();
  const lem::Slope& slope = *prepared.slope;
  const lem::SearchOptions options = make_search_options(data, threads);
  SliceOutcome outcome;
  results::SliceResult& result = outcome.result;
  result.methods = options.methods;
  result.slices = options.slices;
  if (data.lem.drawdown) result.drawdown = data.lem.drawdown->method;
  result.warnings = prepared.notes;
  if (std::string sentence = describe_restrictions(data.lem); !sentence.empty())
    result.warnings.push_back(std::move(sentence));
  result.given = solve_given(data, slope, options);
  if (data.lem.search != input::SurfaceSearch::none) {
    lem::SearchResult found = lem::search(slope, options);
    const auto take = [&](lem::Critical& c, std::vector<results::CriticalSurface>& list) {
      if (data.lem.yield_acceleration)
        c.yield_acceleration = lem::find_yield_acceleration(slope, c.cut, c.method, options.checks);
      list.push_back(make_critical_result(slope, c));
    };
    for (lem::Critical& c : found.circular) take(c, result.critical);
    for (lem::Critical& c : found.noncircular) take(c, result.noncircular);
    for (std::size_t m = 0; m < found.minima.size(); ++m) {
      auto& list = result.minima[to_word(options.methods[m])];
      for (const lem::Critical& c : found.minima[m]) list.push_back(make_surface_result(c));
    }
    result.warnings.insert(result.warnings.end(), found.warnings.begin(), found.warnings.end());
    result.search = make_search_result(options, found);
    result.search->restrictions = make_restrictions(data);
    outcome.trials = make_trials_result(options, found);
    result.trials_file = "lem.json";
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

std::optional<input::EarthquakeDirection> find_weaker_direction(const input::Case& data, int threads) {
  if (data.mesh.dimension != 2 || data.mesh.polygons.empty()) return std::nullopt;
  input::Case circles = data;
  circles.lem = {};
  circles.lem.methods = {lem::Method::bishop};
  circles.lem.noncircular = false;
  try {
    const SliceOutcome found = run_lem(circles, prepare_slope(circles), threads);
    if (found.result.critical.empty()) return std::nullopt;
    return found.result.critical.front().slides_left ? input::EarthquakeDirection::left
                                                     : input::EarthquakeDirection::right;
  } catch (const Error& error) {
    if (error.code() == ExitCode::interrupted) throw;
    return std::nullopt;
  }
}

}  // namespace talus::run
