// SPDX-License-Identifier: MIT
// Cam-clay in packs against doubles, in plane strain against 3D, in rotated axes, and the plastic strain of an update.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>

#include "support/clay_draw.hpp"

namespace {

using namespace talus;
using material::RootedCamClay;

/// A point with its increment.
template <int NS>
struct Case {
  support::ClayPoint<NS, true> point;
  std::array<double, NS> d_epsilon;
};

template <int NS>
Case<NS> draw_case(support::Draw& draw, const RootedCamClay& law) {
  auto point = support::draw_clay_point<NS>(draw, law);
  const double size = support::draw_logarithmic(draw, 1e-8, 3e-2);
  return {point, support::draw_increment<NS>(draw, size)};
}

/// Updates the cases as one pack; inactive lanes contain NaN.
template <int NS>
std::array<Case<NS>, lane_width> update_pack(const RootedCamClay& law, std::array<Case<NS>, lane_width> cases,
                                             unsigned active) {
  Pack stress[NS], d[NS], state[RootedCamClay::state_size];
  material::Surroundings<Pack> around;
  Mask mask(false);
  for (int l = 0; l < lane_width; ++l) {
    const auto& c = cases[static_cast<std::size_t>(l)];
    const bool in = (active >> l & 1) != 0;
    set_lane(mask, l, in);
    const double nothing = std::nan("");
    for (std::size_t i = 0; i < NS; ++i) stress[i].value[l] = in ? c.point.stress[i] : nothing;
    for (std::size_t i = 0; i < NS; ++i) d[i].value[l] = in ? c.d_epsilon[i] : nothing;
    for (std::size_t i = 0; i < RootedCamClay::state_size; ++i) state[i].value[l] = in ? c.point.state[i] : nothing;
    around.saturation.value[l] = in ? c.point.saturation : nothing;
  }
  const auto r = law.update<NS>(stress, d, state, mask, around);
  for (int l = 0; l < lane_width; ++l) {
    auto& c = cases[static_cast<std::size_t>(l)];
    for (std::size_t i = 0; i < NS; ++i) c.point.stress[i] = stress[i][l];
    for (std::size_t i = 0; i < RootedCamClay::state_size; ++i) c.point.state[i] = state[i][l];
    c.point.dissipation = r.dissipation[l];
    c.point.plastic_dilation = r.plastic_dilation[l];
  }
  return cases;
}

template <int NS>
void compare_packs(unsigned seed) {
  support::Draw draw(seed);
  for (int i = 0; i < 3000; ++i) {
    const auto law = support::draw_soil(draw);
    std::array<Case<NS>, lane_width> cases;
    for (auto& c : cases) c = draw_case<NS>(draw, law);
    const auto active = static_cast<unsigned>(draw(0, 1 << lane_width));
    const auto whole = update_pack<NS>(law, cases, active);
    for (std::size_t l = 0; l < lane_width; ++l) {
      if ((active >> l & 1) == 0) continue;
      auto single = cases[l].point;
      single.step(law, cases[l].d_epsilon);
      const double scale = law.find_preconsolidation(single.state.data(), single.saturation) + single.p();
      const auto& lane = whole[l].point;
      for (std::size_t k = 0; k < NS; ++k) ASSERT_NEAR(lane.stress[k], single.stress[k], 1e-9 * scale) << i;
      for (std::size_t k = 0; k < RootedCamClay::state_size; ++k)
        ASSERT_NEAR(lane.state[k], single.state[k], 1e-9 * std::abs(single.state[k]) + 1e-15) << i << " state " << k;
      ASSERT_NEAR(lane.dissipation, single.dissipation, 1e-9 * scale) << i;
      ASSERT_NEAR(lane.plastic_dilation, single.plastic_dilation, 1e-9 * std::abs(single.plastic_dilation) + 1e-14)
          << i;
      // and alone in its pack a lane is bitwise identical: results do not depend on other lanes
      const auto alone = update_pack<NS>(law, cases, 1u << l);
      ASSERT_EQ(alone[l].point.stress, lane.stress) << i;
      ASSERT_EQ(alone[l].point.state, lane.state) << i;
    }
  }
}

TEST(CamClayLanes, PacksGiveWhatDoublesGive) {
  compare_packs<4>(1);
  compare_packs<6>(2);
}

TEST(CamClayLanes, PlaneStrainIsSpaceWithoutShearOutOfThePlane) {
  support::Draw draw(4);
  for (int i = 0; i < 3000; ++i) {
    const auto law = support::draw_soil(draw);
    const auto plane = draw_case<4>(draw, law);
    Case<6> space;
    std::copy_n(plane.point.stress.begin(), 4, space.point.stress.begin());
    space.d_epsilon = {plane.d_epsilon[0], plane.d_epsilon[1], plane.d_epsilon[2], plane.d_epsilon[3], 0, 0};
    space.point.state = plane.point.state;
    space.point.saturation = plane.point.saturation;
    auto flat = plane.point;
    flat.step(law, plane.d_epsilon);
    space.point.step(law, space.d_epsilon);
    const double scale = law.find_preconsolidation(flat.state.data(), flat.saturation) + flat.p();
    for (std::size_t k = 0; k < 4; ++k) ASSERT_NEAR(space.point.stress[k], flat.stress[k], 1e-9 * scale);
    ASSERT_EQ(space.point.stress[4], 0);
    ASSERT_EQ(space.point.stress[5], 0);
  }
}

using Tensor = Eigen::Matrix3d;

/// Voigt to tensor, of four components in plane strain; shear strains are engineering strains.
template <std::size_t NS>
Tensor to_tensor(const std::array<double, NS>& v, bool strain) {
  const double h = strain ? 0.5 : 1;
  std::array<double, 6> all{};
  std::copy(v.begin(), v.end(), all.begin());
  return Tensor{{all[0], h * all[3], h * all[5]}, {h * all[3], all[1], h * all[4]}, {h * all[5], h * all[4], all[2]}};
}
std::array<double, 6> to_voigt(const Tensor& t, bool strain) {
  const double h = strain ? 2 : 1;
  return {t(0, 0), t(1, 1), t(2, 2), h * t(0, 1), h * t(1, 2), h * t(2, 0)};
}

TEST(CamClayLanes, DoNotDependOnTheAxes) {
  support::Draw draw(5);
  for (int i = 0; i < 1000; ++i) {
    const auto law = support::draw_soil(draw);
    const auto c = draw_case<6>(draw, law);
    const Tensor turn =
        Eigen::AngleAxisd(draw(-3, 3), Eigen::Vector3d(draw(-1, 1), draw(-1, 1), 1).normalized()).toRotationMatrix();
    auto turned = c;
    turned.point.stress = to_voigt(turn * to_tensor(c.point.stress, false) * turn.transpose(), false);
    turned.d_epsilon = to_voigt(turn * to_tensor(c.d_epsilon, true) * turn.transpose(), true);
    auto point = c.point;
    point.step(law, c.d_epsilon);
    turned.point.step(law, turned.d_epsilon);
    const double scale = law.find_preconsolidation(point.state.data(), point.saturation) + point.p() + point.q();
    const Tensor difference =
        turn * to_tensor(point.stress, false) * turn.transpose() - to_tensor(turned.point.stress, false);
    ASSERT_LT(difference.norm(), 1e-8 * scale) << i;
  }
}

/// A twin without preconsolidation has the elastic stress: what is missing from it is the plastic strain.
template <int NS>
void compare_with_plastic_strain() {
  support::Draw draw(6);
  int plastic = 0;
  for (int i = 0; i < 3000; ++i) {
    auto law = support::draw_soil(draw);
    const auto c = draw_case<NS>(draw, law);
    auto point = c.point, twin = c.point;
    twin.state[1] = law.not_set;
    point.step(law, c.d_epsilon);
    twin.step(law, c.d_epsilon);
    const Tensor before = to_tensor(c.point.stress, false), after = to_tensor(point.stress, false);
    const Tensor elastic = to_tensor(twin.stress, false), d = to_tensor(c.d_epsilon, true), one = Tensor::Identity();
    const double volume = d.trace(), bulk = (elastic - before).trace() / 3 / volume;
    const double shear = bulk * 3 * (1 - 2 * law.soil().poisson_ratio) / (2 * (1 + law.soil().poisson_ratio));
    const Tensor missing = elastic - after;
    const double mean = missing.trace() / 3;
    const Tensor flow = (missing - mean * one) / (2 * shear) + mean / (3 * bulk) * one;
    if (point.dissipation > 0) ++plastic;
    const double p_c = law.find_preconsolidation(point.state.data(), point.saturation);
    const double scale = (elastic.norm() + before.norm() + p_c) * 1e-9;
    EXPECT_NEAR(point.plastic_dilation, flow.diagonal().head<(NS == 4 ? 2 : 3)>().sum(),
                1e-6 * flow.norm() + scale / bulk)
        << i;
    EXPECT_NEAR(point.dissipation, (after.array() * flow.array()).sum(), 1e-6 * point.dissipation + scale * flow.norm())
        << i;
    const double deviatoric = std::sqrt(2.0 / 3) * (flow - flow.trace() / 3 * one).norm();
    EXPECT_NEAR(point.state[0], deviatoric, 1e-6 * deviatoric + scale / shear) << i;
  }
  EXPECT_GT(plastic, 1000);
}

TEST(CamClayLanes, ResponseIsThatOfThePlasticStrain) {
  compare_with_plastic_strain<4>();
  compare_with_plastic_strain<6>();
}

/// (T23.2): nonlocal plastic dilation softens the soil like its own.
TEST(CamClayLanes, SoftensByNonlocalDilation) {
  support::Draw draw(7);
  for (int i = 0; i < 200; ++i) {
    const auto law = support::draw_soil(draw);
    auto point = support::draw_clay_point<4>(draw, law);
    const double nonlocal_correction = draw(-1e-3, 1e-3), before = point.state[1], e = point.state[2];
    double nothing[4] = {};
    const double inside = 0.5 * law.find_preconsolidation(point.state.data(), point.saturation);
    for (std::size_t k = 0; k < 4; ++k) point.stress[k] = k < 3 ? -inside : 0;
    material::Surroundings<double> around;
    around.saturation = point.saturation;
    material::Softening<double> softening{nonlocal_correction};
    around.softening = &softening;
    law.update<4>(point.stress.data(), nothing, point.state.data(), true, around);
    const double slope = (1 + e) / (law.soil().compression - law.soil().swelling);
    EXPECT_NEAR(point.state[1], before * std::exp(-slope * nonlocal_correction), 1e-12 * before);
  }
}

}  // namespace
