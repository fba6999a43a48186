// SPDX-License-Identifier: MIT
// The section that a drawing shows.
#include "drawing/section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace talus::drawing {
namespace {

using mesh::Polyline;

DrawnLine draw(const std::string& layer, Polyline points, bool closed = false) {
  return {layer, "LINE", "1A", closed, std::move(points)};
}

bool has_remark(const DrawnSection& section, const std::string& part) {
  return std::any_of(section.remarks.begin(), section.remarks.end(),
                     [&](const std::string& r) { return r.find(part) != std::string::npos; });
}

std::string find_fault(const Drawing& drawing, const SectionOptions& options = {}) {
  try {
    find_section(drawing, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(DrawnSection, JoinsSegmentsAndSortsLinesFromTheTop) {
  Drawing drawing;
  drawing.lines = {draw("rock", {{44, 0}, {0, 0}}), draw("clay", {{44, 3}, {0, 9}}), draw("G", {{32, 5}, {12, 15}}),
                   draw("G", {{32, 5}, {44, 5}}), draw("G", {{0, 15}, {12, 15}})};
  const DrawnSection section = find_section(drawing, {});
  EXPECT_EQ(section.ground, (Polyline{{0, 15}, {12, 15}, {32, 5}, {44, 5}}));
  ASSERT_EQ(section.layers.size(), 2u);
  EXPECT_EQ(section.layers[0].name, "clay");
  EXPECT_EQ(section.layers[0].points, (Polyline{{0, 9}, {44, 3}}));
  EXPECT_EQ(section.layers[1].name, "rock");
}

TEST(DrawnSection, KnowsGroundAndWaterByTheirNames) {
  Drawing drawing;
  drawing.lines = {draw("Groundwater", {{0, 8}, {44, 5}}), draw("GROUND", {{0, 10}, {44, 10}}),
                   draw("frame", {{0, 20}, {44, 20}}), draw("base", {{0, 0}, {44, 0}})};
  const DrawnSection section = find_section(drawing, {0.5, {}, {}, {"Groundwater", "GROUND", "base"}});
  EXPECT_EQ(section.water_table, (Polyline{{0, 4}, {22, 2.5}}));
  EXPECT_EQ(section.ground, (Polyline{{0, 5}, {22, 5}})) << "in metres";
  ASSERT_EQ(section.layers.size(), 1u);
}

TEST(DrawnSection, LeavesResultsOut) {
  Drawing drawing;
  drawing.lines = {draw("clay", {{0, 0}, {44, 0}, {44, 10}, {0, 10}}, true),
                   draw(ground_layer, {{0, 10}, {44, 10}}),
                   draw(water_layer, {{0, 8}, {44, 5}}),
                   draw(pond_layer, {{30, 11}, {44, 11}}),
                   draw(support_layer, {{20, 10}, {12, 8}}),
                   draw("slip_lem_spencer_1.434", {{5, 10}, {20, 5}, {30, 10}}),
                   draw("slip_zone", {{10, 4}, {20, 4}, {20, 6}, {10, 6}}, true)};
  const DrawnSection section = find_section(drawing, {});
  EXPECT_TRUE(section.ground.empty());
  ASSERT_EQ(section.regions.size(), 2u);
  EXPECT_EQ(section.regions[1].name, "slip_zone") << "a soil of this name is no result";
  EXPECT_EQ(section.water_table, (Polyline{{0, 8}, {44, 5}}));
  EXPECT_TRUE(has_remark(section, "3 slip surfaces, supports and ponds"));
}

TEST(DrawnSection, TakesAnOutlineWithLinesInIt) {
  Drawing drawing;
  drawing.lines = {draw("EXTERNAL", {{0, 0}, {44, 0}, {44, 5}, {32, 5}, {12, 15}, {0, 15}}, true),
                   draw("MATERIAL", {{0, 9}, {44, 3}})};
  const DrawnSection section = find_section(drawing, {});
  EXPECT_EQ(section.ground, (Polyline{{0, 15}, {12, 15}, {32, 5}, {44, 5}}));
  ASSERT_EQ(section.layers.size(), 2u);
  EXPECT_EQ(section.layers[1].points, (Polyline{{0, 0}, {44, 0}}));
  const DrawnSection tops = find_section(drawing, {1, LineRole::tops, {}, {}});
  EXPECT_EQ(tops.layers[0].name, "EXTERNAL");
  EXPECT_EQ(tops.layers[1].name, "MATERIAL");
}

TEST(DrawnSection, MayHaveABaseBelowItsLines) {
  Drawing drawing;
  drawing.lines = {draw("GROUND", {{0, 10}, {44, 10}}), draw("CLAY_TOP", {{0, 5}, {44, 5}})};
  const DrawnSection section = find_section(drawing, {1, LineRole::tops, -2, {}});
  ASSERT_EQ(section.layers.size(), 2u);
  EXPECT_EQ(section.layers[0].name, "GROUND");
  EXPECT_EQ(section.layers[1].name, "CLAY_TOP");
  EXPECT_EQ(section.layers[1].points, (Polyline{{0, -2}, {44, -2}}));
}

TEST(DrawnSection, NamesRegionsAfterTheTextsInThem) {
  Drawing drawing;
  drawing.lines = {draw("soil", {{0, 0}, {10, 0}, {10, 5}, {0, 5}}, true),
                   draw("soil", {{0, 5}, {10, 5}, {10, 8}, {0, 8}}, true),
                   draw("soil", {{10, 0}, {20, 0}}),
                   draw("soil", {{20, 0}, {20, 5}}),
                   draw("soil", {{20, 5}, {10, 5}}),
                   draw("soil", {{10, 5}, {10, 0}})};
  drawing.texts = {{"labels", "clay no. 2", {5, 2}}, {"labels", "title", {50, 50}}};
  const DrawnSection section = find_section(drawing, {});
  ASSERT_EQ(section.regions.size(), 3u) << "four segments are a region too";
  EXPECT_EQ(section.regions[0].name, "clay no_ 2");
  EXPECT_EQ(section.regions[1].name, "soil");
  EXPECT_EQ(section.regions[2].name, "soil 2");
  EXPECT_TRUE(has_remark(section, "1 text was not used"));
}

TEST(DrawnSection, ListsWhatItDoesNotUse) {
  Drawing drawing;
  drawing.lines = {draw("a", {{0, 10}, {44, 10}}), draw("b", {{0, 0}, {44, 0}}), draw("c", {{5, 0}, {5, 3}}),
                   draw("d", {{5, 1}, {9, 1}, {7, 2}, {12, 2}}), draw("e", {{5, 5}, {5, 5}})};
  const DrawnSection section = find_section(drawing, {});
  EXPECT_TRUE(has_remark(section, "the line 1A on layer 'c' is vertical"));
  EXPECT_TRUE(has_remark(section, "the line 1A on layer 'd' folds back at x = 7 m"));
  EXPECT_TRUE(has_remark(section, "the line 1A on layer 'e' is shorter than"));
}

TEST(DrawnSection, ThinsOutFineLines) {
  Drawing drawing;
  Polyline fine;
  for (int i = 0; i <= 20000; ++i) fine.push_back({0.005 * i, 20 + std::sin(0.0005 * i)});
  drawing.lines = {draw("ground", fine), draw("base", {{0, 0}, {100, 0}})};
  const DrawnSection section = find_section(drawing, {});
  EXPECT_LT(section.ground.size(), 2000u);
  EXPECT_TRUE(has_remark(section, "points were left out"));
  for (const auto& p : section.ground)
    EXPECT_NEAR(p[1], 20 + std::sin(0.1 * p[0]), 1e-9) << "corners are points of the line";
}

TEST(DrawnSection, IsRefusedWhereThinningWouldChangeIt) {
  Drawing drawing;
  Polyline rough;
  for (int i = 0; i <= 5000; ++i) rough.push_back({0.02 * i, i % 2 == 0 ? 20.0 : 21.0});
  drawing.lines = {draw("ground", rough), draw("base", {{0, 0}, {100, 0}})};
  EXPECT_NE(find_fault(drawing).find("the drawing has 5003 points, and a section at most 2000"), std::string::npos);
}

TEST(DrawnSection, HasFaultsInOneSentence) {
  Drawing drawing;
  EXPECT_EQ(find_fault(drawing), "the drawing has no lines");
  drawing.lines = {draw("a", {{0, 10}, {44, 10}})};
  EXPECT_NE(find_fault(drawing).find("the drawing shows no section"), std::string::npos);
  EXPECT_EQ(find_fault(drawing, {1, {}, {}, {"b"}}), "the drawing has no lines on a layer 'b'");
  drawing.lines.push_back(draw("b", {{0, 0}, {44, 0}}));
  EXPECT_NE(find_fault(drawing, {1, LineRole::tops, {}, {}}).find("the section needs a base"), std::string::npos);
  drawing.lines[1].layer = "CLAY_TOP";
  EXPECT_NE(find_fault(drawing).find("layer 'CLAY_TOP' of the drawing is named after a top"), std::string::npos);
  drawing.lines[0].points[0][0] = std::nan("");
  EXPECT_NE(find_fault(drawing).find("the drawing shows no section"), std::string::npos);
  drawing.lines = {draw("a", {{3, 3}, {3, 3}})};
  EXPECT_EQ(find_fault(drawing), "the drawing has no extent");
}

TEST(DrawnSection, IsACaseWithoutStrengths) {
  Drawing drawing;
  drawing.lines = {draw("ground", {{0, 10}, {44, 10}}), draw("cl\"ay", {{0, 0}, {44, 0}})};
  const std::string text = write_case(find_section(drawing, {}), "a\nb.dxf");
  EXPECT_EQ(text.rfind("# Section from a_b.dxf.", 0), 0u) << "a name of a file ends no comment";
  EXPECT_NE(text.find("ground = [[0, 10], [44, 10]]"), std::string::npos);
  EXPECT_NE(text.find("[materials.\"cl_ay\"]"), std::string::npos);
}

}  // namespace
}  // namespace talus::drawing
