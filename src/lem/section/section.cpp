// SPDX-License-Identifier: MIT
// Validation of a section (ground, soils, water, loads), pore pressures from a grid of triangles, and loads on vertical
// steps of the ground.
#include "lem/section/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"
#include "lem/section/slope.hpp"

namespace talus::lem {

// Pore pressure at a point of a grid of triangles.

namespace {

struct Box {
  Point low{}, high{};
};

Box bound(const PressureGrid& grid, const std::array<int, 3>& triangle) {
  const Point& first = grid.nodes[static_cast<std::size_t>(triangle[0])];
  Box box{first, first};
  for (const int node : triangle)
    for (std::size_t d = 0; d < 2; ++d) {
      const double value = grid.nodes[static_cast<std::size_t>(node)][d];
      box.low[d] = std::min(box.low[d], value);
      box.high[d] = std::max(box.high[d], value);
    }
  return box;
}

}  // namespace

PressureLocator::PressureLocator(const PressureGrid& grid) {
  if (grid.triangles.empty()) return;
  std::vector<Box> boxes;
  for (const auto& triangle : grid.triangles) boxes.push_back(bound(grid, triangle));
  Point high = boxes[0].high;
  low_ = boxes[0].low;
  for (const Box& box : boxes)
    for (std::size_t d = 0; d < 2; ++d) {
      low_[d] = std::min(low_[d], box.low[d]);
      high[d] = std::max(high[d], box.high[d]);
    }
  const double width = std::max(high[0] - low_[0], 1e-12), height = std::max(high[1] - low_[1], 1e-12);
  const double count = static_cast<double>(boxes.size());
  size_ = std::max(std::sqrt(width * height / count), std::max(width, height) / 4000);
  columns_ = static_cast<int>(width / size_) + 1;
  rows_ = static_cast<int>(height / size_) + 1;
  std::vector<std::vector<int>> buckets(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    const auto step = [&](double v, std::size_t d) { return static_cast<int>((v - low_[d]) / size_); };
    for (int j = step(boxes[t].low[1], 1); j <= std::min(step(boxes[t].high[1], 1), rows_ - 1); ++j)
      for (int i = step(boxes[t].low[0], 0); i <= std::min(step(boxes[t].high[0], 0), columns_ - 1); ++i)
        buckets[find_bucket(i, j)].push_back(static_cast<int>(t));
  }
  first_.push_back(0);
  for (const auto& bucket : buckets) {
    for (const int t : bucket) {
      const auto& corner = grid.triangles[static_cast<std::size_t>(t)];
      const auto node = [&](std::size_t i) { return grid.nodes[static_cast<std::size_t>(corner[i])]; };
      const auto u = [&](std::size_t i) { return grid.pressure[static_cast<std::size_t>(corner[i])]; };
      const Point a = node(0), b = node(1), c = node(2);
      const double area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
      if (area == 0) continue;
      planes_.push_back({a,
                         {(c[1] - a[1]) / area, (a[0] - c[0]) / area},
                         {(a[1] - b[1]) / area, (b[0] - a[0]) / area},
                         u(0),
                         u(1) - u(0),
                         u(2) - u(0)});
    }
    first_.push_back(static_cast<int>(planes_.size()));
  }
}

std::optional<double> PressureLocator::find(const Point& p) const {
  if (empty()) return std::nullopt;
  // Points within rounding outside count as inside, so that the border of the model is not lost.
  const double x = (p[0] - low_[0]) / size_, y = (p[1] - low_[1]) / size_;
  if (!(x >= -1e-9 && y >= -1e-9 && x <= columns_ + 1e-9 && y <= rows_ + 1e-9)) return std::nullopt;
  const int i = std::clamp(static_cast<int>(x), 0, columns_ - 1), j = std::clamp(static_cast<int>(y), 0, rows_ - 1);
  const auto bucket = find_bucket(i, j);
  for (int k = first_[bucket]; k < first_[bucket + 1]; ++k)
    if (const auto u = read(planes_[static_cast<std::size_t>(k)], p)) return u;
  return std::nullopt;
}

std::optional<double> PressureLocator::read(const Plane& plane, const Point& p) {
  const double dx = p[0] - plane.corner[0], dy = p[1] - plane.corner[1];
  const double second = plane.second[0] * dx + plane.second[1] * dy;
  const double third = plane.third[0] * dx + plane.third[1] * dy;
  constexpr double hair = -1e-7;
  if (second < hair || third < hair || 1 - second - third < hair) return std::nullopt;
  return plane.pressure + second * plane.to_second + third * plane.to_third;
}

namespace {

using Faults = std::vector<std::string>;

template <std::size_t N>
bool is_finite(const std::array<double, N>& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
}

/// Checks a line whose x must not decrease. `steps`: vertical pieces are allowed.
template <std::size_t N>
void check_line(const std::string& name, const std::vector<std::array<double, N>>& line, bool steps, Faults& faults) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!is_finite(line[i])) {
      faults.push_back(fmt::format("{}: point {} is not a number", name, i + 1));
      return;
    }
    if (i > 0 && (line[i][0] < line[i - 1][0] || (!steps && line[i][0] == line[i - 1][0]))) {
      faults.push_back(fmt::format("{} runs backwards from {} to {}: x must {}", name, format_point(line[i - 1]),
                                   format_point(line[i]), steps ? "never fall" : "grow from point to point"));
      return;
    }
  }
}

void check_ground(const Section& section, Faults& faults) {
  if (section.ground.size() < 2) {
    faults.push_back("the ground has fewer than two points");
    return;
  }
  check_line("the ground", section.ground, true, faults);
  const Point &a = section.ground.front(), &b = section.ground.back();
  if (!(b[0] > a[0])) faults.push_back("the ground has no width: its first and last points have the same x");
  if (!std::isfinite(section.base)) faults.push_back("the base is not a number");
  for (const Point& p : section.ground)
    if (section.base > p[1] + 1e-9 * (b[0] - a[0])) {
      faults.push_back(fmt::format("the base at elevation {:.6g} lies above the ground at {}",
                                   section.base / section.units.length.si, format_point(p, section.units.length)));
      break;
    }
}

void check_soil(const Soil& soil, std::size_t number, Faults& faults) {
  const std::string name = soil.name.empty() ? fmt::format("soil {}", number + 1) : fmt::format("soil '{}'", soil.name);
  if (!(soil.unit_weight > 0))
    faults.push_back(fmt::format("{}: the unit weight {:.6g} is not positive", name, soil.unit_weight));
  if (!(soil.saturated_unit_weight > 0))
    faults.push_back(
        fmt::format("{}: the saturated unit weight {:.6g} is not positive", name, soil.saturated_unit_weight));
  if (!(soil.cohesion >= 0) || !std::isfinite(soil.cohesion_gradient) || !std::isfinite(soil.cohesion_level))
    faults.push_back(
        fmt::format("{}: the cohesion {:.6g} must not be negative, its growth must be a number", name, soil.cohesion));
  if (!(soil.friction_angle >= 0 && soil.friction_angle < std::numbers::pi / 2))
    faults.push_back(fmt::format("{}: the friction angle {:.4g}° must be at least 0° and less than 90°", name,
                                 soil.friction_angle * 180 / std::numbers::pi));
  if (!soil.law && soil.cohesion == 0 && soil.friction_angle == 0 && !(soil.cohesion_gradient > 0))
    faults.push_back(fmt::format("{} has no strength: cohesion and friction angle are both zero", name));
  if (!(soil.pore_pressure_ratio >= 0 && soil.pore_pressure_ratio < 1))
    faults.push_back(
        fmt::format("{}: r_u = {:.4g} must be at least 0 and less than 1", name, soil.pore_pressure_ratio));
  if (soil.suction == Suction::saturation && !soil.saturation)
    faults.push_back(fmt::format("{}: strength of suction by saturation needs a retention curve", name));
  if (!(soil.phi_b >= 0 && soil.phi_b < std::numbers::pi / 2) || !(soil.largest_suction >= 0))
    faults.push_back(
        fmt::format("{}: phi_b must be at least 0° and less than 90°, the largest suction not negative", name));
  if (soil.envelope && !(soil.envelope->cohesion >= 0 && soil.envelope->friction_angle >= 0 &&
                         soil.envelope->friction_angle < std::numbers::pi / 2 && soil.friction_angle > 0))
    faults.push_back(
        fmt::format("{}: an undrained envelope needs c_R of at least 0, φ_R from 0° to less than 90°, and a friction "
                    "angle of its own above 0°",
                    name));
  if (soil.b_bar && !(*soil.b_bar >= 0 && *soil.b_bar <= 1))
    faults.push_back(fmt::format("{}: B̄ = {:.4g} must be between 0 and 1", name, *soil.b_bar));
}

void check_grid(const PressureGrid& grid, Faults& faults) {
  if (grid.pressure.size() != grid.nodes.size())
    faults.push_back(
        fmt::format("the pore pressure grid has {} nodes and {} pressures", grid.nodes.size(), grid.pressure.size()));
  for (std::size_t t = 0; t < grid.triangles.size(); ++t)
    for (const int node : grid.triangles[t])
      if (node < 0 || node >= static_cast<int>(grid.nodes.size())) {
        faults.push_back(
            fmt::format("triangle {} of the pore pressure grid names node {}, which is not there", t, node));
        return;
      }
}

void check_water(const Section& section, Faults& faults) {
  check_line("the water table", section.water_table, false, faults);
  for (const std::vector<Point>& line : section.piezometric_lines)
    check_line("a piezometric line", line, false, faults);
  if (!(section.water_unit_weight > 0)) faults.push_back("the unit weight of water is not positive");
  if (section.pressure_grid) check_grid(*section.pressure_grid, faults);
}

void check_loads(const Section& section, Faults& faults) {
  for (std::size_t i = 0; i < section.surcharges.size(); ++i)
    check_line(fmt::format("surcharge {}", i + 1), section.surcharges[i].load, true, faults);
  for (std::size_t i = 0; i < section.roots.size(); ++i)
    check_line(fmt::format("the root cohesion's profile {}", i + 1), section.roots[i].profile, true, faults);
  if (!std::isfinite(section.horizontal_acceleration) || !(section.vertical_acceleration > -1))
    faults.push_back(
        "the accelerations must be numbers, and k_v greater than -1: upwards they would lift the soil off");
  if (section.crack &&
      !(section.crack->depth >= 0 && section.crack->water >= 0 && section.crack->water <= section.crack->depth))
    faults.push_back(fmt::format("the tension crack is {} deep with {} of water: expected 0 <= water <= depth",
                                 format_value(section.crack->depth, section.units.length),
                                 format_value(section.crack->water, section.units.length)));
}

void check_drawdown(const Section& section, Faults& faults) {
  if (!section.drawdown) return;
  const Section* before = section.drawdown->before.get();
  if (before == nullptr || before->drawdown || before->ground != section.ground || before->base != section.base ||
      before->soils.size() != section.soils.size() || before->regions.size() != section.regions.size())
    faults.push_back("the section before drawdown is not the one after it with other water");
}

}  // namespace

StrengthTangent find_strength(const Soil& soil, const StrengthPlane& plane) {
  if (soil.law) return soil.law->find_tangent(plane);
  return {soil.cohesion + soil.cohesion_gradient * std::max(0.0, soil.cohesion_level - plane.at[1]),
          std::tan(soil.friction_angle)};
}

bool holds_water(const Section& section, const Soil& soil) {
  if (!section.drawdown) return false;
  return section.drawdown->method == DrawdownMethod::b_bar ? soil.b_bar.has_value() : soil.envelope.has_value();
}

double find_relief(const Section& section) {
  const auto [low, high] = std::minmax_element(section.ground.begin(), section.ground.end(),
                                               [](const Point& a, const Point& b) { return a[1] < b[1]; });
  constexpr double level = 0.05;
  if (section.ground.empty()) return 0;
  const double relief = (*high)[1] - (*low)[1];
  return std::isfinite(section.base) ? std::max(relief, level * ((*high)[1] - section.base)) : relief;
}

std::vector<std::string> find_faults(const Section& section) {
  Faults faults;
  check_ground(section, faults);
  for (std::size_t i = 0; i < section.soils.size(); ++i) check_soil(section.soils[i], i, faults);
  check_water(section, faults);
  check_loads(section, faults);
  check_drawdown(section, faults);
  // The check of the regions walks along the ground, which must be free of faults.
  if (faults.empty()) find_region_faults(section, faults);
  return faults;
}

}  // namespace talus::lem
