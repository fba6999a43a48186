// SPDX-License-Identifier: MIT
#include "reference/wet_slope.hpp"

namespace talus::reference {

Curves wet_slope_curves() {
  return {material::ExponentialRetention{0.1, 1, 1 / 1.5e4}, material::Hillel{3, material::SaturationMeasure::total}};
}

template <int D>
WetBody<D> make_wet_slope(unsigned seed) {
  std::array<int, D> cells{};
  std::array<double, D> size{};
  for (int d = 0; d < D; ++d) {
    const int count[] = {D == 2 ? 16 : 8, D == 2 ? 10 : 5, 2};
    const double length[] = {8, 5, 2};
    at(cells, d) = count[d];
    at(size, d) = length[d];
  }
  Soil soil;
  soil.skeleton = {.young_modulus = 5e6,
                   .poisson_ratio = 0.3,
                   .plastic = true,
                   .cohesion = 300,
                   .friction_angle = 0.35,
                   .dilatancy_angle = 0.05,
                   .tensile_strength = 200};
  soil.water.conductivity = 1e-3;
  soil.water.bulk_modulus = 2e8;
  set_curves(soil.water, wet_slope_curves());
  Soil ground = soil, berm = soil;
  ground.water.conductivity = 1e-5;
  berm.wet = false;
  const Slope slope{6, 1, 3, 4};
  const double g = 9.81, table = 1.5;
  WetBody<D> body = make_wet_body(make_box<D>(cells, size, 0.15, seed), soil);
  body.soils = {soil, ground, berm};
  body.gravity[1] = -g;
  fix_wet_box(body, size);
  const auto pressure = [&](const Vector<D>& x) { return 1000 * g * (x[1] - table); };
  const auto below_surface = [&](const Vector<D>& x) { return x[1] < slope.surface(x[0]); };
  const auto in_berm = [&](const Vector<D>& x) { return x[1] > 3.2 && x[0] < 1.5; };
  fill_wet(
      body, 0.40, 0, [&](const Vector<D>& x) { return below_surface(x) && x[1] > 1 && !in_berm(x); }, pressure);
  fill_wet(
      body, 0.35, 1, [&](const Vector<D>& x) { return below_surface(x) && x[1] < 1; }, pressure);
  fill_wet(
      body, 0.30, 2, [&](const Vector<D>& x) { return below_surface(x) && in_berm(x); }, pressure);
  for (WetPoint<D>& point : body.points) {
    const double depth = std::max(0.0, slope.surface(point.x[0]) - point.x[1]);
    const double total = -1800 * g * depth, pore = point.water_mass > 0 ? point.pressure : 0.0;
    const double effective = total - soil.water.saturation(pore) * pore;
    point.sigma = Vector3(0.5 * effective, effective, 0.5 * effective).asDiagonal();
  }
  body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::rain, .rain = -2e-4 * Vector<D>::Unit(1)});
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i) {
    const auto& x = body.mesh.nodes[i];
    if (x[0] > 5.2) body.surface[i] = {.kind = SurfaceKind::head, .head = 1.3};
    if (x[0] > 1e-9 || x[1] < 1e-9) continue;
    body.surface[i] = {.kind = SurfaceKind::head, .head = 2};
    body.water_constraints[i].fixed[0] = false;  // the left wall lets water through
  }
  return body;
}

template <int D>
double wet_slope_step(const WetBody<D>& body, Drag drag) {
  const CoupledSoil limits = CoupledSoil::saturated(5e6 * 0.7 / 0.52, 0.35, 2e8, 2650, 1e-5);
  return 0.7 * critical_step(limits, smallest_altitude(body.mesh), 1, drag);
}

template WetBody<2> make_wet_slope<2>(unsigned seed);
template WetBody<3> make_wet_slope<3>(unsigned seed);
template double wet_slope_step<2>(const WetBody<2>& body, Drag drag);
template double wet_slope_step<3>(const WetBody<3>& body, Drag drag);

}  // namespace talus::reference
