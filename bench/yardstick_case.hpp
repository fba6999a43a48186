// SPDX-License-Identifier: MIT
#pragma once
// The benchmark slope: a box filled to a slope profile that fails and runs out. All numbers are those of the yardstick,
// the prototype with which docs/performance.md compares.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "material/every_law.hpp"
#include "mpm/solver/build.hpp"
#include "rooted_soil.hpp"
#include "yardstick_mesh.hpp"

namespace talus::bench {

inline constexpr double yardstick_gravity = 9.81;  ///< [m/s²]

/// Soil parameters and initial stress of the slope.
struct YardstickSoil {
  double young, poisson;      ///< E [Pa], ν [-]
  double density;             ///< dry density [kg/m³]
  double cohesion, friction;  ///< c [Pa], φ [rad]; the tensile strength is that of the apex, as in the yardstick
  double stress_share = 1;    ///< initial effective stress over the dry overburden and its K0 part [-]

  material::LinearElastic elastic() const { return material::LinearElastic::from_young(young, poisson); }
  material::MohrCoulomb law() const {
    return material::MohrCoulomb(elastic(), {cohesion, friction, 0, cohesion / std::tan(friction)});
  }
};

template <int D>
struct YardstickFill {
  std::vector<mpm::InitialPoint<D>> points;
  std::vector<int> in_element;  ///< number of points by element
};

/// Fills the elements that lie lowest relative to the slope profile.
template <int D>
YardstickFill<D> fill_slope(const mesh::Mesh<D>& mesh, const YardstickCase& c, const YardstickSoil& soil) {
  const double length = c.cells[0] * c.size, height = c.cells[1] * c.size;
  const auto ground = [&](double x) {
    const double x1 = 0.38 * length, x2 = 0.56 * length, h1 = 0.86 * height, h2 = 0.40 * height;
    return x < x1 ? h1 : (x > x2 ? h2 : h1 + (h2 - h1) * (x - x1) / (x2 - x1));
  };
  std::vector<std::pair<double, int>> depth(mesh.elements.size());
  for (int e = 0; e < mesh.element_count(); ++e) {
    std::array<double, D> centre{};
    for (int i : mesh.elements[e]) {
      for (int d = 0; d < D; ++d) centre[d] += mesh.nodes[i][d] / (D + 1);
    }
    depth[e] = {centre[1] - ground(centre[0]), e};
  }
  std::sort(depth.begin(), depth.end());
  const double offset = depth[static_cast<std::size_t>(c.filled_elements) - 1].first;

  const double k0 = soil.poisson / (1 - soil.poisson);
  YardstickFill<D> fill;
  fill.in_element.assign(mesh.elements.size(), 0);
  std::vector<int> filled;
  for (int i = 0; i < c.filled_elements; ++i) filled.push_back(depth[static_cast<std::size_t>(i)].second);
  std::sort(filled.begin(), filled.end());
  for (int e : filled) {
    fill.in_element[e] = c.points_per_element;
    for (int p = 0; p < c.points_per_element; ++p) {
      mpm::InitialPoint<D> point;
      point.element = e;
      const double low = D == 2 ? 1.0 / 6 : 0.13819660112501, high = D == 2 ? 2.0 / 3 : 0.58541019662497;
      for (int d = 0; d < D; ++d) point.xi[d] = p == d + 1 ? high : low;
      const auto x = mesh::to_global(mesh, e, point.xi);
      const double vertical =
          -soil.stress_share * soil.density * yardstick_gravity * std::max(0.0, ground(x[0]) + offset - x[1]);
      point.stress[0] = point.stress[2] = k0 * vertical;
      point.stress[1] = vertical;
      point.volume = mesh.volumes[e] / c.points_per_element;
      point.mass = point.volume * soil.density;
      fill.points.push_back(point);
    }
  }
  return fill;
}

/// Returns the fixed directions of a node at the walls: all at the base, the normal at the other walls.
template <int D>
mpm::Constraint<D> hold_at_walls(const Vec<D>& node, const YardstickCase& c) {
  mpm::Constraint<D> constraint;
  const auto add = [&](int d) {
    Vec<D> n{};
    n[d] = 1;
    constraint.fixed[constraint.fixed_count++] = n;
  };
  const bool bottom = node[1] == 0;
  if (bottom || node[0] == 0 || node[0] == c.cells[0] * c.size) add(0);
  if (bottom || node[1] == c.cells[1] * c.size) add(1);
  if constexpr (D == 3) {
    if (bottom || node[2] == 0 || node[2] == c.cells[2] * c.size) add(2);
  }
  return constraint;
}

template <int D>
void hold_grains(mpm::Body<D>& body, const YardstickCase& c) {
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
    const mpm::Constraint<D> constraint = hold_at_walls<D>(body.mesh().nodes[i], c);
    if (constraint.fixed_count == 0) continue;
    body.conditions.constraint_of_node[i] = static_cast<int>(body.conditions.constraints.size());
    body.conditions.constraints.push_back(constraint);
  }
}

template <int D>
struct Yardstick {
  mpm::Body<D> body;
  mpm::StepOptions<D> options;
};

/// Returns the dry case, ready for the first step. `chunks` as in make_layout(); `rooted` selects the rooted-soil model
/// instead of Mohr–Coulomb.
template <int D>
Yardstick<D> make_yardstick(const std::string& name, int chunks, bool rooted = false) {
  const YardstickCase c = yardstick_case<D>(name);
  const YardstickSoil soil{1.0e7, 0.3, 1800, 1e3, 18 * std::numbers::pi / 180};
  mesh::Mesh<D> mesh = make_yardstick_mesh<D>(c);
  YardstickFill<D> fill = fill_slope(mesh, c, soil);
  material::Law law = soil.law();
  if (rooted) law = plant_roots(fill.points, soil.elastic().constrained_modulus(), soil.poisson);
  Yardstick<D> y;
  y.body =
      mpm::make_body<D>(mpm::make_layout<D>(std::move(mesh), fill.in_element, chunks), {law}, {"soil"}, fill.points);
  hold_grains(y.body, c);
  const double size = c.size * (D == 3 ? 0.6 : 1);
  y.options.dt = 0.25 * size / std::sqrt(soil.elastic().constrained_modulus() / soil.density);
  y.options.gravity[1] = -yardstick_gravity;
  y.options.damping = 0.05;
  y.options.objective = false;  // as in the yardstick
  mpm::gather_nodal_sums(y.body, y.options);
  return y;
}

}  // namespace talus::bench
