// SPDX-License-Identifier: MIT
// Published embankments on geosynthetics, tied-back walls and gabions, as njones61/xslope transcribes the verification
// manuals of Slide2 (VP: its number) and SLOPE/W. xslope's own factors, on the same surfaces, are held more closely.

#include "lem/search/search.hpp"
#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

constexpr double unlimited = 1e6;  ///< a bond that never governs

struct Expected {
  Method method;
  double published = 0, band = 0;
  double xslope = 0;  ///< 0: none
};

void expect_factors(const Slope& slope, const Surface& surface, const std::vector<Expected>& expected) {
  for (const Expected& e : expected) {
    const double factor = find_factor(slope, surface, e.method);
    EXPECT_NEAR(factor, e.published, e.band * e.published) << to_word(e.method);
    if (e.xslope > 0) {
      EXPECT_NEAR(factor, e.xslope, 0.003 * e.xslope) << to_word(e.method) << " of xslope";
    }
  }
}

/// A soil below a level, as the last region.
void add_layer(Section& section, const Soil& soil, double top) {
  section.soils.push_back(soil);
  const int number = static_cast<int>(section.soils.size()) - 1;
  section.regions.push_back(
      make_region_below(section, number, {{section.ground.front()[0], top}, {section.ground.back()[0], top}}));
}

void add_polygon(Section& section, const Soil& soil, std::vector<Point> polygon) {
  section.soils.push_back(soil);
  section.regions.push_back({static_cast<int>(section.soils.size()) - 1, std::move(polygon)});
}

/// A sheet with a loose head; its pull-out is by friction on both sides.
Bar make_sheet(const Point& head, const Point& end, double strength, double friction, bool is_active) {
  Bar bar;
  bar.head = head, bar.end = end;
  bar.tensile = strength;
  bar.bond_factor = 2 * std::tan(friction * degree);
  bar.is_active = is_active;
  return bar;
}

/// An active tieback of `length` at `dip` degrees below the horizontal, towards larger x.
Bar make_tieback(const Point& head, double length, double dip, double bonded, double tensile, double bond) {
  Bar bar;
  bar.head = head;
  bar.end = {head[0] + length * std::cos(dip * degree), head[1] - length * std::sin(dip * degree)};
  bar.free_length = length - bonded;
  bar.tensile = bar.plate = tensile;
  bar.bond = bond;
  bar.is_active = true;
  return bar;
}

// VP31: Borges and Cardoso (2002), case 2, with 1.15; SLOPE/W (its 2.18) has these factors on its circle.

TEST(LemSupportsWalls, EmbankmentOnClayWithAStrengthThatGrows) {
  Section section =
      make_section({{-30, 0}, {0, 0}, {6.15, 5}, {36.41, 5}, {42.56, 0}, {45, 0}}, make_soil(0, 35, 20), -21);
  add_layer(section, make_soil(33, 0, 17), 0);
  add_layer(section, make_soil(16, 0, 17), -1);
  Soil soil = make_soil(16, 0, 17);
  soil.cohesion_gradient = 0.96, soil.cohesion_level = -4.5;
  add_layer(section, soil, -4.5);
  soil.cohesion = 18.4, soil.cohesion_gradient = 1.314, soil.cohesion_level = -7;
  add_layer(section, soil, -7);
  section.bars = {make_sheet({1.23, 1}, {41.33, 1}, 200, 33.7, true)};
  const Slope slope(std::move(section));
  expect_factors(slope, make_circle(slope, {3.4655, 5.6642}, 13.2761),
                 {{Method::bishop, 1.170, 0.02, 1.155},
                  {Method::morgenstern_price, 1.171, 0.02, 1.153},
                  {Method::janbu, 1.233, 0.02, 0}});
}

// VP32: Borges and Cardoso (2002), case 3, an embankment of 7 and of 8.75 m. They have 1.25, 1.19 and 0.99.

Section make_two_fills(bool is_high) {
  const std::vector<Point> low{{-50, 4},   {-35.605, 4},  {-31.915, 7}, {-8.61, 7},
                               {-1.23, 1}, {-1.107, 0.9}, {0, 0},       {40, 0}},
      high{{-50, 4}, {-35.605, 4}, {-29.7625, 8.75}, {-10.7625, 8.75}, {-1.23, 1}, {0, 0}, {40, 0}};
  Section section = make_section(is_high ? high : low, make_soil(0, 35, 21.9), -24);
  section.soils.push_back(make_soil(0, 33, 17.2));
  section.regions.push_back(make_region_below(section, 1, {{-50, 1}, {-1.23, 1}, {0, 0}, {40, 0}}));
  const double tops[] = {0, -1, -3, -7, -18}, strengths[] = {43, 31, 30, 32, 32},
               weights[] = {18, 16.6, 13.5, 17, 17.5};
  for (int i = 0; i < 5; ++i) add_layer(section, make_soil(strengths[i], 0, weights[i]), tops[i]);
  section.bars = {make_sheet({-1.107, 0.9}, {-35.605, 0.9}, 200, 30.96, false)};
  return section;
}

TEST(LemSupportsWalls, EmbankmentsOnLayersOfClay) {
  const Slope low(make_two_fills(false)), high(make_two_fills(true));
  expect_factors(low, make_circle(low, {-4.8, 8}, 21.83),
                 {{Method::bishop, 1.23, 0.02, 1.218}, {Method::spencer, 1.23, 0.02, 1.218}});
  expect_factors(low, make_circle(low, {-3.8, 15}, 31.47),
                 {{Method::bishop, 1.22, 0.02, 1.216}, {Method::spencer, 1.22, 0.02, 1.216}});
  expect_factors(high, make_circle(high, {-4.8, 14}, 28.8),
                 {{Method::bishop, 0.98, 0.02, 0.981}, {Method::spencer, 0.98, 0.02, 0.981}});
}

// VP39: Tandjiria (2002), half an embankment of sand (dry crack) or clay (crack full of water) on clay, and the force
// of a sheet on the clay for which Slide2's factor by Spencer's method is 1.35.

Section make_half_embankment(bool is_sand, double force, double level) {
  Section section =
      make_section({{0, 9}, {10, 9}, {20, 3}, {30, 3}}, is_sand ? make_soil(0, 37, 17) : make_soil(20, 0, 19.4), 0);
  add_layer(section, make_soil(20, 0, is_sand ? 20 : 19.4), 3);
  section.crack = TensionCrack{2, is_sand ? 0.0 : 2.0, false};
  if (force > 0) {
    Bar bar;
    bar.head = {20 - std::max(0.0, level - 3) * 10 / 6, level}, bar.end = {0, level};
    bar.tensile = bar.plate = force;
    bar.bond = unlimited;
    bar.is_active = true;
    section.bars = {bar};
  }
  return section;
}

TEST(LemSupportsWalls, HalfEmbankmentsWithoutASheet) {
  SearchOptions options;
  options.methods = {Method::spencer};
  options.optimise_surface = false;
  options.slices = 100;
  for (const bool is_sand : {true, false}) {
    const double published = is_sand ? 1.209 : 0.975, xslope = is_sand ? 1.200 : 0.968;
    const Slope slope(make_half_embankment(is_sand, 0, 3));
    const SearchResult found = search(slope, options);
    ASSERT_EQ(found.circular.size(), 1u);
    EXPECT_NEAR(found.circular[0].solution.factor, published, 0.01 * published);
    EXPECT_NEAR(found.circular[0].solution.factor, xslope, 0.003 * xslope);
  }
}

TEST(LemSupportsWalls, HalfEmbankmentsWithTheForceFor135) {
  const auto expect = [](const Section& section, const Circle& circle, double xslope) {
    const Slope slope{Section(section)};
    expect_factors(slope, make_circle(slope, circle.centre, circle.radius), {{Method::spencer, 1.35, 0.02, xslope}});
  };
  const Circle in_sand{{15.080, 9.339}, 9.339}, in_clay{{14.967, 12.276}, 12.276};
  // The sheet lies on the border of sand and clay: the base that it crosses is in one or the other.
  expect(make_half_embankment(true, 44, 3.01), in_sand, 1.343);
  expect(make_half_embankment(true, 44, 2.99), in_sand, 0);
  expect(make_half_embankment(false, 169, 3), in_clay, 1.332);
}

// VP49: a tied-back wall with soldier piles of the manual of SNAILZ (1.52), on its wedge. The pile stands half a foot
// behind the wall, as in xslope, which takes its force across it.

TEST(LemSupportsWalls, TiedBackWallWithSoldierPiles) {
  Section section =
      make_section({{-20, 0}, {0, 0}, {0, 30}, {29, 51}, {33, 53}, {60, 66}, {70, 71}, {178, 80}, {195, 80}},
                   make_soil(300, 34, 130), -20, 62.4);
  add_polygon(section, make_soil(600, 24, 120), {{33, 53}, {195, 26}, {195, 80}, {178, 80}, {70, 71}, {60, 66}});
  section.bars = {make_tieback({0, 20}, 35, 25, 35, 120344.9 / 8, 13571.68 / 8),
                  make_tieback({0, 8}, 33, 25, 33, 164217.3 / 8, 13571.68 / 8)};
  Bar pile;
  const double top = 30 + 0.5 * 21 / 29;
  pile.head = {0.5, top}, pile.end = {0.5, top - 37};
  pile.hold = BarHold::across;
  pile.lateral = 5900;
  pile.is_active = true;
  section.bars.push_back(pile);
  const Surface wedge = make_polyline({{0, 0}, {37, 33.6}, {60.3636, 66.1818}});
  for (const BarDirection direction : {BarDirection::tangent, BarDirection::normal}) {
    section.bars.back().direction = direction;
    const bool is_across = direction == BarDirection::normal;
    expect_factors(Slope{Section(section)}, wedge,
                   {{Method::janbu, 1.446, 0.02, is_across ? 1.434 : 0},
                    {Method::janbu_corrected, 1.479, 0.02, is_across ? 1.469 : 0}});
  }
}

// VP58: a tied-back wall in eight layers (Pockoski and Duncan 2000, slope 4). UTEXAS4 has 1.14. The circle passes
// behind the upper tiebacks and crosses the lowest 3.5 ft before its end.

TEST(LemSupportsWalls, TiedBackWallInLayers) {
  Section section = make_section({{50, 69}, {200, 69}, {200, 113}, {350, 113}}, make_soil(0, 30, 120.4), 0, 62.4);
  add_layer(section, make_soil(0, 30, 114.7), 109);
  const double tops[] = {93, 86, 82.5, 69, 40, 24}, strengths[] = {900, 2485, 1670, 960, 1085, 1500},
               weights[] = {110.2, 117.8, 117.8, 117.8, 117.8, 147.1};
  for (int i = 0; i < 6; ++i) add_layer(section, make_soil(strengths[i], 0, weights[i]), tops[i]);
  section.water_table = {{50, 69}, {200, 69}, {200.001, 102.5}, {350, 102.5}};
  for (const double y : {104.0, 89.5, 75.0}) section.bars.push_back(make_tieback({200, y}, 88, 20, 40, 40000, 1000));
  const Slope slope(std::move(section));
  expect_factors(slope, make_circle(slope, {208.313, 148.638}, 124.638),
                 {{Method::bishop, 1.147, 0.01, 1.142},
                  {Method::spencer, 1.145, 0.01, 1.140},
                  {Method::fellenius, 1.129, 0.01, 1.119}});
}

// VP59: a tied-back wall in sand after drawdown (Pockoski and Duncan 2000, slope 5). u is γ_w times the depth below the
// water table and cos² of its slope, as in Slide2 (0.583) and xslope (0.566); SLOPE/W has 0.575. The line was read off
// a figure: 0.25 ft lower the factor is 0.582. With the whole depth an independent calculation has 0.310, as here.

TEST(LemSupportsWalls, TiedBackWallAfterDrawdown) {
  const std::vector<Point> table{{0, 16.6}, {8, 22.7}, {20, 27.1}, {40, 34.4}};
  Section section = make_section({{-50, -15}, {-10, 0}, {0, 0}, {0, 20}, {40, 35}}, make_soil(0, 30, 120), -30, 62.4);
  section.bars = {make_tieback({0, 9}, 31.7, 10, 22, 13750, 625)};
  const Point centre{-30.872, 31.315};
  const double radius = 43.975, end = 12.6068, crest = 20 + 0.375 * end;
  const double from = std::atan2(-centre[1], -centre[0]), to = std::atan2(crest - centre[1], end - centre[0]);
  std::vector<Point> arc{{0, 0}};
  for (int i = 1; i < 60; ++i) {
    const double angle = from + (to - from) * i / 60;
    arc.push_back({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)});
  }
  arc.push_back({end, crest});
  for (const bool is_reduced : {true, false}) {
    PressureGrid grid;
    for (std::size_t i = 0; i + 1 < table.size(); ++i) {
      const Point &a = table[i], &b = table[i + 1];
      const double slope = (b[1] - a[1]) / (b[0] - a[0]), weight = 62.4 / (is_reduced ? 1 + slope * slope : 1);
      const int first = static_cast<int>(grid.nodes.size());
      for (const Point& p : {a, b})
        for (const double depth : {0.0, 50.0}) {
          grid.nodes.push_back({p[0], p[1] - depth});
          grid.pressure.push_back(weight * depth);
        }
      grid.triangles.push_back({first, first + 1, first + 3});
      grid.triangles.push_back({first, first + 3, first + 2});
    }
    section.pressure_grid = grid;
    const double expected = is_reduced ? 0.566 : 0.310;
    EXPECT_NEAR(find_factor(Slope{Section(section)}, make_polyline(arc), Method::janbu), expected, 0.01 * expected);
  }
}

// VP110: an equivalent fluid pressure is a triangular load on the wall. Slide2 has one factor for both; its source
// gives neither soil nor geometry.

TEST(LemSupportsWalls, EquivalentFluidPressure) {
  const double weight = 7, height = 5;
  Section section = make_section({{0, 0}, {10, 0}, {10, height}, {30, height}}, make_soil(5, 30, 19), -6);
  Section as_liquid(section), as_load(section);
  as_liquid.slurries.push_back({0, 10, height, weight});
  const int strips = 20;
  for (int i = 0; i < strips; ++i) {
    const double low = height * i / strips, high = height * (i + 1) / strips;
    as_load.face_loads.push_back({10, low, high, {weight * (height - 0.5 * (low + high)), 0}});
  }
  const Surface arc = make_arc({6, 10}, std::sqrt(116.0), 10, 6 + std::sqrt(91.0));
  const Slope bare(std::move(section)), liquid(std::move(as_liquid)), load(std::move(as_load));
  EXPECT_GT(find_factor(liquid, arc, Method::janbu), 1.5 * find_factor(bare, arc, Method::janbu));
  EXPECT_NEAR(find_factor(liquid, arc, Method::janbu), find_factor(load, arc, Method::janbu), 1e-6);
  for (const Method method : {Method::bishop, Method::spencer})  // strips raise the resultant by 1/2400 of the height
    EXPECT_NEAR(find_factor(liquid, arc, method), find_factor(load, arc, method), 1e-3) << to_word(method);
}

// VP107: a wall of gabions (Cao et al. 2016), whose mesh is a cohesion or sheets between the courses; the circle passes
// below both.

TEST(LemSupportsWalls, BatteredGabions) {
  const auto place = [](double up, double across) {
    return Point{11.84 + up * 0.99 / 6 + across * 3.945 / 4, 94.342 + up * 5.918 / 6 - across * 0.66 / 4};
  };
  for (const bool has_sheets : {false, true}) {
    Section section = make_section({{0, 95.33}, place(1, 0), place(6, 0), place(6, 1), {16.85, 101.813}, {30, 101.813}},
                                   make_soil(0, 32, 21), 89);
    add_polygon(section, make_soil(0, 30, 20),
                {{0, 95.33}, place(1, 0), place(0, 0), place(0, 4), {30, 93.682}, {30, 80}, {0, 80}});
    add_polygon(section, make_soil(has_sheets ? 0 : 100, 45, 20),
                {place(0, 0), place(0, 4), place(1, 4), place(1, 3), place(3, 3), place(3, 2), place(5, 2), place(5, 1),
                 place(6, 1), place(6, 0)});
    section.water_table = {{0, 95.33}, {15.68, 95.33}, {30, 101}};
    section.surcharges.push_back({{{16.85, 12, 0}, {25.85, 12, 0}}});
    const double widths[] = {3, 3, 2, 2, 1};
    for (int k = 0; has_sheets && k < 5; ++k) {
      Bar bar;
      bar.head = place(k + 1, 0), bar.end = place(k + 1, widths[k]);
      bar.tensile = bar.plate = 71;
      bar.bond = unlimited;
      bar.is_active = true;
      bar.direction = BarDirection::tangent;
      section.bars.push_back(bar);
    }
    const Slope slope(std::move(section));
    expect_factors(slope, make_circle(slope, {11.203, 102.816}, 10.339),
                   {{Method::bishop, has_sheets ? 1.378 : 1.373, 0.01, 1.382},
                    {Method::spencer, has_sheets ? 1.392 : 1.386, 0.01, 1.398}});
  }
}

// VP108 and VP109: a wall of gabions with its steps outside, without and with joints of 6 cm between the courses.
// Slide2 has VP109 (1.799, 1.803) by a search along the joints; xslope has it on this circle.

TEST(LemSupportsWalls, SteppedGabions) {
  const auto place = [](double up, double from_back) {
    return Point{18.434 + up * 0.139 - from_back * 0.9905, 4.9 + up * 0.9905 + from_back * 0.139};
  };
  for (const bool has_joints : {false, true}) {
    Section section = make_section({{0, 5.456},
                                    place(0, 4),
                                    place(1, 4),
                                    place(1, 3),
                                    place(2, 3),
                                    place(2, 2),
                                    place(3, 2),
                                    place(3, 1),
                                    place(4, 1),
                                    {30, 9}},
                                   make_soil(5, 30, 21), 0);
    add_polygon(section, make_soil(0, 25, 20),
                {{0, 0}, {16.453, 5.178}, place(0, 0), place(1, 0), {30, 7}, {30, -10}, {0, -10}});
    add_polygon(section, make_soil(59.7, 42, 23),
                {place(0, 4), place(1, 4), place(1, 3), place(2, 3), place(2, 2), place(3, 2), place(3, 1), place(4, 1),
                 place(4, 0), place(0, 0)});
    for (int k = 1; has_joints && k < 4; ++k)
      add_polygon(section, make_soil(20.4, 37.8, 23),
                  {place(k, 4 - k), place(k, 0), place(k - 0.06, 0), place(k - 0.06, 4 - k)});
    const Slope slope(std::move(section));
    expect_factors(slope, make_circle(slope, {15.956, 10.016}, 5.722),
                   {{Method::bishop, has_joints ? 1.799 : 1.787, 0.01, 1.790},
                    {Method::spencer, has_joints ? 1.803 : 1.791, 0.01, 1.797}});
  }
}

}  // namespace
}  // namespace talus::lem
