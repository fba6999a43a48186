// SPDX-License-Identifier: MIT
// Slip surfaces as asked: circles tangent to levels and layers, impenetrable soil, excluded areas, windows, directions,
// sizes, and the mirror of each.

#include "base/error.hpp"
#include "support/lem_searches.hpp"

namespace talus::lem {
namespace {

TEST(LemTangent, AtTheLevelOfTheCriticalCircleFindsThatCircle) {
  const Slope slope(make_plain_section());
  SearchOptions options = make_circle_options();
  const SearchResult free = search(slope, options);
  const Circle circle = *free.circular.front().surface.circle;
  const double factor = free.circular.front().solution.factor;
  for (const SearchKind kind : {SearchKind::entry_exit, SearchKind::grid}) {
    options.kind = kind;
    options.tangent = TangentLines{{}, {}, true};
    const double level = circle.centre[1] - circle.radius;
    options.tangent->upper = options.tangent->lower = {{0, level}, {90, level}};
    const Critical tangent = search(slope, options).circular.front();
    EXPECT_NEAR(tangent.solution.factor, factor, 1e-4 * factor);
    EXPECT_NEAR(tangent.surface.circle->centre[1] - tangent.surface.circle->radius, level,
                1e-9 * tangent.surface.circle->radius);
    // Between two levels below it the higher one governs, and the factor is larger.
    options.tangent->lower = {{0, 3}, {90, 3}};
    options.tangent->upper = {{0, 6}, {90, 6}};
    const Critical deep = search(slope, options).circular.front();
    EXPECT_GT(deep.solution.factor, factor);
    EXPECT_NEAR(deep.surface.circle->centre[1] - deep.surface.circle->radius, 6, 1e-3);
  }
}

TEST(LemTangent, ToAnInclinedLayer) {
  const Slope slope(make_plain_section());
  SearchOptions options = make_circle_options();
  options.tangent = TangentLines{{{0, 4}, {90, 13}}, {{0, 4}, {90, 13}}, false};
  for (const SearchKind kind : {SearchKind::entry_exit, SearchKind::grid}) {
    options.kind = kind;
    const Circle circle = *search(slope, options).circular.front().surface.circle;
    EXPECT_NEAR((circle.centre[1] - 4 - 0.1 * circle.centre[0]) / std::hypot(1, 0.1), circle.radius,
                1e-9 * circle.radius);
  }
}

double measure_distance(const Point& p, const std::vector<Point>& line) {
  double least = 1e300;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double dx = line[i][0] - line[i - 1][0], dy = line[i][1] - line[i - 1][1];
    const double t =
        std::clamp(((p[0] - line[i - 1][0]) * dx + (p[1] - line[i - 1][1]) * dy) / (dx * dx + dy * dy), 0., 1.);
    least = std::min(least, std::hypot(p[0] - line[i - 1][0] - t * dx, p[1] - line[i - 1][1] - t * dy));
  }
  return least;
}

/// Every local minimum of every method touches the side of the seam of ACADS 4, and stays above it.
TEST(LemTangent, EveryMinimumTouchesTheSideOfALayer) {
  const Slope slope(make_inclined_seam_section());
  const Path seam = make_path({{{20, 18.28}, {84, 36.2}, {84, 36.8}, {20, 18.88}}});
  SearchOptions options = make_options({Method::bishop, Method::janbu, Method::spencer});
  for (const auto* side : {&seam.top, &seam.bottom}) {
    options.tangent = TangentLines{*side, *side, false};
    const SearchResult result = search(slope, options);
    EXPECT_TRUE(result.noncircular.empty());
    for (const auto& minima : result.minima)
      for (const Critical& c : minima)
        EXPECT_NEAR(measure_distance(c.surface.circle->centre, *side), c.surface.circle->radius,
                    1e-9 * c.surface.circle->radius);
  }
}

/// Griffiths & Lane (1999), example 2: the chart of Bishop & Morgenstern for circles that touch the base has 1.752, an
/// independent program has 1.366 for free circles by Spencer. No tangent circle about a dense grid has a lower factor.
TEST(LemTangent, ToTheBaseHasThePublishedFactor) {
  const Slope slope(make_section({{0, 0}, {100, 0}, {200, 50}, {260, 50}}, make_soil(312.5, 20, 125), -25, 62.4));
  SearchOptions options = make_options({Method::bishop, Method::spencer});
  options.optimise_surface = false;
  EXPECT_NEAR(find_smallest(search(slope, options), Method::spencer), 1.366, 0.005);
  options.tangent = TangentLines{{{0, -25}, {260, -25}}, {{0, -25}, {260, -25}}, true};
  const double factor = find_smallest(search(slope, options), Method::bishop);
  EXPECT_NEAR(factor, 1.752, 0.005 * 1.752);
  double least = 10;
  for (double x = 100; x <= 150; x += 2.5)
    for (double y = 60; y <= 110; y += 2.5) {
      const Circle circle{{x, y}, (y + 25) * (1 - 1e-9)};
      const auto arcs = find_arcs(slope, circle);
      if (arcs.size() == 1)
        least = std::min(least, find_factor(slope, make_arc(circle.centre, circle.radius, arcs[0][0], arcs[0][1]),
                                            Method::bishop, 50));
    }
  EXPECT_GT(least, factor * (1 - 1e-4));
  EXPECT_LT(least, factor * 1.002);
}

/// Fredlund & Krahn (1977), case 2: the circle cut off at the firm base under a weak seam; feet and pounds. Rock that
/// reaches further down is the same as a section that ends there.
Section make_seam_on_rock(double base, bool has_rock) {
  Section section = make_section({{0, 20}, {40, 20}, {120, 60}, {180, 60}}, make_soil(600, 20, 120), base, 62.4);
  section.soils.push_back(make_soil(0, 10, 120));
  section.regions.push_back(make_region_below(section, 1, {{0, 16}, {180, 16}}));
  if (!has_rock) return section;
  section.soils.push_back(make_soil(0, 45, 150));
  section.regions.push_back(make_region_below(section, 2, {{0, 15}, {180, 15}}));
  section.impenetrable = {2};
  return section;
}

TEST(LemImpenetrable, RockIsABaseOfTheSection) {
  const Slope cut(make_seam_on_rock(15, false)), rock(make_seam_on_rock(-40, true));
  Surface circle;
  circle.circle = Circle{{60, 90}, 80};
  circle.from = find_arcs(rock, *circle.circle).front()[0];
  circle.to = find_arcs(rock, *circle.circle).front()[1];
  Checks checks = report_only();
  for (const auto& [method, expected] :
       {std::pair{Method::bishop, 1.3798}, {Method::spencer, 1.3792}, {Method::morgenstern_price, 1.3697}}) {
    CutSurface here = cut_surface(rock, circle, 100, checks), there = cut_surface(cut, circle, 100, checks);
    const double factor = solve(rock, here, method, checks, false).factor;
    EXPECT_NEAR(factor, expected, 0.003);
    EXPECT_NEAR(factor, solve(cut, there, method, checks, false).factor, 1e-9);
    EXPECT_TRUE(here.composite);
  }
  // Without `composite` the base of the section rejects circles, and impenetrable soil above it clips them.
  checks.composite = false;
  EXPECT_EQ(cut_surface(cut, circle, 50, checks).refusal, Refusal::below_base);
  EXPECT_EQ(cut_surface(rock, circle, 50, checks).refusal, Refusal::none);
}

TEST(LemImpenetrable, RockFarBelowChangesNothing) {
  Section deep = make_plain_section();
  const double factor = search(Slope(make_plain_section()), make_circle_options()).circular.front().solution.factor;
  deep.soils.push_back(make_soil(0, 45, 22));
  deep.regions.push_back(make_region_below(deep, 1, {{0, 1}, {90, 0.5}}));
  deep.impenetrable = {1};
  EXPECT_NEAR(search(Slope(std::move(deep)), make_circle_options()).circular.front().solution.factor, factor,
              1e-4 * factor);
}

/// The base along inclined rock is the polyline that has a corner at each end of it, and a vertex at each slice.
TEST(LemImpenetrable, ACircleFollowsInclinedRock) {
  Section section = make_plain_section();
  section.soils.push_back(make_soil(0, 45, 22));
  section.regions.push_back(make_region_below(section, 1, {{0, 6}, {40, 7}, {90, 14}}));
  section.impenetrable = {1};
  const Slope slope(std::move(section));
  Surface circle;
  circle.circle = Circle{{36, 30}, 26};
  circle.from = find_arcs(slope, *circle.circle).front()[0];
  circle.to = find_arcs(slope, *circle.circle).front()[1];
  CutSurface cut = cut_surface(slope, circle, 200, report_only());
  ASSERT_EQ(cut.refusal, Refusal::none);
  std::vector<Point> line{cut.slices.front().base_left};
  for (const Slice& slice : cut.slices) {
    EXPECT_EQ(slice.soil, 0);
    EXPECT_NEAR(slice.base_left[1], line.back()[1], 1e-9) << "the base has no step";
    EXPECT_GE(slice.base_right[1], slope.floor(slice.right) - 1e-9);
    line.push_back(slice.base_right);
  }
  const double factor = solve(slope, cut, Method::spencer, report_only(), false).factor;
  EXPECT_NEAR(find_factor(slope, make_polyline(line), Method::spencer, 200), factor, 1e-5 * factor);
}

Section make_slope_on_rock() {
  Section section = make_plain_section();
  section.soils.push_back(make_soil(0, 45, 22));
  section.regions.push_back(make_region_below(section, 1, {{0, 9}, {34, 10.3}, {90, 18}}));
  section.impenetrable = {1};
  return section;
}

/// No base lies below the rock, whatever the search, and the lowest surface of each follows it.
TEST(LemImpenetrable, NoSurfaceOfASearchEntersRock) {
  const Slope slope(make_slope_on_rock());
  for (const SearchKind kind : {SearchKind::entry_exit, SearchKind::grid, SearchKind::block}) {
    SearchOptions options = make_block_options({Method::spencer, Method::janbu},
                                               {{"a", {{30, 6}, {38, 11}}, true}, {"b", {{42, 8}, {56, 15}}, true}});
    options.kind = kind;
    options.vertices = 8;
    const SearchResult result = search(slope, options);
    bool follows = false;
    for (const auto* list : {&result.circular, &result.noncircular})
      for (const Critical& c : *list)
        for (const Slice& slice : c.cut.slices) {
          EXPECT_EQ(slice.soil, 0);
          const double left = slice.base_left[1] - slope.floor(slice.left),
                       right = slice.base_right[1] - slope.floor(slice.right);
          EXPECT_GE(std::min(left, right), -1e-9);
          follows = follows || std::max(left, right) < 1e-9;
        }
    EXPECT_TRUE(follows);
  }
}

TEST(LemExcluded, AnAreaThatNoSurfaceMeetsChangesNothing) {
  const Slope slope(make_plain_section());
  const double factor = search(slope, make_circle_options()).circular.front().solution.factor;
  SurfaceLimits limits;
  limits.excluded = {{{70, 0}, {80, 0}, {80, 2}, {70, 2}}};
  EXPECT_EQ(search(slope, limit(make_circle_options(), limits)).circular.front().solution.factor, factor);
}

TEST(LemExcluded, AnAreaOverTheCriticalSurfaceMovesIt) {
  const Slope slope(make_plain_section());
  SearchOptions options = make_options({Method::spencer});
  options.vertices = 8;
  const SearchResult free = search(slope, options);
  SurfaceLimits limits;
  limits.excluded = {{{36, 9}, {44, 9}, {44, 14}, {36, 14}}};
  const SearchResult moved = search(slope, limit(options, limits));
  EXPECT_GE(moved.circular.front().solution.factor, free.circular.front().solution.factor);
  EXPECT_GE(moved.noncircular.front().solution.factor, free.noncircular.front().solution.factor * 0.999);
  EXPECT_GT(moved.refused.front().at(Refusal::excluded), 0);
  for (const auto* list : {&moved.circular, &moved.noncircular})
    for (const Slice& slice : list->front().cut.slices)
      EXPECT_FALSE(enters_polygon(limits.excluded.front(), slice.base_left, slice.base_right));
}

TEST(LemPassage, EverySurfacePassesTheWindow) {
  const Slope slope(make_plain_section());
  const double factor = search(slope, make_circle_options()).circular.front().solution.factor;
  SurfaceLimits limits;
  limits.passages = {{"deep", {{40, 4}, {42, 6}}, true}};
  const SearchResult deep = search(slope, limit(make_circle_options(), limits));
  EXPECT_GT(deep.circular.front().solution.factor, factor);
  const auto& slices = deep.circular.front().cut.slices;
  EXPECT_TRUE(std::any_of(slices.begin(), slices.end(), [&](const Slice& s) {
    return meets_window(limits.passages.front(), s.base_left, s.base_right);
  }));
}

/// A dam with a steep left and a gentle right side.
TEST(LemDirection, KeepsTheSideThatIsAskedFor) {
  const Slope slope(make_section({{0, 0}, {30, 0}, {45, 10}, {50, 10}, {80, 0}, {110, 0}}, make_soil(5, 28, 19), -5));
  SurfaceLimits left, right;
  left.direction = -1, right.direction = 1;
  const SearchResult both = search(slope, make_circle_options()),
                     to_left = search(slope, limit(make_circle_options(), left)),
                     to_right = search(slope, limit(make_circle_options(), right));
  EXPECT_TRUE(to_left.circular.front().cut.slides_left);
  EXPECT_FALSE(to_right.circular.front().cut.slides_left);
  EXPECT_NEAR(to_left.circular.front().solution.factor, both.circular.front().solution.factor, 1e-6);
  EXPECT_GT(to_right.circular.front().solution.factor, 1.2 * both.circular.front().solution.factor);
  EXPECT_GT(to_right.refused.front().at(Refusal::direction), 0);
}

/// Circles pass through the foot of a vertical cut, whichever way it faces. Taylor (1937): F = 3.83 c/(γ H) with φ = 0.
TEST(LemDirection, ThroughTheFootOfAVerticalCut) {
  const Section section = make_section({{0, 5}, {20, 5}, {20, 10}, {45, 10}}, make_soil(30, 0, 20), 0);
  SearchOptions options = make_circle_options();
  options.checks.most_tension = 1;
  const double here = search(Slope(section), options).circular.front().solution.factor,
               there = search(Slope(mirror(section)), options).circular.front().solution.factor;
  EXPECT_NEAR(here, there, 2e-3 * here);
  EXPECT_NEAR(here, 3.83 * 30 / (20 * 5), 0.02 * here);
}

/// An exit alone, on a section whose toe lies beyond its middle: the entries are those of the whole ground.
TEST(LemDirection, OfExitsAloneIsThatOfTheGround) {
  const Section section = make_section({{0, 8}, {32, 8}, {48, 16}, {60, 16}}, make_soil(5, 25, 19), 0);
  SearchOptions options = make_circle_options();
  const double free = search(Slope(section), options).circular.front().solution.factor;
  for (const std::array<double, 2> entry : {std::array{0.0, 60.0}, std::array{46.0, 55.0}}) {
    options.entry_exit.emplace();
    options.entry_exit->exit = {31.9, 36};
    options.entry_exit->entry = entry;
    const Critical found = search(Slope(section), options).circular.front();
    EXPECT_TRUE(found.cut.slides_left);
    EXPECT_NEAR(found.solution.factor, free, 5e-3 * free);
    options.entry_exit->exit = {-36, -31.9};
    options.entry_exit->entry = {-entry[1], -entry[0]};
    const Critical turned = search(Slope(mirror(section)), options).circular.front();
    EXPECT_NEAR(turned.solution.factor, found.solution.factor, 1e-6);
  }
}

TEST(LemExcluded, ACrackIsPartOfTheSurface) {
  Section section = make_section({{0, 8}, {32, 8}, {48, 16}, {60, 16}}, make_soil(12, 15, 19), 0);
  section.crack = TensionCrack{2.5, 0};
  section.crack->limited = false;
  const Slope slope(section);
  const Critical free = search(slope, make_circle_options()).circular.front();
  const double crack = free.cut.slices.back().right;
  SurfaceLimits limits;
  limits.excluded = {{{crack - 1, 14.5}, {crack + 6, 14.5}, {crack + 6, 16}, {crack - 1, 16}}};
  EXPECT_EQ(cut_surface(slope, free.surface, 30, limit(make_circle_options(), limits).checks).refusal,
            Refusal::excluded);
  EXPECT_GT(search(slope, limit(make_circle_options(), limits)).circular.front().solution.factor, free.solution.factor);
}

/// A crack that may be as deep as given weakens a slope or leaves it.
TEST(LemCrack, NeverRaisesTheFactor) {
  Section section = make_section({{0, 8}, {32, 8}, {48, 16}, {60, 16}}, make_soil(40, 25, 19), 0);
  const SearchOptions options = make_options({Method::bishop, Method::spencer});
  const SearchResult without = search(Slope(section), options);
  double last = find_smallest(without, Method::spencer);
  for (const double depth : {1.0, 2.0, 6.0, 12.0}) {
    section.crack = TensionCrack{depth, 0, true};
    const double factor = find_smallest(search(Slope(section), options), Method::spencer);
    EXPECT_LE(factor, last * 1.002) << depth;
    last = std::min(last, factor);
  }
}

/// Ranges of entries and exits, a level and an area hold in the mirror.
TEST(LemDirection, RangesLevelsAndAreasAreTheSameInAMirror) {
  SearchOptions here = make_options({Method::bishop, Method::spencer});
  here.optimise_surface = false;
  here.entry_exit.emplace();
  here.entry_exit->exit = {26, 36};
  here.entry_exit->entry = {48, 70};
  SearchOptions there = here;
  there.entry_exit->exit = {-36, -26};
  there.entry_exit->entry = {-70, -48};
  SurfaceLimits limits, turned;
  limits.excluded = {{{36, 9}, {44, 9}, {44, 12}, {36, 12}}};
  turned.excluded = {{{-36, 9}, {-44, 9}, {-44, 12}, {-36, 12}}};
  limits.direction = -1, turned.direction = 1;
  const Slope slope(make_plain_section()), mirrored(mirror(make_plain_section()));
  for (const bool has_tangent : {false, true}) {
    if (has_tangent) {
      here.tangent = TangentLines{{{0, 9}, {90, 9}}, {{0, 5}, {90, 5}}, true};
      there.tangent = TangentLines{{{-90, 9}, {0, 9}}, {{-90, 5}, {0, 5}}, true};
    }
    const SearchResult a = search(slope, limit(here, limits)), b = search(mirrored, limit(there, turned));
    for (const Method method : here.methods)
      EXPECT_NEAR(find_smallest(b, method), find_smallest(a, method), 1e-9 * find_smallest(a, method));
  }
}

/// Rock, a layer to which circles are tangent, and a window to pass.
TEST(LemDirection, RockTangentsAndWindowsAreTheSameInAMirror) {
  const Slope slope(make_slope_on_rock()), mirrored(mirror(make_slope_on_rock()));
  SearchOptions options = make_options({Method::bishop, Method::spencer});
  options.optimise_surface = false;
  const auto expect_same = [&](const SearchOptions& here, const SearchOptions& there) {
    const SearchResult a = search(slope, here), b = search(mirrored, there);
    for (const Method method : options.methods)
      EXPECT_NEAR(find_smallest(b, method), find_smallest(a, method), 1e-9 * find_smallest(a, method));
  };
  expect_same(options, options);
  SurfaceLimits limits, turned;
  limits.passages = {{"deep", {{40, 12}, {44, 14}}, true}};
  turned.passages = {{"deep", {{-44, 12}, {-40, 14}}, true}};
  expect_same(limit(options, limits), limit(options, turned));
  SearchOptions there = options;
  options.tangent = TangentLines{{{0, 9.5}, {90, 18.5}}, {{0, 9.5}, {90, 18.5}}, false};
  there.tangent = TangentLines{{{-90, 18.5}, {0, 9.5}}, {{-90, 18.5}, {0, 9.5}}, false};
  expect_same(options, there);
}

/// The limits of the size hold for all local minima of all methods.
TEST(LemSmallest, HoldsForEveryMethod) {
  const Slope slope(make_plain_section());
  std::vector<Method> methods = all_methods;
  for (const Method m : {Method::corps_1, Method::corps_2, Method::lowe_karafiath, Method::modified_swedish})
    methods.push_back(m);
  SearchOptions options = make_options(methods);
  options.optimise_surface = false;
  options.checks.smallest_depth = 5;
  options.finds_skins = true;
  SurfaceLimits limits;
  limits.smallest_area = 120;
  limits.smallest_weight = 125 * 19;
  const SearchResult result = search(slope, limit(options, limits));
  EXPECT_EQ(result.circular.size(), methods.size());
  for (const auto& minima : result.minima)
    for (const Critical& c : minima) {
      EXPECT_GE(c.cut.depth, 5) << to_word(c.method);
      EXPECT_GE(c.cut.area, 125 * (1 - 1e-9)) << to_word(c.method);
    }
}

TEST(LemSmallest, AreaAndWeightHoldForEverySearch) {
  const Slope slope(make_plain_section());
  const Path path{{{0, 9.5}, {90, 9.5}}, {{0, 9.5}, {90, 9.5}}};
  for (const SearchKind kind : {SearchKind::entry_exit, SearchKind::grid, SearchKind::block}) {
    SearchOptions options = make_block_options({Method::spencer}, {}, path);
    options.kind = kind;
    options.vertices = 8;
    SurfaceLimits area, weight;
    area.smallest_area = 150;
    weight.smallest_weight = 150 * 19;
    const SearchResult a = search(slope, limit(options, area)), b = search(slope, limit(options, weight));
    for (const auto* list : {&a.circular, &a.noncircular})
      for (const Critical& c : *list) EXPECT_GE(c.cut.area, 150);
    EXPECT_NEAR(find_smallest(b, Method::spencer), find_smallest(a, Method::spencer), 1e-3);
    options.checks.smallest_depth = 9;
    options.finds_skins = true;
    const SearchResult deep = search(slope, options);
    for (const auto* list : {&deep.circular, &deep.noncircular})
      for (const Critical& c : *list) EXPECT_GE(c.cut.depth, 9);
  }
}

}  // namespace
}  // namespace talus::lem
