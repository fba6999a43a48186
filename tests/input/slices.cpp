// SPDX-License-Identifier: MIT
// [lem], its surfaces, [[surcharge]] and [partial_factors].

#include "methods_slope.hpp"

#include <cmath>

#include "input/case/partial_factors.hpp"

namespace talus::input {
namespace {

const std::string circle = "[[lem.surface]]\nname = \"A\"\ncentre = [30, 55]\nradius = 30.5\n";
const std::string polyline = "[[lem.surface]]\nname = \"B\"\npoints = [[30, 25], [45, 27], [55, 35]]\n";

TEST(Slices, ReadTheirSettings) {
  const Case data =
      read(slices_alone +
           "[lem]\nmethods = [\"fellenius\", \"morgenstern_price_constant\"]\nsearch = \"grid\"\n"
           "slices = 30\nsmallest_depth = \"50 cm\"\n[lem.grid]\ncorners = [[20, 40], [40, 60]]\ncolumns = 7\n"
           "levels = [20, 25]\n[lem.tension_crack]\ndepth = 2\nwater = \"1 m\"\n" +
           circle + polyline);
  EXPECT_EQ(data.lem.methods, (std::vector{SliceMethod::fellenius, SliceMethod::morgenstern_price_constant}));
  EXPECT_EQ(data.lem.search, SurfaceSearch::grid);
  EXPECT_DOUBLE_EQ(data.lem.smallest_depth.value(), 0.5);
  EXPECT_EQ(data.lem.grid.columns, 7);
  EXPECT_EQ(data.lem.grid.corners[1], (std::array{40.0, 60.0}));
  EXPECT_DOUBLE_EQ(data.lem.crack.water, 1);
  ASSERT_EQ(data.lem.surfaces.size(), 2u);
  EXPECT_DOUBLE_EQ(data.lem.surfaces[0].radius.value(), 30.5);
  EXPECT_FALSE(data.lem.surfaces[1].centre.has_value());
  EXPECT_EQ(data.lem.surfaces[1].points.size(), 3u);
}

TEST(Slices, NeedAMethodAndSomethingToCalculate) {
  expect_fault(slices_alone + "[lem]\nmethods = @@[]\n", "name at least one method");
  expect_fault(slices_alone + "[lem]\nmethods = [\"bishop\", @@\"bishop\"]\n", "named twice");
  expect_fault(slices_alone + "[lem]\nmethods = [@@\"bishops\"]\n", "did you mean 'bishop'?");
  expect_fault(slices_alone + "[lem]\nsearch = @@\"none\"\n", "nothing to calculate");
  EXPECT_TRUE(find_faults(slices_alone + "[lem]\nsearch = \"none\"\n" + circle).empty());
}

TEST(Slices, SearchOnTheGround) {
  const std::string between = slices_alone + "[lem.entry_exit]\n";
  EXPECT_TRUE(find_faults(between + "exit = [0, 32]\nentry = [50, 90]\n").empty());
  expect_fault(between + "exit = @@[-5, 32]\n", "reaches beyond the ground, which goes from x = 0 m to x = 90 m");
  expect_fault(between + "entry = @@[60, 50]\n", "'entry' is to be [from, to], two increasing places x");
  expect_fault(between + "entry = @@[60]\n", "two increasing places x");
  const std::string grid = slices_alone + "[lem.grid]\n";
  expect_fault(grid + "corners = @@[[40, 60], [20, 40]]\n", "lower left and the upper right corner");
  expect_fault(grid + "corners = @@[[40, 60]]\n", "lower left and the upper right corner");
  expect_fault(grid + "levels = @@[40, 45]\n", "no soil lies between the 'levels'");
  expect_fault(slices_alone + "[lem.tension_crack]\ndepth = 1\nwater = @@2\n", "2 m high, but the crack is 1 m deep");
}

TEST(SlipSurface, IsACircleOrAPolyline) {
  const std::string given = slices_alone + "@@[[lem.surface]]\nname = \"A\"\n";
  expect_fault(given, "surface 'A' has no shape");
  expect_fault(given + "centre = [30, 55]\n", "the circle of surface 'A' has no 'radius'");
  expect_fault(given + "radius = 30\n", "has no 'centre'");
  expect_fault(given + "centre = [30, 55]\nradius = 30\npoints = [[30, 25], [50, 35]]\n", "a circle and a polyline");
  expect_fault(slices_alone + circle + change(circle, "\"A\"", "@@\"A\""), "two slip surfaces named 'A'");
}

TEST(SlipSurface, CirclesReachTheGround) {
  EXPECT_TRUE(find_faults(slices_alone + circle).empty());
  expect_fault(slices_alone + "@@" + change(circle, "30.5", "20"), "lies outside the ground");
  expect_fault(slices_alone + "@@" + change(circle, "[30, 55]", "[-60, 55]"), "lies outside the ground");
  EXPECT_TRUE(find_faults(slices_alone + circle + "ends = [30, 52]\n").empty());
  expect_fault(slices_alone + circle + "ends = @@[30, 95]\n", "x = 95 m, is not on the ground");
  expect_fault(slices_alone + circle + "ends = @@[30, 61]\n", "farther from the centre than its radius, 30.5 m");
  expect_fault(slices_alone + circle + "ends = @@[52, 30]\n", "two increasing places x");
}

TEST(SlipSurface, PolylinesRunFromGroundToGroundThroughTheSoil) {
  const auto with = [](const std::string& points) {
    return slices_alone + change(polyline, "[[30, 25], [45, 27], [55, 35]]", points);
  };
  EXPECT_TRUE(find_faults(slices_alone + polyline).empty());
  expect_fault(with("@@[[30, 25]]"), "has 1 points; it needs at least 2");
  expect_fault(with("[[30, 25], [45, 27], @@[45, 35]]"),
               "from x = 45 m to x = 45 m; its points run from left to right");
  expect_fault(with("[@@[30, 23], [45, 27], [55, 35]]"), "is 2 m below the ground");
  expect_fault(with("[[30, 25], [45, 27], @@[95, 35]]"), "outside the ground");
  expect_fault(with("[[30, 25], @@[40, 31], [55, 35]]"), "the point (40, 31) of surface 'B' is above the ground");
  expect_fault(with("[[30, 25], @@[45, 19], [55, 35]]"), "below the soil, whose lowest level is 20 m");
  expect_fault(slices_alone + polyline + "ends = @@[30, 55]\n", "'ends' belongs to a circle");
}

TEST(Surcharge, LiesOnTheGround) {
  const auto with = [](const std::string& keys) { return slices_alone + "[[surcharge]]\nname = \"road\"\n" + keys; };
  const Case data = read(with("x = [60, 70]\nload = [20, \"10 kPa\"]\nvariable = true\n"));
  EXPECT_DOUBLE_EQ(data.surcharges.at(0).load.at(1), 10e3);
  EXPECT_TRUE(data.surcharges.at(0).variable);
  expect_fault(with("x = [60, 70]\nload = @@[20]\n"), "has 2 places x and 1 loads");
  expect_fault(with("x = @@[60]\nload = [20]\n"), "needs at least two places x");
  expect_fault(with("x = @@[70, 60]\nload = [20, 20]\n"), "go from 70 m to 60 m");
  expect_fault(with("x = @@[70, 100]\nload = [20, 20]\n"), "reaches beyond the ground");
}

TEST(PartialFactors, AreThoseOfTheStandard) {
  const auto find = [](const std::string& keys) {
    return find_partial_factors(read(slices_alone + "[partial_factors]\n" + keys).partial_factors);
  };
  EXPECT_FALSE(find("").is_active());
  // EN 1997-1:2004, tables A.3 (actions), A.4 (materials) and A.14 (resistance).
  struct Row {
    const char* set;
    double permanent, variable, friction, cohesion, undrained, resistance;
  };
  for (const Row& row : {Row{"DA1-1", 1.35, 1.5, 1, 1, 1, 1}, Row{"DA1-2", 1, 1.3, 1.25, 1.25, 1.4, 1},
                         Row{"DA2", 1.35, 1.5, 1, 1, 1, 1.1}, Row{"DA3", 1, 1.3, 1.25, 1.25, 1.4, 1}}) {
    const PartialFactorValues v = find(std::string("set = \"") + row.set + "\"\n");
    EXPECT_EQ(v.set, row.set);
    EXPECT_EQ((std::array{v.permanent_load, v.variable_load, v.friction, v.cohesion, v.undrained, v.resistance}),
              (std::array{row.permanent, row.variable, row.friction, row.cohesion, row.undrained, row.resistance}))
        << row.set;
    EXPECT_EQ(v.weight, 1) << row.set;
  }
  const PartialFactorValues v = find("set = \"DA1-2\"\nfriction = 1.2\n");
  EXPECT_EQ(v.friction, 1.2) << "given by hand";
  EXPECT_EQ(v.cohesion, 1.25) << "of the set";
}

TEST(PartialFactors, OfPermanentActionsAreTheSameAsSmallerStrengths) {
  // A block on a plane inclined by β: F = (c l + W cosβ tanφ)/(W sinβ + Q sinβ), with actions multiplied or strengths
  // divided.
  PartialFactors given;
  given.set = DesignApproach::da2;
  const PartialFactorValues v = find_partial_factors(given), w = divide_by_permanent(v);
  const double beta = 0.5, phi = 0.6, c = 12e3, l = 8, weight = 300e3, load = 40e3;
  const double g = v.permanent_load, q = v.variable_load;
  const double actions = (c / v.cohesion * l + (g * weight + q * load) * std::cos(beta) * std::tan(phi) / v.friction) /
                         ((g * weight + q * load) * std::sin(beta));
  const double strengths =
      (c / w.cohesion * l + (weight + w.variable_load * load) * std::cos(beta) * std::tan(phi) / w.friction) /
      ((weight + w.variable_load * load) * std::sin(beta));
  EXPECT_NEAR(strengths, actions, 1e-14);
  EXPECT_EQ(w.permanent_load, 1);
  EXPECT_EQ(w.resistance, 1.1);
}

TEST(PartialFactors, ByHandNeedOne) {
  expect_fault(slices_alone + "[partial_factors]\nset = @@\"by_hand\"\n", "needs at least one factor");
  expect_fault(slices_alone + "[partial_factors]\nset = \"by_hand\"\nfriction = @@0\n", "above 0");
  expect_fault(slices_alone + "[partial_factors]\nfriction = @@1.25\n",
               "has a meaning only with set other than \"none\"");
  expect_fault(slices_alone + "[partial_factors]\nset = @@\"DA4\"\n", "choose one of none, DA1-1");
}

}  // namespace
}  // namespace talus::input
