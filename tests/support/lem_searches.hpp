// SPDX-License-Identifier: MIT
#pragma once
// Sections and settings of the tests of restricted searches: seams of published problems, a plain slope, mirrors.

#include <algorithm>
#include <memory>

#include "lem/search/search.hpp"
#include "support/lem_sections.hpp"

namespace talus::lem {

/// ACADS 3 (Giam & Donald 1989): a weak seam of 0.5 m and a piezometric line along its bottom; kN and m.
inline Section make_seam_section() {
  Section section = make_section({{20, 27.75}, {43, 27.75}, {67.5, 40}, {84, 40}}, make_soil(28.5, 20, 18.84), 20);
  section.soils.push_back(make_soil(0, 10, 18.84));
  section.regions.push_back(make_region_below(section, 1, {{20, 27}, {84, 27}}));
  section.regions.push_back(make_region_below(section, 0, {{20, 26.5}, {84, 26.5}}));
  section.water_table = {{20, 26.5}, {84, 26.5}};
  return section;
}

/// ACADS 4: an inclined seam of 0.6 m, water and two loads.
inline Section make_inclined_seam_section() {
  Section section = make_section({{20, 27.75}, {43, 27.75}, {67.5, 40}, {84, 40}}, make_soil(28.5, 20, 18.84), 15);
  section.soils.push_back(make_soil(0, 10, 18.84));
  section.regions.push_back(make_region_below(section, 1, {{20, 18.88}, {84, 36.8}}));
  section.regions.push_back(make_region_below(section, 0, {{20, 18.28}, {84, 36.2}}));
  section.water_table = {{20, 27.75}, {43, 27.75}, {49, 29.8}, {60, 34},
                         {66, 35.8},  {74, 37.6},  {80, 38.4}, {84, 38.4}};
  section.surcharges = {{{{23, 20}, {43, 20}}}, {{{70, 20}, {80, 40}}}};
  return section;
}

/// A slope of 1:2, 10 m high, on 10 m of the same soil.
inline Section make_plain_section() {
  return make_section({{0, 10}, {30, 10}, {50, 20}, {90, 20}}, make_soil(5, 25, 19), 0);
}

inline Section mirror(Section section) {
  const auto turn = [](std::vector<Point>& line, bool is_open) {
    for (Point& p : line) p[0] = -p[0];
    if (is_open) std::reverse(line.begin(), line.end());
  };
  turn(section.ground, true);
  turn(section.water_table, true);
  for (Region& region : section.regions) turn(region.polygon, false);
  for (Surcharge& s : section.surcharges) {
    for (auto& row : s.load) row[0] = -row[0];
    std::reverse(s.load.begin(), s.load.end());
  }
  return section;
}

inline SearchOptions make_options(std::vector<Method> methods) {
  SearchOptions options;
  options.methods = std::move(methods);
  options.checks.most_tension = 0.3;
  options.threads = 2;
  return options;
}

inline SearchOptions make_block_options(std::vector<Method> methods, std::vector<Window> windows, Path path = {}) {
  SearchOptions options = make_options(std::move(methods));
  options.kind = SearchKind::block;
  options.block.emplace();
  options.block->windows = std::move(windows);
  options.block->path = std::move(path);
  options.block->active = {45 * degree, 70 * degree};
  options.block->passive = {15 * degree, 45 * degree};
  options.block->surfaces = 2000;
  return options;
}

/// Circles by Bishop alone.
inline SearchOptions make_circle_options() {
  SearchOptions options = make_options({Method::bishop});
  options.optimise_surface = false;
  return options;
}

inline SearchOptions limit(SearchOptions options, SurfaceLimits limits) {
  options.checks.limits = std::make_shared<const SurfaceLimits>(std::move(limits));
  return options;
}

inline double find_smallest(const SearchResult& result, Method method) {
  for (const auto* list : {&result.circular, &result.noncircular})
    for (const Critical& c : *list)
      if (c.method == method) return c.solution.factor;
  return 0;
}

}  // namespace talus::lem
