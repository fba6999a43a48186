// SPDX-License-Identifier: MIT
// Initial state of MPM: preconsolidation pressure of Cam-clay against the weight of a column, with suction and roots,
// given or from the equilibrium stress, set exactly once; also after a start from another run.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "material/every_law.hpp"
#include "mpm/solver/observe.hpp"
#include "run/mpm/start/prepare.hpp"
#include "support/wet_case.hpp"

namespace talus {
namespace {

using input::MaterialModel;
using material::ModifiedCamClay;
using material::RootedCamClay;
using run::set_preconsolidation;

/// Dry soil of 3/5 · 2650 kg/m³ with K0 = 0.5.
input::Material make_clay(MaterialModel kind = material::model_of<material::ModifiedCamClay>) {
  input::Material soil = support::make_elastic(1, 1.0 / 3, 2650);
  soil.model = kind;
  soil.porosity = 0.4;
  soil.compression = 0.089;
  soil.swelling = 0.022;
  soil.critical_state_slope = 1.2;
  soil.smallest_pressure = 5e3;
  soil.hardening = 0.28;
  soil.strength = 0.18;
  return soil;
}

/// A column of 1 m × 4 m, filled.
template <int D>
mesh::Mesh<D> make_column() {
  std::array<int, D> cells{};
  Vec<D> size{};
  for (std::size_t d = 0; d < D; ++d) {
    cells[d] = d == 1 ? 8 : 2;
    size[d] = d == 1 ? 4 : 1;
  }
  auto mesh = support::make_box_mesh<D>(cells, size, {"soil"}, [](const Vec<D>&) { return 0; });
  return mesh;
}

template <int D>
mpm::Body<D> fill(const input::Case& data) {
  return run::prepare<D>(data, make_column<D>());
}

template <int D>
void expect_the_ratio_of_the_weight() {
  input::Case data = support::make_box_case<D>(make_clay());
  data.initial.stress = input::InitialStress::k0;
  data.stages.resize(2);
  data.materials.at("soil").preconsolidation_ratio = 2.5;
  mpm::Body<D> body = fill<D>(data);
  for (int id = 0; id < body.points.size(); ++id) {
    const auto state = mpm::view_point(body, id).state;
    ASSERT_EQ(state[1], ModifiedCamClay::not_set);
    ASSERT_NEAR(state[2], 2.0 / 3, 1e-15);
  }
  const auto done = set_preconsolidation(body, data);
  EXPECT_EQ(done.points, body.points.size());
  double smallest = 1e30, largest = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    const auto point = mpm::view_point(body, id);
    const double vertical = 0.6 * 2650 * 9.81 * (4 - point.position[1]), p = vertical * (1 + 2 * 0.5) / 3;
    const double expected = 2.5 * std::max(p, 5e3);
    ASSERT_NEAR(point.state[1], expected, 1e-9 * expected);
    ASSERT_NEAR(point.state[2], 2.0 / 3, 1e-15);
    smallest = std::min(smallest, expected);
    largest = std::max(largest, expected);
  }
  EXPECT_NEAR(done.smallest, smallest, 1e-6);
  EXPECT_NEAR(done.largest, largest, 1e-6);
  // K0 compression has q = 0.75 p' here: q²/M² = 0.39 p'² lies below p'(p'_c - p') = 1.5 p'².
  EXPECT_EQ(done.beyond, 0);
  EXPECT_EQ(set_preconsolidation(body, data).points, 0) << "what is set stays";
}

TEST(Preconsolidation, IsTheRatioTimesTheStressOfTheColumn) {
  expect_the_ratio_of_the_weight<2>();
  expect_the_ratio_of_the_weight<3>();
}

TEST(Preconsolidation, CountsStressesBeyondTheYieldSurface) {
  input::Case data = support::make_box_case<2>(make_clay());
  data.initial.stress = input::InitialStress::k0;
  data.stages.resize(1);
  // q²/M² = (0.75/1.2)² p'² = 0.39 p'² and p'(R_0 - 1)p': the border is at R_0 = 1.39.
  for (const double ratio : {1.38, 1.40}) {
    data.materials.at("soil").preconsolidation_ratio = ratio;
    mpm::Body<2> body = fill<2>(data);
    int deep = 0;
    for (int id = 0; id < body.points.size(); ++id) {
      const auto s = mpm::view_point(body, id).stress;
      deep += -(s[0] + s[1] + s[2]) / 3 > 5e3 ? 1 : 0;
    }
    ASSERT_GT(deep, 20);
    EXPECT_EQ(set_preconsolidation(body, data).beyond, ratio < 1.39 ? deep : 0) << ratio;
  }
}

/// Unsaturated rooted soil above a water table at the foot of the column.
input::Case make_suction_case() {
  input::Material soil = make_clay(material::model_of<material::RootedCamClay>);
  soil.suction_hardening = 2;
  soil.root_content = 0.88;
  soil.water.retention = input::RetentionCurve::van_genuchten;
  soil.water.minimum_saturation = 0.2;
  soil.water.reference_pressure = 10e3;
  soil.water.lambda = 0.4;
  soil.water.conductivity = 1e-5;
  input::Case data = support::make_box_case<2>(soil);
  data.initial.stress = input::InitialStress::k0;
  data.initial.water.pressure = input::InitialPressure::water_table;
  data.initial.water.water_table = {{0, 0}, {1, 0}};
  data.stages.resize(1);
  return data;
}

TEST(Preconsolidation, HardensWithTheSuctionAndTheRootsOfTheStart) {
  input::Case data = make_suction_case();
  data.materials.at("soil").preconsolidation = 12e3;
  const mpm::Body<2> body = fill<2>(data);
  const auto& law = std::get<RootedCamClay>(body.laws[0]);
  double least_saturation = 1;
  int raised = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    const auto point = mpm::view_point(body, id);
    const double p = -(point.stress[0] + point.stress[1] + point.stress[2]) / 3;
    const double hardened = 12e3 * std::exp(2 * (1 - point.saturation) + 0.28 * 0.88), expected = std::max(hardened, p);
    ASSERT_NEAR(law.find_preconsolidation(point.state.data(), point.saturation), expected, 1e-9 * expected);
    ASSERT_EQ(point.state[3], 0.88);
    least_saturation = std::min(least_saturation, point.saturation);
    raised += p > hardened ? 1 : 0;
  }
  EXPECT_LT(least_saturation, 0.7) << "without suction nothing is tested";
  EXPECT_GT(raised, 0);
  EXPECT_LT(raised, body.points.size());
}

TEST(Preconsolidation, OfTheRatioIsThatOfTheSaturatedSoilWithoutRoots) {
  input::Case data = make_suction_case();
  data.materials.at("soil").preconsolidation_ratio = 2;
  mpm::Body<2> body = fill<2>(data);
  const auto done = set_preconsolidation(body, data);
  double smallest = 1e30;
  for (int id = 0; id < body.points.size(); ++id) {
    const auto point = mpm::view_point(body, id);
    const double p = -(point.stress[0] + point.stress[1] + point.stress[2]) / 3;
    ASSERT_NEAR(point.state[1], 2 * std::max(p, 5e3), 1e-6);
    smallest = std::min(smallest, point.state[1] * std::exp(2 * (1 - point.saturation) + 0.28 * 0.88));
  }
  EXPECT_NEAR(done.smallest, smallest, 1e-6);
}

TEST(InitialState, FollowsTheEquilibriumStageOfTheCase) {
  input::Case data;
  data.stages.resize(3);
  data.stages[0].name = "weight";
  data.stages[1].name = "seepage";
  data.stages[2].name = "rain";
  EXPECT_TRUE(run::is_equilibrium_stage(data, 0));
  EXPECT_FALSE(run::is_equilibrium_stage(data, 1));
  data.initial.equilibrium = "seepage";
  EXPECT_FALSE(run::is_equilibrium_stage(data, 0));
  EXPECT_TRUE(run::is_equilibrium_stage(data, 1));
}

/// The end of another run, with stress, plastic strain and state of its own.
mpm::Body<2> leave(const input::Case& data) {
  mpm::Body<2> body = fill<2>(data);
  for (int id = 0; id < body.points.size(); ++id) {
    auto state = mpm::view_point(body, id).state;
    state[0] = 0.02;
    if (std::holds_alternative<RootedCamClay>(body.laws[0])) {
      state[1] = 33e3;
      state[2] = 0.61;
      state[5] = 0.04;
      state[6] = 0.9;
    }
    mpm::write_state(body, id, state.data());
  }
  return body;
}

/// Takes the points of the old body as EndState does, and fits them.
mpm::Body<2> adopt(const input::Case& data, const mpm::Body<2>& old, MaterialModel before, bool same_roots) {
  const mpm::Body<2> fresh = fill<2>(data);
  mpm::Body<2> body = fresh;
  for (int id = 0; id < body.points.size(); ++id) mpm::write_state(body, id, mpm::view_point(old, id).state.data());
  run::adopt_state(body, data, fresh, std::vector<MaterialModel>(body.points.element.size(), before), same_roots);
  return body;
}

TEST(InitialState, KeepsTheStateOfTheSameSoilAndRenewsOtherRoots) {
  input::Case data = support::make_box_case<2>(make_clay(material::model_of<material::RootedCamClay>));
  data.initial.stress = input::InitialStress::k0;
  data.stages.resize(1);
  data.materials.at("soil").preconsolidation_ratio = 2;
  data.materials.at("soil").root_content = 0.44;
  const mpm::Body<2> old = leave(data);
  const mpm::Body<2> same = adopt(data, old, material::model_of<material::RootedCamClay>, true);
  data.materials.at("soil").root_content = 0.88;
  mpm::Body<2> other = adopt(data, old, material::model_of<material::RootedCamClay>, false);
  for (int id = 0; id < same.points.size(); ++id) {
    const auto before = mpm::view_point(old, id).state, kept = mpm::view_point(same, id).state,
               renewed = mpm::view_point(other, id).state;
    ASSERT_EQ(kept, before);
    for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(renewed[i], before[i]);
    ASSERT_EQ(renewed[3], 0.88);
    ASSERT_NEAR(renewed[4], 0.28 * 0.88, 1e-15);
    ASSERT_EQ(renewed[5], 0);
    ASSERT_EQ(renewed[6], 1);
  }
  EXPECT_EQ(set_preconsolidation(other, data).points, 0) << "the other run has set it";
}

TEST(InitialState, TakesAGivenPreconsolidationWhereTheOtherRunHadNotSetOne) {
  input::Case data = support::make_box_case<2>(make_clay());
  data.initial.stress = input::InitialStress::k0;
  data.stages.resize(1);
  data.materials.at("soil").preconsolidation_ratio = 2;
  const mpm::Body<2> old = fill<2>(data);
  data.materials.at("soil").preconsolidation_ratio.reset();
  data.materials.at("soil").preconsolidation = 12e3;
  const mpm::Body<2> body = adopt(data, old, material::model_of<material::ModifiedCamClay>, true);
  for (int id = 0; id < body.points.size(); ++id) {
    const auto point = mpm::view_point(body, id);
    const double p = -(point.stress[0] + point.stress[1] + point.stress[2]) / 3;
    ASSERT_NEAR(point.state[1], std::max(12e3, p), 1e-6);
  }
}

TEST(InitialState, OfSoilThatWasMohrCoulombStartsFromItsStress) {
  input::Case before = support::make_box_case<2>(make_clay(material::model_of<material::MohrCoulomb>));
  before.initial.stress = input::InitialStress::k0;
  before.materials.at("soil").cohesion = 5e3;
  input::Case data = before;
  data.stages.resize(1);
  data.materials.at("soil").model = material::model_of<material::ModifiedCamClay>;
  data.materials.at("soil").preconsolidation_ratio = 2;
  // A body of Cam-clay holds what the Mohr–Coulomb body left: its plastic strain in front, nothing behind.
  const mpm::Body<2> fresh = fill<2>(data);
  mpm::Body<2> body = fresh;
  std::array<double, material::max_state_size> left{0.02};
  for (int id = 0; id < body.points.size(); ++id) mpm::write_state(body, id, left.data());
  run::adopt_state(body, data, fresh,
                   std::vector<MaterialModel>(body.points.element.size(), material::model_of<material::MohrCoulomb>),
                   true);
  for (int id = 0; id < body.points.size(); ++id) {
    const auto state = mpm::view_point(body, id).state;
    ASSERT_EQ(state[0], 0.02);
    ASSERT_EQ(state[1], ModifiedCamClay::not_set);
    ASSERT_NEAR(state[2], 2.0 / 3, 1e-12);
  }
  EXPECT_EQ(set_preconsolidation(body, data).points, body.points.size());
}

TEST(InitialState, GivesEachPointTheRootCohesionOfItsPlace) {
  input::Material soil = support::make_elastic(10e6, 0.3, 2000);
  soil.model = material::model_of<material::RootedMohrCoulomb>;
  soil.cohesion = 2e3;
  input::Case data = support::make_box_case<3>(soil);
  input::Roots roots;
  roots.ground = "top";
  roots.depth = 1.5;
  roots.profile = input::RootProfile::exponential;
  roots.decay_depth = 0.5;
  roots.cohesion = 8e3;
  data.roots = {roots};
  const mpm::Body<3> body = fill<3>(data);
  int rooted = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    const auto point = mpm::view_point(body, id);
    const double z = 4 - point.position[1], expected = z <= 1.5 ? 8e3 * std::exp(-z / 0.5) : 0;
    ASSERT_NEAR(point.state[1], expected, 1e-6) << z;
    rooted += expected > 0 ? 1 : 0;
  }
  EXPECT_GT(rooted, body.points.size() / 4);
  EXPECT_LT(rooted, body.points.size() / 2);
}

}  // namespace
}  // namespace talus
