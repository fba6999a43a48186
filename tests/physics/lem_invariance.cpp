// SPDX-License-Identifier: MIT
// Invariances of the factor: reflection, position, units, the level of a pool above the slope, and absent items.

#include <algorithm>
#include <functional>

#include "lem/search/search.hpp"
#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

/// Layers, water, pond, surcharge, crack, roots and earthquake at once; kN and m.
Section make_full_section() {
  Section section = make_section({{0, 5}, {12, 5}, {20, 10}, {20, 11}, {32, 17}, {50, 18}}, make_soil(8, 28, 18), -2);
  section.soils[0].saturated_unit_weight = 19.5;
  section.soils.push_back(make_soil(15, 22, 19));
  section.soils[1].saturated_unit_weight = 20;
  section.soils.push_back(make_soil(30, 0, 17));
  section.soils[2].undrained = true;
  section.soils[2].cohesion_gradient = 1.5;
  section.soils[2].cohesion_level = 3;
  section.regions.push_back(make_region_below(section, 1, {{0, 7}, {50, 12}}));
  section.regions.push_back({2, {{14, 6}, {26, 5}, {30, 7}, {18, 8.5}}});  // a lens
  section.water_table = {{0, 6.5}, {16, 6.5}, {30, 11}, {50, 13}};
  section.surcharges = {{{{34, 10}, {40, 25}}}};
  section.crack = TensionCrack{1.2, 0.7};
  section.roots = {{{{0, 6}, {1.0, 2}}, 15, 30}};
  section.horizontal_acceleration = 0.05;
  section.vertical_acceleration = 0.02;
  return section;
}

void change_points(Section& section, const std::function<Point(const Point&)>& move) {
  const auto change = [&](std::vector<Point>& line) {
    for (Point& p : line) p = move(p);
    // Left to right again where it was mirrored.
    if (line.size() > 1 && line.back()[0] < line.front()[0]) std::reverse(line.begin(), line.end());
  };
  change(section.ground);
  change(section.water_table);
  for (Region& region : section.regions)
    for (Point& p : region.polygon) p = move(p);
  section.base = move({0, section.base})[1];
  for (Soil& soil : section.soils) soil.cohesion_level = move({0, soil.cohesion_level})[1];
}

Surface move_surface(const Surface& surface, const std::function<Point(const Point&)>& move, double scale) {
  Surface moved = surface;
  if (surface.circle) {
    moved.circle = Circle{move(surface.circle->centre), scale * surface.circle->radius};
    moved.from = move({surface.from, 0})[0];
    moved.to = move({surface.to, 0})[0];
    if (moved.from > moved.to) std::swap(moved.from, moved.to);
  }
  for (Point& p : moved.line) p = move(p);
  if (moved.line.size() > 1 && moved.line.back()[0] < moved.line.front()[0])
    std::reverse(moved.line.begin(), moved.line.end());
  return moved;
}

std::vector<Surface> make_surfaces(const Slope& slope) {
  return {make_circle(slope, {17, 26}, 21.5), make_circle(slope, {18, 25}, 22.5),
          make_polyline({{11, 5}, {15, 4.2}, {24, 5.5}, {33, 10}, {40, slope.ground(40)}})};
}

void expect_same(const Section& changed, const std::function<Point(const Point&)>& move, double scale) {
  const Slope slope(make_full_section());
  const Slope other{Section(changed)};
  for (const Surface& surface : make_surfaces(slope))
    for (const Method method : all_methods) {
      if (method == Method::bishop && !surface.circle) continue;  // has no axis for moments
      const double expected = find_factor(slope, surface, method);
      EXPECT_GT(expected, 0.5);
      EXPECT_NEAR(find_factor(other, move_surface(surface, move, scale), method), expected, 1e-9) << to_word(method);
    }
}

TEST(LemInvariance, Mirrored) {
  const auto move = [](const Point& p) { return Point{-p[0], p[1]}; };
  Section section = make_full_section();
  change_points(section, move);
  section.surcharges = {{{{-40, 25}, {-34, 10}}}};
  section.roots = {{{{0, 6}, {1.0, 2}}, -30, -15}};
  expect_same(section, move, 1);
}

TEST(LemInvariance, Shifted) {
  const auto move = [](const Point& p) { return Point{p[0] + 1024, p[1] - 512}; };
  Section section = make_full_section();
  change_points(section, move);
  section.surcharges = {{{{34 + 1024, 10}, {40 + 1024, 25}}}};
  section.roots = {{{{0, 6}, {1.0, 2}}, 15 + 1024, 30 + 1024}};
  expect_same(section, move, 1);
}

/// Centroids are measured from the base of a slice: about y = 0 the moments of an earthquake would drown in rounding.
TEST(LemInvariance, AtGreatElevation) {
  const auto move = [](const Point& p) { return Point{p[0] + 524288, p[1] + 4194304}; };
  Section section = make_full_section();
  change_points(section, move);
  section.surcharges = {{{{34 + 524288, 10}, {40 + 524288, 25}}}};
  section.roots = {{{{0, 6}, {1.0, 2}}, 15 + 524288, 30 + 524288}};
  expect_same(section, move, 1);
}

TEST(LemInvariance, InFeetAndPounds) {
  const double foot = 1 / 0.3048, pound = 1 / 4.4482216152605e-3, pressure = pound / (foot * foot),
               weight = pressure / foot;
  const auto move = [&](const Point& p) { return Point{p[0] * foot, p[1] * foot}; };
  Section section = make_full_section();
  change_points(section, move);
  for (Soil& soil : section.soils) {
    soil.cohesion *= pressure;
    soil.cohesion_gradient *= weight;
    soil.unit_weight *= weight;
    soil.saturated_unit_weight *= weight;
  }
  section.water_unit_weight *= weight;
  section.surcharges = {{{{34 * foot, 10 * pressure}, {40 * foot, 25 * pressure}}}};
  section.crack = TensionCrack{1.2 * foot, 0.7 * foot};
  section.roots = {{{{0, 6 * pressure}, {foot, 2 * pressure}}, 15 * foot, 30 * foot}};
  expect_same(section, move, foot);
}

template <std::size_t N>
std::vector<std::array<double, N>> add_points(const std::vector<std::array<double, N>>& line, bool closed) {
  std::vector<std::array<double, N>> refined;
  for (std::size_t i = 0; i < line.size(); ++i) {
    refined.push_back(line[i]);
    if (i + 1 == line.size() && !closed) break;
    const std::array<double, N>&a = line[i], &b = line[(i + 1) % line.size()];
    for (const double t : {0.2, 0.381966}) {
      std::array<double, N> between{};
      for (std::size_t d = 0; d < N; ++d) between[d] = a[d] + t * (b[d] - a[d]);
      refined.push_back(between);
    }
  }
  return refined;
}

/// Points in straight edges of regions, water table and load divide no slice.
TEST(LemInvariance, PointsInStraightEdges) {
  Section section = make_full_section();
  for (Region& region : section.regions) region.polygon = add_points(region.polygon, true);
  section.water_table = add_points(section.water_table, false);
  section.surcharges[0].load = add_points(section.surcharges[0].load, false);
  expect_same(
      section, [](const Point& p) { return p; }, 1);
}

/// A region whose edge is the ground, with corners rounded to a nanometre as a drawing has them: the two lines are one
/// and cross nowhere, wherever the section lies.
TEST(LemInvariance, RegionsThatEndAlongTheGround) {
  const auto move = [](const Point& p) { return Point{p[0] + 5e5, p[1] + 850}; };
  Section section = make_section({{0, 0}, {24.156, 0}, {70.389, 13.42}, {99.913, 13.42}}, make_soil(2, 32, 17), -7.62);
  section.soils.push_back(make_soil(57, 0, 20));
  section.regions.push_back(
      {1,
       {{99.913, 8.121}, {99.913, 13.42}, {70.389, 13.42}, {47.655510143, 6.821175916}, {38.004142957, 4.019684608}}});
  Section moved = section;
  change_points(moved, move);
  const Slope slope(std::move(section)), other(std::move(moved));
  const Surface circle = make_circle(slope, {47.272, 25.498}, 23.485);
  const Surface there = move_surface(circle, move, 1);
  EXPECT_EQ(cut_surface(other, there, 30, report_only()).slices.size(),
            cut_surface(slope, circle, 30, report_only()).slices.size());
  for (const Method method : {Method::bishop, Method::spencer}) {
    const double factor = find_factor(slope, circle, method);
    EXPECT_NEAR(find_factor(other, there, method), factor, 1e-9 * factor) << to_word(method);
  }
}

/// Random slope 87 of tools/published/random_slopes.py. Its critical circles lie under the far edge of the load and are
/// as shallow as the search allows: much smaller than the distance of the trial circles' ends, so that the optimisation
/// must find them.
TEST(LemInvariance, SearchUnderTheEdgeOfALoadMirrored) {
  Section section = make_section({{0, 0}, {16.2, 0}, {44.788, 9}, {64.588, 9}}, make_soil(2.5, 30.1, 20.31), -6.04);
  section.soils[0].saturated_unit_weight = 21.39;
  section.soils.push_back(make_soil(6.9, 36, 17.85));
  section.soils[1].saturated_unit_weight = 18.2;
  section.regions.push_back(make_region_below(section, 1, {{0, 0}, {16.2, 0}, {30.917, 4.633}, {64.588, 6.866}}));
  section.water_table = {{0, -0.9}, {16.2, -0.9}, {30.494, 1.847}, {53.788, 5.204}, {64.588, 5.204}};
  section.surcharges = {{{{45.688, 29.8}, {55.508, 29.8}}}};
  Section mirrored = section;
  change_points(mirrored, [](const Point& p) { return Point{-p[0], p[1]}; });
  mirrored.surcharges = {{{{-55.508, 29.8}, {-45.688, 29.8}}}};
  SearchOptions options;
  options.methods = {Method::fellenius, Method::bishop, Method::spencer};
  options.optimise_surface = false;
  const SearchResult here = search(Slope(std::move(section)), options),
                     there = search(Slope(std::move(mirrored)), options);
  ASSERT_EQ(here.circular.size(), options.methods.size());
  ASSERT_EQ(there.circular.size(), options.methods.size());
  for (std::size_t m = 0; m < options.methods.size(); ++m)
    EXPECT_NEAR(there.circular[m].solution.factor / here.circular[m].solution.factor, 1, 5e-4)
        << to_word(options.methods[m]);
}

/// A crack in soil whose strength depends on the inclination is as deep in a mirror.
TEST(LemInvariance, CrackOfDirectedSoilMirrored) {
  Section section = make_section({{0, 5}, {20, 5}, {30, 12}, {50, 12}}, make_soil(0, 0, 18), 0), mirrored = section;
  StrengthLaw law;
  law.is_directed = true;
  law.find_tangent = [](const StrengthPlane& plane) { return StrengthTangent{plane.inclination > 0 ? 10.0 : 25.0, 0}; };
  section.crack = TensionCrack{6, 0, true};
  section.soils[0].law = std::make_shared<const StrengthLaw>(law);
  mirrored.crack = section.crack;
  mirrored.soils[0].law = section.soils[0].law;
  change_points(mirrored, [](const Point& p) { return Point{-p[0], p[1]}; });
  const Slope here(section), there(mirrored);
  EXPECT_NEAR(here.crack_depth(40), there.crack_depth(-40), 1e-9);
  EXPECT_NEAR(here.crack_depth(40), 2 * 25.0 / 18, 1e-3);
}

/// Layers, water and a load, at map coordinates and in a mirror: the search counts from the toe, and its tolerances are
/// fractions of the section.
TEST(LemInvariance, SearchMovedAndMirrored) {
  Section section = make_full_section();
  section.crack.reset();
  section.roots.clear();
  SearchOptions options;
  options.methods = {Method::fellenius, Method::bishop, Method::spencer};
  options.entry_exit = EntryExitSearch{};
  options.entry_exit->exits = options.entry_exit->entries = 12;
  options.optimise_surface = false;
  Section mirrored = section, moved = section;
  change_points(mirrored, [](const Point& p) { return Point{-p[0], p[1]}; });
  mirrored.surcharges = {{{{-40, 25}, {-34, 10}}}};
  change_points(moved, [](const Point& p) { return Point{p[0] + 5e5, p[1] + 850}; });
  for (auto& row : moved.surcharges[0].load) row[0] += 5e5;
  const SearchResult here = search(Slope(std::move(section)), options);
  for (Section* other : {&mirrored, &moved}) {
    const SearchResult there = search(Slope(std::move(*other)), options);
    ASSERT_EQ(there.circular.size(), options.methods.size());
    for (std::size_t m = 0; m < options.methods.size(); ++m)
      EXPECT_NEAR(there.circular[m].solution.factor / here.circular[m].solution.factor, 1, 1e-6)
          << to_word(options.methods[m]) << (other == &moved ? ", moved" : ", mirrored");
  }
}

/// Drawn to the other side, at either place: the search amplifies rounding, where it has many variables and the factor
/// has kinks, so that a section and its mirror image must be searched as one.
TEST(LemInvariance, SearchOfPolylinesMirrored) {
  Section section = make_section({{0, 5}, {17, 5}, {19.2, 11}, {40, 11}}, make_soil(12, 32, 20), 0);
  section.soils.push_back(make_soil(5, 28, 19));
  section.regions.push_back({1, {{17, 5}, {40, 5}, {40, 11}, {19.2, 11}}});
  section.water_table = {{0, 3.2}, {15, 4.8}, {40, 7.38}};
  section.surcharges = {{{{22, 10}, {28, 10}}}};
  Bar nail;
  nail.head = {18.356666667, 8.7}, nail.end = {24.225552271, 7.452529855};
  nail.tensile = 100, nail.plate = 46.7, nail.bond = 16.7;
  section.bars = {nail};
  const auto mirror = [&](double sum) {
    Section mirrored = section;
    change_points(mirrored, [&](const Point& p) { return Point{sum - p[0], p[1]}; });
    mirrored.surcharges = {{{{sum - 28, 10}, {sum - 22, 10}}}};
    for (Bar& bar : mirrored.bars) bar.head[0] = sum - bar.head[0], bar.end[0] = sum - bar.end[0];
    return mirrored;
  };
  SearchOptions options;
  options.methods = {Method::spencer};
  options.slices = 20;
  options.vertices = 8;
  options.entry_exit = EntryExitSearch{};
  options.entry_exit->exits = options.entry_exit->entries = 8;
  options.entry_exit->depths = 5;
  const SearchResult here = search(Slope(Section(section)), options);
  ASSERT_EQ(here.noncircular.size(), 1);
  for (const double sum : {40.0, 0.0}) {
    const SearchResult there = search(Slope(mirror(sum)), options);
    ASSERT_EQ(there.noncircular.size(), 1);
    EXPECT_NEAR(there.circular[0].solution.factor, here.circular[0].solution.factor, 1e-9);
    EXPECT_NEAR(there.noncircular[0].solution.factor, here.noncircular[0].solution.factor, 1e-9);
    EXPECT_NEAR(sum - there.noncircular[0].surface.line.back()[0], here.noncircular[0].surface.line.front()[0], 1e-9);
    ASSERT_EQ(there.trials.size(), here.trials.size());
    EXPECT_NEAR(sum - there.trials.back().surface.to, here.trials.back().surface.from, 1e-9);
  }
}

TEST(LemInvariance, SplitAndRepeatedRegionsChangeNothing) {
  Section section = make_full_section();
  // The same soil once more over a part of it, the other way round, and a polygon cut in two.
  section.regions.insert(section.regions.begin() + 1, {0, {{5, -12}, {5, 30}, {45, 30}, {45, -12}}});
  section.regions.push_back({2, {{14, 6}, {26, 5}, {18, 8.5}}});
  section.regions.push_back({2, {{18, 8.5}, {26, 5}, {30, 7}}});
  const Slope slope(make_full_section()), other(std::move(section));
  // The sides of slices may differ: the areas are exact, the factors close.
  for (const Surface& surface : make_surfaces(slope)) {
    double weight = 0, other_weight = 0;
    for (const Slice& slice : cut_surface(slope, surface, 400, report_only()).slices) weight += slice.weight;
    for (const Slice& slice : cut_surface(other, surface, 400, report_only()).slices) other_weight += slice.weight;
    EXPECT_NEAR(other_weight, weight, 1e-4 * weight);
    EXPECT_NEAR(find_factor(other, surface, Method::spencer, 400), find_factor(slope, surface, Method::spencer, 400),
                1e-3);
  }
}

/// c and tanφ divided by 1.25: F divided by 1.25, by every method and on every surface (EN 1997-1, DA1-C2 without
/// loads).
TEST(LemReduction, FactoredStrengthGivesTheFactoredFactor) {
  Section section = make_full_section();
  section.roots.clear();
  const Slope slope{Section(section)};
  for (Soil& soil : section.soils) {
    soil.cohesion /= 1.25;
    soil.cohesion_gradient /= 1.25;
    soil.friction_angle = std::atan(std::tan(soil.friction_angle) / 1.25);
  }
  const Slope factored(std::move(section));
  for (const Surface& surface : make_surfaces(slope))
    for (const Method method : all_methods) {
      if (method == Method::bishop && !surface.circle) continue;  // has no axis for moments
      EXPECT_NEAR(find_factor(factored, surface, method), find_factor(slope, surface, method) / 1.25, 1e-9)
          << to_word(method);
    }
}

/// φ = 0: Bishop and Fellenius agree on every circle, whatever loads it.
TEST(LemReduction, WithoutFrictionBishopIsFellenius) {
  Section section = make_full_section();
  for (Soil& soil : section.soils) {
    soil.friction_angle = 0;
    soil.undrained = true;
  }
  const Slope slope(std::move(section));
  int circles = 0;
  for (double x = 8; x <= 26; x += 3)
    for (double y = 20; y <= 40; y += 4)
      for (double radius = y - 9; radius < y + 1.5; radius += 1.7) {
        const Surface circle = make_circle(slope, {x, y}, radius);
        if (!(circle.to > circle.from)) continue;
        CutSurface cut = cut_surface(slope, circle, 40, report_only());
        const Solution fellenius = solve(slope, cut, Method::fellenius, report_only(), false);
        // Circles cut level at the base have normal forces with an arm, which the two find differently.
        if (!(fellenius.factor > 0) || cut.composite) continue;
        ++circles;
        const Solution bishop = solve(slope, cut, Method::bishop, report_only(), false);
        EXPECT_NEAR(bishop.factor, fellenius.factor, 1e-9 * fellenius.factor);
      }
  EXPECT_GT(circles, 100);
}

}  // namespace
}  // namespace talus::lem
