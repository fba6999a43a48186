// SPDX-License-Identifier: MIT
#pragma once
// Converts a body of the plain two-velocity step to one of the MPM step.

#include <string>
#include <vector>

#include "material/every_law.hpp"
#include "mpm/solver/build.hpp"
#include "reference/two_phase_bodies.hpp"

namespace talus::golden {

template <int D>
Vec<D> to_vec(const reference::Vector<D>& x) {
  Vec<D> y{};
  for (int d = 0; d < D; ++d) y[d] = x[d];
  return y;
}

/// Orthonormal directions that a constraint holds; its normal must be normal to its fixed components.
template <int D, class Constraint>
Constraint translate_directions(const reference::Constraint<D>& plain) {
  Constraint c;
  for (int d = 0; d < D; ++d)
    if (plain.fixed[d]) c.fixed[c.fixed_count++][d] = 1;
  if (plain.normal.norm() > 0) c.fixed[c.fixed_count++] = to_vec<D>(plain.normal);
  return c;
}

inline material::Law translate(const reference::Material& m) {
  const auto elastic = material::LinearElastic::from_young(m.young_modulus, m.poisson_ratio);
  if (!m.plastic) return elastic;
  return material::MohrCoulomb(elastic, {m.cohesion, m.friction_angle, m.dilatancy_angle, m.tensile_strength});
}

/// `curves` are those that the soil's water follows, see reference::set_curves().
inline mpm::WaterLaw translate(const reference::Soil& soil, const reference::Curves& curves) {
  mpm::WaterLaw law;
  law.wet = soil.wet;
  law.grain_density = soil.grain_density;
  law.density = soil.water.density;
  law.bulk_modulus = soil.water.bulk_modulus;
  law.conductivity = soil.water.conductivity;
  law.drag_gravity = soil.water.drag_gravity;
  law.retention = curves.retention;
  law.relative = curves.relative;
  law.chi_air_entry = soil.water.chi_air_entry;
  return law;
}

template <int D>
mpm::SurfaceCondition translate(const reference::SurfaceCondition<D>& plain) {
  mpm::SurfaceCondition condition;
  double value = 0;
  switch (plain.kind) {
    case reference::SurfaceKind::open:
      condition.kind = mpm::SurfaceKind::open;
      break;
    case reference::SurfaceKind::seepage:
      condition.kind = mpm::SurfaceKind::seepage;
      break;
    case reference::SurfaceKind::rain:
      condition.kind = mpm::SurfaceKind::rain;
      condition.vertical = plain.rain.norm() > 0;
      condition.suction_limit = plain.suction_limit;
      value = plain.rain.norm() + plain.normal_rain - plain.evaporation;  // only one of them is not zero
      break;
    case reference::SurfaceKind::flux:
    case reference::SurfaceKind::closed:
      condition.kind = mpm::SurfaceKind::flux;
      value = plain.kind == reference::SurfaceKind::flux ? plain.inflow : 0.0;
      break;
    case reference::SurfaceKind::head:
      condition.kind = mpm::SurfaceKind::head;
      value = plain.head;
      break;
    case reference::SurfaceKind::pressure:
      condition.kind = mpm::SurfaceKind::pressure;
      value = plain.pressure;
      break;
  }
  condition.value = {{0.0}, {value}};
  return condition;
}

/// Gives every node its condition; equal ones are one condition of the engine.
template <int D>
void translate_surface(const reference::WetBody<D>& plain, mpm::Body<D>& body) {
  std::vector<mpm::SurfaceCondition>& found = body.water.surfaces;
  found.clear();
  body.water.surface_of_node.assign(plain.mesh.nodes.size(), 0);
  for (std::size_t i = 0; i < plain.mesh.nodes.size(); ++i) {
    mpm::SurfaceCondition c = translate(reference::surface_condition(plain, static_cast<int>(i)));
    std::size_t number = 0;
    while (number < found.size() &&
           (found[number].kind != c.kind || found[number].value.value != c.value.value ||
            found[number].vertical != c.vertical || found[number].suction_limit != c.suction_limit))
      ++number;
    c.name = "surface " + std::to_string(number);
    if (number == found.size()) found.push_back(c);
    body.water.surface_of_node[i] = static_cast<int>(number);
  }
  body.water.budgets.assign(found.size(), {});
}

/// The same body for the engine, cut into `chunks`.
template <int D>
mpm::Body<D> translate(const reference::WetBody<D>& plain, const reference::Curves& curves, int chunks) {
  std::vector<mpm::InitialPoint<D>> points;
  std::vector<int> in_element(plain.mesh.elements.size(), 0);
  constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
  for (const reference::WetPoint<D>& p : plain.points) {
    mpm::InitialPoint<D> q;
    q.element = p.element;
    const auto n = reference::shape_functions(plain.mesh, p.element, p.x);
    for (int d = 0; d < D; ++d) q.xi[d] = n[d + 1];
    q.velocity = to_vec<D>(p.v);
    q.water_velocity = to_vec<D>(p.w);
    for (std::size_t i = 0; i < q.stress.size(); ++i) q.stress[i] = p.sigma(row[i], column[i]);
    q.mass = p.mass;
    q.volume = p.volume;
    q.material = p.material;
    q.pressure = p.pressure;
    points.push_back(q);
    ++reference::at(in_element, p.element);
  }
  std::vector<material::Law> laws;
  std::vector<std::string> names;
  std::vector<mpm::WaterLaw> water;
  for (const reference::Soil& soil : plain.soils) {
    laws.push_back(translate(soil.skeleton));
    names.push_back("soil");
    water.push_back(translate(soil, curves));
  }
  mpm::Body<D> body =
      mpm::make_body<D>(mpm::make_layout<D>(plain.mesh, in_element, chunks), laws, names, points, water);
  body.water.constraint_of_node.assign(plain.mesh.nodes.size(), -1);
  for (std::size_t i = 0; i < plain.mesh.nodes.size(); ++i) {
    auto solid = translate_directions<D, mpm::Constraint<D>>(plain.solid_constraints[i]);
    if (plain.solid_constraints[i].drive.norm() > 0) {
      body.conditions.factors.resize(1);
      solid.factor = 0;
      solid.drive = to_vec<D>(plain.solid_constraints[i].drive);
    }
    const auto held = translate_directions<D, mpm::WaterConstraint<D>>(plain.water_constraints[i]);
    if (solid.fixed_count > 0) {
      body.conditions.constraint_of_node[i] = static_cast<int>(body.conditions.constraints.size());
      body.conditions.constraints.push_back(solid);
    }
    if (held.fixed_count > 0) {
      body.water.constraint_of_node[i] = static_cast<int>(body.water.constraints.size());
      body.water.constraints.push_back(held);
    }
  }
  translate_surface(plain, body);
  return body;
}

template <int D>
mpm::StepOptions<D> translate(const reference::WetSettings& s, const reference::WetBody<D>& plain) {
  mpm::StepOptions<D> o;
  o.dt = s.time_step;
  o.gravity = to_vec<D>(plain.gravity);
  o.damping = s.damping;
  o.water_damping = s.water_damping;
  o.net_damping = s.damped_force == reference::DampedForce::net;
  o.mass_scaling = s.mass_scaling;
  o.mixed = s.mixed;
  o.smoothing = s.smoothing == reference::Smoothing::none     ? input::Smoothing::none
                : s.smoothing == reference::Smoothing::strain ? input::Smoothing::strain
                                                              : input::Smoothing::stable;
  o.moving = !s.frozen;
  o.objective = s.objective;
  o.implicit_drag = s.drag == reference::Drag::implicit_at_nodes;
  o.smooth_pressure = s.smooth_pressure;
  o.exchange_water = s.exchange_water;
  return o;
}

}  // namespace talus::golden
