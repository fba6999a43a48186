// SPDX-License-Identifier: MIT
#pragma once
// Boundary conditions in the form that the step uses: per constrained node and per traction, resolved from the names of
// the case.

#include <cstdint>
#include <type_traits>
#include <vector>

#include "base/vec.hpp"
#include "input/language/time_table.hpp"

namespace talus::mpm {

/// Constraint of one node (theory 8): no motion along the `fixed` unit vectors (orthonormal, the first `fixed_count`)
/// other than that of the support, and none into a frictional wall.
template <int D>
struct Constraint {
  int fixed_count = 0;
  Vec<D> fixed[D]{};
  Vec<D> drive{};   ///< velocity of the support [m/s], in the span of `fixed`, at factor 1
  int factor = -1;  ///< index into Conditions::factors; -1: the support does not move
  bool has_wall = false;
  Vec<D> wall_normal{};  ///< unit, out of the soil
  double friction = 0;   ///< Coulomb's μ of the wall [-]
};

/// A traction: nodal forces of mesh sides, or forces carried by points, both at factor 1.
template <int D>
struct Load {
  struct Entry {
    int index;     ///< node, or point
    Vec<D> force;  ///< [N]
  };
  bool on_points = false;
  std::vector<Entry> entries;
  input::TimeTable factor;
};

template <int D>
struct Conditions {
  std::vector<int> constraint_of_node;     ///< index into constraints, or -1
  std::vector<Constraint<D>> constraints;  ///< each belongs to one node
  std::vector<std::uint8_t> pressed;  ///< by constraint: the wall stopped the node in the accelerations of this step
  std::vector<input::TimeTable> factors;  ///< over time, of moving supports
  std::vector<Load<D>> loads;
};

/// Velocity [m/s] of a node's support at time `t` [s]. C: Conditions, or those on a GPU.
template <class C, int D>
TALUS_PORTABLE Vec<D> find_drive(const C& conditions, const Constraint<D>& c, double t) {
  if (c.factor < 0) return {};
  const double f = conditions.factors[static_cast<std::size_t>(c.factor)].at(t);
  Vec<D> v = c.drive;
  for (int d = 0; d < D; ++d) v[d] *= f;
  return v;
}

/// Admissible velocity [m/s] of a node at time `t` [s] that would move with `wanted` without the constraint (T8.1).
template <class C, int D>
TALUS_PORTABLE Vec<D> constrain_velocity(const C& conditions, const Constraint<D>& c,
                                         std::type_identity_t<Vec<D>> wanted, double t) {
  if (c.has_wall) {
    const double into = dot(wanted, c.wall_normal);
    if (into > 0) {  // the wall stops the normal motion; its friction is at most μ times that impulse
      Vec<D> along = wanted;
      for (int d = 0; d < D; ++d) along[d] -= into * c.wall_normal[d];
      const double speed = norm(along);
      const double keep = speed > c.friction * into ? 1 - c.friction * into / speed : 0;
      for (int d = 0; d < D; ++d) wanted[d] = along[d] * keep;
    }
  }
  for (int k = 0; k < c.fixed_count; ++k) {
    const double along = dot(wanted, c.fixed[k]);
    for (int d = 0; d < D; ++d) wanted[d] -= along * c.fixed[k][d];
  }
  const Vec<D> given = find_drive(conditions, c, t);
  for (int d = 0; d < D; ++d) wanted[d] += given[d];
  return wanted;
}

}  // namespace talus::mpm
