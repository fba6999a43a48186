// SPDX-License-Identifier: MIT
#pragma once
// Models for FEM: meshes of polygons, sides by position, Mohr–Coulomb soil.

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "fem/solid/solid.hpp"
#include "material/every_law.hpp"
#include "mesh/generate.hpp"

namespace talus::support {

inline constexpr double degree = 0.017453292519943295;

/// Sides of the soil's border, with no soil across, whose nodes all satisfy `wanted`.
template <int D>
std::vector<std::array<int, D>> find_sides(const mesh::Mesh<D>& mesh, const std::function<bool(const Vec<D>&)>& wanted);

template <int D>
std::vector<std::array<int, D>> find_sides_at(const mesh::Mesh<D>& mesh, std::size_t axis, double value);

/// Holds one axis of the sides at a coordinate plane.
template <int D>
void add_roller(fem::SolidModel<D>& model, std::size_t axis, double value);

/// The same traction on all of the sides [Pa].
template <int D>
void add_load(fem::SolidModel<D>& model, const std::vector<std::array<int, D>>& sides, const Vec<D>& traction);

/// One load step to a residual of 1e-8, on one thread.
inline fem::SolidOptions make_tight() {
  fem::SolidOptions options;
  options.force_tolerance = 1e-8;
  options.load_steps = 1;
  options.threads = 1;
  return options;
}

/// A homogeneous slope or block: the polygon of the soil and its Mohr–Coulomb parameters; tension up to the apex.
struct SoilSection {
  std::vector<std::array<double, 2>> polygon;
  double cohesion = 0, friction = 0, dilatancy = 0;  ///< [Pa, degrees]
  double unit_weight = 0;
  double young = 1e7, poisson = 0.3;
  double size = 1;       ///< of the elements [m]
  double thickness = 0;  ///< 3D
};

material::MohrCoulombStrength find_strength(const SoilSection& s);

/// Mesh and model; the base is fixed, walls are rollers. Not to be moved: the model points to the mesh.
template <int D>
struct SolidSlope {
  mesh::Mesh<D> mesh;
  fem::SolidModel<D> model;

  explicit SolidSlope(const SoilSection& s) {
    mesh::Plan plan;
    plan.dimension = D;
    plan.box_min = plan.box_max = s.polygon[0];
    for (const auto& p : s.polygon)
      for (std::size_t d = 0; d < 2; ++d) {
        plan.box_min[d] = std::min(plan.box_min[d], p[d]);
        plan.box_max[d] = std::max(plan.box_max[d], p[d]);
      }
    const auto low = plan.box_min, high = plan.box_max;
    plan.size = s.size;
    plan.thickness = s.thickness;
    plan.polygons = {{"soil", s.polygon}};
    mesh = mesh::generate<D>(plan);
    model.mesh = &mesh;
    model.make_law = [s](int, double factor) -> material::Law {
      return material::MohrCoulomb(material::LinearElastic::from_young(s.young, s.poisson),
                                   find_strength(s).reduced(factor));
    };
    model.unit_weight.assign(mesh.elements.size(), s.unit_weight);
    model.direction = {};
    model.direction[1] = -1;
    add_roller<D>(model, 0, low[0]);
    add_roller<D>(model, 0, high[0]);
    fem::Support<D> base;
    base.name = "base";
    base.sides = find_sides_at<D>(mesh, 1, low[1]);
    base.fixed.fill(true);
    model.supports.push_back(base);
    if constexpr (D == 3) {
      add_roller<3>(model, 2, 0);
      add_roller<3>(model, 2, s.thickness);
    }
  }
  SolidSlope(const SolidSlope&) = delete;
  SolidSlope& operator=(const SolidSlope&) = delete;
};

}  // namespace talus::support
