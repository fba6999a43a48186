// SPDX-License-Identifier: MIT
// Composite circles along bases that are not one level line: inclined, stepped, with a pit beyond the toe, and the top
// of impenetrable soil; against level bases, polylines along the same points, and mirror images.

#include "support/lem_searches.hpp"

namespace talus::lem {
namespace {

/// A bank of 8 m of fill on a seam of 1 m of clay, to the left of its toe at x = 28, on a base along `bottom`.
Section make_bank_on_seam(const std::vector<Point>& bottom) {
  Section section = make_section({{0, 11}, {16, 11}, {28, 3}, {40, 3}}, make_soil(10, 30, 19), 0);
  section.soils.push_back(make_soil(8, 0, 18));
  section.base = std::min_element(bottom.begin(), bottom.end(), [](auto& a, auto& b) { return a[1] < b[1]; })->at(1);
  section.ground.back()[0] = bottom.back()[0];
  const auto above = [&](std::vector<Point> top) {
    for (auto p = bottom.rbegin(); p != bottom.rend(); ++p) top.push_back(*p);
    return top;
  };
  section.regions = {{1, above({{0, 1}, {bottom.back()[0], 1}})},
                     {0, {{0, 1}, {bottom.back()[0], 1}, {bottom.back()[0], 3}, {28, 3}, {16, 11}, {0, 11}}}};
  return section;
}

/// The same on rock, whose top is `bottom`, down to y = -20.
Section make_bank_on_rock(const std::vector<Point>& bottom) {
  Section section = make_bank_on_seam(bottom);
  section.base = -20;
  section.soils.push_back(make_soil(0, 45, 24));
  std::vector<Point> rock = bottom;
  rock.push_back({bottom.back()[0], -20});
  rock.push_back({0, -20});
  section.regions.push_back({2, rock});
  section.impenetrable = {2};
  return section;
}

const std::vector<Point> level{{0, 0}, {40, 0}};

Checks follow_base() {
  Checks checks = report_only();
  checks.composite = true;
  return checks;
}

/// Circles that reach below the base of the bank.
std::vector<Circle> list_deep_circles() {
  return {{{24, 20}, 21.5}, {{25, 17}, 18}, {{24, 24}, 25.5}, {{27, 14}, 16}, {{25, 28}, 29}};
}

double solve_circle(const Slope& slope, const Circle& circle, Method method, int slices = 200) {
  const auto arcs = find_arcs(slope, circle);
  if (arcs.empty()) return 0;
  CutSurface cut =
      cut_surface(slope, make_arc(circle.centre, circle.radius, arcs[0][0], arcs[0][1]), slices, follow_base());
  return solve(slope, cut, method, follow_base(), false).factor;
}

SearchOptions make_composite_options(std::vector<Method> methods) {
  SearchOptions options = make_options(std::move(methods));
  options.composite = true;
  options.optimise_surface = false;
  return options;
}

/// The case of a user: 8 m beyond the toe the base is 3 m deeper, which no circle of the slope reaches. Bishop 1.093
/// with a level base, and 1.231 where circles may not follow it.
TEST(LemComposite, APitBeyondTheToeChangesNothing) {
  const SearchOptions options = make_composite_options({Method::bishop, Method::spencer});
  const SearchResult here = search(Slope(make_bank_on_seam({{0, 0}, {40, 0}})), options),
                     pit = search(Slope(make_bank_on_seam({{0, 0}, {40, 0}, {40, -3}, {50, -3}})), options);
  for (const Method method : options.methods)
    EXPECT_NEAR(find_smallest(pit, method), find_smallest(here, method), 2e-3 * find_smallest(here, method));
  EXPECT_NEAR(find_smallest(pit, Method::bishop), 1.093, 0.005);
  EXPECT_TRUE(pit.circular.front().cut.composite);
  EXPECT_TRUE(std::any_of(pit.limit_hits.begin(), pit.limit_hits.end(), [](const LimitHit& hit) {
    return hit.limit.find("continues along the bottom") != std::string::npos;
  }));
}

/// The factor of every circle tends to that of the level base as the fall of the base tends to zero, in proportion.
TEST(LemComposite, AFallThatVanishesIsALevelBase) {
  const Slope flat(make_bank_on_seam(level));
  for (const Circle& circle : list_deep_circles())
    for (const Method method : {Method::bishop, Method::spencer}) {
      const double factor = solve_circle(flat, circle, method);
      ASSERT_GT(factor, 0.5);
      for (const double fall : {0.1, 0.01, 1e-4, 1e-6, 1e-9})
        for (const double sign : {-1.0, 1.0}) {
          const Slope falls(make_bank_on_seam({{0, 0}, {40, sign * fall}}));
          EXPECT_NEAR(solve_circle(falls, circle, method), factor, (0.3 * fall + 1e-7) * factor) << fall;
        }
    }
  const SearchOptions options = make_composite_options({Method::bishop});
  const double level_factor = find_smallest(search(flat, options), Method::bishop);
  for (const double fall : {-0.1, -1e-6, 0.1}) {
    const Slope falls(make_bank_on_seam({{0, 0}, {40, fall}}));
    EXPECT_NEAR(find_smallest(search(falls, options), Method::bishop), level_factor, 0.02 * level_factor) << fall;
  }
}

const std::vector<std::vector<Point>> bottoms{
    {{0, -2}, {40, 1}},                                        // rises towards the toe
    {{0, 0.8}, {12, 0.5}, {20, -1.5}, {40, 0.5}},              // a basin
    {{0, 0.5}, {15, -1}, {20, 0.6}, {26, -1}, {40, 0}},        // a ridge
    {{0, 0.5}, {14, 0.5}, {14, -0.5}, {40, -0.5}},             // a step down in the direction of sliding
    {{0, -1}, {24, -1}, {24, 0.4}, {40, 0.4}},                 // a step against it
    {{0, 0}, {21, 0}, {21, -1}, {22, -1}, {22, 0}, {40, 0}}};  // a drain

/// A base is the line that its slices have: the polyline along the same points has the same factor by Spencer's method.
TEST(LemComposite, IsThePolylineAlongItsPoints) {
  for (const auto& bottom : bottoms) {
    const Slope slope(make_bank_on_seam(bottom));
    for (const Circle& circle : list_deep_circles()) {
      const auto arc = find_arcs(slope, circle).front();
      CutSurface cut = cut_surface(slope, make_arc(circle.centre, circle.radius, arc[0], arc[1]), 200, follow_base());
      ASSERT_EQ(cut.refusal, Refusal::none) << name_refusal(cut.refusal);
      EXPECT_TRUE(cut.composite);
      std::vector<Point> line{cut.slices.front().base_left};
      for (const Slice& slice : cut.slices) {
        EXPECT_NEAR(slice.base_left[1], line.back()[1], 1e-5) << "the base has no step";
        EXPECT_GE(slice.base_right[1], slope.lower_floor(slice.right) - 1e-6);
        line.push_back(slice.base_right);
      }
      const double factor = solve(slope, cut, Method::spencer, follow_base(), false).factor;
      if (!(factor > 0)) continue;
      EXPECT_NEAR(find_factor(slope, make_polyline(line), Method::spencer, 200), factor, 1e-4 * factor);
    }
  }
}

TEST(LemComposite, TheTopOfRockIsTheBottomOfASection) {
  for (const auto& bottom : bottoms) {
    const Slope soil(make_bank_on_seam(bottom)), rock(make_bank_on_rock(bottom));
    for (const Circle& circle : list_deep_circles())
      for (const Method method : {Method::bishop, Method::spencer, Method::janbu}) {
        const double factor = solve_circle(soil, circle, method);
        EXPECT_NEAR(solve_circle(rock, circle, method), factor, 1e-6 * factor);
      }
  }
}

TEST(LemComposite, TheMirrorImageIsTheSame) {
  for (const auto& bottom : bottoms) {
    const Section section = make_bank_on_seam(bottom);
    const Slope slope(section), other(mirror(section));
    for (Circle circle : list_deep_circles()) {
      const double factor = solve_circle(slope, circle, Method::bishop);
      circle.centre[0] = -circle.centre[0];
      EXPECT_NEAR(solve_circle(other, circle, Method::bishop), factor, 1e-8 * factor);
    }
  }
}

/// A step is a change of the base like others: its factor tends to that of the level base with its height, and the
/// circle just above its edge has the factor of the one just below.
TEST(LemComposite, StepsAreContinuous) {
  const Slope flat(make_bank_on_seam(level));
  for (const Circle& circle : list_deep_circles()) {
    const double factor = solve_circle(flat, circle, Method::spencer);
    for (const double height : {0.03, 1e-3, 1e-5})
      for (const double x : {14.0, 22.0, 26.0}) {
        const Slope down(make_bank_on_seam({{0, height}, {x, height}, {x, 0}, {40, 0}})),
            up(make_bank_on_seam({{0, 0}, {x, 0}, {x, height}, {40, height}}));
        EXPECT_NEAR(solve_circle(down, circle, Method::spencer), factor, (height + 1e-6) * factor);
        EXPECT_NEAR(solve_circle(up, circle, Method::spencer), factor, (height + 1e-6) * factor);
      }
  }
  // The edges of both steps lie between the circles.
  const Slope steps(make_bank_on_seam({{0, 1e-9}, {12, 1e-9}, {12, -2}, {26, -2}, {26, 1e-9}, {40, 1e-9}}));
  double last = 0;
  for (double radius = 19.1; radius < 21; radius += 0.005) {
    const double factor = solve_circle(steps, {{24, 20}, radius}, Method::bishop);
    ASSERT_GT(factor, 0.5) << radius;
    if (last > 0) {
      EXPECT_NEAR(factor, last, 0.01 * last) << radius;
    }
    last = factor;
  }
}

/// Drains and benches in the base leave circles their factors: none is lost.
TEST(LemComposite, ADrainUnderTheToeKeepsTheFactor) {
  const SearchOptions options = make_composite_options({Method::bishop, Method::spencer});
  const SearchResult plain = search(Slope(make_bank_on_seam(level)), options),
                     drain = search(Slope(make_bank_on_seam(bottoms.back())), options);
  for (const Method method : options.methods)
    EXPECT_NEAR(find_smallest(drain, method), find_smallest(plain, method), 0.02 * find_smallest(plain, method));
  EXPECT_EQ(drain.refused[0].count(Refusal::below_base) + drain.refused[0].count(Refusal::blocked), 0u);
}

/// Without `composite` such circles are rejected with their reason; rock is followed in any case.
TEST(LemComposite, IsAskedFor) {
  const Slope soil(make_bank_on_seam(bottoms[0])), rock(make_bank_on_rock(bottoms[0]));
  Checks checks = report_only();
  checks.composite = false;
  const Circle circle = list_deep_circles().front();
  for (const Slope* slope : {&soil, &rock}) {
    const auto arc = find_arcs(*slope, circle).front();
    EXPECT_EQ(cut_surface(*slope, make_arc(circle.centre, circle.radius, arc[0], arc[1]), 50, checks).refusal,
              slope == &soil ? Refusal::below_base : Refusal::none);
  }
}

/// A ridge of rock that reaches above the upper end of the mass leaves no way over it.
TEST(LemComposite, ARidgeThatHoldsTheMassRejectsTheCircle) {
  Section section = make_section({{0, 6}, {12, 6}, {12.5, 9}, {18, 9}, {30, 2}, {45, 2}}, make_soil(10, 20, 19), -5);
  section.soils.push_back(make_soil(0, 45, 24));
  for (const double top : {4.6, 8.5}) {
    Section ridge = section;
    ridge.regions.push_back({1, {{13.2, -5}, {17, -5}, {17, top}, {13.2, top}}});
    ridge.impenetrable = {1};
    const Slope slope(ridge);
    const Circle circle{{22, 16}, 14.866};
    const auto arc = find_arcs(slope, circle).front();
    const CutSurface cut =
        cut_surface(slope, make_arc(circle.centre, circle.radius, arc[0], arc[1]), 50, follow_base());
    EXPECT_EQ(cut.refusal, top > 6 ? Refusal::blocked : Refusal::none);
  }
  EXPECT_STREQ(name_refusal(Refusal::blocked), "meets a step of the base that it cannot pass");
}

/// Cracks, drawdown and yield acceleration work on the same surfaces.
TEST(LemComposite, CracksDrawdownAndYieldAccelerationFollowTheBase) {
  for (const auto& bottom : {bottoms[0], bottoms[3]}) {
    Section soil = make_bank_on_seam(bottom), rock = make_bank_on_rock(bottom);
    for (Section* section : {&soil, &rock}) {
      section->crack = TensionCrack{1.5, 0.5, false};
      section->water_table = {{0, 6}, {20, 6}, {28, 3}, {40, 3}};
    }
    const Circle circle = list_deep_circles().front();
    const double factor = solve_circle(Slope(soil), circle, Method::spencer);
    EXPECT_GT(factor, 0.3);
    EXPECT_NEAR(solve_circle(Slope(rock), circle, Method::spencer), factor, 1e-8 * factor);
    soil.water_table.clear();
    const Slope dry(soil);
    const auto arc = find_arcs(dry, circle).front();
    CutSurface cut = cut_surface(dry, make_arc(circle.centre, circle.radius, arc[0], arc[1]), 60, follow_base());
    const auto yield = find_yield_acceleration(dry, cut, Method::bishop, follow_base());
    ASSERT_EQ(yield.has_value(), solve(dry, cut, Method::bishop, follow_base(), false).factor > 1);
    Section before = soil;
    before.crack.reset();
    before.water_table = {{0, 9}, {40, 9}};
    Section after = before;
    after.water_table = {{0, 9}, {19, 9}, {28, 3}, {40, 3}};
    after.soils[1].envelope = UndrainedEnvelope{5, 12 * degree};
    after.soils[1].friction_angle = before.soils[1].friction_angle = 20 * degree;
    before.soils[1].envelope = after.soils[1].envelope;
    after.drawdown = Drawdown{DrawdownMethod::three_stage, std::make_shared<const Section>(before)};
    EXPECT_GT(solve_circle(Slope(after), circle, Method::spencer), 0.3);
  }
}

}  // namespace
}  // namespace talus::lem
