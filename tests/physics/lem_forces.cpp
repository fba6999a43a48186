// SPDX-License-Identifier: MIT
// The slice table: every slice is in equilibrium, the line of thrust follows from the moments, k_y gives F = 1.

#include "lem/slices/mass.hpp"
#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

Section make_loaded() {
  Section section = make_section({{0, 5}, {12, 5}, {32, 17}, {50, 18}}, make_soil(12, 28, 19), -2);
  section.water_table = {{0, 7}, {16, 7.4}, {30, 11}, {50, 13}};
  section.surcharges = {{{{34, 10}, {40, 25}}}};
  section.horizontal_acceleration = 0.06;
  section.vertical_acceleration = 0.03;
  section.crack = TensionCrack{1.5, 1.0};
  return section;
}

/// Sum of forces and moments on one slice; `way` -1: sliding to the left.
void expect_equilibrium(const Section& section, const CutSurface& cut, std::size_t i, double scale) {
  const Slice& s = cut.slices[i];
  const bool left = cut.slides_left;
  // The side towards the upper end carries E and X of the slice itself when sliding to the left.
  const auto side = [&](bool right) {
    std::array<double, 3> force{0, 0, 0};
    if (right) return std::array{s.normal_right, s.shear_right, s.thrust_right};
    if (i > 0) {
      const Slice& other = cut.slices[i - 1];
      return std::array{other.normal_right, other.shear_right, other.thrust_right};
    }
    if (!left) force = {cut.crack_thrust, 0, cut.crack_thrust_level};
    return force;
  };
  const auto on_left = side(false), on_right = side(true);
  // In the plane of the section: base normal up, shear against the sliding.
  const double dx = s.right - s.left, dy = s.base_right[1] - s.base_left[1], away = left ? 1 : -1;
  double fx = -s.normal * dy / s.length + away * s.shear * dx / s.length;
  double fy = s.normal * dx / s.length + away * s.shear * dy / s.length;
  fx += away * s.surface_thrust - away * s.earthquake;
  fy -= (1 + section.vertical_acceleration) * s.weight + s.surface_load;
  fx += on_left[0] - on_right[0];
  // X on the lower side supports the slice; on the upper side it loads it.
  fy += left ? on_left[1] - on_right[1] : on_right[1] - on_left[1];
  EXPECT_NEAR(fx, 0, 1e-7 * scale) << i;
  EXPECT_NEAR(fy, 0, 1e-7 * scale) << i;
  const double y = 0.5 * (s.base_left[1] + s.base_right[1]);
  if (std::isnan(on_left[2]) || std::isnan(on_right[2])) return;
  double moment = -s.surface_moment + (s.centroid - y) * away * s.earthquake;
  moment += -(on_left[2] - y) * on_left[0] + (on_right[2] - y) * on_right[0];
  moment += left ? -0.5 * dx * (on_left[1] + on_right[1]) : 0.5 * dx * (on_right[1] + on_left[1]);
  EXPECT_NEAR(moment, 0, 1e-7 * scale) << i;
}

TEST(LemSliceTable, EverySliceIsInEquilibrium) {
  for (const bool mirrored : {false, true}) {
    Section section = make_loaded();
    if (mirrored) {
      section = make_section({{-50, 18}, {-32, 17}, {-12, 5}, {0, 5}}, make_soil(12, 28, 19), -2);
      section.water_table = {{-50, 13}, {-30, 11}, {-16, 7.4}, {0, 7}};
      section.surcharges = {{{{-40, 25}, {-34, 10}}}};
      section.horizontal_acceleration = 0.06;
      section.vertical_acceleration = 0.03;
      section.crack = TensionCrack{1.5, 1.0};
    }
    const Slope slope{Section(section)};
    const Surface arc = make_circle(slope, {mirrored ? -15.0 : 15.0, 28}, 24);
    for (const Method method : {Method::spencer, Method::morgenstern_price, Method::morgenstern_price_constant}) {
      CutSurface cut = cut_surface(slope, arc, 40, report_only());
      ASSERT_EQ(cut.refusal, Refusal::none);
      EXPECT_EQ(cut.slides_left, !mirrored);
      const Solution solution = solve(slope, cut, method, report_only(), true);
      ASSERT_EQ(solution.refusal, Refusal::none) << name_refusal(solution.refusal);
      double scale = 0;
      for (const Slice& slice : cut.slices) scale += slice.weight;
      for (std::size_t i = 0; i < cut.slices.size(); ++i) {
        expect_equilibrium(section, cut, i, scale);
        const Slice& s = cut.slices[i];
        // The strength that is used: (c l + (N - u l) tanφ) / F.
        const double strength =
            s.cohesion * s.length + (s.normal - std::max(0.0, s.pore_pressure) * s.length) * s.tan_friction;
        EXPECT_NEAR(s.shear, strength / solution.factor, 1e-8 * scale);
      }
      // The lower end is free, the upper one bears the water in the crack, and the thrust runs out through the toe.
      const Slice& toe = mirrored ? cut.slices.back() : cut.slices[0];
      if (mirrored) {
        EXPECT_NEAR(toe.normal_right, 0, 1e-8 * scale);
      } else {
        EXPECT_NEAR(cut.slices.back().normal_right, 0.5 * 9.81, 1e-12);
      }
      const Slice& middle = cut.slices[cut.slices.size() / 2];
      EXPECT_GT(middle.thrust_right, middle.base_right[1]);
      EXPECT_LT(middle.thrust_right, middle.top_right);
    }
  }
}

TEST(LemSliceTable, GeometryAndWeightAreExact) {
  // Two layers and a water table: the area and weight of the mass over a polyline, by hand.
  Section section = make_section({{0, 0}, {10, 0}, {20, 10}, {40, 10}}, make_soil(5, 30, 16), -10);
  section.soils[0].saturated_unit_weight = 19;
  section.soils.push_back(make_soil(5, 30, 21));
  section.regions.push_back(make_region_below(section, 1, {{0, -4}, {40, -4}}));
  section.water_table = {{0, -2}, {40, -2}};
  const Slope slope(std::move(section));
  const CutSurface cut = cut_surface(slope, make_polyline({{4, 0}, {10, -6}, {20, -6}, {36, 10}}), 17, report_only());
  double weight = 0, area = 0;
  for (const Slice& slice : cut.slices) {
    weight += slice.weight;
    area += 0.5 * (slice.right - slice.left) *
            (slice.top_left - slice.base_left[1] + slice.top_right - slice.base_right[1]);
  }
  // Trapezia between elevations: y -6 to -4 (10 and 14 wide), -4 to -2 (14, 18), -2 to 0 (18, 22), 0 to 10 (16, 16).
  EXPECT_NEAR(weight, 24 * 21 + 32 * 19 + 40 * 16 + 160 * 16, 1e-9);
  EXPECT_NEAR(area, 24 + 32 + 40 + 160, 1e-9);
  EXPECT_NEAR(cut.area, area, 1e-9);
  EXPECT_DOUBLE_EQ(cut.depth, 16);
  // Sides of slices are at every break of the ground and of the base, at the layer and at the water table.
  for (const double x : {4.0, 6.0, 8.0, 10.0, 20.0, 22.0, 24.0, 36.0}) {
    bool found = false;
    for (const Slice& slice : cut.slices)
      found = found || std::abs(slice.left - x) < 1e-9 || std::abs(slice.right - x) < 1e-9;
    EXPECT_TRUE(found) << x;
  }
}

// Each method balances what it should; a factor that is 1 % off leaves a thousandth of the weight and more.
TEST(LemForces, EveryFactorClosesItsEquations) {
  const Slope slope{make_section({{0, 15}, {12, 15}, {32, 5}, {44, 5}}, make_soil(2, 30, 15.5979), 0)};
  const Surface arc = make_arc({35.044455, 38.147107}, 33.286625, 11.123526, 32);
  CutSurface cut = cut_surface(slope, arc, 100, Checks{});
  for (const Method method : all_methods) {
    const Solution solution = solve(slope, cut, method, report_only(), false);
    EXPECT_LT(solution.residual, 1e-6) << to_word(method);
    if (method == Method::fellenius) continue;
    Mass mass;
    mass.set(slope, cut, 0);
    mass.set_interslice_function(method == Method::morgenstern_price, cut);
    std::vector<Forces> forces;
    const double factor = 1.01 * solution.factor / solution.correction;
    find_forces(mass, factor, solution.lambda, forces);
    const bool complete = is_rigorous(method), moments = complete || method == Method::bishop;
    EXPECT_GT(measure_residual(mass, factor, forces, complete || !moments, moments), 1e-3) << to_word(method);
  }
}

// The coefficient of the source's dry slope is 0.171 by Bishop and 0.172 by Spencer, searched.
TEST(LemYieldAcceleration, GivesAFactorOfOne) {
  Section section = make_section({{0, 15}, {12, 15}, {32, 5}, {44, 5}}, make_soil(2, 30, 15.5979), 0);
  const Surface arc = make_arc({35.044455, 38.147107}, 33.286625, 11.123526, 32);
  for (const Method method :
       {Method::fellenius, Method::bishop, Method::janbu, Method::spencer, Method::morgenstern_price}) {
    section.horizontal_acceleration = 0;
    const Slope still{Section(section)};
    const auto k = find_yield_acceleration(still, cut_surface(still, arc, 100, Checks{}), method, Checks{});
    ASSERT_TRUE(k) << to_word(method);
    EXPECT_NEAR(*k, 0.165, 0.015);
    section.horizontal_acceleration = *k;
    EXPECT_NEAR(find_factor(Slope{Section(section)}, arc, method), 1, 1e-9) << to_word(method);
  }
  const Slope still{Section(section)};
  EXPECT_NEAR(*find_yield_acceleration(still, cut_surface(still, arc, 100, Checks{}), Method::bishop, Checks{}), 0.1712,
              5e-4);
  EXPECT_NEAR(*find_yield_acceleration(still, cut_surface(still, arc, 100, Checks{}), Method::spencer, Checks{}),
              0.1725, 5e-4);
  // A surface that fails by itself has none.
  section.soils[0] = make_soil(0.1, 10, 15.5979);
  const Slope weak{Section(section)};
  EXPECT_FALSE(find_yield_acceleration(weak, cut_surface(weak, arc, 100, Checks{}), Method::bishop, Checks{}));
}

}  // namespace
}  // namespace talus::lem
