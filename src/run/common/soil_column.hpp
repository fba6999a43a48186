// SPDX-License-Identifier: MIT
#pragma once
// The soil above a point of a plane section, from which strengths by depth and by σ'_v follow in FEM, limit analysis
// and MPM as they do in LEM.

#include <memory>
#include <vector>

#include "base/vec.hpp"
#include "material/blocks.hpp"
#include "mesh/planar.hpp"
#include "site/site.hpp"

namespace talus::lem {
class Slope;
}

namespace talus::run {

class SoilColumns {
 public:
  /// Makes the section of the case if a soil has a strength by depth or σ'_v; else find() gives the place alone. Throws
  /// what make_section() throws.
  explicit SoilColumns(const site::Site& site);

  bool is_needed() const { return slope_ != nullptr; }
  /// Returns level, depth under the ground and σ'_v at a point as a plane of unknown inclination. σ'_v is the weight of
  /// soil, water and loads above less the pore pressure.
  StrengthPlane find(const Vec<2>& x) const;

  /// Returns the places between which σ'_v is linear in each soil, above and below the lines of list_water_lines() [m].
  std::vector<double> list_breaks() const;
  /// Returns the water table and the piezometric lines, in parts without vertical steps.
  std::vector<mesh::Polyline> list_water_lines() const;

 private:
  std::shared_ptr<const lem::Slope> slope_;
};

/// Writes x, and where they are needed depth and σ'_v at `x`, into the start of a state.
template <int D>
void add_column(const SoilColumns& columns, const Vec<D>& x, material::StateStart& start) {
  start.x = x[0];
  if (!columns.is_needed()) return;
  const StrengthPlane plane = columns.find({x[0], x[1]});
  start.depth = plane.depth;
  start.vertical = plane.vertical;
}

}  // namespace talus::run
