// SPDX-License-Identifier: MIT
#include "site/supports.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "input/case/support_places.hpp"

namespace talus::site {

namespace {

/// Sets tensile strength, bond, head and stiffness.
void set_tension(const input::Support& s, Bar& bar) {
  const double share = 1 / s.out_of_plane_spacing;
  const double adhesion = s.bond_adhesion.value_or(0), friction = s.bond_scale * std::tan(s.bond_friction.value_or(0));
  if (s.kind == input::SupportKind::geosynthetic) {
    const double width = s.coverage * (s.sides == input::BondSides::both ? 2 : 1);
    bar.tensile = s.coverage * s.strength;
    bar.plate = s.coverage * s.connection;
    bar.bond = width * adhesion;
    bar.bond_factor = width * friction;
    bar.stiffness = s.coverage * s.sheet_stiffness.value_or(0);
    return;
  }
  const double perimeter = std::numbers::pi * s.diameter.value_or(0);
  bar.tensile = share * s.tensile_strength;
  bar.plate = share * s.plate;
  bar.bond = share * s.bond.value_or(perimeter * adhesion);
  bar.bond_factor = s.bond ? 0 : share * perimeter * friction;
  bar.prestress = share * s.prestress;
  bar.stiffness = share * s.axial_stiffness.value_or(0);
}

Bar make_bar(const std::string& name, const input::Support& s, const input::BarLine& line) {
  Bar bar;
  bar.support = name;
  bar.row = line.row;
  bar.kind = s.kind;
  bar.head = line.head;
  bar.end = line.end;
  bar.spacing = s.out_of_plane_spacing;
  bar.diameter = s.diameter.value_or(0);
  bar.is_active = s.is_active();
  bar.direction = s.find_direction();
  set_tension(s, bar);
  if (s.kind == input::SupportKind::bolt) bar.plate = std::numeric_limits<double>::infinity();
  if (s.kind == input::SupportKind::anchor)
    bar.free_length = s.free_length ? *s.free_length : line.length() - *s.bond_length;
  const double share = 1 / s.out_of_plane_spacing;
  if (s.kind == input::SupportKind::wall) {
    bar.is_barrier = s.crossing == input::WallCrossing::excluded;
    if (!bar.is_barrier) bar.lateral = bar.shear = *s.shear_strength;
    if (s.shear_strength) bar.shear = *s.shear_strength;
    bar.weight = s.weight.value_or(0);
  }
  if (s.kind == input::SupportKind::pile) {
    bar.has_soil_pressure = s.lateral_law == input::LateralLaw::ito_matsui;
    bar.lateral = share * s.lateral_resistance.value_or(0);
    if (s.shear_strength) bar.shear = share * *s.shear_strength;
  }
  bar.bending = share * s.bending_stiffness.value_or(0);
  bar.moment = share * s.plastic_moment.value_or(0);
  return bar;
}

}  // namespace

double Bar::length() const {
  return std::hypot(end[0] - head[0], end[1] - head[1]);
}

std::vector<Bar> list_bars(const Site& site) {
  std::vector<Bar> bars;
  const input::Case& data = site.data();
  if (data.supports.empty()) return bars;
  const Polyline& ground = site.ground();
  if (ground.empty())
    throw Error(ExitCode::wrong_input,
                fmt::format("support '{}' needs a plane section of polygons or layers", data.supports.begin()->first));
  for (const auto& [name, support] : data.supports) {
    const input::BarLayout layout =
        data.construction.empty() ? input::lay_bars(support, ground, data.units().length) : input::lay_bars(data, name);
    if (!layout.fault.empty()) throw Error(ExitCode::wrong_input, fmt::format("support '{}': {}", name, layout.fault));
    for (const input::BarLine& line : layout.bars) bars.push_back(make_bar(name, support, line));
  }
  return bars;
}

std::string describe_sense(const input::Case& data) {
  std::string active, passive;
  for (const auto& [name, support] : data.supports) {
    std::string& list = support.is_active() ? active : passive;
    list += (list.empty() ? "'" : ", '") + name + "'";
  }
  if (active.empty() && passive.empty()) return "";
  if (passive.empty())
    return fmt::format("supports {} active: their forces are loads, which F does not divide", active);
  if (active.empty()) return fmt::format("supports {} passive: F divides their forces", passive);
  return fmt::format("supports {} active (loads, which F does not divide), {} passive (F divides their forces)", active,
                     passive);
}

}  // namespace talus::site
