// SPDX-License-Identifier: MIT
#pragma once
// The slope of yardstick_case.hpp with pore water, as in the two-phase program of the yardstick: hydrostatic pressure
// below the water level, suction above it, free surfaces without a condition on the water, and impermeable walls.

#include "material/every_law.hpp"
#include "yardstick_case.hpp"

namespace talus::bench {

inline mpm::WaterLaw yardstick_water(double grain_density, bool saturated) {
  mpm::WaterLaw law;
  law.wet = true;
  law.grain_density = grain_density;
  law.density = 1000;
  law.bulk_modulus = 5e7;  // reduced, so that the time step is that of the yardstick
  law.conductivity = 1e-3;
  law.drag_gravity = yardstick_gravity;
  if (saturated) return law;  // S = 1 at any suction
  law.retention = material::VanGenuchten{0.1, 1.0, 5e3, 0.4};
  law.relative = material::Mualem{0.4, material::SaturationMeasure::effective, 1, 1, true};
  return law;
}

/// Returns the wet case, ready for the first step. With `saturated`, S = 1 also above the level. `chunks` as in
/// make_layout(); `rooted` selects the rooted-soil model instead of Mohr–Coulomb.
template <int D>
Yardstick<D> make_wet_yardstick(const std::string& name, int chunks, bool saturated, bool rooted = false) {
  const YardstickCase c = yardstick_case<D>(name);
  constexpr double grain_density = 2650, porosity = 0.35;
  const YardstickSoil soil{1e7, 0.3, (1 - porosity) * grain_density, 5e3, 30 * std::numbers::pi / 180, 0.6};
  const mpm::WaterLaw water = yardstick_water(grain_density, saturated);
  mesh::Mesh<D> mesh = make_yardstick_mesh<D>(c);
  YardstickFill<D> fill = fill_slope(mesh, c, soil);
  const double level = 0.55 * c.cells[1] * c.size;
  for (mpm::InitialPoint<D>& point : fill.points)
    point.pressure = -water.density * yardstick_gravity * (level - mesh::to_global(mesh, point.element, point.xi)[1]);

  material::Law law = soil.law();
  if (rooted) law = plant_roots(fill.points, soil.elastic().constrained_modulus(), soil.poisson);
  Yardstick<D> y;
  y.body = mpm::make_body<D>(mpm::make_layout<D>(std::move(mesh), fill.in_element, chunks), {law}, {"soil"},
                             fill.points, {water});
  hold_grains(y.body, c);
  mpm::Water<D>& w = y.body.water;
  for (std::size_t i = 0; i < y.body.mesh().nodes.size(); ++i) {
    const mpm::Constraint<D> held = hold_at_walls<D>(y.body.mesh().nodes[i], c);
    if (held.fixed_count == 0) continue;
    mpm::WaterConstraint<D> constraint;
    constraint.fixed_count = held.fixed_count;
    std::copy(held.fixed, held.fixed + D, constraint.fixed);
    w.constraint_of_node[i] = static_cast<int>(w.constraints.size());
    w.constraints.push_back(constraint);
  }
  for (mpm::SurfaceCondition& surface : w.surfaces) surface.kind = mpm::SurfaceKind::open;

  const double size = c.size * (D == 3 ? 0.6 : 1);
  const double stiffness = soil.elastic().constrained_modulus() + water.bulk_modulus / porosity;
  y.options.dt = 0.2 * size / std::sqrt(stiffness / soil.density);
  y.options.gravity[1] = -yardstick_gravity;
  y.options.damping = y.options.water_damping = 0.05;
  y.options.net_damping = false;  // as in the yardstick, also the next line
  y.options.objective = false;
  mpm::gather_nodal_sums(y.body, y.options);
  return y;
}

}  // namespace talus::bench
