// SPDX-License-Identifier: MIT
#include "support/lem_sections.hpp"

namespace talus::lem {

Soil make_soil(double cohesion, double friction_degrees, double unit_weight) {
  Soil soil;
  soil.cohesion = cohesion;
  soil.friction_angle = friction_degrees * degree;
  soil.unit_weight = soil.saturated_unit_weight = unit_weight;
  return soil;
}

Region make_region_below(const Section& section, int soil, std::vector<Point> line) {
  const double left = section.ground.front()[0], right = section.ground.back()[0];
  if (line.front()[0] > left) line.insert(line.begin(), {left, line.front()[1]});
  if (line.back()[0] < right) line.push_back({right, line.back()[1]});
  line.push_back({right, section.base - 10});
  line.push_back({left, section.base - 10});
  return {soil, line};
}

Section make_section(std::vector<Point> ground, const Soil& soil, double base, double water) {
  Section section;
  section.ground = std::move(ground);
  section.soils = {soil};
  section.base = base;
  section.water_unit_weight = water;
  section.regions = {make_region_below(section, 0, section.ground)};
  return section;
}

Surface make_arc(const Point& centre, double radius, double from, double to) {
  Surface surface;
  surface.circle = Circle{centre, radius};
  surface.from = from;
  surface.to = to;
  return surface;
}

Surface make_circle(const Slope& slope, const Point& centre, double radius) {
  Surface surface = make_arc(centre, radius, 0, 0);
  for (const auto& arc : find_arcs(slope, *surface.circle))
    if (arc[1] - arc[0] > surface.to - surface.from) {
      surface.from = arc[0];
      surface.to = arc[1];
    }
  return surface;
}

Surface make_polyline(std::vector<Point> line) {
  Surface surface;
  surface.line = std::move(line);
  return surface;
}

Checks report_only() {
  Checks checks;
  checks.smallest_lambda = -10;
  checks.largest_lambda = 10;
  checks.reject = false;
  return checks;
}

double find_factor(const Slope& slope, const Surface& surface, Method method, int slices) {
  const Checks checks = report_only();
  CutSurface cut = cut_surface(slope, surface, slices, checks);
  EXPECT_EQ(cut.refusal, Refusal::none) << name_refusal(cut.refusal);
  const Solution solution = solve(slope, cut, method, checks, false);
  EXPECT_EQ(solution.refusal, Refusal::none) << to_word(method) << ": " << name_refusal(solution.refusal);
  return solution.factor;
}

}  // namespace talus::lem
