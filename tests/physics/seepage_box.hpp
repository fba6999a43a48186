// SPDX-License-Identifier: MIT
#pragma once
// Soil boxes and columns for the tests of seepage: meshes with named sides, without a mesh generator.

#include <cmath>

#include "base/error.hpp"
#include "fem/seepage/seepage.hpp"
#include "support/box_case.hpp"

namespace talus::support {

using fem::HydraulicBoundary;
using fem::HydraulicKind;
using fem::HydraulicSoil;
using fem::SeepageModel;

constexpr double gamma_w = 9810;

/// A box of soil on a jittered mesh whose layers follow `region` (by centroid).
template <int D>
mesh::Mesh<D> make_soil_box(
    const std::array<int, D>& cells, const Vec<D>& size, const Filling<D>& region = [](const Vec<D>&) { return 0; },
    double jitter = 0.15) {
  return make_box_mesh<D>(cells, size, {"soil", "other"}, region, jitter);
}

template <int D>
HydraulicSoil<D> make_soil(double conductivity, double porosity = 0.4) {
  HydraulicSoil<D> soil;
  soil.name = "soil";
  soil.porosity = porosity;
  soil.conductivity.fill(conductivity);
  return soil;
}

template <int D>
HydraulicBoundary<D> make_condition(const mesh::Mesh<D>& mesh, const std::string& side, HydraulicKind kind,
                                    double value = 0) {
  HydraulicBoundary<D> b;
  b.name = side;
  b.kind = kind;
  b.sides = mesh.sides.at(side);
  b.value = value;
  return b;
}

/// Error of the balance as a fraction of the inflow or outflow.
template <int D>
double relative_balance(const fem::SeepageResult<D>& r) {
  return std::abs(r.balance_error) / std::max({r.inflow, r.outflow, std::abs(r.storage_rate), 1e-300});
}

}  // namespace talus::support
