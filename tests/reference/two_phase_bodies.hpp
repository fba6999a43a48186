// SPDX-License-Identifier: MIT
#pragma once
// Bodies for the plain two-velocity step and for the comparison of the MPM step with it: filled boxes and columns on
// rollers with pore water. Component 1 is upwards.

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "material/water/conductivity.hpp"
#include "reference/bodies.hpp"
#include "reference/plain_two_phase.hpp"
#include "reference/plain_two_phase_limits.hpp"

namespace talus::reference {

/// Table 2.1: the soil of the wave; Table 2.2 has a tenth of its permeability.
Soil make_table_soil(double intrinsic_permeability = 1.0214e-12);

/// Retention and conductivity as the engine has them, so that both compute with the same functions.
struct Curves {
  material::Retention retention = material::ConstantSaturation{};
  material::Conductivity relative = material::ConstantConductivity{};
};

/// Makes `water` follow the curves. The relative conductivity must be a function of the saturation.
void set_curves(PoreWater& water, const Curves& curves);

/// S = 0.1 + 0.9 exp(−s/20 kPa) for suctions s.
Soil make_retaining_soil();

/// The sides of a cube [m].
template <int D>
std::array<double, D> cube(double size) {
  std::array<double, D> sides{};
  sides.fill(size);
  return sides;
}

template <int D>
WetBody<D> make_wet_body(const mesh::Mesh<D>& mesh, const Soil& soil);

/// Takes the points out of the element that holds x: a gap.
template <int D>
void empty_element(WetBody<D>& body, const Vector<D>& x) {
  const auto holds = [&](int e) { return shape_functions(body.mesh, e, x).minCoeff() >= 0; };
  int e = 0;
  while (!holds(e)) ++e;
  std::erase_if(body.points, [&](const WetPoint<D>& point) { return point.element == e; });
  for (std::size_t p = 0; p < body.points.size(); ++p) body.points[p].id = static_cast<int>(p);
}

/// Places D+1 points per element as fill() does, with porosity n and the pressure p(x), taken at the element's middle
/// so that the points of an element agree about the water that they hold. The effective stress is zero.
template <int D, class Inside, class Pressure>
void fill_wet(WetBody<D>& body, double n, int soil_number, Inside inside, Pressure pressure) {
  const Soil& soil = at(body.soils, soil_number);
  Body<D> dry;
  dry.mesh = body.mesh;
  fill(dry, (1 - n) * soil.grain_density, soil_number, inside);
  for (const Point<D>& point : dry.points) {
    WetPoint<D> wet;
    static_cast<Point<D>&>(wet) = point;
    wet.id = static_cast<int>(body.points.size());
    if (soil.wet) {
      Vector<D> middle = Vector<D>::Zero();
      for (int i = 0; i <= D; ++i)
        for (int d = 0; d < D; ++d)
          middle[d] += at(at(body.mesh.nodes, node_of(body.mesh, point.element, i)), d) / (D + 1);
      wet.pressure = pressure(middle);
      wet.water_mass = n * soil.water.saturation(wet.pressure) * water_density(soil.water, wet.pressure) * wet.volume;
    }
    body.points.push_back(wet);
  }
}

enum class Phase { solid, water, both };

/// Fixes a component of every node whose coordinate `axis` is `value` [m].
template <int D>
void fix_wet_face(WetBody<D>& body, int axis, double value, int component, Phase phase = Phase::both);

/// Closed rollers for both phases on all sides of the box from 0 to `size` [m] but the top.
template <int D>
void fix_wet_box(WetBody<D>& body, const typename mesh::Mesh<D>::Point& size);

/// A column of `cells` squares (cubes) of size `h` [m] on rollers, full of soil of porosity n at zero pressure.
template <int D>
WetBody<D> make_column(int cells, double h, const Soil& soil, double n, double jitter = 0);

/// ∫ N n dS over mesh boundary sides whose nodes all lie at coordinate `axis` = `value`: what a unit pressure needs.
template <int D>
std::vector<Vector<D>> face_areas(const mesh::Mesh<D>& mesh, int axis, double value) {
  std::vector<Vector<D>> areas(mesh.nodes.size(), Vector<D>::Zero());
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int k = 0; k <= D; ++k) {
      if (at(at(mesh.neighbours, e), k) >= 0) continue;
      bool on_face = true;
      for (int i = 0; i <= D; ++i)
        on_face = on_face && (i == k || std::abs(at(at(mesh.nodes, node_of(mesh, e, i)), axis) - value) < 1e-12);
      for (int i = 0; on_face && i <= D; ++i)
        if (i != k) at(areas, node_of(mesh, e, i)) -= at(mesh.volumes, e) * shape_gradients(mesh, e).row(k).transpose();
    }
  return areas;
}

/// Smallest altitude of the mesh [m].
template <int D>
double smallest_altitude(const mesh::Mesh<D>& mesh) {
  return *std::min_element(mesh.altitudes.begin(), mesh.altitudes.end());
}

/// V_p-weighted mean of `value(point)` over points whose height lies within `half` of `y`.
template <int D, class Value>
double mean_at_height(const WetBody<D>& body, double y, double half, Value value) {
  double sum = 0, volume = 0;
  for (const WetPoint<D>& point : body.points)
    if (std::abs(point.x[1] - y) < half) sum += point.volume * value(point), volume += point.volume;
  return sum / volume;
}

}  // namespace talus::reference
