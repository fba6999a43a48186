// SPDX-License-Identifier: MIT
#include "run/bounds/referee.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/error.hpp"
#include "bounds/find_bounds.hpp"
#include "input/case/support.hpp"
#include "run/bounds/problem_of_case.hpp"
#include "run/common/bedding_lines.hpp"

namespace talus::run {
namespace {

/// The search ends at this relative width of the interval, or with this number of triangles: at least twice those of
/// the first mesh, which pore pressures of a wide section make fine. For `most_unproven` see BoundsOptions.
constexpr double judging_gap = 0.03;
constexpr int most_triangles = 2500, most_unproven = 3;

/// Returns why limit analysis cannot judge this case; nullopt if it can.
std::optional<std::string> find_obstacle(const input::Case& data) {
  if (data.mesh.dimension != 2) return "limit analysis is that of a plane section";
  if (auto why = input::find_axial_obstacle(data)) return why;
  if (data.lem.drawdown) return "strengths after a rapid drawdown depend on the slip surface";
  for (const auto& [region, name] : data.regions) {
    const input::Material& material = data.materials.at(name);
    if (material.traits().only_slices)
      return fmt::format("the strength of material '{}' ({}) is not one of limit analysis", name,
                         material.traits().title);
    if (has_wide_bedding(material))
      return fmt::format(
          "the bedding of material '{}' has a range of directions in LEM and one direction in limit analysis", name);
  }
  return std::nullopt;
}

input::Case make_case(const input::Case& data) {
  input::Case judged = data;
  judged.bounds.tension = input::BoundsTension::apex;
  judged.bounds.flow = input::BoundsFlow::associated;
  // No slip surface enters these materials, whatever their strength.
  for (const std::string& name : data.lem.impenetrable)
    judged.materials.at(name).model = material::model_of<material::LinearElastic>;
  return judged;
}

void take(const bounds::BoundsResult& found, results::Referee& referee) {
  if (found.lower > 0)
    referee.lower = std::min(referee.lower.value_or(found.lower), found.lower);
  else
    referee.no_lower = found.no_lower.empty() ? "no stress field passed its check" : found.no_lower;
  if (std::isfinite(found.upper))
    referee.upper = std::min(referee.upper.value_or(found.upper), found.upper);
  else
    referee.no_upper = found.no_upper.empty() ? "no mechanism passed its check" : found.no_upper;
  for (const bounds::BoundsLevel& level : found.levels) {
    referee.triangles = std::max(referee.triangles, level.triangles);
    referee.programs += level.programs;
  }
}

}  // namespace

results::Referee search_referee_interval(const input::Case& data, std::optional<double> start,
                                         const RunOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  results::Referee referee;
  referee.why_not = find_obstacle(data);
  if (referee.why_not) return referee;
  bounds::BoundsOptions search;
  search.gap = judging_gap, search.most_unproven = most_unproven;
  search.start = start.value_or(1);
  search.threads = options.threads;
  input::Case judged = make_case(data);
  bool has_lower = true, has_heads = false;
  try {
    for (const input::EarthquakeDirection direction : data.earthquake.list_directions()) {
      judged.earthquake.direction = direction;
      if (options.progress) options.progress->show("limit analysis: proving an interval");
      const ProblemOfCase made = make_bounds_problem(judged, Supports::below_soil);
      search.most_triangles = std::max(most_triangles, 2 * static_cast<int>(made.problem.size()));
      has_heads = !made.problem.heads.empty();
      take(find_case_bounds(made, search), referee);
      has_lower = has_lower && referee.no_lower.empty();
    }
  } catch (const Error& error) {
    if (error.code() == ExitCode::interrupted) throw;
    results::Referee none;
    none.why_not = error.what();
    return none;
  }
  if (!has_lower) referee.lower.reset();
  if (has_heads) {
    referee.upper.reset();
    referee.no_upper =
        "it presses the heads of supports on a metre of the ground, below which the soil may fail, and in LEM it does "
        "not";
  }
  if (data.lem.crack.depth > 0)
    referee.upper_only = "the tension crack of the case weakens the soil, and limit analysis has none";
  referee.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return referee;
}

}  // namespace talus::run
