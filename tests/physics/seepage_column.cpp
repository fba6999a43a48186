// SPDX-License-Identifier: MIT
// Steady seepage in columns against closed forms: Darcy flow, layers, and Gardner's infiltration.

#include <gtest/gtest.h>

#include "physics/seepage_box.hpp"

namespace talus {
namespace {

using namespace support;

template <int D>
std::array<int, D> cut(int across, int up) {
  if constexpr (D == 2)
    return {across, up};
  else
    return {across, up, across};
}
template <int D>
Vec<D> extent(double across, double up) {
  if constexpr (D == 2)
    return {across, up};
  else
    return {across, up, across};
}

template <class Dimension>
class SeepageColumn : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(SeepageColumn, Dimensions);

TYPED_TEST(SeepageColumn, DarcyFlowIsExactOnAnyMesh) {
  constexpr int D = TypeParam::value;
  const auto mesh = make_soil_box<D>(cut<D>(3, 6), extent<D>(1, 3));
  SeepageModel<D> model{&mesh, {make_soil<D>(2e-5)}, {}};
  model.boundaries = {make_condition(mesh, "bottom", HydraulicKind::total_head, 4.5),
                      make_condition(mesh, "top", HydraulicKind::pressure, 0.0)};
  const auto r = fem::solve_steady_seepage(model);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    EXPECT_NEAR(r.head[i], 4.5 - 0.5 * mesh.nodes[i][1], 1e-12);
    EXPECT_NEAR(r.pressure[i], gamma_w * (1.5 * mesh.nodes[i][1] - 4.5), 1e-7);
  }
  for (const auto& v : r.velocity) {
    EXPECT_NEAR(v[1], 1e-5, 1e-16);
    EXPECT_NEAR(v[0], 0, 1e-16);
  }
  EXPECT_NEAR(r.discharges[0].inflow, 1e-5, 1e-16);
  EXPECT_NEAR(r.discharges[1].outflow, 1e-5, 1e-16);
  EXPECT_LT(relative_balance(r), 1e-10);
}

TYPED_TEST(SeepageColumn, LayersAddTheirResistances) {
  constexpr int D = TypeParam::value;
  // 2 m of 1e-5 under 1 m of 1e-8 m/s; the interface follows the mesh, whose inner nodes are not moved
  const auto mesh = make_soil_box<D>(
      cut<D>(2, 9), extent<D>(1, 3), [](const Vec<D>& x) { return x[1] > 2 ? 1 : 0; }, 0.0);
  SeepageModel<D> model{&mesh, {make_soil<D>(1e-5), make_soil<D>(1e-8)}, {}};
  model.boundaries = {make_condition(mesh, "top", HydraulicKind::total_head, 6.0),
                      make_condition(mesh, "bottom", HydraulicKind::total_head, 3.0)};
  const auto r = fem::solve_steady_seepage(model);
  const double q = 3 / (2 / 1e-5 + 1 / 1e-8);
  EXPECT_NEAR(r.discharges[0].inflow / q, 1, 1e-11);
  EXPECT_NEAR(r.discharges[1].outflow / q, 1, 1e-11);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const double y = mesh.nodes[i][1];
    EXPECT_NEAR(r.head[i], 3 + q * (std::min(y, 2.0) / 1e-5 + std::max(0.0, y - 2) / 1e-8), 1e-10);
  }
}

TYPED_TEST(SeepageColumn, WaterAtRestStaysAtRestSaturatedAndWithSuction) {
  constexpr int D = TypeParam::value;
  const auto mesh = make_soil_box<D>(cut<D>(3, 6), extent<D>(2, 3));
  auto soil = make_soil<D>(1e-6);
  soil.retention = material::VanGenuchten{0.15, 1, 6130, 0.27};
  soil.relative = material::Mualem{0.27};
  SeepageModel<D> model{&mesh, {soil}, {make_condition(mesh, "left", HydraulicKind::total_head, 1.1)}};
  model.boundaries.push_back(make_condition(mesh, "top", HydraulicKind::seepage_face));
  const auto r = fem::solve_steady_seepage(model);
  for (double h : r.head) EXPECT_NEAR(h, 1.1, 1e-10);
  EXPECT_LT(r.inflow + r.outflow, 1e-17);
  EXPECT_TRUE(r.exits.empty());
}

/// Steady infiltration q into a column over a water table, k = k_s e^(-αψ): k/k_s = (1 - q/k_s) e^(-αz) + q/k_s.
double find_gardner_suction_head(double z, double alpha, double ratio) {
  return -std::log((1 - ratio) * std::exp(-alpha * z) + ratio) / alpha;
}

TYPED_TEST(SeepageColumn, InfiltrationIntoGardnersSoilConvergesToTheClosedSolution) {
  constexpr int D = TypeParam::value;
  const double alpha = 2.0, ks = 1e-5, height = 3;  // α [1/m]
  struct Infiltration {
    double ratio, error;  // q/k_s, and the largest error of the suction's head with 12 elements [m]
  };
  for (const auto& [ratio, error] : {Infiltration{0.1, 6e-3}, {0.9, 8e-4}, {-0.0015, 0.08}}) {  // the last evaporates
    for (int n : {12, 24, 48}) {
      if (D == 3 && n == 48) continue;
      const auto mesh = make_soil_box<D>(cut<D>(2, n), extent<D>(height * 2 / n, height));
      auto soil = make_soil<D>(ks);
      soil.retention = material::ExponentialRetention{0.15, 1, alpha / gamma_w};
      soil.relative = material::ExponentialConductivity{alpha / gamma_w};
      SeepageModel<D> model{&mesh, {soil}, {}};
      model.boundaries = {make_condition(mesh, "bottom", HydraulicKind::pressure, 0.0),
                          make_condition(mesh, "top", HydraulicKind::flux, ratio * ks)};
      const auto r = fem::solve_steady_seepage(model);
      double worst = 0;
      for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const double exact = find_gardner_suction_head(mesh.nodes[i][1], alpha, ratio);
        worst = std::max(worst, std::abs(r.pressure[i] / gamma_w - exact));
      }
      EXPECT_LT(relative_balance(r), 1e-10);
      EXPECT_LT(worst, error * std::pow(12.0 / n, 1.8)) << ratio << ", " << n;  // second order, roughly
    }
  }
}

}  // namespace
}  // namespace talus
