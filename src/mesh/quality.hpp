// SPDX-License-Identifier: MIT
#pragma once
// How well shaped a mesh is, in the few numbers that a user needs.

#include "mesh/mesh.hpp"

namespace talus::mesh {

/// Shape of the elements looked at.
template <int D>
struct Quality {
  int element_count = 0;
  double min_altitude = 0;      ///< governs the time step [m]
  double mean_altitude = 0;     ///< [m]
  double mean_size = 0;         ///< edge of the regular element of the mean volume [m]
  double min_angle = 0;         ///< smallest angle of a triangle or dihedral angle of a tetrahedron [rad]
  double min_radius_ratio = 0;  ///< D × radius of the inscribed over the circumscribed ball [-]; 1 when equilateral
  int worst_element = -1;       ///< the element of min_altitude
  std::array<double, D> worst_place{};  ///< its centroid [m]
};

/// Measures the elements that hold soil (or all of them, with `soil_only` false).
/// With no such element the counts are zero and worst_element is -1.
template <int D>
Quality<D> measure_quality(const Mesh<D>& mesh, bool soil_only = true);

}  // namespace talus::mesh
