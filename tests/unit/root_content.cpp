// SPDX-License-Identifier: MIT
// Root distribution: depth normal to inclined ground and around its corners, profiles, planting along the slope, age
// and felling, sum of several blocks, and the soils that they affect.

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "site/roots.hpp"

namespace talus {
namespace {

using input::Roots;
using site::find_age_share;
using site::find_depths;
using site::find_ground_cohesion;
using site::find_root_share;
using site::find_roots;

/// Ground of the vegetated slope: crest at y = 5 to x = 3, face down to (7, 1), foot to x = 11; sides of 0.25 m.
mesh::Mesh<2> make_ground() {
  mesh::Mesh<2> mesh;
  const std::array<Vec<2>, 4> corners{{{0, 5}, {3, 5}, {7, 1}, {11, 1}}};
  mesh.nodes.push_back(corners[0]);
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const int pieces = 16;
    for (int i = 1; i <= pieces; ++i) {
      const double fraction = static_cast<double>(i) / pieces;
      mesh.nodes.push_back({corners[k - 1][0] + fraction * (corners[k][0] - corners[k - 1][0]),
                            corners[k - 1][1] + fraction * (corners[k][1] - corners[k - 1][1])});
      const int last = static_cast<int>(mesh.nodes.size()) - 1;
      mesh.sides["ground"].push_back({last - 1, last});
    }
  }
  return mesh;
}

const double root2 = std::sqrt(2.0);

TEST(RootDepth, IsNormalToTheGround) {
  const auto depths = find_depths<2>(make_ground(), "ground",
                                     {{1, 4.5},        // below the crest
                                      {5, 2.8},        // below the face, which passes (5, 3)
                                      {5 - 0.3, 2.7},  // 0.3 √2 into the slope from (5, 3)
                                      {9, 0.2},        // below the foot
                                      {2.9, 4.4},      // below the crest's corner: the face x + y = 8 is nearer
                                      {2.0, 4.9},      // left of it: the crest is
                                      {6.8, 0.5},      // the wedge at the toe: the corner (7, 1) is nearest
                                      {5, 3}});        // on the ground
  EXPECT_NEAR(depths[0], 0.5, 1e-12);
  EXPECT_NEAR(depths[1], 0.2 / root2, 1e-12);
  EXPECT_NEAR(depths[2], 0.3 * root2, 1e-12);
  EXPECT_NEAR(depths[3], 0.8, 1e-12);
  EXPECT_NEAR(depths[4], 0.7 / root2, 1e-12);
  EXPECT_NEAR(depths[5], 0.1, 1e-12);
  EXPECT_NEAR(depths[6], std::hypot(0.2, 0.5), 1e-12);
  EXPECT_NEAR(depths[7], 0, 1e-12);
}

TEST(RootDepth, BisectsTheCornerOfTheCrest) {
  // Crest and face meet at (3, 5) under 135° of soil; on the bisector both are equally far, 1 m along it sin 67.5°.
  const double angle = M_PI + 67.5 * M_PI / 180;
  const Vec<2> on{3 + std::cos(angle), 5 + std::sin(angle)};
  EXPECT_NEAR(find_depths<2>(make_ground(), "ground", {on})[0], std::sin(67.5 * M_PI / 180), 1e-12);
}

TEST(RootDepth, OfAnExtrudedLineIsThatOfItsSection) {
  mesh::Mesh<3> mesh;
  const mesh::Mesh<2> flat = make_ground();
  const int n = flat.node_count();
  for (const double z : {0.0, 0.7, 2.0})
    for (const auto& x : flat.nodes) mesh.nodes.push_back({x[0], x[1], z});
  for (const int layer : {0, n})
    for (const auto& [a, b] : flat.sides.at("ground")) {
      mesh.sides["ground"].push_back({layer + a, layer + b, layer + n + a});
      mesh.sides["ground"].push_back({layer + b, layer + n + b, layer + n + a});
    }
  std::vector<Vec<2>> section{{1, 4.5}, {4.7, 2.7}, {2.9, 4.4}, {6.8, 0.5}, {10.9, 0.95}};
  const auto expected = find_depths<2>(flat, "ground", section);
  for (const double z : {0.0, 0.3, 1.1, 2.0}) {
    std::vector<Vec<3>> places;
    for (const auto& x : section) places.push_back({x[0], x[1], z});
    const auto depths = find_depths<3>(mesh, "ground", places);
    for (std::size_t i = 0; i < places.size(); ++i) EXPECT_NEAR(depths[i], expected[i], 1e-12);
  }
}

TEST(RootDepth, NamesTheLineThatTheMeshLacks) {
  try {
    find_depths<2>(make_ground(), "meadow", {{1, 4.5}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    EXPECT_NE(std::string(error.what()).find("'meadow'"), std::string::npos);
  }
}

TEST(RootFraction, FollowsTheProfileDownToTheDepth) {
  Roots roots;
  roots.depth = 0.5;
  for (const double z : {0.0, 0.3, 0.5}) EXPECT_EQ(find_root_share(roots, z, 0), 1);
  EXPECT_EQ(find_root_share(roots, 0.5001, 0), 0);
  roots.profile = input::RootProfile::exponential;
  roots.decay_depth = 0.2;
  EXPECT_NEAR(find_root_share(roots, 0.4, 0), std::exp(-2.0), 1e-15);
  EXPECT_EQ(find_root_share(roots, 0.6, 0), 0);
  roots.profile = input::RootProfile::table;
  roots.depth_table = {{0.1, 1}, {0.3, 0.4}, {0.4, 0.1}};
  EXPECT_NEAR(find_root_share(roots, 0, 0), 1, 1e-15);
  EXPECT_NEAR(find_root_share(roots, 0.25, 0), 0.55, 1e-12);
  EXPECT_NEAR(find_root_share(roots, 0.45, 0), 0.1, 1e-12);  // constant below its last row, to the depth
  EXPECT_EQ(find_root_share(roots, 0.51, 0), 0);
}

TEST(RootFraction, FollowsThePlantingAlongTheSlope) {
  Roots roots;
  roots.depth = 1;
  roots.along = {{3, 0}, {3, 1}, {5, 1}, {7, 0.5}};  // nothing on the crest
  EXPECT_EQ(find_root_share(roots, 0.2, 2.9), 0);
  EXPECT_EQ(find_root_share(roots, 0.2, 3.1), 1);
  EXPECT_NEAR(find_root_share(roots, 0.2, 6), 0.75, 1e-12);
  EXPECT_NEAR(find_root_share(roots, 0.2, 10), 0.5, 1e-12);
}

TEST(RootAge, GrowsAndDecays) {
  Roots roots;
  EXPECT_EQ(find_age_share(roots), 1);
  const double year = 365.25 * 86400;
  roots.growth = {{0, 0}, {2 * year, 0.4}, {10 * year, 1}};
  EXPECT_EQ(find_age_share(roots), 1);  // a table without an age has no effect
  roots.age = 6 * year;
  EXPECT_NEAR(find_age_share(roots), 0.7, 1e-12);
  roots.felled = 3 * year;
  roots.decay = {{0, 1}, {5 * year, 0.2}, {10 * year, 0}};
  EXPECT_NEAR(find_age_share(roots), 0.7 * 0.52, 1e-12);
  roots.felled = 20 * year;
  EXPECT_EQ(find_age_share(roots), 0);
}

TEST(RootCohesion, OfTheGroundIsGivenOrFromTheBundle) {
  Roots roots;
  EXPECT_FALSE(find_ground_cohesion(roots));
  roots.bundle = input::RootBundle{input::RootBundleModel::wu_waldron, {1e-3, 5e-3}, {1e-4, 4e-4}, {40e6, 15e6}, 1.2};
  EXPECT_NEAR(*find_ground_cohesion(roots), 12e3, 1e-9);
  roots.bundle->model = input::RootBundleModel::fibre_bundle;
  EXPECT_NEAR(*find_ground_cohesion(roots), 7.2e3, 1e-9);
  roots.cohesion = 5e3;
  EXPECT_EQ(*find_ground_cohesion(roots), 5e3);
}

input::Material make_soil(input::MaterialModel kind, double content = 0, double cohesion = 0) {
  input::Material soil;
  soil.model = kind;
  soil.root_content = content;
  soil.root_cohesion = cohesion;
  return soil;
}

TEST(RootsAtPlaces, AddUpWhereBlocksReachAndAreTheMaterialsElsewhere) {
  input::Case data;
  Roots grass, shrubs, cuttings;
  grass.ground = shrubs.ground = cuttings.ground = "ground";
  grass.depth = 0.3;
  grass.content = 0.5;
  shrubs.depth = 1;
  shrubs.profile = input::RootProfile::exponential;
  shrubs.decay_depth = 0.5;
  shrubs.content = 0.2;
  shrubs.age = 1;
  shrubs.growth = {{0, 0}, {2, 1}};
  cuttings.depth = 0.6;
  cuttings.cohesion = 4e3;
  data.roots = {grass, shrubs, cuttings};
  const auto clay = make_soil(material::model_of<material::RootedCamClay>, 0.05),
             sand = make_soil(material::model_of<material::RootedMohrCoulomb>, 0, 700),
             bare = make_soil(material::model_of<material::ModifiedCamClay>, 0.3),
             plain = make_soil(material::model_of<material::MohrCoulomb>, 0, 900);
  const std::vector<Vec<2>> places{{1, 4.8}, {1, 4.5}, {1, 3.5}, {1, 4.8}, {1, 4.3}, {1, 4.8}, {1, 4.8}, {1, 4.5}};
  const std::vector<const input::Material*> soils{&clay, &clay, &clay, &sand, &sand, &bare, &plain, &sand};
  const auto roots = find_roots<2>(data, make_ground(), places, soils);
  EXPECT_NEAR(roots[0].content, 0.5 + 0.1 * std::exp(-0.4), 1e-12);  // grass and shrubs of half their age
  EXPECT_NEAR(roots[1].content, 0.1 * std::exp(-1.0), 1e-12);
  EXPECT_EQ(roots[2].content, 0.05);  // below all
  EXPECT_EQ(roots[3].cohesion, 4e3);
  EXPECT_EQ(roots[3].content, 0);
  EXPECT_EQ(roots[4].cohesion, 700);
  EXPECT_EQ(roots[5].content, 0);  // soils without a rooted model have no roots
  EXPECT_EQ(roots[6].cohesion, 0);
  EXPECT_EQ(roots[7].cohesion, 4e3);
}

TEST(RootsAtPlaces, LeaveABlockThatOnlyDrinksAside) {
  input::Case data;
  Roots thirst;
  thirst.ground = "ground";
  thirst.depth = 1;
  thirst.transpiration = input::Transpiration{};
  data.roots = {thirst};
  const auto clay = make_soil(material::model_of<material::RootedCamClay>, 0.4);
  EXPECT_EQ(find_roots<2>(data, make_ground(), {{1, 4.8}}, {&clay})[0].content, 0.4);
}

}  // namespace
}  // namespace talus
