// SPDX-License-Identifier: MIT
// [lem], [[lem.surface]], [[surcharge]] and [partial_factors]: surfaces and ranges that lie on the soil.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "input/case/checks.hpp"
#include "input/case/soil_outline.hpp"

namespace talus::input {
namespace {

void check_stretch(const std::vector<double>& range, const std::string& path, const SoilOutline& soil,
                   Findings& findings) {
  if (!check_range(range, path, "places x", findings)) return;
  if (!soil.spans(range[0]) || !soil.spans(range[1]))
    findings.add(
        path, fmt::format("'{}' reaches beyond the ground, {}", path.substr(path.rfind('.') + 1), soil.write_span()));
}

template <class Block>
void check_names(const std::vector<Block>& list, const std::string& path, const char* what, Findings& findings) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (const std::string at = fmt::format("{}.{}.name", path, i);
        findings.is_sound(at) && !names.insert(list[i].name).second)
      findings.add(at, fmt::format("there are two {} named '{}'", what, list[i].name));
}

void check_surcharge(const Surcharge& s, const std::string& path, const SoilOutline& soil, Findings& findings) {
  if (!findings.is_sound(path + ".x") || !findings.is_sound(path + ".load")) return;
  if (s.x.size() != s.load.size())
    return findings.add(path + ".load", fmt::format("surcharge '{}' has {} places x and {} loads; each place has one",
                                                    s.name, s.x.size(), s.load.size()));
  if (s.x.size() < 2)
    return findings.add(path + ".x", fmt::format("surcharge '{}' needs at least two places x, from and to", s.name));
  for (std::size_t i = 1; i < s.x.size(); ++i)
    if (s.x[i] <= s.x[i - 1])
      return findings.add(path + ".x",
                          fmt::format("the places x of surcharge '{}' go from {:.6g} m to {:.6g} m; they run "
                                      "from left to right, increasing",
                                      s.name, s.x[i - 1], s.x[i]));
  if (!soil.spans(s.x.front()) || !soil.spans(s.x.back()))
    findings.add(path + ".x", fmt::format("surcharge '{}' reaches beyond the ground, {}", s.name, soil.write_span()));
}

void check_grid(const CentreGrid& grid, const SoilOutline& soil, Findings& findings) {
  const std::string corners = "lem.grid.corners", levels = "lem.grid.levels";
  if (!grid.corners.empty() && findings.is_sound(corners) &&
      !(grid.corners.size() == 2 && grid.corners[0][0] < grid.corners[1][0] && grid.corners[0][1] < grid.corners[1][1]))
    findings.add(corners,
                 "'corners' is to be the lower left and the upper right corner of the grid, two points [x, y]");
  if (check_range(grid.levels, levels, "levels y", findings) &&
      (grid.levels[0] > soil.top() || grid.levels[1] < soil.bottom()))
    findings.add(levels, fmt::format("no soil lies between the 'levels' of the deepest points, {} m and {} m; it "
                                     "goes from y = {} m to y = {} m",
                                     format_coordinate(grid.levels[0]), format_coordinate(grid.levels[1]),
                                     format_coordinate(soil.bottom()), format_coordinate(soil.top())));
}

void check_crack(const TensionCrack& crack, Findings& findings) {
  const std::string path = "lem.tension_crack.water";
  if (crack.water > crack.depth && findings.is_sound(path) && findings.is_sound("lem.tension_crack.depth"))
    findings.add(path, fmt::format("the water in the tension crack is {:.6g} m high, but the crack is {:.6g} m deep",
                                   crack.water, crack.depth));
}

void check_settings(const LimitEquilibrium& lem, Findings& findings) {
  if (lem.methods.empty() && findings.is_sound("lem.methods"))
    findings.add("lem.methods", "'methods' of [lem] is empty; name at least one method of slices");
  for (std::size_t i = 1; i < lem.methods.size(); ++i)
    if (std::count(lem.methods.begin(), lem.methods.begin() + static_cast<std::ptrdiff_t>(i), lem.methods[i]) > 0)
      findings.add(fmt::format("lem.methods.{}", i), "a method of slices is named twice");
  if (lem.search == SurfaceSearch::none && lem.surfaces.empty() && findings.is_sound("lem.surface"))
    findings.add("lem.search", "there is nothing to calculate: search = \"none\" and no [[lem.surface]]");
}

void check_partial_factors(const Case& data, Findings& findings) {
  const PartialFactors& p = data.partial_factors;
  const bool has_any =
      p.cohesion || p.friction || p.undrained || p.weight || p.permanent_load || p.variable_load || p.resistance;
  if (p.set == DesignApproach::by_hand && !has_any && findings.is_sound("partial_factors"))
    findings.add("partial_factors.set", "set = \"by_hand\" needs at least one factor, for example friction = 1.25");
  if (p.set == DesignApproach::none || !findings.is_sound("materials")) return;
  for (const auto& [name, m] : data.materials)
    if (!m.traits().serves_slices)
      findings.add("partial_factors.set",
                   fmt::format("partial factors divide cohesion and friction angle, which material "
                               "'{}' does not have",
                               name));
}

}  // namespace

bool check_range(const std::vector<double>& range, const std::string& path, const char* what, Findings& findings) {
  if (range.empty() || !findings.is_sound(path)) return false;
  if (range.size() == 2 && range[0] < range[1]) return true;
  findings.add(path,
               fmt::format("'{}' is to be [from, to], two increasing {}", path.substr(path.rfind('.') + 1), what));
  return false;
}

void check_slices(const Case& data, Findings& findings) {
  check_partial_factors(data, findings);
  check_crack(data.lem.crack, findings);
  check_names(data.lem.surfaces, "lem.surface", "slip surfaces", findings);
  check_names(data.surcharges, "surcharge", "surcharges", findings);
  if (uses(data, Method::lem)) check_settings(data.lem, findings);
  if (!findings.is_sound("geometry.polygon") || data.mesh.polygons.empty()) return;
  const SoilOutline soil(data.mesh);
  check_stretch(data.lem.entry_exit.exit, "lem.entry_exit.exit", soil, findings);
  check_stretch(data.lem.entry_exit.entry, "lem.entry_exit.entry", soil, findings);
  check_grid(data.lem.grid, soil, findings);
  for (std::size_t i = 0; i < data.lem.surfaces.size(); ++i)
    if (const std::string path = fmt::format("lem.surface.{}", i); findings.is_sound(path))
      check_slip_surface(data.lem.surfaces[i], path, soil, findings);
  for (std::size_t i = 0; i < data.surcharges.size(); ++i)
    check_surcharge(data.surcharges[i], fmt::format("surcharge.{}", i), soil, findings);
}

}  // namespace talus::input
