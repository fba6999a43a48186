// SPDX-License-Identifier: MIT
// A chainage beside coordinates in plan: the section is as long as the chainage, or both lengths are named.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>

#include "base/error.hpp"
#include "drawing/survey.hpp"
#include "support/scratch.hpp"

namespace talus::drawing {
namespace {

using Table = std::vector<std::pair<std::string, std::vector<std::string>>>;  // columns: heading and cells

// Five points of a straight line, 120 m long: a slope of 30 m over 60 m.
const std::vector<std::string> chainages{"0", "30", "60", "90", "120"}, levels{"60", "60", "45", "30", "30"},
    eastings{"2600000.00", "2600009.00", "2600018.00", "2600027.00", "2600036.00"},
    northings{"1200000.00", "1199971.38", "1199942.76", "1199914.15", "1199885.53"};
const mesh::Polyline slope_of_120_m{{0, 60}, {30, 60}, {60, 45}, {90, 30}, {120, 30}};

std::string write_rows(const Table& table, bool is_reversed = false) {
  std::string text;
  for (std::size_t c = 0; c < table.size(); ++c) text += (c == 0 ? "" : ",") + table[c].first;
  text += "\n";
  const std::size_t rows = table.front().second.size();
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < table.size(); ++c)
      text += (c == 0 ? "" : ",") + table[c].second[is_reversed ? rows - 1 - r : r];
    text += "\n";
  }
  return text;
}

DrawnSection read_texts(const std::vector<std::string>& texts, SurveyOptions options = {}) {
  const auto folder = support::make_scratch("chainage");
  std::vector<std::string> files;
  for (const std::string& text : texts) {
    files.push_back(folder / ("t" + std::to_string(files.size()) + ".csv"));
    std::ofstream(files.back()) << text;
  }
  if (!options.base) options.base = -20;
  return read_survey(files, options);
}

std::string find_refusal(const std::string& text, const SurveyOptions& options = {}) {
  try {
    read_texts({text}, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool says(const DrawnSection& section, const std::string& part) {
  return std::any_of(section.remarks.begin(), section.remarks.end(),
                     [&](const std::string& r) { return r.find(part) != std::string::npos; });
}

void expect_line(const mesh::Polyline& found, const mesh::Polyline& right, double within, const std::string& what) {
  ASSERT_EQ(found.size(), right.size()) << what;
  for (std::size_t i = 0; i < right.size(); ++i) {
    EXPECT_NEAR(found[i][0], right[i][0], within) << what;
    EXPECT_NEAR(found[i][1], right[i][1], within) << what;
  }
}

TEST(SurveyChainage, GivesTheLengthInAnyOrderOfColumns) {
  Table table{{"Easting", eastings}, {"Northing", northings}, {"Chainage", chainages}, {"Level", levels}};
  std::sort(table.begin(), table.end());
  do {
    for (const bool is_reversed : {false, true}) {
      const DrawnSection section = read_texts({write_rows(table, is_reversed)});
      EXPECT_EQ(section.ground, slope_of_120_m) << write_rows(table, is_reversed);
      EXPECT_TRUE(
          says(section, "'Chainage' is the position along the section, which is 120 m long by it and 119.997 m by"));
    }
  } while (std::next_permutation(table.begin(), table.end()));
}

TEST(SurveyChainage, GivesTheLengthUnderAnyNameOfColumns) {
  constexpr std::array<std::array<const char*, 2>, 7> plans{{{"Easting", "Northing"},
                                                             {"X", "Y"},
                                                             {"East", "North"},
                                                             {"x_coord", "y_coord"},
                                                             {"X_UTM", "Y_UTM"},
                                                             {"LOCA_NATE", "LOCA_NATN"},
                                                             {"Rechtswert", "Hochwert"}}};
  for (const char* along :
       {"Chainage", "Station", "Distance", "dist", "Ch (m)", "Abstand", "Distance along", "Position"})
    for (const auto& [x, y] : plans)
      for (const char* level : {"Level", "Elevation [m]", "Z"}) {
        const std::string text = write_rows({{x, eastings}, {y, northings}, {along, chainages}, {level, levels}});
        EXPECT_EQ(read_texts({text}).ground, slope_of_120_m) << text;
      }
}

TEST(SurveyChainage, RunsAgainstTheCoordinates) {
  std::vector<std::string> turned(eastings.rbegin(), eastings.rend()),
      turned_north(northings.rbegin(), northings.rend());
  const std::string text =
      write_rows({{"Easting", turned}, {"Northing", turned_north}, {"Chainage", chainages}, {"Level", levels}});
  EXPECT_EQ(read_texts({text}).ground, slope_of_120_m);
}

TEST(SurveyChainage, FollowsASectionThatBends) {
  const std::string text = "chainage,x,y,z\n0,0,0,60\n30,30,0,60\n60,60,0,45\n90,60,30,30\n120,60,60,30\n";
  EXPECT_EQ(read_texts({text}).ground, slope_of_120_m);
}

TEST(SurveyChainage, KeepsUnitsOfEachColumn) {
  const std::vector<std::string> feet{"0", "98.4252", "196.8504", "295.2756", "393.7008"},
      high{"196.8504", "196.8504", "147.6378", "98.4252", "98.4252"};
  const Table stated{
      {"X (m)", eastings}, {"Y (m)", northings}, {"Distance (feet)", feet}, {"Ground Elevation (feet)", high}};
  expect_line(read_texts({write_rows(stated)}).ground, slope_of_120_m, 1e-4, "units in the headings");
  SurveyOptions in_feet;
  in_feet.unit = 0.3048, in_feet.is_unit_given = true;
  const Table assumed{{"X (m)", eastings}, {"Y (m)", northings}, {"Distance", feet}, {"Elevation", high}};
  expect_line(read_texts({write_rows(assumed)}, in_feet).ground, slope_of_120_m, 1e-4, "--units ft");
  const std::string refusal = find_refusal(write_rows(assumed));
  EXPECT_NE(refusal.find("393.701 m long by 'Distance' and 119.997 m by 'X (m)' and 'Y (m)'"), std::string::npos)
      << refusal;
  EXPECT_NE(refusal.find("the ratio is that of metres to feet"), std::string::npos) << refusal;
}

// Places every 30 m along the azimuth 162.5° from 46° N, 7° E, by geod and cs2cs of PROJ 9.1 on WGS 84.
TEST(SurveyChainage, IsComparedWithWebMapsAndDegreesOnTheGround) {
  const Table map{{"X", {"779236.436", "779249.399", "779262.363", "779275.327", "779288.291"}},
                  {"Y", {"5780349.220", "5780307.970", "5780266.720", "5780225.470", "5780184.221"}},
                  {"Distance", chainages},
                  {"Elevation", levels}};
  const DrawnSection section = read_texts({write_rows(map)});
  EXPECT_EQ(section.ground, slope_of_120_m) << "173 m on the map";
  EXPECT_TRUE(says(section, "120 m long by it and 120 m by 'X' and 'Y' on the ground, as coordinates of a web map"))
      << section.remarks[1];
  const Table degrees{{"X", {"7", "7.00011646", "7.00023291", "7.00034937", "7.00046582"}},
                      {"Y", {"46", "45.99974259", "45.99948518", "45.99922777", "45.99897036"}},
                      {"Distance", chainages},
                      {"Elevation", levels}};
  const DrawnSection sphere = read_texts({write_rows(degrees)});
  EXPECT_EQ(sphere.ground, slope_of_120_m);
  EXPECT_TRUE(says(sphere, "m by 'X' and 'Y' as longitude and latitude"));
  const Table named{
      {"lat", degrees[1].second}, {"lon", degrees[0].second}, {"Distance", chainages}, {"Elevation", levels}};
  EXPECT_EQ(read_texts({write_rows(named)}).ground, slope_of_120_m);
}

TEST(SurveyChainage, IsRefusedWithBothLengthsWhereCoordinatesDiffer) {
  const std::map<std::string, std::string> faults{
      // Coordinates 1.44 times as long as the distance, where a web map of their latitude has 1.21.
      {"X,Y,Distance (feet),Ground Elevation (feet)\n-13039680,4033348,0,200\n-13039680,4033304,100,200\n"
       "-13039680,4033260,200,150\n-13039680,4033216,300,100\n-13039680,4033172,400,100\n",
       "is 121.92 m long by 'Distance (feet)' and 176 m by 'X' and 'Y', and they may differ by 1 %"},
      {"Easting,Northing,Level,Station\n0,0,9,1\n60,0,7,1\n120,0,5,1\n", "is 0 m long by 'Station' and 120 m by"},
      {"pt,x,y,z,position\n1,0,0,9,1\n2,60,0,7,2\n3,120,0,5,3\n", "is 2 m long by 'position' and 120 m by"},
      // y is the level: x and the slope distance differ.
      {"x,y,distance\n0,40,0\n30,0,50\n60,0,80\n", "is 80 m long by 'distance' and 60 m by 'x'"},
      {"hole,chainage,easting,northing,elevation,top,bottom,soil\nA,0,0,0,9,0,2,clay\nB,120,0,150,9,0,2,clay\n",
       "is 120 m long by 'chainage' and 150 m by 'easting' and 'northing'"}};
  for (const auto& [text, fault] : faults)
    EXPECT_NE(find_refusal(text).find(fault), std::string::npos) << find_refusal(text);
  // A miss of 0.9 % agrees, 1.1 % does not.
  EXPECT_EQ(find_refusal("chainage,easting,northing,level\n0,0,0,9\n100,60.54,80.72,5\n"), "");
  EXPECT_NE(find_refusal("chainage,easting,northing,level\n0,0,0,9\n100,60.66,80.88,5\n"), "");
}

TEST(SurveyChainage, PlacesBoreholesBesideTheSection) {
  // The section runs along (0.6, 0.8); the boreholes stand 12 m to its right, 9 m to its left, on it, and 15 m right.
  const std::string head = "hole,chainage,easting,northing,elevation,top,bottom,soil\n", layer = "0,4,clay\n",
                    places = "A,0,509.6,192.8,60," + layer + "B,40,516.8,237.4,58," + layer + "C,80,548,264,50," +
                             layer + "D,120,584,287,44," + layer;
  const mesh::Polyline right{{0, 60}, {40, 58}, {80, 50}, {120, 44}};
  const DrawnSection section = read_texts({head + places});
  EXPECT_EQ(section.ground, right);
  EXPECT_TRUE(says(section, "120 m long by it and 120 m by"));
  const std::string collars =
                        "hole,easting,northing,chainage,elevation\nA,509.6,192.8,0,60\nB,516.8,237.4,40,58\n"
                        "C,548,264,80,50\nD,584,287,120,44\n",
                    layers = "hole,from,to,soil\nA,0,4,clay\nB,0,4,clay\nC,0,4,clay\nD,0,4,clay\n";
  EXPECT_EQ(read_texts({collars, layers}).ground, right) << "positions and layers in two tables";
  const DrawnSection columns =
      read_texts({"hole,chainage,easting,northing,lat,lon,offset,elevation,clay\nA,0,509.6,192.8,46,7,12,60,4\n"
                  "B,40,516.8,237.4,46,7,-9,58,4\nC,80,548,264,46,7,0,50,4\nD,120,584,287,46,7,15,44,4\n"});
  EXPECT_EQ(columns.ground, right);
  ASSERT_EQ(columns.layers.size(), 2u) << "neither coordinates nor offsets are depths";
  EXPECT_EQ(columns.layers[0].name, "clay");
  // The borehole E of another section has no part in the comparison.
  SurveyOptions chosen;
  chosen.boreholes = {"A", "B", "C", "D"};
  EXPECT_EQ(read_texts({head + places + "E,300,900,900,40," + layer}, chosen).ground, right);
  EXPECT_NE(find_refusal(head + places + "E,300,900,900,40," + layer), "");
  EXPECT_NE(find_refusal("chainage,x,y,z\n0,0,0,9\n60,0,90,5\n", chosen), "") << "a line has no name of a borehole";
}

TEST(SurveyChainage, IsNotNeededBesideCoordinatesOfOneKind) {
  // Local x and y, eastings and northings, and the distances of the points from the section.
  const std::string text = write_rows({{"X", chainages},
                                       {"Y", levels},
                                       {"Offset", levels},
                                       {"Northing", northings},
                                       {"Easting", eastings},
                                       {"Z", levels}});
  expect_line(read_texts({text}).ground, slope_of_120_m, 0.01, "easting with northing");
}

TEST(SurveyChainage, IsReadFromStations) {
  const mesh::Polyline right{{0, 10}, {12.5, 10.25}, {1045, 2}};
  expect_line(read_texts({"Chainage,RL (mAHD)\n0+000,10\n0+012.5,10.25\n1+045,2\n"}).ground, right, 1e-12, "metres");
  expect_line(read_texts({"Station [ft],Level [ft]\n0+00,30\n12+50.5,20\n"}).ground,
              {{0, 30 * 0.3048}, {1250.5 * 0.3048, 20 * 0.3048}}, 1e-9, "feet");
  EXPECT_TRUE(says(read_texts({"Chainage,Level\n0+000,10\n0+1,9\n0+020,9\n"}), "'0+1' is not a station"));
}

TEST(SurveyChainage, ABaseLiesBelowAllLines) {
  SurveyOptions options;
  for (const double base : {50.0, 2.0, 1e308}) {
    options.base = base;
    EXPECT_NE(find_refusal("x,y\n0,10\n30,2\n", options).find("the base is below it"), std::string::npos) << base;
  }
}

}  // namespace
}  // namespace talus::drawing
