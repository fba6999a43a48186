// SPDX-License-Identifier: MIT
// The section of LEM: soil and water at x, faults by name, surfaces on the ground.

#include "lem/section/slope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.hpp"
#include "lem/surface/surface.hpp"
#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

Section make_layers() {
  Section section = make_section({{0, 0}, {10, 0}, {20, 8}, {20, 9}, {40, 9}}, make_soil(5, 30, 16), -6);
  section.soils[0].saturated_unit_weight = 18;
  section.soils.push_back(make_soil(5, 30, 20));
  section.soils[1].saturated_unit_weight = 21;
  section.soils.push_back(make_soil(5, 30, 25));
  section.soils[2].saturated_unit_weight = 26;
  section.regions.push_back(make_region_below(section, 1, {{0, -2}, {40, 3}}));
  section.regions.push_back(
      {2, {{15, -3}, {25, -3}, {25, 5}, {15, 2}}});  // a block that crosses the layer and the water
  section.water_table = {{0, -1}, {18, 1}, {40, 4}};
  return section;
}

/// The soil of a place by the rule: the last region that holds it.
int find_soil(const Section& section, const Point& p) {
  for (std::size_t r = section.regions.size(); r-- > 0;) {
    const auto& q = section.regions[r].polygon;
    bool inside = false;
    for (std::size_t i = 0, j = q.size() - 1; i < q.size(); j = i++)
      if ((q[i][1] > p[1]) != (q[j][1] > p[1]) &&
          p[0] < q[i][0] + (q[j][0] - q[i][0]) * (p[1] - q[i][1]) / (q[j][1] - q[i][1]))
        inside = !inside;
    if (inside) return section.regions[r].soil;
  }
  return -1;
}

TEST(LemSlope, SoilAndWeightAreThoseOfTheRegions) {
  const Section section = make_layers();
  const Slope slope{Section(section)};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  for (int i = 0; i < 300; ++i) {
    const double x = 40 * part(random), top = slope.ground(x), bottom = -6 + (top + 6) * part(random);
    // By small steps down from the ground.
    double weight = 0;
    const int steps = 4000;
    for (int k = 0; k < steps; ++k) {
      const double y = top - (top - bottom) * (k + 0.5) / steps;
      const Soil& soil = section.soils[static_cast<std::size_t>(find_soil(section, {x, y}))];
      weight += (y < slope.water_table(x) ? soil.saturated_unit_weight : soil.unit_weight) * (top - bottom) / steps;
    }
    int soil = -1;
    EXPECT_NEAR(slope.weight_above(x, bottom, soil), weight, 0.05) << x << ' ' << bottom;
    EXPECT_EQ(soil, find_soil(section, {x, bottom}));
    EXPECT_EQ(slope.soil_at({x, bottom}), soil);
  }
}

TEST(LemSlope, LinesAreFollowed) {
  const Slope slope(make_layers());
  EXPECT_DOUBLE_EQ(slope.ground(15), 4);
  EXPECT_DOUBLE_EQ(slope.ground(20), 9);  // the right side of a step
  EXPECT_NEAR(slope.ground(20 - 1e-7), 8, 1e-6);
  EXPECT_NEAR(slope.water_table(9), 0, 1e-12);
  EXPECT_NEAR(slope.pore_pressure({9, -2}), 2 * 9.81, 1e-9);
  EXPECT_NEAR(slope.pore_pressure({9, 1}), -9.81, 1e-9);
  EXPECT_EQ(slope.soil_at({5, 1}), -1);
  EXPECT_EQ(slope.soil_at({5, -7}), -1);
}

/// The one fault of a section; "" when there are none or several.
std::string find_fault(const Section& section) {
  const auto faults = find_faults(section);
  return faults.size() == 1 ? faults[0] : "";
}

void expect_fault(const Section& section, const std::string& part) {
  const auto faults = find_faults(section);
  ASSERT_EQ(faults.size(), 1u) << (faults.empty() ? "" : faults[0] + " | " + faults.back());
  EXPECT_NE(faults[0].find(part), std::string::npos) << faults[0];
  try {
    const Slope slope{Section(section)};
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    EXPECT_EQ(error.what(), faults[0]);
  }
}

TEST(LemFaults, ASoundSectionHasNone) {
  EXPECT_TRUE(find_faults(make_layers()).empty());
}

TEST(LemFaults, NameTheCulprit) {
  const Section sound = make_layers();
  const auto change = [&](auto&& edit) {
    Section section = sound;
    edit(section);
    return section;
  };
  expect_fault(change([](Section& s) { s.ground = {{0, 0}}; }), "fewer than two points");
  expect_fault(change([](Section& s) { s.ground[2] = {9, 8}; }), "the ground runs backwards from (10, 0) to (9, 8)");
  expect_fault(change([](Section& s) { s.ground[1][1] = std::nan(""); }), "the ground: point 2 is not a number");
  expect_fault(change([](Section& s) { s.base = 2; }), "base at elevation 2 lies above the ground at (0, 0)");
  expect_fault(change([](Section& s) { s.water_table[1][0] = -3; }), "the water table runs backwards");
  expect_fault(change([](Section& s) {
                 s.soils[1].name = "clay";
                 s.soils[1].unit_weight = 0;
               }),
               "soil 'clay': the unit weight 0 is not positive");
  expect_fault(change([](Section& s) { s.soils[2].cohesion = s.soils[2].friction_angle = 0; }),
               "soil 3 has no strength");
  expect_fault(change([](Section& s) { s.soils[2].friction_angle = 2; }), "friction angle 114.6°");
  expect_fault(change([](Section& s) { s.soils[0].suction = Suction::saturation; }), "needs a retention curve");
  expect_fault(change([](Section& s) { s.regions[1].soil = 7; }), "region 2 names soil 7, which is not there");
  // A bow tie.
  expect_fault(change([](Section& s) {
                 s.soils[2].name = "lens";
                 s.regions[2].polygon = {{15, -3}, {25, 5}, {25, -3}, {15, 5}};
               }),
               "region 3 of soil 'lens' crosses or touches itself at (20, 1)");
  expect_fault(change([](Section& s) {
                 s.regions[2].polygon = {{45, 0}, {50, 0}, {50, 3}};
               }),
               "region 3 lies outside: it is beside");
  expect_fault(change([](Section& s) {
                 s.regions[2].polygon = {{15, 20}, {25, 20}, {25, 25}};
               }),
               "region 3 lies outside: it is above");
  expect_fault(change([](Section& s) {
                 s.regions[2].polygon = {{15, 0}, {25, 0}};
               }),
               "region 3 has fewer than three points");
  expect_fault(change([](Section& s) { s.regions.clear(); }), "no region of soil");
  expect_fault(change([](Section& s) {
                 s.regions[0].polygon = {{0, 0}, {10, 0}, {18, 6.4}, {18, -16}, {0, -16}};
               }),
               "no soil under the ground between x = 18 and x = 40");
  expect_fault(change([](Section& s) { s.crack = TensionCrack{2, 3}; }), "tension crack is 2 m deep with 3 m of water");
  expect_fault(change([](Section& s) { s.surcharges = {{{{20, 1}, {15, 1}}}}; }), "surcharge 1 runs backwards");
  expect_fault(change([](Section& s) {
                 s.pressure_grid = PressureGrid{{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 3}}, {0, 0, 0}};
               }),
               "names node 3, which is not there");
  EXPECT_EQ(find_fault(sound), "");
}

TEST(LemFaults, OfASurface) {
  const Slope slope(make_layers());
  const auto expect = [&](const Surface& surface, const std::string& part) {
    const auto faults = find_faults(slope, surface);
    ASSERT_EQ(faults.size(), 1u) << part << (faults.empty() ? "" : faults[0]);
    EXPECT_NE(faults[0].find(part), std::string::npos) << faults[0];
  };
  Surface surface = make_polyline({{10, 0}, {18, -1}, {30, 9}});
  surface.name = "A";
  EXPECT_TRUE(find_faults(slope, surface).empty());
  surface.line[2] = {30, 7.5};
  expect(surface, "slip surface 'A': its right end (30, 7.5) lies 1.5 m below the ground");
  surface.line[2] = {45, 9};
  expect(surface, "outside the ground, which runs from x = 0 to 40");
  surface.line = {{10, 0}, {9, -1}, {30, 9}};
  expect(surface, "runs backwards from (10, 0) to (9, -1)");
  surface.line = {{10, 0}, {18, -7}, {30, 9}};
  expect(surface, "below the base at elevation -6");
  surface.line = {{5, 0}, {12, 3}, {30, 9}};
  expect(surface, "rises above the ground");
  EXPECT_TRUE(find_faults(slope, make_polyline({{20, 8.5}, {24, 8.2}, {30, 9}})).empty());  // out of the step's face
  expect(make_arc({20, 20}, 15, 10, 40), "the slip circle");
}

TEST(LemArcs, SteepEndGivenWithFewDigits) {
  // Low 1989: the arc is vertical at the crest; x rounded to a millimetre misses the ground by 5 cm in height, by
  // nothing in distance.
  const Slope slope(make_section({{0, 8}, {10, 8}, {26, 16}, {40, 16}}, make_soil(15, 0, 20), 0));
  const CutSurface cut = cut_surface(slope, make_arc({18.0021, 16.0}, 15.252, 5.017, 33.254), 50, report_only());
  ASSERT_EQ(cut.refusal, Refusal::none);
  EXPECT_EQ(cut.slices.back().base_right[1], 16);
  EXPECT_EQ(cut.slices.front().base_left[1], 8);
  EXPECT_EQ(cut_surface(slope, make_arc({18.0021, 16.0}, 15.252, 5.2, 33.254), 50, report_only()).refusal,
            Refusal::outside);
}

TEST(LemArcs, StretchesOfACircleBelowTheGround) {
  // Two hills: one circle goes through both.
  const Slope slope(
      make_section({{0, 0}, {10, 0}, {15, 5}, {20, 0}, {30, 0}, {35, 5}, {40, 0}, {50, 0}}, make_soil(5, 30, 18), -10));
  const Circle circle{{25, 40}, 39.5};
  const auto arcs = find_arcs(slope, circle);
  ASSERT_EQ(arcs.size(), 2u);
  for (const auto& arc : arcs)
    for (const double x : arc) EXPECT_NEAR(slope.ground(x), 40 - std::sqrt(39.5 * 39.5 - (x - 25) * (x - 25)), 1e-9);
  EXPECT_LT(arcs[0][1], arcs[1][0]);
  // One that goes deep enough to leave the ground only once.
  EXPECT_EQ(find_arcs(slope, {{25, 40}, 41}).size(), 1u);
  // Through the side of the model, or with the end of its lower half in the ground: no arc.
  EXPECT_TRUE(find_arcs(slope, {{2, 10}, 12}).empty());
  EXPECT_TRUE(find_arcs(slope, {{25, -2}, 6}).empty());
  EXPECT_TRUE(find_arcs(slope, {{25, 40}, 20}).empty());
}

}  // namespace
}  // namespace talus::lem
