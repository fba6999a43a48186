// SPDX-License-Identifier: MIT
// Water in LEM: ponds, submerged slopes, vertical faces, pressure grids, suction.

#include <algorithm>

#include "lem/section/uplift.hpp"
#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

// Duncan and Wright 2005, figure 6.27: a slope under water; F = 1.60 whatever the level of the pool. Feet and pounds.
Section make_submerged(double pool) {
  Section section = make_section({{0, 15}, {30, 15}, {105, 45}, {140, 45}}, make_soil(100, 20, 128), 0, 62.4);
  section.water_table = {{0, pool}, {140, pool}};
  return section;
}

const Surface submerged_arc = make_arc({47.661081, 95.399774}, 82.31669, 30, 112.744875);

TEST(LemSubmerged, LevelOfThePoolDoesNotMatter) {
  const Slope low(make_submerged(45)), high(make_submerged(75)), higher(make_submerged(105));
  for (const Method method : {Method::bishop, Method::janbu, Method::janbu_corrected}) {
    const double expected = find_factor(low, submerged_arc, method);
    EXPECT_NEAR(find_factor(high, submerged_arc, method), expected, 1e-9) << to_word(method);
    EXPECT_NEAR(find_factor(higher, submerged_arc, method), expected, 1e-9) << to_word(method);
  }
  EXPECT_NEAR(find_factor(high, submerged_arc, Method::bishop), 1.5967, 0.003 * 1.6);
  // The forces between the slices hold the water's pressure, which grows with the pool, and are inclined as a whole.
  for (const Method method : {Method::spencer, Method::morgenstern_price})
    EXPECT_NEAR(find_factor(higher, submerged_arc, method), find_factor(low, submerged_arc, method), 2e-3);
  EXPECT_NEAR(find_factor(high, submerged_arc, Method::spencer), 1.5940, 0.003 * 1.6);
  EXPECT_NEAR(find_factor(higher, submerged_arc, Method::spencer), 1.5936, 0.003 * 1.6);
}

TEST(LemSubmerged, FelleniusDependsOnThePool) {
  // N' = W cosα - u l with the pool as a load: the known weakness of the classical form, 0.8926 and 0.5038.
  EXPECT_NEAR(find_factor(Slope(make_submerged(75)), submerged_arc, Method::fellenius), 0.8926, 0.003);
  EXPECT_NEAR(find_factor(Slope(make_submerged(105)), submerged_arc, Method::fellenius), 0.5038, 0.003);
}

TEST(LemSubmerged, EqualsTheDrySlopeOfBuoyantWeight) {
  Section dry = make_submerged(75);
  dry.water_table.clear();
  dry.soils[0].unit_weight = 128 - 62.4;
  const Slope buoyant(std::move(dry)), wet(make_submerged(75));
  // Equal forces on every slice; their moments differ by where on the base the pore pressure acts, an error of the
  // slices.
  EXPECT_NEAR(find_factor(wet, submerged_arc, Method::janbu), find_factor(buoyant, submerged_arc, Method::janbu), 1e-9);
  EXPECT_NEAR(find_factor(wet, submerged_arc, Method::bishop), find_factor(buoyant, submerged_arc, Method::bishop),
              5e-4);
}

TEST(LemSubmerged, VerticalFaceOfTheGround) {
  for (const double way : {1.0, -1.0}) {  // and mirrored
    const auto make = [&](double pool) {
      std::vector<Point> ground{{-10 * way, 0}, {0, 0}, {0, 4}, {6 * way, 10}, {40 * way, 10}};
      if (way < 0) std::reverse(ground.begin(), ground.end());
      Section section = make_section(ground, make_soil(20, 25, pool > 0 ? 20 : 20 - 9.81), -5);
      if (pool > 0) section.water_table = {{-50, pool}, {50, pool}};
      return section;
    };
    const Slope buoyant(make(0)), low(make(10)), high(make(40));
    // Below the face, through its foot, and out of the face 2 m above it.
    for (const double level : {-0.11, 0.0, 2.0}) {
      const Surface arc = make_circle(buoyant, {-2 * way, 18}, level < 0 ? 18 - level : std::hypot(2, 18 - level));
      ASSERT_GT(arc.to, arc.from);
      for (const Method method : {Method::bishop, Method::janbu}) {
        const double expected = find_factor(low, arc, method), slices = method == Method::janbu ? 1e-9 : 5e-4;
        EXPECT_NEAR(find_factor(high, arc, method), expected, 1e-9) << to_word(method) << level;
        EXPECT_NEAR(find_factor(buoyant, arc, method), expected, slices) << to_word(method) << level;
      }
    }
  }
}

// The thrust of a pond on an even face, and its moment, against the hydrostatic pressure on the face.
TEST(LemPond, PressesNormalToTheFace) {
  Section section = make_section({{-20, 0}, {0, 0}, {12, 9}, {40, 9}}, make_soil(10, 25, 19), -5);
  section.water_table = {{-20, 6}, {8, 6}, {40, 6}};
  const Slope slope(std::move(section));
  const CutSurface cut = cut_surface(slope, make_circle(slope, {2.5, 16}, std::hypot(2.5, 16)), 37, report_only());
  ASSERT_FALSE(cut.slices.empty());
  double down = 0, side = 0, moment = 0;
  for (const Slice& slice : cut.slices) {
    const double x = 0.5 * (slice.left + slice.right), y = 0.5 * (slice.base_left[1] + slice.base_right[1]);
    down += slice.surface_load;
    side += slice.surface_thrust;
    moment += slice.surface_load * x + slice.surface_thrust * y + slice.surface_moment;
  }
  // Face of 4 in 3 from (0, 0) to (8, 6): ½ γ_w 6² across, ½ γ_w 6 8 down, both at a third of the wet height.
  EXPECT_NEAR(side, 0.5 * 9.81 * 36, 1e-9);
  EXPECT_NEAR(down, 0.5 * 9.81 * 48, 1e-9);
  EXPECT_NEAR(moment, down * 8.0 / 3 + side * 2, 1e-9 * moment);
}

TEST(LemPressureGrid, HydrostaticGridIsTheLine) {
  Section section = make_section({{0, 15}, {12, 15}, {32, 5}, {44, 5}}, make_soil(5, 30, 17), 0);
  section.water_table = {{0, 11}, {44, 11}};
  const Slope line{Section(section)};
  PressureGrid grid;
  const int columns = 23, rows = 9;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const double x = 44.0 * i / columns, y = 15.0 * j / rows;
      grid.nodes.push_back({x, y});
      grid.pressure.push_back(9.81 * (11 - y));
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i;
      grid.triangles.push_back({a, a + 1, a + columns + 2});
      grid.triangles.push_back({a, a + columns + 2, a + columns + 1});
    }
  section.pressure_grid = grid;
  const Slope gridded{Section(section)};
  for (double x = 0.05; x < 44; x += 0.77)
    for (double y = 0.1; y < 15; y += 0.63)
      EXPECT_NEAR(gridded.pore_pressure({x, y}), 9.81 * (11 - y), 1e-9) << x << ' ' << y;
  const Surface arc = make_arc({35.044455, 38.147107}, 33.286625, 11.123526, 32);
  for (const Method method : all_methods)
    EXPECT_NEAR(find_factor(gridded, arc, method), find_factor(line, arc, method), 1e-9) << to_word(method);
}

TEST(LemPressureGrid, IsLinearInEachTriangle) {
  // A fan with values of no plane: the middle of each triangle has the mean of its corners, outside there is the line.
  Section section = make_section({{0, 15}, {44, 15}}, make_soil(5, 30, 17), 0);
  section.water_table = {{0, 9}, {44, 9}};
  section.pressure_grid = PressureGrid{{{20, 7}, {30, 7}, {24, 12}, {12, 9}, {14, 3}, {28, 2}},
                                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}},
                                       {50, -20, 10, 35, 90, -5}};
  const PressureGrid grid = *section.pressure_grid;
  const Slope slope(std::move(section));
  for (const auto& triangle : grid.triangles) {
    Point middle{0, 0};
    double mean = 0;
    for (const int node : triangle) {
      const auto n = static_cast<std::size_t>(node);
      middle = {middle[0] + grid.nodes[n][0] / 3, middle[1] + grid.nodes[n][1] / 3};
      mean += grid.pressure[n] / 3;
    }
    EXPECT_NEAR(slope.pore_pressure(middle), mean, 1e-9);
  }
  EXPECT_NEAR(slope.pore_pressure({5, 4}), 5 * 9.81, 1e-9);
  EXPECT_NEAR(slope.pore_pressure({29, 11}), -2 * 9.81, 1e-9);
}

TEST(LemUndrainedSoil, BearsNoPorePressure) {
  Section section = make_section({{0, 15}, {12, 15}, {32, 5}, {44, 5}}, make_soil(30, 0, 18), 0);
  section.soils[0].undrained = true;
  section.water_table = {{0, 12}, {44, 6}};
  const Slope slope(std::move(section));
  for (const Slice& slice : cut_surface(slope, make_circle(slope, {30, 25}, 22), 30, report_only()).slices) {
    EXPECT_EQ(slice.pore_pressure, 0);
    EXPECT_EQ(slice.cohesion, 30);
  }
}

TEST(LemSuction, AddsItsStrength) {
  Section section = make_section({{0, 15}, {12, 15}, {32, 5}, {44, 5}}, make_soil(2, 30, 16), 0);
  section.water_table = {{0, 5}, {44, 5}};
  const Surface arc = make_arc({35.044455, 38.147107}, 33.286625, 11.123526, 32);
  const double ignored = find_factor(Slope{Section(section)}, arc, Method::bishop);
  Soil& soil = section.soils[0];
  // Every slice must bear c + s tan φ_b.
  soil.suction = Suction::phi_b;
  soil.phi_b = 15 * degree;
  const Slope with_phi_b{Section(section)};
  for (const Slice& slice : cut_surface(with_phi_b, arc, 60, report_only()).slices) {
    const double y = 0.5 * (slice.base_left[1] + slice.base_right[1]), suction = std::max(0.0, 9.81 * (y - 5));
    EXPECT_NEAR(slice.suction_strength, suction * std::tan(15 * degree), 1e-9);
    EXPECT_NEAR(slice.cohesion, 2 + suction * std::tan(15 * degree), 1e-9);
  }
  EXPECT_GT(find_factor(with_phi_b, arc, Method::bishop), ignored + 0.2);
  // χ = S_w = tan φ_b / tan φ everywhere is the same strength.
  soil.suction = Suction::saturation;
  soil.saturation = [&](double) { return std::tan(15 * degree) / std::tan(30 * degree); };
  EXPECT_NEAR(find_factor(Slope{Section(section)}, arc, Method::janbu), find_factor(with_phi_b, arc, Method::janbu),
              1e-9);
  // Capped suction.
  soil.largest_suction = 20;
  for (const Slice& slice : cut_surface(Slope{Section(section)}, arc, 60, report_only()).slices)
    EXPECT_LE(slice.suction_strength, 20 * std::tan(15 * degree) + 1e-12);
}

// A blanket of 3 m over an aquifer whose head rises to `head` above the base of the blanket: F = γ t / (γ_w h), below
// the ground and as well under a pond, whose weight and head both act.
TEST(LemUplift, OfABlanketOverAnAquifer) {
  const auto make = [](double head, double pond) {
    Section section = make_section({{0, 7}, {40, 7}}, make_soil(5, 24, 17), 0);
    const double top = 9.81 * pond, base = 9.81 * (head + pond);
    section.pressure_grid = PressureGrid{{{0, 0}, {40, 0}, {40, 4}, {0, 4}, {40, 7}, {0, 7}},
                                         {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}},
                                         {base + 4 * 9.81, base + 4 * 9.81, base, base, top, top}};
    section.soils.push_back(make_soil(0, 34, 19));
    section.regions.push_back(make_region_below(section, 1, {{0, 4}, {40, 4}}));
    if (pond > 0) section.water_table = {{0, 7 + pond}, {40, 7 + pond}};
    return section;
  };
  EXPECT_FALSE(find_uplift(Slope(make(5.1, 0)))) << "51 kPa weigh more than 50.0 kPa";
  const auto dry = find_uplift(Slope(make(6, 0)));
  ASSERT_TRUE(dry);
  EXPECT_NEAR(dry->factor(), 51 / (6 * 9.81), 1e-5);
  EXPECT_NEAR(dry->at[1], 4, 1e-3);
  const auto ponded = find_uplift(Slope(make(6, 2)));
  ASSERT_TRUE(ponded);
  EXPECT_NEAR(ponded->stress, 51 + 2 * 9.81, 1e-3);
  EXPECT_NEAR(ponded->pressure, 8 * 9.81, 1e-3);
}

/// φ_b = 0 is no suction, and suction with χ = 0 neither, on a curved envelope too.
TEST(LemSuction, DoesNotMoveAlongACurvedEnvelopeByItself) {
  Section section = make_section({{0, 15}, {12, 15}, {32, 5}, {44, 5}}, make_soil(0, 0, 16), 0);
  section.water_table = {{0, 2}, {44, 2}};
  StrengthLaw law;
  law.is_curved = true;
  law.find_tangent = [](const StrengthPlane& plane) {
    const double at = std::max(0.1, plane.normal), strength = 2 * std::pow(at, 0.6), slope = 0.6 * strength / at;
    return StrengthTangent{strength - slope * at, slope};
  };
  Soil& soil = section.soils[0];
  soil.law = std::make_shared<const StrengthLaw>(law);
  const Surface arc = make_arc({35.044455, 38.147107}, 33.286625, 11.123526, 32);
  for (const Method method : {Method::bishop, Method::janbu}) {
    soil.suction = Suction::ignored;
    const double ignored = find_factor(Slope{Section(section)}, arc, method);
    soil.suction = Suction::phi_b;
    soil.phi_b = 0;
    EXPECT_NEAR(find_factor(Slope{Section(section)}, arc, method), ignored, 1e-9);
    soil.suction = Suction::saturation;
    soil.saturation = [](double) { return 0.0; };
    EXPECT_NEAR(find_factor(Slope{Section(section)}, arc, method), ignored, 1e-9);
    // All of it is an effective stress: every base bears its strength at that stress.
    soil.saturation = [](double) { return 1.0; };
    const Slope full{Section(section)};
    CutSurface cut = cut_surface(full, arc, 30, report_only());
    const double factor = solve(full, cut, method, report_only(), true).factor;
    ASSERT_GT(factor, 0) << to_word(method);
    for (const Slice& s : cut.slices) {
      const double effective = s.normal / s.length - s.pore_pressure;
      if (effective > 1) {
        EXPECT_NEAR(s.shear / s.length * factor, 2 * std::pow(effective, 0.6), 1e-3 * 2 * std::pow(effective, 0.6));
      }
    }
    soil.saturation = nullptr;
  }
}

TEST(LemUplift, IsNowhereInHydrostaticSoil) {
  for (const double level : {2.0, 7.0, 30.0}) {
    Section section = make_section({{0, 15}, {12, 15}, {32, 5}, {44, 5}}, make_soil(2, 30, 18), 0);
    section.water_table = {{0, level}, {44, level}};
    EXPECT_FALSE(find_uplift(Slope(std::move(section)))) << level;
  }
}

TEST(LemRoots, ActInSoilThatTakesThem) {
  Section section = make_section({{0, 15}, {12, 15}, {32, 5}, {44, 5}}, make_soil(2, 30, 16), 0);
  const Surface arc = make_arc({35.044455, 38.147107}, 33.286625, 11.123526, 32);
  const double bare = find_factor(Slope{Section(section)}, arc, Method::bishop);
  section.roots = {{{{0, 10}, {1, 10}}}};
  EXPECT_GT(find_factor(Slope{Section(section)}, arc, Method::bishop), bare);
  section.soils[0].takes_roots = false;
  EXPECT_EQ(find_factor(Slope{Section(section)}, arc, Method::bishop), bare);
}

TEST(LemRoots, AddCohesionByDepthNormalToTheGround) {
  Section section = make_section({{0, 15}, {12, 15}, {32, 5}, {44, 5}}, make_soil(2, 30, 16), 0);
  section.roots = {{{{0, 10}, {1, 10}}}};
  const double beta = std::atan(0.5);
  const Slope slope(std::move(section));
  // A plane 0.9 m under the face, normal to it, is rooted, one 1.1 m under it is not.
  for (const double depth : {0.9, 1.1}) {
    const double down = depth / std::cos(beta);
    const auto face = [&](double x) { return 15 - 0.5 * (x - 12); };
    const Surface plane = make_polyline({{14, face(14)}, {17, face(17) - down}, {27, face(27) - down}, {30, face(30)}});
    const CutSurface cut = cut_surface(slope, plane, 80, report_only());
    ASSERT_GT(cut.slices.size(), 70u);
    for (const Slice& slice : cut.slices)
      if (slice.left > 17 && slice.right < 27) {
        EXPECT_NEAR(slice.root_cohesion, depth < 1 ? 10 : 0, 1e-9);
      }
  }
}

}  // namespace
}  // namespace talus::lem
