// SPDX-License-Identifier: MIT
// Checks of what restricts the search for slip surfaces: windows, layers, tangents, excluded areas, impenetrable soil,
// and the side to which masses slide.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/numbers.hpp"
#include "base/text.hpp"
#include "input/case/checks.hpp"
#include "input/case/geometry.hpp"

namespace talus::input {
namespace {

using Points = std::vector<std::array<double, 2>>;

/// Returns true if points reach into the soil of the section, between its sides.
bool meets_soil(const Points& points, const SoilOutline& soil) {
  double left = points.front()[0], right = left, low = points.front()[1], high = low, ground = -1e300;
  for (const auto& [x, y] : points) {
    left = std::min(left, x), right = std::max(right, x);
    low = std::min(low, y), high = std::max(high, y);
  }
  constexpr int places = 20;
  for (int i = 0; i <= places; ++i) ground = std::max(ground, soil.find_ground(left + (right - left) * i / places));
  return right >= soil.left() - soil.slack() && left <= soil.right() + soil.slack() && high >= soil.bottom() &&
         low <= ground + soil.slack();
}

/// Returns the indices of two sides of a polygon that cross or touch; nullopt if it is simple and has an area.
std::optional<std::array<std::size_t, 2>> find_crossing(const Points& p) {
  const auto turn = [](const auto& a, const auto& b, const auto& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  };
  const auto differ = [](double a, double b) { return (a >= 0 && b <= 0) || (a <= 0 && b >= 0); };
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const auto &a = p[i], &b = p[i + 1 == n ? 0 : i + 1], &c = p[j], &d = p[j + 1 == n ? 0 : j + 1];
      const bool next = j == i + 1, last = i == 0 && j + 1 == n;
      // Neighbours share a corner; they overlap where one turns back on the other.
      if (next || last) {
        const auto &corner = next ? b : a, &before = next ? a : c, &after = next ? d : b;
        const double back =
            (before[0] - corner[0]) * (after[0] - corner[0]) + (before[1] - corner[1]) * (after[1] - corner[1]);
        if (a == b || c == d || (turn(before, corner, after) == 0 && back >= 0)) return std::array{i, j};
      } else if (std::max(a[0], b[0]) >= std::min(c[0], d[0]) && std::max(c[0], d[0]) >= std::min(a[0], b[0]) &&
                 std::max(a[1], b[1]) >= std::min(c[1], d[1]) && std::max(c[1], d[1]) >= std::min(a[1], b[1]) &&
                 differ(turn(a, b, c), turn(a, b, d)) && differ(turn(c, d, a), turn(c, d, b))) {
        return std::array{i, j};
      }
    }
  return std::nullopt;
}

/// Checks a window. `least`: smallest number of its points.
void check_window(const SurfaceWindow& w, const std::string& path, std::size_t least, const SoilOutline& soil,
                  Findings& findings) {
  if (!findings.is_sound(path + ".points") || !findings.is_sound(path + ".box")) return;
  if (w.points.empty() == w.box.empty())
    return findings.add(path, "window '{}' {}; give its 'points', or two corners of a 'box'", w.name,
                        w.points.empty() ? "has no shape" : "has points and a box");
  if (!w.box.empty() && (w.box.size() != 2 || w.box[0][0] == w.box[1][0] || w.box[0][1] == w.box[1][1]))
    return findings.add(path + ".box", "the box of window '{}' is to be two opposite corners, [x, y] each", w.name);
  if (w.box.empty() && w.points.size() < least)
    return findings.add(path + ".points",
                        "window '{}' is a point; surfaces pass through a polyline of 2 points or more, or a box",
                        w.name);
  const Points& points = w.box.empty() ? w.points : w.box;
  for (const auto& p : points)
    if (!soil.spans(p[0]))
      return findings.add(path, "window '{}' reaches to x = {}, outside the section, {}", w.name,
                          format_coordinate(p[0], soil.units().length), soil.write_span());
  if (!meets_soil(points, soil))
    findings.add(path, "window '{}' lies outside the soil of the section: no surface passes through it", w.name);
}

void check_angles(const std::vector<double>& range, const std::string& path, Findings& findings) {
  constexpr double degree = 0.017453292519943295;
  if (!findings.is_sound(path)) return;
  const std::string key = path.substr(path.rfind('.') + 1);
  if (range.size() != 2)
    return findings.add(path, "'{}' has {} angles; expected [from, to], two inclinations", key, range.size());
  if (range[0] > range[1])
    findings.add(path, "'{}' goes from {:.6g}° to {:.6g}°; expected [from, to], the smaller inclination first", key,
                 range[0] / degree, range[1] / degree);
}

/// Checks that a region, material or line has this name, and that it is one layer or a line from left to right.
void check_layer(const Case& data, const std::string& name, const std::string& path, Findings& findings) {
  if (!findings.is_sound(path) || !findings.is_sound("geometry.line") || !findings.is_sound("regions")) return;
  std::set<std::string> known;
  for (const mesh::Line& line : data.mesh.lines) {
    known.insert(line.name);
    if (line.name != name) continue;
    const bool is_left = line.points.size() > 1 && line.points.back()[0] < line.points.front()[0];
    for (std::size_t i = 1; i < line.points.size(); ++i)
      if (is_left ? line.points[i][0] >= line.points[i - 1][0] : line.points[i][0] <= line.points[i - 1][0])
        return findings.add(
            path, "line '{}' turns back at point {}; a line that surfaces follow runs from left to right", name, i + 1);
    return;
  }
  std::vector<std::array<double, 2>> spans;
  for (const mesh::Polygon& polygon : data.mesh.polygons) {
    const auto region = data.regions.find(polygon.name);
    known.insert(polygon.name);
    if (region != data.regions.end()) known.insert(region->second);
    if (polygon.points.empty() || (polygon.name != name && (region == data.regions.end() || region->second != name)))
      continue;
    const auto [low, high] = std::minmax_element(polygon.points.begin(), polygon.points.end());
    spans.push_back({(*low)[0], (*high)[0]});
  }
  if (spans.empty())
    return findings.add(path, "there is no region, material or line '{}'; {}", name,
                        talus::suggest(name, {known.begin(), known.end()}));
  std::sort(spans.begin(), spans.end());
  double reached = spans.front()[1];
  for (const auto& [from, to] : spans) {
    if (from > reached)
      return findings.add(path, "layer '{}' has a gap from x = {} to x = {}; a surface follows one layer without gaps",
                          name, format_coordinate(reached, data.units().length),
                          format_coordinate(from, data.units().length));
    reached = std::max(reached, to);
  }
}

void check_block(const Case& data, const SoilOutline& soil, Findings& findings) {
  const BlockSearch& block = data.lem.block;
  constexpr std::size_t most = 8;
  check_names(block.windows, "lem.block.window", "windows", findings);
  check_angles(block.active, "lem.block.active", findings);
  check_angles(block.passive, "lem.block.passive", findings);
  if (!block.along.empty()) check_layer(data, block.along, "lem.block.along", findings);
  for (std::size_t i = 0; i < block.windows.size(); ++i)
    check_window(block.windows[i], fmt::format("lem.block.window.{}", i), 1, soil, findings);
  if (data.lem.search != SurfaceSearch::block || !findings.is_sound("lem.block")) return;
  const std::size_t count = block.windows.size();
  if (!block.along.empty() && count > 0)
    findings.add("lem.block.along",
                 "'along' and [[lem.block.window]] exclude each other: surfaces follow one layer or "
                 "pass through windows");
  else if (block.along.empty() && (count < 2 || count > most))
    findings.add("lem.block", "search = \"block\" needs 'along', or 2 to {} [[lem.block.window]]; there {}", most,
                 count == 1 ? "is 1" : fmt::format("are {}", count));
  if (findings.is_sound("lem.methods") &&
      std::none_of(data.lem.methods.begin(), data.lem.methods.end(), [](SliceMethod m) { return suits_polylines(m); }))
    findings.add("lem.methods",
                 "search = \"block\" tries polylines, and none of 'methods' applies to them; add \"spencer\"");
}

void check_tangent(const Case& data, const SoilOutline& soil, Findings& findings) {
  if (!data.lem.tangent) return;
  const TangentCircles& tangent = *data.lem.tangent;
  const std::string path = "lem.tangent", levels = "lem.tangent.levels";
  if (data.lem.search == SurfaceSearch::block || data.lem.search == SurfaceSearch::none)
    findings.add(path, "[lem.tangent] restricts circles, and search = \"{}\" tries none", get_word(data.lem.search));
  if (tangent.levels.empty() == tangent.layer.empty() && findings.is_sound(path))
    return findings.add(path, "[lem.tangent] has {}; give one of them",
                        tangent.layer.empty() ? "neither 'levels' nor 'layer'" : "'levels' and 'layer'");
  if (!tangent.layer.empty()) return check_layer(data, tangent.layer, path + ".layer", findings);
  if (!findings.is_sound(levels)) return;
  const ShownUnit& length = soil.units().length;
  if (tangent.levels.size() > 2 || tangent.levels.front() > tangent.levels.back())
    findings.add(levels, "'levels' is to be one level, or [from, to], the lower level first");
  else if (tangent.levels.back() < soil.bottom() || tangent.levels.front() > soil.top())
    findings.add(levels, "no soil lies at the 'levels' of the deepest points; it goes from y = {} to y = {}",
                 format_coordinate(soil.bottom(), length), format_coordinate(soil.top(), length));
}

void check_areas(const Case& data, const SoilOutline& soil, Findings& findings) {
  // Every base of every surface is compared with every corner.
  constexpr std::size_t most_corners = 1000;
  std::size_t corners = 0;
  for (const ExcludedArea& area : data.lem.excluded) corners += area.points.size();
  for (const SurfaceWindow& window : data.lem.passages) corners += window.points.size();
  if (corners > most_corners)
    return findings.add("lem", "[[lem.exclude]] and [[lem.through]] have {} corners; expected at most {}", corners,
                        most_corners);
  check_names(data.lem.excluded, "lem.exclude", "excluded areas", findings);
  check_names(data.lem.passages, "lem.through", "windows", findings);
  for (std::size_t i = 0; i < data.lem.excluded.size(); ++i) {
    const ExcludedArea& area = data.lem.excluded[i];
    const std::string path = fmt::format("lem.exclude.{}", i);
    if (!findings.is_sound(path)) continue;
    if (area.points.size() < 3)
      findings.add(path + ".points", "the excluded area '{}' has {} corners; a polygon has at least 3", area.name,
                   area.points.size());
    else if (const auto sides = find_crossing(area.points))
      findings.add(path + ".points", "the excluded area '{}' is no polygon: its sides {} and {} cross", area.name,
                   (*sides)[0] + 1, (*sides)[1] + 1);
    else if (!meets_soil(area.points, soil))
      findings.add(path + ".points", "the excluded area '{}' lies outside the soil of the section", area.name);
  }
  for (std::size_t i = 0; i < data.lem.passages.size(); ++i)
    check_window(data.lem.passages[i], fmt::format("lem.through.{}", i), 2, soil, findings);
}

void check_impenetrable(const Case& data, Findings& findings) {
  if (!findings.is_sound("lem.impenetrable") || !findings.is_sound("materials")) return;
  std::set<std::string> names;
  for (const auto& [name, material] : data.materials) names.insert(name);
  for (std::size_t i = 0; i < data.lem.impenetrable.size(); ++i)
    if (const std::string& name = data.lem.impenetrable[i]; names.count(name) == 0)
      findings.add(fmt::format("lem.impenetrable.{}", i), "there is no material '{}'; {}", name,
                   talus::suggest(name, {names.begin(), names.end()}));
  const auto is_firm = [&](const auto& region) {
    return std::count(data.lem.impenetrable.begin(), data.lem.impenetrable.end(), region.second) > 0;
  };
  if (!data.regions.empty() && std::all_of(data.regions.begin(), data.regions.end(), is_firm))
    findings.add("lem.impenetrable", "all soil of the section is impenetrable: no surface is left");
}

void check_side(const LimitEquilibrium& lem, Findings& findings) {
  const auto &exit = lem.entry_exit.exit, &entry = lem.entry_exit.entry;
  if (lem.search == SurfaceSearch::grid && (!exit.empty() || !entry.empty()))
    findings.add(exit.empty() ? "lem.entry_exit.entry" : "lem.entry_exit.exit",
                 "'exit' and 'entry' of [lem.entry_exit] restrict search = \"entry_exit\" or \"block\", and circles "
                 "about a grid have no such ranges; take them out, or change 'search'");
  if (lem.slides == SlidingDirection::both || exit.size() != 2 || entry.size() != 2) return;
  if (lem.slides == SlidingDirection::left ? exit[0] >= entry[1] : exit[1] <= entry[0])
    findings.add("lem.slides", "slides = \"{}\", but the exits of [lem.entry_exit] lie {} of the entries",
                 get_word(lem.slides), lem.slides == SlidingDirection::left ? "right" : "left");
}

}  // namespace

void check_slip_search(const Case& data, const SoilOutline& soil, Findings& findings) {
  check_block(data, soil, findings);
  check_tangent(data, soil, findings);
  check_areas(data, soil, findings);
  check_impenetrable(data, findings);
  check_side(data.lem, findings);
}

}  // namespace talus::input
