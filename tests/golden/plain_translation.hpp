// SPDX-License-Identifier: MIT
#pragma once
// Converts bodies and options of the plain step to those of the MPM step, for comparison.

#include <string>
#include <vector>

#include "material/every_law.hpp"
#include "mpm/solver/build.hpp"
#include "reference/bodies.hpp"
#include "reference/plain_mpm.hpp"

namespace talus::golden {

inline material::Law translate(const reference::Material& m) {
  const auto elastic = material::LinearElastic::from_young(m.young_modulus, m.poisson_ratio);
  if (!m.plastic) return elastic;
  return material::MohrCoulomb(elastic, {m.cohesion, m.friction_angle, m.dilatancy_angle, m.tensile_strength});
}

/// The same body for the engine.
template <int D>
mpm::Body<D> translate(const reference::Body<D>& plain, int chunks) {
  std::vector<mpm::InitialPoint<D>> points;
  std::vector<int> in_element(plain.mesh.elements.size(), 0);
  constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
  for (const reference::Point<D>& p : plain.points) {
    mpm::InitialPoint<D> q;
    q.element = p.element;
    const auto n = reference::shape_functions(plain.mesh, p.element, p.x);
    for (int d = 0; d < D; ++d) {
      q.xi[d] = n[d + 1];
      q.velocity[d] = p.v[d];
    }
    for (std::size_t i = 0; i < q.stress.size(); ++i) q.stress[i] = p.sigma(row[i], column[i]);
    q.mass = p.mass;
    q.volume = p.volume;
    q.material = p.material;
    points.push_back(q);
    ++in_element[p.element];
  }
  std::vector<material::Law> laws;
  std::vector<std::string> names;
  for (const reference::Material& m : plain.materials) {
    laws.push_back(translate(m));
    names.push_back("soil");
  }
  mpm::Body<D> body = mpm::make_body<D>(mpm::make_layout<D>(plain.mesh, in_element, chunks), laws, names, points);
  for (std::size_t i = 0; i < plain.constraints.size(); ++i) {
    const reference::Constraint<D>& c = plain.constraints[i];
    mpm::Constraint<D> constraint;
    for (int d = 0; d < D; ++d) {
      if (c.fixed[d]) constraint.fixed[constraint.fixed_count++][d] = 1;
    }
    if (c.normal.norm() > 0) {
      Vec<D> n;
      for (int d = 0; d < D; ++d) n[d] = c.normal[d];
      constraint.fixed[constraint.fixed_count++] = n;
    }
    if (constraint.fixed_count == 0) continue;
    if (c.drive.norm() > 0) {
      body.conditions.factors.resize(1);
      constraint.factor = 0;
      for (int d = 0; d < D; ++d) constraint.drive[d] = c.drive[d];
    }
    body.conditions.constraint_of_node[i] = static_cast<int>(body.conditions.constraints.size());
    body.conditions.constraints.push_back(constraint);
  }
  return body;
}

struct PlainVariant {
  std::string name;
  bool mixed;
  reference::Smoothing smoothing;
  bool objective;
  bool frozen;
  double mass_scaling;
  int filter_interval = 0;
  bool comes_apart = false;
};

inline input::Smoothing translate(reference::Smoothing s) {
  switch (s) {
    case reference::Smoothing::none:
      return input::Smoothing::none;
    case reference::Smoothing::strain:
      return input::Smoothing::strain;
    case reference::Smoothing::stable:
      return input::Smoothing::stable;
  }
  return input::Smoothing::none;
}

inline std::vector<PlainVariant> all_variants() {
  using enum reference::Smoothing;
  return {{"points", false, none, false, false, 1},       {"points objective", false, none, true, false, 1},
          {"mixed", true, none, true, false, 1},          {"mixed scaled", true, none, true, false, 4},
          {"smoothed", false, strain, true, false, 1},    {"mixed smoothed", true, strain, true, false, 1},
          {"stable", false, stable, true, false, 1},      {"mixed stable", true, stable, true, false, 1},
          {"frozen stable", true, stable, true, true, 1}, {"frozen", true, none, false, true, 1},
          {"fading", true, stable, true, false, 1, 16}};
}

/// Sheared, so that points change their elements within the few steps of a test.
template <int D>
reference::Body<D> set_in_motion(reference::Body<D> body) {
  for (auto& p : body.points) p.v[0] = p.x[1];
  return body;
}

}  // namespace talus::golden
