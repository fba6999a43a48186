// SPDX-License-Identifier: MIT
#include "drawing/chainage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

#include "base/error.hpp"
#include "drawing/case_text.hpp"
#include "drawing/plan_line.hpp"

namespace talus::drawing {
namespace {

// Chainages and coordinates are often rounded to decimetres, and the scale of a map projection differs from 1 by less.
constexpr double largest_difference = 0.01;

struct ChainedPlace {
  double chainage = 0;
  PlanPlace at;
};

/// The places of one line, or of all boreholes.
using Places = std::vector<ChainedPlace>;

struct Lengths {
  double chainage = 0, plan = 0;  ///< [m]
  bool agree = true;
};

bool are_equal(double a, double b) {
  return std::abs(a - b) <= largest_difference * std::max(a, b);
}

/// Returns the length in the direction in which the chainage increases most, if the chainage is the distance along a
/// straight line in that direction; places may then lie beside it. Otherwise returns −1.
double project_straight(const Places& places, double chainage) {
  std::vector<PlanPlace> plan;
  double mean = 0;
  for (const ChainedPlace& p : places) plan.push_back(p.at), mean += p.chainage / static_cast<double>(places.size());
  const PlanLine line(plan);
  double along = 0, across = 0, along2 = 0, across2 = 0;
  for (const ChainedPlace& p : places) {
    const double u = line.measure(p.at), v = line.measure_across(p.at);
    along += u * (p.chainage - mean), across += v * (p.chainage - mean);
    along2 += u * u, across2 += v * v;
  }
  // Places in a narrow band give no gradient across it.
  constexpr double narrow = 0.02;
  if (!(along2 > 0)) return -1;
  const double slope = along / along2, slope_across = across2 > narrow * narrow * along2 ? across / across2 : 0;
  const double gradient = std::hypot(slope, slope_across);
  if (!(gradient > 0)) return -1;
  double least = 1e300, largest = -1e300;
  for (const ChainedPlace& p : places) {
    const double distance = (slope * line.measure(p.at) + slope_across * line.measure_across(p.at)) / gradient;
    if (!(std::abs(distance - (p.chainage - mean)) <= largest_difference * chainage)) return -1;
    least = std::min(least, distance), largest = std::max(largest, distance);
  }
  return largest - least;
}

Lengths compare_places(Places places) {
  std::stable_sort(places.begin(), places.end(),
                   [](const ChainedPlace& a, const ChainedPlace& b) { return a.chainage < b.chainage; });
  Lengths lengths{places.back().chainage - places.front().chainage, 0, true};
  for (std::size_t i = 1; i < places.size(); ++i)
    lengths.plan += std::hypot(places[i].at.x - places[i - 1].at.x, places[i].at.northing - places[i - 1].at.northing);
  lengths.agree = are_equal(lengths.chainage, lengths.plan);
  if (lengths.agree) return lengths;
  const double straight = project_straight(places, lengths.chainage);
  if (straight >= 0 && are_equal(lengths.chainage, straight)) return {lengths.chainage, straight, true};
  return lengths;
}

/// Factors of eastings and northings to metres on the ground.
struct Scale {
  double x = 1, northing = 1;
};

/// Returns the lengths of one degree, or of one radian, of longitude and latitude at a latitude [rad] on the ellipsoid
/// WGS 84: N cos φ and M.
Scale compute_radii(double latitude) {
  constexpr double a = 6'378'137, e2 = 0.00669437999014;  // [m], square of the eccentricity
  const double w2 = 1 - e2 * std::sin(latitude) * std::sin(latitude);
  return {a / std::sqrt(w2) * std::cos(latitude), a * (1 - e2) / (w2 * std::sqrt(w2))};
}

enum class PlanKind { plane, web_map, degrees };

/// Returns the scale of coordinates of a kind; zero if the place cannot have such coordinates.
Scale compute_scale(PlanKind kind, const PlanPlace& place) {
  if (kind == PlanKind::web_map) {
    constexpr double a = 6'378'137, half = a * std::numbers::pi;  // [m]
    if (!(std::abs(place.x) <= half && std::abs(place.northing) <= half)) return {0, 0};
    const double latitude = 2 * std::atan(std::exp(place.northing / a)) - std::numbers::pi / 2;
    // Nearer to the equator the scale of a web map is 1 within the largest difference.
    constexpr double least_latitude = 5 * std::numbers::pi / 180;
    if (std::abs(latitude) < least_latitude) return {0, 0};
    const Scale radii = compute_radii(latitude);
    return {radii.x / a, radii.northing * std::cos(latitude) / a};
  }
  if (kind == PlanKind::degrees) {
    constexpr double degree = std::numbers::pi / 180;
    if (!(std::abs(place.x) <= 180 && std::abs(place.northing) <= 90)) return {0, 0};
    const Scale radii = compute_radii(place.northing * degree);
    return {radii.x * degree, radii.northing * degree};
  }
  return {};
}

std::map<std::string, Places> read_places(const SurveyTable& table, const std::vector<std::string>& boreholes) {
  std::map<std::string, Places> lines;
  for (std::size_t row = table.first_row(); row < table.rows(); ++row) {
    const bool is_chosen =
        boreholes.empty() || table.form() == TableForm::lines ||
        std::find(boreholes.begin(), boreholes.end(), table.read_text(row, Role::hole)) != boreholes.end();
    if (!is_chosen) continue;
    try {
      const auto chainage = table.read_length(row, Role::chainage), x = table.read_length(row, Role::x);
      const auto northing = table.has(Role::northing) ? table.read_length(row, Role::northing) : 0.0;
      const std::string line = table.form() == TableForm::lines ? table.read_text(row, Role::soil) : "";
      if (chainage && x && northing) lines[line].push_back({*chainage, {*x, *northing}});
    } catch (const Error&) {
      continue;  // the reader of the rows lists their faults
    }
  }
  std::erase_if(lines, [](const auto& line) { return line.second.size() < 2; });
  return lines;
}

/// Returns the lengths of the longest line, or of the first one whose lengths differ.
Lengths compare_lines(const std::map<std::string, Places>& lines, PlanKind kind, const Scale& unit) {
  Lengths longest;
  for (const auto& [name, places] : lines) {
    Places scaled = places;
    for (ChainedPlace& p : scaled) p.at = {p.at.x * unit.x, p.at.northing * unit.northing};
    const Scale scale = compute_scale(kind, scaled[scaled.size() / 2].at);
    if (scale.x == 0) return {0, 0, false};
    for (ChainedPlace& p : scaled) p.at = {p.at.x * scale.x, p.at.northing * scale.northing};
    const Lengths lengths = compare_places(std::move(scaled));
    if (!lengths.agree) return lengths;
    if (lengths.chainage >= longest.chainage) longest = lengths;
  }
  return longest;
}

}  // namespace

std::string compare_chainage(const SurveyTable& table, const std::vector<std::string>& boreholes) {
  if (!table.has_both_positions()) return "";
  const std::string file = std::filesystem::path(table.file()).filename().string();
  const std::string chainage = fmt::format("'{}'", clean_text(table.get_heading(Role::chainage)));
  std::string plan = fmt::format("'{}'", clean_text(table.get_heading(Role::x)));
  if (table.has(Role::northing)) plan += fmt::format(" and '{}'", clean_text(table.get_heading(Role::northing)));
  const auto lines = read_places(table, boreholes);
  if (lines.empty())
    return fmt::format("{} is the position along the section; no two rows of {} have {} to compare it with", chainage,
                       file, plan);
  // Web maps are in metres and degrees have no unit, whatever unit the options give to columns without one.
  const Scale own{1 / table.get_assumed_unit(Role::x), 1 / table.get_assumed_unit(Role::northing)};
  const Lengths plane = compare_lines(lines, PlanKind::plane, {});
  const auto describe = [&](const Lengths& lengths, const char* kind) {
    return fmt::format("{} is the position along the section, which is {:.6g} m long by it and {:.6g} m by {}{}",
                       chainage, lengths.chainage, lengths.plan, plan, kind);
  };
  if (plane.agree) return describe(plane, "");
  if (table.has(Role::northing)) {
    if (const Lengths map = compare_lines(lines, PlanKind::web_map, own); map.agree)
      return describe(map, " on the ground, as coordinates of a web map (EPSG:3857)");
    if (const Lengths sphere = compare_lines(lines, PlanKind::degrees, own); sphere.agree)
      return describe(sphere, " as longitude and latitude");
  }
  constexpr double foot = 0.3048;
  const bool is_foot = are_equal(plane.chainage * foot, plane.plan) || are_equal(plane.plan * foot, plane.chainage);
  fail_input(
      "the section of '{}' is {:.6g} m long by {} and {:.6g} m by {}, and they may differ by 1 %{}: correct the units "
      "in the headings, or delete the columns that are not positions along the section",
      table.file(), plane.chainage, chainage, plane.plan, plan,
      is_foot ? " (the ratio is that of metres to feet)" : "");
}

}  // namespace talus::drawing
