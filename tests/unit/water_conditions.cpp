// SPDX-License-Identifier: MIT
// Nodes at which water is fixed, and their conditions: walls, skins, lines inside the soil, and moving ground.

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/wet_case.hpp"

namespace talus {
namespace {

using namespace support;
using input::WaterCondition;

template <int D>
const mpm::SurfaceCondition& get_surface(const mpm::Body<D>& body, const std::type_identity_t<Vec<D>>& x) {
  const int node = find_node<D>(body.mesh(), x);
  EXPECT_GE(node, 0);
  const auto number = static_cast<std::size_t>(body.water.surface_of_node[static_cast<std::size_t>(node)]);
  return body.water.surfaces[number];
}

/// Fixed directions at a node, as sums of |component|: (1, 1) at a corner.
Vec<2> get_fixed(const mpm::Body<2>& body, const Vec<2>& x) {
  Vec<2> sum{};
  const int c = body.water.constraint_of_node[static_cast<std::size_t>(find_node<2>(body.mesh(), x))];
  if (c < 0) return sum;
  const mpm::WaterConstraint<2>& held = body.water.constraints[static_cast<std::size_t>(c)];
  for (int k = 0; k < held.fixed_count; ++k)
    for (std::size_t d = 0; d < 2; ++d) sum[d] += std::abs(held.fixed[k][d]);
  return sum;
}

void expect_fixed(const mpm::Body<2>& body, const Vec<2>& x, const Vec<2>& wanted) {
  const Vec<2> held = get_fixed(body, x);
  for (std::size_t d = 0; d < 2; ++d) EXPECT_NEAR(held[d], wanted[d], 1e-9) << x[0] << ", " << x[1];
}

mpm::Body<2> prepare_step(const std::vector<input::Hydraulic>& hydraulics) {
  input::Case data = make_box_case<2>(make_wet_soil());
  data.hydraulics = hydraulics;
  return run::prepare<2>(data, make_step_mesh<2>());
}

TEST(WaterConditions, RollersHoldTheWaterAndFixedSoilHoldsItAlongTheNormalOnly) {
  input::Case data = make_box_case<2>(make_wet_soil());
  for (input::Boundary& b : data.boundaries) b.fix = b.on == "bottom" ? input::Fix::full : b.fix;
  const auto body = run::prepare<2>(data, make_step_mesh<2>());
  expect_fixed(body, {0, 1}, {1, 0});
  expect_fixed(body, {2, 0}, {0, 1});
  expect_fixed(body, {0, 0}, {1, 1});
  expect_fixed(body, {1, 2}, {0, 0});
  EXPECT_EQ(body.water.surfaces.size(), 1u) << "rollers have no condition";
}

TEST(WaterConditions, AHeadOpensTheWallItIsOn) {
  const auto body = prepare_step({make_hydraulic("left", WaterCondition::total_head, 1.4)});
  expect_fixed(body, {0, 1}, {0, 0});
  expect_fixed(body, {0, 0}, {0, 1});
  EXPECT_EQ(get_surface<2>(body, {0, 1}).kind, mpm::SurfaceKind::head);
  EXPECT_EQ(get_surface<2>(body, {0, 1.5}).name, "left") << "above its level it is a seepage face";
  EXPECT_EQ(get_surface<2>(body, {1, 2}).name, "other surfaces");
  EXPECT_EQ(get_surface<2>(body, {2, 0.5}).name, "other surfaces") << "a wall's condition stays at the wall";
}

TEST(WaterConditions, NoFlowOnTheGroundIsASkinAndOnAWallAWall) {
  const auto body =
      prepare_step({make_hydraulic("crest", WaterCondition::no_flow), make_hydraulic("left", WaterCondition::no_flow)});
  const auto& skin = get_surface<2>(body, {1, 2});
  EXPECT_EQ(skin.kind, mpm::SurfaceKind::flux);
  EXPECT_EQ(skin.value.at(3), 0);
  expect_fixed(body, {1, 2}, {0, 0});
  expect_fixed(body, {0, 1}, {1, 0});
}

TEST(WaterConditions, FollowTheNearestGround) {
  const auto body = prepare_step(
      {make_hydraulic("crest", WaterCondition::rain, 1e-6), make_hydraulic("foot", WaterCondition::total_head, 1.4)});
  EXPECT_EQ(get_surface<2>(body, {1, 3}).name, "crest") << "soil may come there";
  EXPECT_EQ(get_surface<2>(body, {0, 1.5}).name, "crest") << "or fall to there";
  EXPECT_EQ(get_surface<2>(body, {3.5, 2}).name, "foot");
  EXPECT_EQ(get_surface<2>(body, {4, 0.5}).name, "foot") << "a side of the box, by the nearest ground";
  EXPECT_EQ(get_surface<2>(body, {2, 1.5}).name, "other surfaces") << "the cliff has no name";
  EXPECT_EQ(get_surface<2>(body, {2, 2}).name, "crest") << "a named condition goes before none";
  EXPECT_EQ(get_surface<2>(body, {2, 1}).name, "foot");
  const auto dry_foot = prepare_step({make_hydraulic("crest", WaterCondition::rain, 1e-6),
                                      make_hydraulic("foot", WaterCondition::total_head, 0.5),
                                      make_hydraulic("left", WaterCondition::total_head, 1.4)});
  EXPECT_EQ(get_surface<2>(dry_foot, {0, 2}).name, "crest") << "a head above its level gives way to rain";
}

TEST(WaterConditions, FollowTheNearestGroundInThreeDimensions) {
  input::Case data = make_box_case<3>(make_wet_soil());
  data.hydraulics = {make_hydraulic("crest", WaterCondition::rain, 1e-6),
                     make_hydraulic("foot", WaterCondition::total_head, 1.4)};
  const auto body = run::prepare<3>(data, make_step_mesh<3>());
  EXPECT_EQ(get_surface<3>(body, {1, 3, 0.5}).name, "crest");
  EXPECT_EQ(get_surface<3>(body, {3.5, 2, 1}).name, "foot");
  EXPECT_EQ(get_surface<3>(body, {2, 1.5, 0.5}).name, "other surfaces");
  EXPECT_EQ(get_surface<3>(body, {2, 1, 0}).name, "foot");
  const auto c = body.water.constraint_of_node[static_cast<std::size_t>(find_node<3>(body.mesh(), {0, 0, 0}))];
  ASSERT_GE(c, 0);
  EXPECT_EQ(body.water.constraints[static_cast<std::size_t>(c)].fixed_count, 3);
}

TEST(WaterConditions, AnInclinedImpermeableLineHoldsTheWaterAcrossIt) {
  mesh::Mesh<2> mesh = make_step_mesh<2>();
  const auto diagonal = [](const Vec<2>& x) { return std::abs(x[0] - x[1]) < 1e-9 && x[0] < 1.6; };
  const auto other = [](const Vec<2>& x) { return std::abs(x[0] + x[1] - 1.5) < 1e-9; };
  name_line<2>(mesh, "clay", diagonal);
  const bool rising = !mesh.sides["clay"].empty();
  if (!rising) name_line<2>(mesh, "clay", other);
  ASSERT_FALSE(mesh.sides["clay"].empty());
  input::Case data = make_box_case<2>(make_wet_soil());
  data.hydraulics = {make_hydraulic("clay", WaterCondition::no_flow)};
  const auto body = run::prepare<2>(data, mesh);
  expect_fixed(body, rising ? Vec<2>{1, 1} : Vec<2>{1, 0.5}, {std::sqrt(0.5), std::sqrt(0.5)});
}

TEST(WaterConditions, PressuresChangeTheirSign) {
  const auto body = prepare_step({make_hydraulic("foot", WaterCondition::pressure, 5e3)});
  EXPECT_EQ(get_surface<2>(body, {3, 1}).kind, mpm::SurfaceKind::pressure);
  EXPECT_EQ(get_surface<2>(body, {3, 1}).value.at(0), -5e3);
}

TEST(WaterConditions, RainThatMeetsNoWaterIsAFault) {
  mesh::Mesh<2> mesh = make_step_mesh<2>();
  name_line<2>(mesh, "inside", [](const Vec<2>& x) { return std::abs(x[1] - 0.5) < 1e-9; });
  input::Case data = make_box_case<2>(make_wet_soil());
  data.hydraulics = {make_hydraulic("inside", WaterCondition::rain, 1e-6)};
  try {
    (void)run::prepare<2>(data, mesh);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    EXPECT_NE(std::string(error.what()).find("'inside' has no effect"), std::string::npos) << error.what();
  }
}

TEST(WaterConditions, BendsOfAWallAreClosedByASkin) {
  // The bottom is lifted in the middle, so that it is no straight line.
  mesh::Mesh<2> mesh = make_step_mesh<2>();
  for (auto& x : mesh.nodes) x[1] += 0.02 * (x[0] < 2 ? x[0] : 4 - x[0]) * (3 - x[1]);
  mesh::finish(mesh, mesh::Order::as_given);
  const auto body = run::prepare<2>(make_box_case<2>(make_wet_soil()), mesh);
  ASSERT_EQ(body.water.surfaces.size(), 2u);
  int closed = 0;
  for (const int number : body.water.surface_of_node) closed += number == 1;
  EXPECT_EQ(closed, 1) << "the top of the bend only";
  EXPECT_EQ(body.water.surfaces[1].kind, mpm::SurfaceKind::flux);
}

}  // namespace
}  // namespace talus
