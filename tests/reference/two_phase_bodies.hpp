// SPDX-License-Identifier: MIT
#pragma once
// Bodies for the plain coupled step and for the comparison of the engine with it: filled boxes and columns on rollers
// with pore water. Component 1 is upwards.

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
inline Soil make_table_soil(double intrinsic_permeability = 1.0214e-12) {
  Soil soil;
  soil.skeleton = {.young_modulus = 1e7, .poisson_ratio = 0.3};
  soil.grain_density = 2650;
  soil.water.bulk_modulus = 2.15e9;
  soil.water.conductivity = 1000 * 9.81 / 1.002e-3 * intrinsic_permeability;
  return soil;
}

/// Retention and conductivity as the engine has them, so that both compute with the same functions.
struct Curves {
  material::Retention retention = material::ConstantSaturation{};
  material::Conductivity relative = material::ConstantConductivity{};
};

/// Makes `water` follow the curves. The relative conductivity must be a function of the saturation.
inline void set_curves(PoreWater& water, const Curves& curves) {
  const material::Retention retention = curves.retention;
  const material::Conductivity relative = curves.relative;
  water.saturation = [retention](double p) { return material::saturation(retention, p); };
  water.saturation_slope = [retention](double p) { return material::find_water(retention, p).slope; };
  water.relative_conductivity = [retention, relative](double s) {
    const double range = std::visit([](const auto& curve) { return curve.maximum - curve.minimum; }, retention);
    const double least = std::visit([](const auto& curve) { return curve.minimum; }, retention);
    const material::SoilWater<double> at_s{0, s, 0, range > 0 ? (s - least) / range : 1.0, 0};
    return material::find_relative_conductivity(relative, at_s).value;
  };
}

/// S = 0.1 + 0.9 exp(−s/20 kPa) for suctions s.
inline Soil make_retaining_soil() {
  Soil soil = make_table_soil(1e-10);
  soil.water.saturation = [](double p) { return p > 0 ? 0.1 + 0.9 * std::exp(-p / 2e4) : 1.0; };
  soil.water.saturation_slope = [](double p) { return p > 0 ? -0.9 / 2e4 * std::exp(-p / 2e4) : 0.0; };
  soil.water.relative_conductivity = [](double s) { return (s - 0.1) / 0.9; };
  return soil;
}

/// The sides of a cube [m].
template <int D>
std::array<double, D> cube(double size) {
  std::array<double, D> sides{};
  sides.fill(size);
  return sides;
}

template <int D>
WetBody<D> make_wet_body(const mesh::Mesh<D>& mesh, const Soil& soil) {
  WetBody<D> body;
  body.mesh = mesh;
  body.soils = {soil};
  body.solid_constraints.assign(mesh.nodes.size(), {});
  body.water_constraints.assign(mesh.nodes.size(), {});
  return body;
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
void fix_wet_face(WetBody<D>& body, int axis, double value, int component, Phase phase = Phase::both) {
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i) {
    if (std::abs(at(body.mesh.nodes[i], axis) - value) > 1e-12) continue;
    if (phase != Phase::water) at(body.solid_constraints[i].fixed, component) = true;
    if (phase != Phase::solid) at(body.water_constraints[i].fixed, component) = true;
  }
}

/// Closed rollers for both phases on all sides of the box from 0 to `size` [m] but the top.
template <int D>
void fix_wet_box(WetBody<D>& body, const typename mesh::Mesh<D>::Point& size) {
  for (int d = 0; d < D; ++d) {
    fix_wet_face(body, d, 0.0, d);
    if (d != 1) fix_wet_face(body, d, at(size, d), d);
  }
}

/// A column of `cells` squares (cubes) of size `h` [m] on rollers, full of soil of porosity n at zero pressure.
template <int D>
WetBody<D> make_column(int cells, double h, const Soil& soil, double n, double jitter = 0) {
  std::array<int, D> count{};
  std::array<double, D> size{};
  count.fill(1), size.fill(h);
  count[1] = cells, size[1] = cells * h;
  WetBody<D> body = make_wet_body(make_box<D>(count, size, jitter), soil);
  fix_wet_box(body, size);
  fill_wet(
      body, n, 0, [](const Vector<D>&) { return true; }, [](const Vector<D>&) { return 0.0; });
  return body;
}

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
