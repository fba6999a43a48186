// SPDX-License-Identifier: MIT
// Fronts, volumes and retreats from the thickness over the old ground: shapes with exact answers, and soil in front
// that is pushed or heaves.

#include "run/mpm/record/deposit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run/mpm/record/runout.hpp"
#include "support/soil_body.hpp"

namespace talus::run {
namespace {

constexpr double length = 100, base = 5, grain = 0.1;

ColumnGrid make_grid(double left = 0, double scale = 1) {
  return {left, scale, static_cast<int>(length), 0, 1, 1};
}

/// Cubes below `top(x)` and above y = `from`.
std::vector<SoilCube> fill(double from, const std::function<double(double)>& top) {
  std::vector<SoilCube> soil;
  for (double x = 0.5 * grain; x < length; x += grain)
    for (double y = from + 0.5 * grain; y < top(x); y += grain) soil.push_back({x, y, 0, grain, grain * grain});
  return soil;
}

std::vector<SoilCube> make_level_ground() {
  return fill(base - 1, [](double) { return base; });
}

/// A wedge on level ground, 4 m thick at x = 20 m and 0 at x = 60 m.
std::vector<SoilCube> make_wedge() {
  return fill(base, [](double x) { return x < 20 ? 0 : base + 0.1 * (60 - x); });
}

TEST(Deposit, OfAWedgeEndsWhereItIsAsThickAsAsked) {
  const Ground ground(make_grid(), make_level_ground());
  for (const double least : {0.25, 0.5, 1.0, 2.0}) {
    const Deposit deposit = measure_deposit(make_wedge(), &ground, make_grid(), 1, least);
    EXPECT_NEAR(deposit.front.value(), 60 - 10 * least, 0.5 * 10 * grain) << least;
    EXPECT_NEAR(deposit.volume, 80, 0.01 * 80);
  }
  EXPECT_FALSE(measure_deposit(make_wedge(), &ground, make_grid(), 1, 4.2).front) << "nowhere so thick";
  // Its rear end is vertical; the mean over 1 m reaches a quarter of 4 m a quarter of 1 m before its middle lies there.
  EXPECT_NEAR(measure_deposit(make_wedge(), &ground, make_grid(), -1, 1.0).front.value(), 19.75, 0.02);
}

TEST(Deposit, OfAMirroredOrShiftedOrScaledSectionIsTheSame) {
  const auto measure = [](double sign, double shift, double scale) {
    std::vector<SoilCube> soil = make_wedge(), before = make_level_ground();
    for (auto* list : {&soil, &before})
      for (SoilCube& c : *list)
        c = {scale * (sign > 0 ? c.x : length - c.x) + shift, scale * (c.y + shift), 0, scale * c.size,
             scale * scale * c.volume};
    const ColumnGrid grid = make_grid(shift, scale);
    const Ground ground(grid, before);
    const Deposit deposit = measure_deposit(soil, &ground, grid, sign > 0 ? 1 : -1, 0.5 * scale);
    const double x = (deposit.front.value() - shift) / scale;
    return std::pair{sign > 0 ? x : length - x, deposit.volume / (scale * scale)};
  };
  const auto [front, volume] = measure(1, 0, 1);
  for (const auto& [x, v] : {measure(-1, 0, 1), measure(1, 1000, 1), measure(1, 0, 0.3048), measure(-1, -70, 3.2)}) {
    EXPECT_NEAR(x, front, 1e-7);
    EXPECT_NEAR(v, volume, 1e-7 * volume);
  }
}

TEST(Deposit, IsNotASinglePointThatRolledAhead) {
  const Ground ground(make_grid(), make_level_ground());
  std::vector<SoilCube> soil = make_wedge();
  const double front = measure_deposit(soil, &ground, make_grid(), 1, 0.25).front.value();
  soil.push_back({80, base + 0.2, 0, 0.4, 0.16});  // a third of an element: 0.16 m over its metre
  EXPECT_EQ(measure_deposit(soil, &ground, make_grid(), 1, 0.25).front.value(), front);
}

TEST(Deposit, OnAFloorWithoutSoilIsAllSoil) {
  const std::vector<SoilCube> soil = fill(0, [](double x) { return x < 30 ? 2 : 0; });
  const Ground nothing(make_grid(), {});
  EXPECT_NEAR(measure_deposit(soil, &nothing, make_grid(), 1, 1).front.value(), 30, 1e-6);
  EXPECT_NEAR(measure_deposit(soil, &nothing, make_grid(), 1, 1).volume, 60, 1e-6);
}

TEST(Retreat, IsTheDistanceOfTheRearmostGroundThatSank) {
  // The ground sinks linearly from 0 at x = 30 m to 4 m at x = 50 m, the crest.
  const auto sink = [](double x) { return x < 30 || x > 50 ? 0.0 : 0.2 * (x - 30); };
  const Ground before(make_grid(), fill(0, [](double) { return 10; })),
      now(make_grid(), fill(0, [&](double x) { return 10 - sink(x); }));
  const Stretch all{0, length};
  for (const double least : {0.5, 1.0, 2.0})
    EXPECT_NEAR(measure_retreat(before, now, 50, 1, least, all), 20 - 5 * least, 1.1 * 5 * grain + 0.5) << least;
  EXPECT_EQ(measure_retreat(before, before, 50, 1, 0.5, all), 0);
  EXPECT_EQ(measure_retreat(before, now, 50, 1, 5, all), 0) << "it sinks by 4 m at most";
  EXPECT_EQ(measure_retreat(before, now, 20, 1, 0.5, {0, 20}), 0) << "of the other side";
  // The same from the other side.
  const auto mirror = [](const std::function<double(double)>& top) {
    return fill(0, [top](double x) { return top(length - x); });
  };
  const Ground there(make_grid(), mirror([&](double x) { return 10 - sink(x); }));
  EXPECT_NEAR(measure_retreat(before, there, 50, -1, 1, all), measure_retreat(before, now, 50, 1, 1, all), 1e-9);
}

/// Soil at rest where it is now; the tests say where it came from. Level ground, y < 8 m, with a bank of 10 m left of
/// x = 15 m and a sheet of 1 m over the ground in front of it, to x = 25 m. Elements of 1 m. `heave`: of
/// the ground from x = 28 m to 36 m [m].
mpm::Body<2> make_slide(double elevation = 0, bool is_mirrored = false, double heave = 0) {
  mesh::Mesh<2> mesh = support::make_mesh<2>({40, 13}, {40, 13}, 0);
  for (Vec<2>& x : mesh.nodes) x[1] += elevation;
  return support::fill_body<2>(std::move(mesh), {{material::LinearElastic::from_young(1e7, 0.3)}}, 3,
                               [=](const Vec<2>& at) {
                                 const double x = is_mirrored ? 40 - at[0] : at[0];
                                 const double top = x < 15 ? 10 : x < 25 ? 9 : x > 28 && x < 36 ? 8 + heave : 8;
                                 return at[1] - elevation < top ? 0 : -1;
                               });
}

/// The sheet came from the top of the bank, 5 < x < 15, 10 < y < 11.
void move_sheet(mpm::Body<2>& body, double elevation = 0, bool is_mirrored = false) {
  support::for_each_point(body, [&](int id, const auto& p) {
    const double x = is_mirrored ? 40 - p.position[0] : p.position[0], y = p.position[1];
    if (y - elevation > 8 && x > 15)
      body.points.reference[static_cast<std::size_t>(id)] = {p.position[0] + (is_mirrored ? 10 : -10), y + 2};
  });
}

results::Runout measure(const mpm::Body<2>& body) {
  return find_runout(body, {find_profile(body, 1.0), 0.5});
}

/// The ends are vertical, so that the mean over an element reaches a quarter of the thickness a quarter of an element
/// beyond them; points lie up to a fifth of an element from the sides of theirs.
constexpr double near = 0.3;

void expect_sheet(const results::Runout& r) {
  EXPECT_EQ(r.direction, 1);
  EXPECT_NEAR(r.initial_toe, 15, 1e-9);
  EXPECT_NEAR(r.toe, 25.25, near);
  EXPECT_NEAR(r.toe_distance, 10.25, near);
  EXPECT_NEAR(r.front_advance, 10, near);
  EXPECT_NEAR(r.deposit_volume, 10, 0.82) << "the level of the ground is known to a fifth of the side of a point";
  EXPECT_NEAR(r.crest, 14.5, 1e-9);
  EXPECT_NEAR(r.crest_retreat, 14.5 - 4.75, near);
}

TEST(Runout, OfASheetThatSlidOverTheGroundIsItsLengthBeyondTheToe) {
  mpm::Body<2> body = make_slide();
  move_sheet(body);
  const results::Runout r = measure(body);
  expect_sheet(r);
  EXPECT_NEAR(r.moved_volume, 10, 1e-9);
  EXPECT_NEAR(r.deposit_threshold, 0.25, 1e-9) << "a quarter of an element; a twentieth of 3 m is less";
  EXPECT_NEAR(r.lowest_ground, 8, 0.1);
}

TEST(Runout, DoesNotCountGroundInFrontThatIsPushed) {
  mpm::Body<2> body = make_slide();
  move_sheet(body);
  support::for_each_point(body, [&](int id, const auto& p) {
    if (p.position[0] > 17 && p.position[1] < 8)
      body.points.reference[static_cast<std::size_t>(id)] = {p.position[0] - 2, p.position[1]};
  });
  const results::Runout r = measure(body);
  expect_sheet(r);
  EXPECT_GT(r.moved_volume, 100) << "the ground in front moved as well";
  EXPECT_GT(r.mass_front, 39) << "to the end of the box";
}

TEST(Runout, DoesNotCountGroundInFrontThatHeaves) {
  mpm::Body<2> body = make_slide(0, false, 1);
  move_sheet(body);
  support::for_each_point(body, [&](int id, const auto& p) {
    if (p.position[0] > 28 && p.position[0] < 36 && p.position[1] > 4)
      body.points.reference[static_cast<std::size_t>(id)] = {p.position[0] - 1, p.position[1] - 1};
  });
  const results::Runout r = measure(body);
  expect_sheet(r);
  EXPECT_NEAR(r.moved_volume, 10 + 8 * 5, 1e-6);
  EXPECT_GT(r.mass_front, 35);
}

TEST(Runout, IsTheSameAtAnyElevationAndInTheMirror) {
  mpm::Body<2> high = make_slide(1000), mirrored = make_slide(0, true);
  move_sheet(high, 1000);
  move_sheet(mirrored, 0, true);
  expect_sheet(measure(high));
  results::Runout r = measure(mirrored);
  EXPECT_EQ(r.direction, -1);
  r.direction = 1;
  for (double* x : {&r.initial_toe, &r.toe, &r.crest}) *x = 40 - *x;
  expect_sheet(r);
}

TEST(Runout, CountsNoGapsBetweenSoil) {
  mpm::Body<2> body = make_slide();
  move_sheet(body);
  // As if it were twice as dense at the start: the points of now have gaps between them.
  std::vector<double> dense = find_specific_volumes(body);
  ASSERT_EQ(dense.size(), 1u);
  EXPECT_NEAR(dense[0], 1 / 1800.0, 1e-12);
  dense[0] /= 2;
  const results::Runout r = find_runout(body, {find_profile(body, 1.0), 0.5, dense});
  EXPECT_NEAR(r.moved_volume, 5, 1e-9);
  EXPECT_LT(r.deposit_volume, 5 + 1e-9);
}

TEST(Runout, OfSoilThatDidNotMoveIsNothing) {
  const results::Runout r = measure(make_slide());
  for (const double number : {r.moved_volume, r.deposit_volume, r.front_advance, r.toe_distance, r.crest_retreat})
    EXPECT_EQ(number, 0);
}

}  // namespace
}  // namespace talus::run
