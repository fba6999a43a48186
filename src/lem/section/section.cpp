// SPDX-License-Identifier: MIT
// Faults of a section that no surface could be calculated in: ground, soils, water and loads.

#include "lem/section/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"
#include "lem/section/region_faults.hpp"

namespace talus::lem {

namespace {

using Faults = std::vector<std::string>;

template <std::size_t N>
bool is_finite(const std::array<double, N>& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
}

/// A line that must run to the right. `steps`: vertical pieces are allowed.
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
      faults.push_back(
          fmt::format("the base at elevation {:.6g} lies above the ground at {}", section.base, format_point(p)));
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
  if (soil.cohesion == 0 && soil.friction_angle == 0 && !(soil.cohesion_gradient > 0))
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
    faults.push_back(
        fmt::format("the tension crack is {:.6g} m deep with {:.6g} m of water: expected 0 <= water <= depth",
                    section.crack->depth, section.crack->water));
}

void check_drawdown(const Section& section, Faults& faults) {
  if (!section.drawdown) return;
  const Section* before = section.drawdown->before.get();
  if (before == nullptr || before->drawdown || before->ground != section.ground || before->base != section.base ||
      before->soils.size() != section.soils.size() || before->regions.size() != section.regions.size())
    faults.push_back("the section before drawdown is not the one after it with other water");
}

}  // namespace

bool holds_water(const Section& section, const Soil& soil) {
  if (!section.drawdown) return false;
  return section.drawdown->method == DrawdownMethod::b_bar ? soil.b_bar.has_value() : soil.envelope.has_value();
}

double find_relief(const Section& section) {
  const auto [low, high] = std::minmax_element(section.ground.begin(), section.ground.end(),
                                               [](const Point& a, const Point& b) { return a[1] < b[1]; });
  return section.ground.empty() ? 0 : (*high)[1] - (*low)[1];
}

std::vector<std::string> find_faults(const Section& section) {
  Faults faults;
  check_ground(section, faults);
  for (std::size_t i = 0; i < section.soils.size(); ++i) check_soil(section.soils[i], i, faults);
  check_water(section, faults);
  check_loads(section, faults);
  check_drawdown(section, faults);
  // What follows walks along the ground, which must be whole for that.
  if (faults.empty()) find_region_faults(section, faults);
  return faults;
}

Section::Section() = default;
Section::Section(const Section&) = default;
Section::Section(Section&&) noexcept = default;
Section& Section::operator=(const Section&) = default;
Section& Section::operator=(Section&&) noexcept = default;
Section::~Section() = default;

}  // namespace talus::lem
