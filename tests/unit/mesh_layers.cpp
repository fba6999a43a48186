// SPDX-License-Identifier: MIT
// Polygons of layered sections: areas by hand, and random boundaries against their integrals.
#include "mesh/layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/cover.hpp"
#include "support/draw.hpp"

namespace talus::mesh {
namespace {

using Kind = LayerNote::Kind;

constexpr double least = 0.01;  // smallest thickness [m]

std::vector<Kind> list_kinds(const LayeredSection& section) {
  std::vector<Kind> kinds;
  for (const LayerNote& note : section.notes) kinds.push_back(note.kind);
  return kinds;
}

double sum_areas(const LayeredSection& section) {
  double area = 0;
  for (const Polygon& polygon : section.polygons) area += std::abs(compute_area(polygon.points));
  return area;
}

TEST(Layers, ShareTheirCorners) {
  const LayeredSection section = make_layers({{0, 10}, {10, 10}, {20, 5}, {30, 5}},
                                             {{"fill", {{0, 8}, {30, 2}}, {}}, {"rock", {{0, 0}, {30, 0}}, {}}}, least);
  ASSERT_EQ(section.polygons.size(), 2u);
  EXPECT_TRUE(section.notes.empty());
  EXPECT_EQ(section.polygons[0].points, (Polyline{{0, 10}, {10, 10}, {20, 5}, {30, 5}, {30, 2}, {0, 8}}));
  EXPECT_EQ(section.polygons[1].points, (Polyline{{0, 8}, {30, 2}, {30, 0}, {0, 0}}));
}

TEST(Layers, EndWhereTheyCropOut) {
  // The boundary at y = 8 m meets the face, from (10, 10) to (20, 5), at x = 14 m.
  const LayeredSection section = make_layers({{0, 10}, {10, 10}, {20, 5}, {30, 5}},
                                             {{"fill", {{0, 8}, {30, 8}}, {}}, {"rock", {{0, 0}, {30, 0}}, {}}}, least);
  ASSERT_EQ(section.polygons.size(), 2u);
  EXPECT_EQ(list_kinds(section), std::vector{Kind::outcrop});
  EXPECT_DOUBLE_EQ(section.notes[0].size, 3);
  EXPECT_EQ(section.polygons[0].points, (Polyline{{0, 10}, {10, 10}, {14, 8}, {0, 8}}));
  EXPECT_EQ(section.polygons[1].points, (Polyline{{0, 8}, {14, 8}, {20, 5}, {30, 5}, {30, 0}, {0, 0}}));
}

TEST(Layers, EndAtAVerticalFace) {
  const LayeredSection section = make_layers({{0, 10}, {10, 10}, {10, 2}, {30, 2}},
                                             {{"fill", {{0, 6}, {30, 6}}, {}}, {"rock", {{0, 0}, {30, 0}}, {}}}, least);
  ASSERT_EQ(section.polygons.size(), 2u);
  EXPECT_EQ(section.polygons[0].points, (Polyline{{0, 10}, {10, 10}, {10, 6}, {0, 6}}));
  EXPECT_EQ(section.polygons[1].points, (Polyline{{0, 6}, {10, 6}, {10, 2}, {30, 2}, {30, 0}, {0, 0}}));
}

TEST(Layers, MayBeLenses) {
  // The clay ends at (20, 6) and (5, 6), on the boundary above: a lens of 15 · 2/2 m².
  const LayeredSection section = make_layers(
      {{0, 10}, {30, 10}},
      {{"fill", {{0, 6}, {30, 6}}, {}}, {"clay", {{5, 6}, {12, 4}, {20, 6}}, {}}, {"rock", {{0, 0}, {30, 0}}, {}}},
      least);
  ASSERT_EQ(section.polygons.size(), 3u);
  EXPECT_TRUE(section.notes.empty());
  EXPECT_EQ(section.polygons[1].points, (Polyline{{5, 6}, {20, 6}, {12, 4}}));
  EXPECT_DOUBLE_EQ(sum_areas(section), 300);
  EXPECT_EQ(section.polygons[0].points.size(), 6u) << "the soil above has the corners of the lens";
}

TEST(Layers, ThatPinchOutHaveSeveralParts) {
  const LayeredSection section = make_layers({{0, 10}, {30, 10}},
                                             {{"fill", {{0, 6}, {30, 6}}, {}},
                                              {"clay", {{0, 5}, {10, 7}, {20, 7}, {30, 5}}, {}, true},
                                              {"rock", {{0, 0}, {30, 0}}, {}}},
                                             least);
  ASSERT_EQ(section.polygons.size(), 4u);
  EXPECT_EQ(list_kinds(section), std::vector{Kind::cut});
  EXPECT_EQ(section.polygons[1].name, "clay");
  EXPECT_EQ(section.polygons[2].name, "clay (2)");
  EXPECT_EQ(section.polygons[1].points, (Polyline{{0, 6}, {5, 6}, {0, 5}}));
  EXPECT_EQ(section.layers, (std::vector{0, 1, 1, 2}));
}

TEST(Layers, ThatCrossAreAFaultUnlessOneCutsTheOther) {
  const Polyline ground{{0, 10}, {30, 10}}, base{{0, 0}, {30, 0}};
  const LayeredSection section = make_layers(
      ground, {{"fill", {{0, 6}, {30, 6}}, {}}, {"clay", {{0, 5}, {30, 8}}, {}}, {"rock", base, {}}}, least);
  ASSERT_EQ(list_kinds(section), std::vector{Kind::crossed});
  EXPECT_EQ(section.notes[0].layer, 1);
  EXPECT_DOUBLE_EQ(section.notes[0].to, 30);
  EXPECT_DOUBLE_EQ(section.notes[0].size, 2);
}

TEST(Layers, ThatAreTooThinAreRemoved) {
  // The boundaries are 4 mm apart on the left and 2 m on the right.
  const LayeredSection section = make_layers({{0, 10}, {30, 10}},
                                             {{"fill", {{0, 6}, {30, 6}}, {}},
                                              {"clay", {{0, 5.996}, {20, 5.996}, {30, 4}}, {}},
                                              {"rock", {{0, 0}, {30, 0}}, {}}},
                                             least);
  ASSERT_EQ(section.polygons.size(), 3u);
  EXPECT_EQ(list_kinds(section), std::vector{Kind::sliver});
  EXPECT_NEAR(section.notes[0].size, 0.004, 1e-12);
  EXPECT_EQ(section.polygons[1].points, (Polyline{{20, 6}, {30, 6}, {30, 4}}));
  const LayeredSection none = make_layers(
      {{0, 10}, {30, 10}}, {{"skin", {{0, 9.995}, {30, 9.995}}, {}}, {"rock", {{0, 0}, {30, 0}}, {}}}, least);
  EXPECT_EQ(none.polygons.size(), 1u);
  EXPECT_EQ(list_kinds(none), (std::vector{Kind::sliver, Kind::vanished}));
}

TEST(Layers, MayHaveAThickness) {
  const LayeredSection section = make_layers({{0, 10}, {10, 10}, {20, 5}, {30, 5}},
                                             {{"topsoil", {}, 0.5}, {"rock", {{0, 0}, {30, 0}}, {}}}, least);
  ASSERT_EQ(section.polygons.size(), 2u);
  EXPECT_DOUBLE_EQ(std::abs(compute_area(section.polygons[0].points)), 30 * 0.5);
}

TEST(Layers, AreExtendedAndTrimmedToTheGround) {
  const LayeredSection section =
      make_layers({{0, 10}, {30, 10}}, {{"fill", {{4, 6}, {20, 8}}, {}}, {"rock", {{-5, 0}, {35, 4}}, {}}}, least);
  EXPECT_EQ(list_kinds(section), (std::vector{Kind::extended, Kind::extended, Kind::trimmed}));
  EXPECT_EQ(section.polygons[0].points, (Polyline{{0, 10}, {30, 10}, {30, 8}, {20, 8}, {4, 6}, {0, 6}}));
  EXPECT_EQ(section.polygons[1].points.back(), (Point2{0, 0.5}));
}

/// Returns a line from left to right, with vertical steps; `fine`: with many short segments.
Polyline draw_line(support::Draw& draw, double level, bool fine) {
  Polyline line{{0, level + draw(-2, 2)}};
  while (line.back()[0] < 40) {
    const double step = draw(0, 1) < 0.2 ? 0 : fine ? draw(0.02, 0.3) : draw(0.5, 9);
    line.push_back({std::min(40.0, line.back()[0] + step), level + draw(-2, 2)});
  }
  return line;
}

TEST(Layers, CoverTheSectionOnceWhateverTheBoundaries) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    support::Draw draw(seed);
    const bool fine = seed % 70 == 0;
    const Polyline ground = draw_line(draw, 10, fine);
    std::vector<Layer> layers;
    for (const double level : {9.0, 7.5, 7.0, 4.0}) layers.push_back({"layer", draw_line(draw, level, fine), {}, true});
    if (seed % 3 == 0) layers[1].thickness = 0.7;
    layers.push_back({"base", {{0, 0}, {40, 0}}, {}, true});
    for (std::size_t i = 0; i < layers.size(); ++i) layers[i].name += std::to_string(i);
    const LayeredSection section = make_layers(ground, layers, least);
    Polyline whole = ground;
    whole.insert(whole.end(), {{40, 0}, {0, 0}});
    EXPECT_NEAR(sum_areas(section), std::abs(compute_area(whole)), 1e-9) << seed;
    Plan plan;
    plan.box_max = {40, 13};
    plan.polygons = section.polygons;
    const auto misfits = find_misfits(plan);
    EXPECT_TRUE(misfits.empty()) << seed << ": " << misfits.front().area;
    for (const Polygon& polygon : section.polygons)
      EXPECT_FALSE(find_self_contact(polygon.points, 1e-9)) << seed << ": " << polygon.name;
    // As a case is read.
    join_corners(plan);
    std::erase_if(plan.polygons, [](const Polygon& polygon) { return polygon.points.size() < 3; });
    for (const Misfit& misfit : find_misfits(plan)) {
      EXPECT_TRUE(fine) << seed << ": steep spikes closer than the tolerance";
      EXPECT_LT(misfit.area, 1e-6) << seed;
    }
    for (const Polygon& polygon : plan.polygons)
      for (std::size_t i = 0; i < polygon.points.size(); ++i)
        EXPECT_NE(polygon.points[i], polygon.points[(i + 1) % polygon.points.size()]) << seed;
  }
}

}  // namespace
}  // namespace talus::mesh
