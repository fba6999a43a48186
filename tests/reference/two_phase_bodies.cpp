// SPDX-License-Identifier: MIT
#include "reference/two_phase_bodies.hpp"

namespace talus::reference {

Soil make_table_soil(double intrinsic_permeability) {
  Soil soil;
  soil.skeleton = {.young_modulus = 1e7, .poisson_ratio = 0.3};
  soil.grain_density = 2650;
  soil.water.bulk_modulus = 2.15e9;
  soil.water.conductivity = 1000 * 9.81 / 1.002e-3 * intrinsic_permeability;
  return soil;
}

void set_curves(PoreWater& water, const Curves& curves) {
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

Soil make_retaining_soil() {
  Soil soil = make_table_soil(1e-10);
  soil.water.saturation = [](double p) { return p > 0 ? 0.1 + 0.9 * std::exp(-p / 2e4) : 1.0; };
  soil.water.saturation_slope = [](double p) { return p > 0 ? -0.9 / 2e4 * std::exp(-p / 2e4) : 0.0; };
  soil.water.relative_conductivity = [](double s) { return (s - 0.1) / 0.9; };
  return soil;
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

template <int D>
void fix_wet_face(WetBody<D>& body, int axis, double value, int component, Phase phase) {
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i) {
    if (std::abs(at(body.mesh.nodes[i], axis) - value) > 1e-12) continue;
    if (phase != Phase::water) at(body.solid_constraints[i].fixed, component) = true;
    if (phase != Phase::solid) at(body.water_constraints[i].fixed, component) = true;
  }
}

template <int D>
void fix_wet_box(WetBody<D>& body, const typename mesh::Mesh<D>::Point& size) {
  for (int d = 0; d < D; ++d) {
    fix_wet_face(body, d, 0.0, d);
    if (d != 1) fix_wet_face(body, d, at(size, d), d);
  }
}

template <int D>
WetBody<D> make_column(int cells, double h, const Soil& soil, double n, double jitter) {
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

template WetBody<2> make_wet_body<2>(const mesh::Mesh<2>& mesh, const Soil& soil);
template WetBody<3> make_wet_body<3>(const mesh::Mesh<3>& mesh, const Soil& soil);
template void fix_wet_face<2>(WetBody<2>& body, int axis, double value, int component, Phase phase);
template void fix_wet_face<3>(WetBody<3>& body, int axis, double value, int component, Phase phase);
template void fix_wet_box<2>(WetBody<2>& body, const typename mesh::Mesh<2>::Point& size);
template void fix_wet_box<3>(WetBody<3>& body, const typename mesh::Mesh<3>::Point& size);
template WetBody<2> make_column<2>(int cells, double h, const Soil& soil, double n, double jitter);
template WetBody<3> make_column<3>(int cells, double h, const Soil& soil, double n, double jitter);

}  // namespace talus::reference
