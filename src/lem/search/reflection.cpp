// SPDX-License-Identifier: MIT
#include "lem/search/reflection.hpp"

#include <algorithm>
#include <cmath>

namespace talus::lem {

namespace {

/// First moments of what has a place in the section, about the middle of the ground; positive: on the right.
class Lean {
 public:
  explicit Lean(const Section& section) : middle_(0.5 * (section.ground.front()[0] + section.ground.back()[0])) {}

  void add(double amount, double x) {
    moment_ += amount * (x - middle_);
    scale_ += std::abs(amount * (x - middle_));
  }

  /// Area below a line, above a level.
  void add_line(const std::vector<Point>& line, double level) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Point &a = line[i - 1], &b = line[i];
      const double width = b[0] - a[0];
      add(0.5 * width * (a[1] - level), a[0] + width / 3);
      add(0.5 * width * (b[1] - level), b[0] - width / 3);
    }
  }

  void add_polygon(const std::vector<Point>& polygon, double weight) {
    double area = 0, moment = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double ax = a[0] - middle_, bx = b[0] - middle_, twice = ax * b[1] - bx * a[1];
      area += 0.5 * twice;
      moment += twice * (ax + bx) / 6;
    }
    if (area != 0) add(weight * std::abs(area), middle_ + moment / area);
  }

  /// Returns -1 (left), 1 (right) or 0 (neither, up to rounding).
  int get_side() const {
    constexpr double rounding = 1e-9;
    return std::abs(moment_) <= rounding * scale_ ? 0 : moment_ < 0 ? -1 : 1;
  }

 private:
  double middle_, moment_ = 0, scale_ = 0;
};

}  // namespace

bool is_searched_reflected(const Section& section) {
  Lean ground(section), weight(section), strength(section), water(section), load(section), bars(section);
  ground.add_line(section.ground, section.base);
  for (const Region& region : section.regions) {
    const Soil& soil = section.soils[static_cast<std::size_t>(region.soil)];
    weight.add_polygon(region.polygon, soil.unit_weight);
    strength.add_polygon(region.polygon, soil.cohesion + soil.unit_weight * std::tan(soil.friction_angle));
  }
  water.add_line(section.water_table, section.base);
  for (const Surcharge& surcharge : section.surcharges)
    for (const auto& [x, down, across] : surcharge.load) load.add(std::abs(down) + std::abs(across), x);
  for (const Bar& bar : section.bars) {
    bars.add(1, bar.head[0]);
    bars.add(1, bar.end[0]);
  }
  for (const Lean* lean : {&ground, &weight, &strength, &water, &load, &bars})
    if (lean->get_side() != 0) return lean->get_side() < 0;
  return false;
}

Reflection::Reflection(const Section& section) {
  constexpr int digits = 12;
  const double left = section.ground.front()[0], right = section.ground.back()[0];
  const double largest = std::max({std::abs(left), std::abs(right), right - left});
  unit_ = std::pow(10.0, digits - 1 - static_cast<int>(std::floor(std::log10(largest))));
  sum_ = std::round(right * unit_) / unit_;
}

double Reflection::turn(double x) const {
  return std::round((sum_ - x) * unit_) / unit_;
}

void Reflection::turn(std::vector<Point>& line) const {
  for (Point& p : line) p[0] = turn(p[0]);
}

/// Reflects a line that runs from left to right.
void Reflection::turn_line(std::vector<Point>& line) const {
  turn(line);
  std::reverse(line.begin(), line.end());
}

/// Triangles are interpolated from their first corner: the order is that of mesh::ScatteredField.
void Reflection::turn_grid(PressureGrid& grid) const {
  turn(grid.nodes);
  const auto get = [&](int i) -> const Point& { return grid.nodes[static_cast<std::size_t>(i)]; };
  for (std::array<int, 3>& t : grid.triangles) {
    std::sort(t.begin(), t.end(), [&](int i, int j) { return get(i) < get(j); });
    const Point &a = get(t[0]), &b = get(t[1]), &c = get(t[2]);
    if ((b[0] - a[0]) * (c[1] - a[1]) < (c[0] - a[0]) * (b[1] - a[1])) std::swap(t[1], t[2]);
  }
}

Section Reflection::reflect(const Section& section) const {
  Section other = section;
  turn_line(other.ground);
  turn_line(other.water_table);
  for (auto& line : other.piezometric_lines) turn_line(line);
  for (Region& region : other.regions) turn(region.polygon);
  for (Soil& soil : other.soils) {
    if (!soil.law) continue;
    StrengthLaw law = *soil.law;
    law.find_tangent = [own = soil.law, mirror = *this](StrengthPlane plane) {
      plane.at[0] = mirror.sum_ - plane.at[0];
      plane.inclination = -plane.inclination;
      return own->find_tangent(plane);
    };
    for (double& inclination : law.weak_inclinations) inclination = -inclination;
    soil.law = std::make_shared<const StrengthLaw>(std::move(law));
  }
  if (other.pressure_grid) turn_grid(*other.pressure_grid);
  if (section.pressure_ratio)
    other.pressure_ratio = [own = section.pressure_ratio, sum = sum_](const Point& p) {
      return own({sum - p[0], p[1]});
    };
  for (Surcharge& surcharge : other.surcharges) {
    std::reverse(surcharge.load.begin(), surcharge.load.end());
    for (auto& [x, down, across] : surcharge.load) x = turn(x), across = -across;
  }
  for (FaceLoad& load : other.face_loads) load.x = turn(load.x), load.traction[0] = -load.traction[0];
  for (Slurry& slurry : other.slurries) {
    const auto [from, to] = turn(std::array{slurry.from, slurry.to});
    slurry.from = from, slurry.to = to;
  }
  for (RootCohesion& roots : other.roots) {
    const auto [from, to] = turn(std::array{roots.from, roots.to});
    roots.from = from, roots.to = to;
  }
  for (Bar& bar : other.bars) bar.head[0] = turn(bar.head[0]), bar.end[0] = turn(bar.end[0]);
  other.push = -section.push;
  if (section.drawdown) other.drawdown->before = std::make_shared<const Section>(reflect(*section.drawdown->before));
  return other;
}

EntryExitSearch Reflection::reflect(EntryExitSearch ranges) const {
  ranges.exit = turn(ranges.exit);
  ranges.entry = turn(ranges.entry);
  return ranges;
}

GridSearch Reflection::reflect(GridSearch grid) const {
  if (grid.from == grid.to) return grid;  // chosen from the ground
  const double left = turn(grid.to[0]);
  grid.to[0] = turn(grid.from[0]);
  grid.from[0] = left;
  return grid;
}

SearchOptions Reflection::reflect(SearchOptions options) const {
  if (options.grid) options.grid = reflect(*options.grid);
  if (options.entry_exit) options.entry_exit = reflect(*options.entry_exit);
  if (options.tangent) {
    turn_line(options.tangent->upper);
    turn_line(options.tangent->lower);
  }
  for (Surface& known : options.known) known = reflect(std::move(known));
  if (!options.checks.limits) return options;
  SurfaceLimits limits = *options.checks.limits;
  for (auto& polygon : limits.excluded) turn(polygon);
  for (Window& window : limits.passages) {
    turn(window.points);
    if (window.is_box) std::swap(window.points[0][0], window.points[1][0]);
  }
  limits.direction = -limits.direction;
  options.checks.limits = std::make_shared<const SurfaceLimits>(std::move(limits));
  return options;
}

Surface Reflection::reflect(Surface surface) const {
  if (surface.circle) surface.circle->centre[0] = sum_ - surface.circle->centre[0];
  const double from = sum_ - surface.to;
  surface.to = sum_ - surface.from;
  surface.from = from;
  for (Point& p : surface.line) p[0] = sum_ - p[0];
  std::reverse(surface.line.begin(), surface.line.end());
  return surface;
}

TrialCircles Reflection::reflect(TrialCircles circles) const {
  for (Surface& surface : circles.surfaces) surface = reflect(std::move(surface));
  const std::array<double, 2> left = turn(circles.right);
  circles.right = turn(circles.left);
  circles.left = left;
  std::swap(circles.step[0], circles.step[1]);
  return circles;
}

}  // namespace talus::lem
