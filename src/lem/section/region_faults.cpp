// SPDX-License-Identifier: MIT
// Faults of the regions of a section whose ground is sound.

#include "lem/section/region_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "lem/slices/strips.hpp"
#include "mesh/planar.hpp"

namespace talus::lem {

namespace {

std::string name_region(const Section& section, std::size_t number) {
  const int soil = section.regions[number].soil;
  const bool known = soil >= 0 && soil < static_cast<int>(section.soils.size());
  const std::string& name = known ? section.soils[static_cast<std::size_t>(soil)].name : std::string();
  return name.empty() ? fmt::format("region {}", number + 1) : fmt::format("region {} of soil '{}'", number + 1, name);
}

/// The polygon without points that repeat the one before.
std::vector<Point> drop_repeated(const std::vector<Point>& polygon) {
  std::vector<Point> kept;
  for (const Point& p : polygon)
    if (kept.empty() || p != kept.back()) kept.push_back(p);
  while (kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
  return kept;
}

bool check_polygon(const Section& section, std::size_t number, double size, std::vector<std::string>& faults) {
  const Region& region = section.regions[number];
  const std::string name = name_region(section, number);
  if (region.soil < 0 || region.soil >= static_cast<int>(section.soils.size())) {
    faults.push_back(fmt::format("{} names soil {}, which is not there", name, region.soil));
    return false;
  }
  const auto polygon = drop_repeated(region.polygon);
  if (!std::all_of(polygon.begin(), polygon.end(),
                   [](const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); })) {
    faults.push_back(fmt::format("{} has a point that is not a number", name));
    return false;
  }
  if (polygon.size() < 3) {
    faults.push_back(fmt::format("{} has fewer than three points", name));
    return false;
  }
  if (const auto place = mesh::find_self_contact(polygon, 1e-9 * size)) {
    faults.push_back(fmt::format("{} crosses or touches itself at {}", name, format_point(*place)));
    return false;
  }
  if (std::abs(mesh::compute_area(polygon)) < 1e-12 * size * size) {
    faults.push_back(fmt::format("{} has no area", name));
    return false;
  }
  double left = polygon[0][0], right = left, low = polygon[0][1];
  for (const Point& p : polygon) {
    left = std::min(left, p[0]);
    right = std::max(right, p[0]);
    low = std::min(low, p[1]);
  }
  const bool beside = right <= section.ground.front()[0] || left >= section.ground.back()[0];
  double top = section.ground[0][1];
  for (const Point& p : section.ground) top = std::max(top, p[1]);
  if (beside || low >= top) {
    faults.push_back(fmt::format("{} lies outside: it is {} the ground", name, beside ? "beside" : "above"));
    return false;
  }
  return true;
}

/// A stretch of x with the same fault, told in one sentence.
struct Gap {
  const char* what;
  double from = 0, to = 0;
  bool open = false;
};

void extend_gap(Gap& gap, bool found, const Strip& strip, std::vector<std::string>& faults) {
  if (found && !gap.open) gap.from = strip.left;
  if (found) gap.to = strip.right;
  if (!found && gap.open)
    faults.push_back(fmt::format("no soil {} between x = {} and x = {}: no region covers it", gap.what,
                                 format_coordinate(gap.from), format_coordinate(gap.to)));
  gap.open = found;
}

/// Places under the ground that no region covers; below the lowest soil that is the bottom of the model and no fault.
void check_cover(const Slope::Strips& strips, double size, std::vector<std::string>& faults) {
  Gap bare{"under the ground"}, hole{"in a hole of the regions"};
  for (const Strip& strip : strips.strips) {
    const double half = 0.5 * (strip.right - strip.left);
    // Where the ground comes down to the base there is nothing to cover.
    if (half < 1e-6 * size || strip.ground.at(half) - strips.section.base < 1e-6 * size) continue;
    bool is_bare = strip.first == strip.last, is_hole = false;
    for (int i = strip.first; i < strip.last; ++i) {
      const bool covered = strips.layer(i).soil >= 0;
      is_bare = is_bare || (i == strip.first && !covered);
      is_hole = is_hole || (i > strip.first + 1 && covered && strips.layer(i - 1).soil < 0);
    }
    extend_gap(bare, is_bare, strip, faults);
    extend_gap(hole, is_hole && !is_bare, strip, faults);
  }
  extend_gap(bare, false, {}, faults);
  extend_gap(hole, false, {}, faults);
}

}  // namespace

void find_region_faults(const Section& section, std::vector<std::string>& faults) {
  const double size = section.ground.back()[0] - section.ground.front()[0];
  bool sound = true;
  for (std::size_t i = 0; i < section.regions.size(); ++i) sound = check_polygon(section, i, size, faults) && sound;
  if (!sound) return;
  if (section.regions.empty()) {
    faults.push_back("the section has no region of soil");
    return;
  }
  Slope::Strips strips;
  strips.section = section;
  strips.section.pressure_grid.reset();
  build_strips(strips);
  check_cover(strips, size, faults);
}

}  // namespace talus::lem
