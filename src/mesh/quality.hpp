// SPDX-License-Identifier: MIT
#pragma once
// Quality measures of a mesh.

#include "mesh/mesh.hpp"

namespace talus::mesh {

/// Shape measures of a set of elements.
template <int D>
struct Quality {
  int element_count = 0;
  double min_altitude = 0;              ///< limits the time step [m]
  double mean_altitude = 0;             ///< [m]
  double mean_size = 0;                 ///< edge of the regular element with the mean volume [m]
  double min_angle = 0;                 ///< smallest angle of a triangle or dihedral angle of a tetrahedron [rad]
  double min_radius_ratio = 0;          ///< D × inradius over circumradius [-]; 1 if equilateral
  int worst_element = -1;               ///< the element with min_altitude
  std::array<double, D> worst_place{};  ///< its centroid [m]
};

/// Measures the elements with soil, or all elements if `soil_only` is false. Without any such element the counts are
/// zero and worst_element is -1.
template <int D>
Quality<D> measure_quality(const Mesh<D>& mesh, bool soil_only = true);

}  // namespace talus::mesh
