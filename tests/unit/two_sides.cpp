// SPDX-License-Identifier: MIT
// Division of sections whose soil moves to both sides, and the sentences on each side.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/planar.hpp"
#include "run/mpm/record/runout.hpp"
#include "run/mpm/record/sections.hpp"
#include "support/soil_body.hpp"

namespace talus::run {
namespace {

using mesh::find_divide;
using mesh::MovedSoil;

TEST(Divide, LiesBetweenSoilThatMovesApartOrTogether) {
  const std::vector<MovedSoil> apart{{1, -1, 2}, {2, -2, 2}, {3, 0.01, 9}, {5, 1, 2}, {6, 1, 2}};
  const auto divide = find_divide(apart, 0.1);
  ASSERT_TRUE(divide);
  EXPECT_EQ(divide->left, -1);
  EXPECT_DOUBLE_EQ(divide->x, 3.5) << "what hardly moves across has no side";
  std::vector<MovedSoil> together = apart;
  for (MovedSoil& s : together) s.across = -s.across;
  EXPECT_EQ(find_divide(together, 0.1)->left, 1);
}

TEST(Divide, IsNotWhereTheSoilMovesOneWay) {
  std::vector<MovedSoil> soil;
  for (int i = 0; i < 100; ++i) soil.push_back({0.1 * i, 1, 1});
  EXPECT_FALSE(find_divide(soil, 0.1));
  for (int i = 0; i < 4; ++i) soil[static_cast<std::size_t>(i)].across = -1;
  EXPECT_FALSE(find_divide(soil, 0.1)) << "less than a twentieth";
  for (int i = 4; i < 10; ++i) soil[static_cast<std::size_t>(i)].across = -1;
  EXPECT_TRUE(find_divide(soil, 0.1));
  EXPECT_FALSE(find_divide(soil, 2)) << "nothing moved so far";
  EXPECT_FALSE(find_divide({}, 0));
  // Soil that moves here and there in turn.
  for (std::size_t i = 0; i < soil.size(); ++i) soil[i].across = i % 2 == 0 ? 1 : -1;
  EXPECT_FALSE(find_divide(soil, 0.1));
}

constexpr double centre = 20, radius = 8;

/// Two circular slides of one level ground, symmetrical about x = 20, which meet at its middle.
MovedSection make_slides(bool with_right = true) {
  MovedSection s;
  s.spacing = 0.25;
  for (double x = 0.125; x < 40; x += 0.25)
    for (double y = 0.125; y < 10; y += 0.25) {
      const bool is_left = x < centre;
      const double of = is_left ? centre - radius : centre + radius;
      const bool moves = std::hypot(x - of, y - 12) < radius && (is_left || with_right);
      s.positions.push_back({x, y});
      s.displacement.push_back(moves ? 1 : 0);
      s.across.push_back(!moves ? 0 : is_left ? -1 : 1);
    }
  return s;
}

TEST(MovedLimit, OfEachSideIsItsOwnAndTheMirrorOfTheOther) {
  const MovedLimit limit = find_moved_limit(make_slides(), 0.5);
  ASSERT_EQ(limit.sides.size(), 2u);
  const auto &left = limit.sides[0], &right = limit.sides[1];
  EXPECT_EQ(left.direction, -1);
  EXPECT_EQ(right.direction, 1);
  EXPECT_TRUE(limit.line == left.points || limit.line == right.points);
  for (const auto& x : left.points) EXPECT_NEAR(std::hypot(x[0] - (centre - radius), x[1] - 12), radius, 0.45) << x[0];
  ASSERT_EQ(left.points.size(), right.points.size());
  // Columns are counted from x = 0, so mirrored ones lie up to one apart.
  for (std::size_t i = 0; i < left.points.size(); ++i) {
    const auto& x = right.points[right.points.size() - 1 - i];
    EXPECT_NEAR(2 * centre - x[0], left.points[i][0], 0.4);
    EXPECT_NEAR(x[1], left.points[i][1], 0.4);
  }
}

TEST(MovedLimit, OfOneSlideIsThatOfTheSlideAlone) {
  const MovedLimit both = find_moved_limit(make_slides(), 0.5), one = find_moved_limit(make_slides(false), 0.5);
  EXPECT_TRUE(one.sides.empty());
  // The line continues to the ground where the other slide begins.
  const auto& left = both.sides[0].points;
  ASSERT_GE(left.size(), one.line.size());
  EXPECT_TRUE(std::equal(one.line.begin(), one.line.end(), left.begin()));
}

TEST(MovedLimit, UnderOneBasinRisesFromTheDivideToTheGround) {
  // An embankment that spreads: all soil above a level basin moves away from the middle.
  MovedSection s;
  s.spacing = 0.25;
  for (double x = 0.125; x < 40; x += 0.25)
    for (double y = 0.125; y < 10; y += 0.25) {
      const bool moves = y > 4 + std::pow((x - centre) / 8, 4);
      s.positions.push_back({x, y});
      s.displacement.push_back(moves ? 1 : 0);
      s.across.push_back(!moves ? 0 : x < centre ? -1 : 1);
    }
  const MovedLimit limit = find_moved_limit(s, 0.5);
  ASSERT_EQ(limit.sides.size(), 2u);
  const auto& left = limit.sides[0].points;
  // 45° + φ/2 = 60° from the middle of the basin at y = 4 to the ground at y = 10.
  EXPECT_NEAR(left.back()[1], 10, 0.3);
  EXPECT_NEAR(left.back()[0], centre + 6 / std::sqrt(3), 0.5);
  EXPECT_NEAR(left.front()[0], centre - 8 * std::pow(6, 0.25), 0.5) << "the toe of its own side";
}

/// A bank of level ground, y < 8, with a crest of y < 10 between x = 14 and x = 26, of elements of 1 m.
mpm::Body<2> make_bank() {
  return support::fill_body<2>(
      support::make_mesh<2>({40, 12}, {40, 12}, 0), {{material::LinearElastic::from_young(1e7, 0.3)}}, 3,
      [](const Vec<2>& x) { return x[1] < 8 || (x[1] < 10 && std::abs(x[0] - centre) < 6) ? 0 : -1; });
}

/// Soil of the crest and of 2 m beside it, above y = 7 m, that moved by up to `left` and `right` [m] to either side,
/// and `drop` [m] down. With 4 m it began within half the distance from the middle: a crest of 3 m and a berm of 1 m on
/// a base at y = 7 m.
void move_bank(mpm::Body<2>& body, double left, double right, double drop = 0.1) {
  support::for_each_point(body, [&](int id, const auto& p) {
    const double x = p.position[0];  // where it is now; it came from the middle
    if (p.position[1] < 7) return;
    auto& from = body.points.reference[static_cast<std::size_t>(id)];
    if (x < centre && x > centre - 8 && left > 0) from = {x + left * (centre - x) / 8, p.position[1] + drop};
    if (x > centre && x < centre + 8 && right > 0) from = {x - right * (x - centre) / 8, p.position[1] + drop};
  });
}

TEST(Runout, OfASymmetricalBankIsTheSameOnBothSides) {
  mpm::Body<2> body = make_bank();
  const results::Profile initial = find_profile(body, 1.0);
  move_bank(body, 4, 4, 1);
  const results::Runout r = find_runout(body, {initial, 0.5});
  ASSERT_TRUE(r.sides);
  ASSERT_EQ(r.sides->size(), 2u);
  const results::RunoutSide &left = (*r.sides)[0], &right = (*r.sides)[1];
  EXPECT_EQ(left.direction, -1);
  EXPECT_EQ(right.direction, 1);
  EXPECT_NEAR(left.moved_volume + right.moved_volume, r.moved_volume, 1e-9 * r.moved_volume);
  EXPECT_NEAR(left.moved_volume, right.moved_volume, 0.05 * r.moved_volume);
  EXPECT_NEAR(left.crest, 17.5, 1e-9);
  EXPECT_NEAR(right.crest, 22.5, 1e-9);
  EXPECT_NEAR(left.deposit_volume + right.deposit_volume, r.deposit_volume, 1e-9 * r.deposit_volume);
  for (const results::RunoutSide& side : *r.sides) {
    EXPECT_NEAR(side.crest_retreat, 2.5, 0.3) << "half of the crest is 3 m wide, and all of it sank";
    EXPECT_NEAR(side.front_advance, 4, 0.3) << "the front moved by the 4 m of its edge";
    EXPECT_NEAR(side.toe_distance, 4, 0.5) << "the smear of a vertical front over a bin";
    EXPECT_GT(side.centre_advance, 0);
  }
  EXPECT_EQ(r.largest_displacement, std::max(left.largest_displacement, right.largest_displacement));
}

TEST(Runout, CountsFromTheToeAndNotFromAHigherBinFarBehindIt) {
  mpm::Body<2> body = make_bank();
  const results::Profile initial = find_profile(body, 1.0);
  move_bank(body, 4, 4);
  support::for_each_point(body, [&](int id, const auto& p) {  // as a coarse mesh may have it
    if (p.position[0] > 39) body.points.reference[static_cast<std::size_t>(id)] = {p.position[0], p.position[1] + 0.3};
  });
  const results::Runout r = find_runout(body, {initial, 0.5});
  ASSERT_TRUE(r.sides);
  EXPECT_NEAR((*r.sides)[0].initial_toe, 16, 1e-9);
  EXPECT_NEAR((*r.sides)[1].initial_toe, 24, 1e-9);
  EXPECT_NEAR((*r.sides)[0].toe_distance, (*r.sides)[1].toe_distance, 0.2);
}

TEST(Runout, ThatMeetsAnEndOfTheBoxIsLimitedByIt) {
  mpm::Body<2> body = make_bank();
  const RunoutStart start{find_profile(body, 1.0), 0.5};
  // Everything right of the middle comes from further left: the soil at the right end moved too.
  support::for_each_point(body, [&](int id, const auto& p) {
    if (p.position[0] > centre)
      body.points.reference[static_cast<std::size_t>(id)] = {p.position[0] - 1, p.position[1]};
  });
  const results::Runout right = find_runout(body, start);
  ASSERT_TRUE(right.limits);
  EXPECT_TRUE(right.limits->front);
  EXPECT_FALSE(right.limits->crest);
  EXPECT_NE(describe_limits(right).find("at the right end of the box"), std::string::npos);
  mpm::Body<2> away = make_bank();
  move_bank(away, 4, 4);
  const results::Runout inside = find_runout(away, start);
  EXPECT_FALSE(inside.limits) << "the soil keeps 10 m from both ends";
  EXPECT_EQ(describe_limits(inside), "");
  // Soil that comes from the left end and does not reach the right one.
  mpm::Body<2> behind = make_bank();
  support::for_each_point(behind, [&](int id, const auto& p) {
    if (p.position[0] < centre)
      behind.points.reference[static_cast<std::size_t>(id)] = {p.position[0] - 1, p.position[1]};
  });
  const results::Runout left = find_runout(behind, start);
  ASSERT_TRUE(left.limits);
  EXPECT_FALSE(left.limits->front);
  EXPECT_TRUE(left.limits->crest);
}

TEST(Runout, OfOneSideIsThatOfThisSideAlone) {
  mpm::Body<2> both = make_bank(), one = make_bank();
  const results::Profile initial = find_profile(both, 1.0);
  move_bank(both, 4, 2);
  move_bank(one, 4, 0);
  const results::Runout a = find_runout(both, {initial, 0.5}), b = find_runout(one, {initial, 0.5});
  ASSERT_TRUE(a.sides);
  EXPECT_FALSE(b.sides);
  const results::RunoutSide& left = (*a.sides)[0];
  EXPECT_EQ(b.direction, -1);
  for (const auto number :
       {&results::RunoutSide::moved_volume, &results::RunoutSide::deposit_volume, &results::RunoutSide::front_advance,
        &results::RunoutSide::toe_distance, &results::RunoutSide::crest_retreat, &results::RunoutSide::mass_front,
        &results::RunoutSide::crest, &results::RunoutSide::centre_advance, &results::RunoutSide::centre_drop,
        &results::RunoutSide::largest_displacement})
    EXPECT_EQ(left.*number, b.*number);
  // The result of the whole is that of the side whose front is farther beyond its toe; the volume is that of both.
  const results::RunoutSide& right = (*a.sides)[1];
  const results::RunoutSide& farther = left.toe_distance > right.toe_distance ? left : right;
  EXPECT_NE(left.toe_distance, right.toe_distance);
  EXPECT_EQ(a.direction, farther.direction);
  EXPECT_EQ(a.crest_retreat, farther.crest_retreat);
  EXPECT_EQ(a.toe_distance, farther.toe_distance);
  EXPECT_NEAR(a.moved_volume, left.moved_volume + right.moved_volume, 1e-9 * a.moved_volume);
}

}  // namespace
}  // namespace talus::run
