// SPDX-License-Identifier: MIT
#pragma once
// Bodies for the tests of the MPM step: a mesh of a box, points in selected elements, and rollers.

#include <cmath>
#include <functional>
#include <vector>

#include "material/every_law.hpp"
#include "mesh/points.hpp"
#include "mpm/solver/build.hpp"
#include "mpm/solver/observe.hpp"
#include "reference/bodies.hpp"
#include "support/filling.hpp"
#include "support/points.hpp"

namespace talus::support {

template <int D>
using Start = std::type_identity_t<std::function<void(mpm::InitialPoint<D>&, const Vec<D>& x)>>;  ///< velocity, stress

struct Substance {
  material::Law law;
  double density = 1800;  ///< [kg/m³]
};

/// Points of equal volume (points_per_element as in mesh::point_positions) in the elements selected by `filling`.
template <int D>
mpm::Body<D> fill_body(mesh::Mesh<D> mesh, const std::vector<Substance>& substances, int points_per_element,
                       const Filling<D>& filling, const Start<D>& start = {}, int chunks = 0);

/// The constraint of a node, made if it has none.
template <int D>
mpm::Constraint<D>& get_constraint(mpm::Body<D>& body, std::size_t node) {
  int& index = body.conditions.constraint_of_node[node];
  if (index < 0) {
    index = static_cast<int>(body.conditions.constraints.size());
    body.conditions.constraints.emplace_back();
  }
  return body.conditions.constraints[static_cast<std::size_t>(index)];
}

/// Prescribes `velocity` [m/s] times `factor` at the node, replacing earlier constraints.
template <int D>
void move_node(mpm::Body<D>& body, std::size_t node, const Vec<D>& velocity, const input::TimeTable& factor = {}) {
  mpm::Constraint<D>& c = get_constraint(body, node);
  c = {};
  c.fixed_count = D;
  for (std::size_t d = 0; d < D; ++d) c.fixed[d][d] = 1;
  c.drive = velocity;
  c.factor = static_cast<int>(body.conditions.factors.size());
  body.conditions.factors.push_back(factor);
}

/// Suppresses motion along the axis `component` at every node that `chosen` accepts.
template <int D>
void fix_nodes(mpm::Body<D>& body, int component,
               const std::type_identity_t<std::function<bool(const Vec<D>&)>>& chosen);

/// Rollers on the faces of the box [0, size] except the upper end of `open_axis`.
template <int D>
void fix_faces(mpm::Body<D>& body, const Vec<D>& size, int open_axis) {
  for (int d = 0; d < D; ++d) {
    const std::size_t s = static_cast<std::size_t>(d);
    fix_nodes<D>(body, d, [&](const Vec<D>& x) { return std::abs(x[s]) < 1e-9; });
    if (d != open_axis) fix_nodes<D>(body, d, [&](const Vec<D>& x) { return std::abs(x[s] - size[s]) < 1e-9; });
  }
}

/// A regular (jitter 0) or jittered mesh of the box from 0 to `size` [m].
template <int D>
mesh::Mesh<D> make_mesh(const std::array<int, D>& cells, const std::type_identity_t<Vec<D>>& size,
                        double jitter = 0.15) {
  return reference::make_box<D>(cells, size, jitter);
}

/// Steps `count` times.
template <int D>
void run_steps(mpm::Body<D>& body, const mpm::StepOptions<D>& options, int count) {
  for (int n = 0; n < count; ++n) mpm::step(body, options);
}

/// Every combination of integration and smoothing, with its name.
struct Mode {
  std::string name;
  bool mixed;
  input::Smoothing smoothing;
};
std::vector<Mode> all_modes();

}  // namespace talus::support
