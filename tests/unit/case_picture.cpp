// SPDX-License-Identifier: MIT
// The picture of a case: its elements, their places on the page, and texts of users.
#include "output/plots/case_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <sstream>

#include "output/plots/svg.hpp"

namespace talus::output {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

/// Returns the number behind `attribute="` in the first element that contains `mark`.
double read_attribute(const std::string& svg, const std::string& mark, const std::string& attribute) {
  const std::size_t at = svg.find(mark);
  const std::size_t value = at == std::string::npos ? at : svg.find(attribute + "=\"", at);
  if (value == std::string::npos) return NAN;
  return std::stod(svg.substr(value + attribute.size() + 2, 30));
}

/// A slope of two soils in a box of feet, with one of everything.
CasePicture make_slope() {
  CasePicture p;
  p.title = "Slope";
  p.soils = {{"upper", "sand", {{0, 5}, {44, 5}, {32, 5}, {12, 15}, {0, 15}}},
             {"lower", "clay", {{0, 0}, {44, 0}, {44, 5}, {0, 5}}}};
  p.box = {{0, 0}, {44, 0}, {44, 17}, {0, 17}};
  p.lines = {{"drain", {{2, 1}, {20, 1}}}};
  p.soil_sides = {{CasePicture::Point{0, 0}, CasePicture::Point{5, 5}}};
  p.ponds = {{{32, 5}, {30, 6}, {44, 6}, {44, 5}}};
  p.pond_levels = {{38, 6}};
  p.water_tables = {{"water table", {{0, 10}, {44, 5}}, false}};
  p.water_sides = {{WaterSideKind::rain, {{0, 15}, {12, 15}}, "crest: rain 20 mm/h"},
                   {WaterSideKind::seepage_face, {{12, 15}, {32, 5}}, "face: seepage face"}};
  p.supports = {{SupportKind::fixed, {{0, 0}, {44, 0}}, "", {0, -1}},
                {SupportKind::rollers, {{0, 0}, {0, 15}}, "", {-1, 0}}};
  p.loads = {{"road: 20 kPa", {{2, 15}, {8, 15}}, {{0, -20e3}, {0, -20e3}}}};
  p.shaking = {{"earthquake k_h = 0.1", {1, 0}}};
  p.roots = {{"crest: roots to 1 m", {{0, 15}, {12, 15}}, 1}};
  p.ranges = {{"entries", {{0, 15}, {10, 15}}, true}, {"exits", {{30, 6}, {32, 5}, {40, 5}}, false}};
  p.centres = CasePicture::CentreGrid{"5 × 4 centres", {20, 16}, {30, 24}, 5, 4, {0, 6}};
  p.zones = {{SearchZoneKind::window, "vertex", {{28, 6}}, false},
             {SearchZoneKind::passage, "gap", {{14, 8}, {14, 13}}, false},
             {SearchZoneKind::excluded, "cellar", {{4, 11}, {8, 11}, {8, 15}, {4, 15}}, true},
             {SearchZoneKind::tangent, "tangent to lower", {{0, 5}, {44, 5}}, false}};
  p.surfaces = {{"A", {{8, 15}, {20, 6}, {32, 5}}}};
  p.notes = {"FEM: elements of 1 m, 700 of them with soil."};
  p.messages = {{true, "error: line 3: first", CasePicture::Point{12, 15}},
                {false, "warning: line 9: second", CasePicture::Point{32, 5}},
                {false, "warning: without a place", std::nullopt}};
  return p;
}

TEST(CasePicture, EveryElementIsDrawn) {
  const std::string svg = write_case_picture(make_slope());
  for (const char* part : {"class=\"soil\" data-region=\"upper\" data-material=\"sand\"",
                           "class=\"soil\" data-region=\"lower\"",
                           "class=\"box\"",
                           "class=\"line\"",
                           "class=\"mesh\"",
                           "class=\"pond\"",
                           "class=\"level\"",
                           "class=\"water-table\"",
                           "class=\"hydraulic\"",
                           "class=\"support\"",
                           "class=\"load\"",
                           "class=\"earthquake\"",
                           "class=\"roots\"",
                           "class=\"range\"",
                           "class=\"centres\"",
                           "class=\"surface\"",
                           "class=\"search-zone\"",
                           ">cellar<",
                           ">window with a vertex of each slip surface<",
                           ">window that each slip surface passes<",
                           ">area without slip surfaces<",
                           ">tangent of each slip circle<",
                           ">crest: rain 20 mm/h<",
                           ">face: seepage face<",
                           ">road: 20 kPa<",
                           ">earthquake k_h = 0.1<",
                           ">crest: roots to 1 m<",
                           ">entries<",
                           ">exits<",
                           ">5 × 4 centres<",
                           ">A<",
                           ">upper: sand<",
                           ">lower: clay<",
                           ">sand: upper<",
                           ">clay: lower<",
                           ">free water<",
                           ">FEM: elements of 1 m, 700 of them with soil.<",
                           ">error: line 3: first<",
                           ">warning: without a place<",
                           ">x [m]<",
                           ">Slope<"})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  EXPECT_EQ(count(svg, "class=\"mark "), 2u) << "a message without a place has no mark";
  EXPECT_EQ(count(svg, "class=\"message "), 3u);
}

TEST(CasePicture, MarksStandAtTheirPlaces) {
  CasePicture picture = make_slope();
  const std::string svg = write_case_picture(picture);
  // The corner (12, 15) of the soil, and the mark of the message on it.
  std::istringstream points(svg.substr(svg.find("points=\"", svg.rfind('<', svg.find("class=\"soil\""))) + 8));
  std::vector<std::array<double, 2>> corners(5);
  char comma = 0;
  for (auto& c : corners) points >> c[0] >> comma >> c[1];
  const double scale = (corners[1][0] - corners[0][0]) / 44;
  EXPECT_NEAR((corners[0][1] - corners[4][1]) / 10, scale, 1e-2) << "true to scale";
  EXPECT_NEAR(read_attribute(svg, "data-number=\"1\" data-x", "cx"), corners[3][0], 0.02);
  EXPECT_NEAR(read_attribute(svg, "data-number=\"1\" data-x", "cy"), corners[3][1], 0.02);
  EXPECT_NEAR(read_attribute(svg, "data-number=\"2\" data-x", "cx"), corners[2][0], 0.02);
  EXPECT_EQ(read_attribute(svg, "class=\"mark error\"", "data-x"), 12);
  picture.length = {"ft", 0.3048};
  const std::string in_feet = write_case_picture(picture);
  EXPECT_NEAR(read_attribute(in_feet, "class=\"mark error\"", "data-x"), 39.370078740, 1e-6);
  EXPECT_NE(in_feet.find(">x [ft]<"), std::string::npos);
}

TEST(CasePicture, EverythingIsOnThePage) {
  CasePicture picture = make_slope();
  for (int i = 0; i < 40; ++i)
    picture.messages.push_back(
        {true, "error: " + std::string(400, 'w') + " many words after it", CasePicture::Point{44, 0}});
  picture.messages.push_back({true, "error: a point far away", CasePicture::Point{1e9, -1e12}});
  const std::string svg = write_case_picture(picture);
  const double width = read_attribute(svg, "<svg ", "width"), height = read_attribute(svg, "<svg ", "height");
  ASSERT_GT(width, 0);
  const std::regex circle("cx=\"([-0-9.]+)\" cy=\"([-0-9.]+)\""), text("<text x=\"([-0-9.]+)\" y=\"([-0-9.]+)\"");
  for (const std::regex& element : {circle, text})
    for (std::sregex_iterator it(svg.begin(), svg.end(), element), end; it != end; ++it) {
      const double x = std::stod((*it)[1]), y = std::stod((*it)[2]);
      EXPECT_TRUE(x >= 0 && x <= width && y >= 0 && y <= height) << it->str();
    }
}

TEST(CasePicture, TextsOfUsersAreEscaped) {
  CasePicture picture = make_slope();
  const std::string hostile = "</text><script>alert('x')</script>\"&\x1b[31m";
  picture.title = hostile;
  picture.soils[0].region = picture.soils[0].material = hostile;
  picture.lines[0].name = hostile;
  picture.loads[0].text = hostile;
  picture.notes = {hostile};
  picture.messages[0].text = hostile;
  const std::string svg = write_case_picture(picture);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find('\x1b'), std::string::npos);
  EXPECT_NE(svg.find("&lt;script&gt;alert(&#39;x&#39;)"), std::string::npos);
  EXPECT_EQ(count(svg, "<text "), count(svg, "</text>"));
}

TEST(CasePicture, ACaseThatCouldNotBeReadHasItsMessagesOnly) {
  CasePicture picture;
  picture.title = "broken.toml";
  picture.messages = {{true, "error: line 2: a key without a value", std::nullopt}};
  const std::string svg = write_case_picture(picture);
  EXPECT_NE(svg.find("No section could be read"), std::string::npos);
  EXPECT_NE(svg.find(">error: line 2: a key without a value<"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(SvgText, LongTextsAreWrappedAtBlanks) {
  EXPECT_EQ(wrap_text("one two three", 7), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrap_text("abcdefgh", 3), (std::vector<std::string>{"abc", "def", "gh"}));
  EXPECT_EQ(wrap_text("φφφφ ψ", 4), (std::vector<std::string>{"φφφφ", "ψ"}));
  EXPECT_EQ(shorten("φφφφφ", 3), "φφ…");
}

TEST(SvgText, LabelsTakeFreePlacesFirst) {
  LabelPlaces places({0, 0, 100, 100});
  places.occupy({0, 0, 50, 100});
  EXPECT_EQ(places.choose({{10, 10, 30, 20}, {60, 10, 80, 20}}, true), 1u);
  EXPECT_EQ(places.choose({{10, 10, 30, 20}, {60, 10, 80, 20}}, true), 2u) << "none is free";
  EXPECT_EQ(places.choose({{90, 90, 130, 100}, {60, 10, 90, 20}}, false), 1u) << "clipped labels are worse";
}

}  // namespace
}  // namespace talus::output
