// SPDX-License-Identifier: MIT
// Keys of [lem] that restrict the slip surfaces of a search: blocks, tangents, windows, areas, impenetrable soil, sides
// and sizes.

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "methods_slope.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"

namespace talus::input {
namespace {

/// The slope with a seam of clay below it, and a line.
const std::string seam = slices_alone + R"(
[[geometry.polygon]]
name = "seam"
points = [[0, 21], [90, 21], [90, 22], [0, 22]]

[[geometry.line]]
name = "plane"
points = [[0, 22], [90, 24]]
)";
const std::string soils =
    change(change(seam, "[regions]\n", "[regions]\nseam = \"clay\"\n"), "[materials.soil]",
           "[materials.clay]\nmodel = \"mohr_coulomb\"\nunit_weight = 19\ncohesion = 0\nfriction_angle = 10\n\n"
           "[materials.soil]");
const std::string block = soils + "[lem]\nsearch = \"block\"\n";
const std::string two_windows =
    "[[lem.block.window]]\nname = \"A\"\npoints = [[28, 22], [34, 22]]\n"
    "[[lem.block.window]]\nname = \"B\"\nbox = [[45, 21], [55, 24]]\n";

/// A window beside window B.
std::string with_window(const std::string& text) {
  return block + change(two_windows, "name = \"A\"\npoints = [[28, 22], [34, 22]]\n", text);
}

TEST(SlipSearch, ReadsBlocks) {
  const Case data = read(block + "[lem.block]\nactive = [50, 60]\npassive = [-10, 20]\nangles = 3\n" + two_windows);
  EXPECT_EQ(data.lem.search, SurfaceSearch::block);
  EXPECT_NEAR(data.lem.block.active[1], 60 * 0.017453292519943295, 1e-12);
  EXPECT_NEAR(data.lem.block.passive[0], -10 * 0.017453292519943295, 1e-12);
  ASSERT_EQ(data.lem.block.windows.size(), 2u);
  EXPECT_EQ(data.lem.block.windows[1].box[1], (std::array{55.0, 24.0}));
  for (const char* name : {"seam", "clay", "plane"})
    EXPECT_TRUE(find_faults(block + "[lem.block]\nalong = \"" + name + "\"\n").empty()) << name;
}

TEST(SlipSearch, BlocksNeedWindowsOrALayer) {
  expect_one_fault(block, "needs 'along', or 2 to 8 [[lem.block.window]]; there are 0");
  expect_one_fault(block + two_windows.substr(0, two_windows.find("[[lem", 2)), "there is 1");
  expect_one_fault(block + "[lem.block]\nalong = \"clay\"\n" + two_windows, "exclude each other");
  expect_one_fault(change(block, "[lem]\n", "[lem]\nmethods = [\"bishop\"]\n") + two_windows,
                   "none of 'methods' applies to them");
  expect_fault(block + "[lem.block]\nalong = @@\"seem\"\n", "no region, material or line 'seem'; did you mean 'seam'?");
  expect_fault(
      change(block, "[[0, 22], [90, 24]]", "[[0, 22], [50, 22], [40, 24]]") + "[lem.block]\nalong = @@\"plane\"\n",
      "line 'plane' turns back at point 3");
  expect_fault(block + two_windows + "[[lem.block.window]]\nname = @@\"A\"\npoints = [[60, 22]]\n",
               "there are two windows named 'A'");
}

TEST(SlipSearch, ALayerHasNoGaps) {
  const std::string broken =
      change(change(block, "points = [[0, 21], [90, 21], [90, 22], [0, 22]]",
                    "points = [[0, 21], [40, 21], [40, 22], [0, 22]]\n\n[[geometry.polygon]]\nname = \"seam2\"\n"
                    "points = [[50, 21], [90, 21], [90, 22], [50, 22]]"),
             "seam = \"clay\"\n", "seam = \"clay\"\nseam2 = \"clay\"\n");
  expect_fault(broken + "[lem.block]\nalong = @@\"clay\"\n", "layer 'clay' has a gap from x = 40 m to x = 50 m");
}

TEST(SlipSearch, WindowsLieInTheSection) {
  EXPECT_TRUE(find_faults(block + two_windows).empty());
  EXPECT_TRUE(find_faults(with_window("name = \"A\"\npoints = [[30, 22]]\n")).empty());
  expect_one_fault(with_window("name = \"A\"\n"), "window 'A' has no shape");
  expect_one_fault(with_window("name = \"A\"\npoints = [[30, 22]]\nbox = [[28, 21], [30, 23]]\n"),
                   "window 'A' has points and a box");
  expect_one_fault(with_window("name = \"A\"\nbox = [[28, 21], [28, 23]]\n"), "two opposite corners");
  expect_one_fault(with_window("name = \"A\"\npoints = [[-5, 22], [30, 22]]\n"),
                   "window 'A' reaches to x = -5 m, outside the section");
  expect_one_fault(with_window("name = \"A\"\npoints = [[20, 40], [30, 40]]\n"),
                   "window 'A' lies outside the soil of the section");
}

TEST(SlipSearch, InclinationsAreRanges) {
  expect_one_fault(change(block, "[lem]\n", "[lem]\nblock.active = [60, 45]\n") + two_windows,
                   "'active' goes from 60° to 45°; expected [from, to], the smaller inclination first");
  expect_one_fault(change(block, "[lem]\n", "[lem]\nblock.passive = [30]\n") + two_windows,
                   "'passive' has 1 angles; expected [from, to], two inclinations");
  expect_one_fault(change(block, "[lem]\n", "[lem]\nblock.active = [45, 95]\n") + two_windows, "at most 89");
  expect_one_fault(change(block, "[lem]\n", "[lem]\nblock.passive = [-70, 30]\n") + two_windows, "at least -60");
}

TEST(SlipSearch, TangentsNeedOneLevelOrLayer) {
  const std::string tangent = soils + "@@[lem.tangent]\n";
  expect_fault(tangent, "[lem.tangent] has neither 'levels' nor 'layer'; give one of them");
  expect_fault(tangent + "levels = [21]\nlayer = \"seam\"\n", "[lem.tangent] has 'levels' and 'layer'");
  const std::string levels = soils + "[lem.tangent]\nlevels = ";
  for (const char* sound : {"[21]", "[21, 23]"}) EXPECT_TRUE(find_faults(levels + sound + "\n").empty()) << sound;
  expect_fault(levels + "@@[23, 21]\n", "the lower level first");
  expect_fault(levels + "@@[2, 3]\n", "no soil lies at the 'levels'");
  expect_fault(soils + "[lem.tangent]\nlayer = @@\"clai\"\n", "no region, material or line 'clai'");
  expect_one_fault(soils + "[lem]\nsearch = \"block\"\n[lem.tangent]\nlevels = [21]\n" + two_windows,
                   "[lem.tangent] restricts circles, and search = \"block\" tries none");
}

TEST(SlipSearch, ExcludedAreasArePolygons) {
  const auto area = [](const std::string& points) {
    return soils + "[[lem.exclude]]\nname = \"cellar\"\npoints = @@" + points + "\n";
  };
  EXPECT_TRUE(find_faults(take_mark(area("[[60, 25], [70, 25], [70, 34]]")).text).empty());
  expect_fault(area("[[60, 25], [70, 25]]"), "'cellar' has 2 corners; a polygon has at least 3");
  expect_fault(area("[[60, 25], [70, 34], [70, 25], [60, 34]]"), "is no polygon: its sides 1 and 3 cross");
  expect_fault(area("[[60, 25], [70, 25], [65, 25]]"), "is no polygon: its sides");
  expect_fault(area("[[60, 25], [70, 25], [70, 34], [70, 25]]"), "is no polygon: its sides");
  expect_fault(area("[[60, 45], [70, 45], [70, 54]]"), "'cellar' lies outside the soil of the section");
  std::string many = "[[60, 25]";
  for (int i = 0; i < 1000; ++i) many += ", [" + std::to_string(61 + 1e-3 * i) + ", 26]";
  expect_one_fault(soils + "[[lem.exclude]]\nname = \"cellar\"\npoints = " + many + "]\n", "expected at most 1000");
}

TEST(SlipSearch, WindowsToPassAreLinesOrBoxes) {
  const std::string through = soils + "@@[[lem.through]]\nname = \"gap\"\n";
  EXPECT_TRUE(find_faults(take_mark(through + "box = [[45, 21], [55, 24]]\n").text).empty());
  expect_fault(soils + "[[lem.through]]\nname = \"gap\"\npoints = @@[[45, 21]]\n", "window 'gap' is a point");
  expect_fault(through + "box = [[45, 21], [95, 24]]\n", "window 'gap' reaches to x = 95 m");
}

TEST(SlipSearch, ImpenetrableSoilIsAMaterialOfTheCase) {
  EXPECT_TRUE(find_faults(soils + "[lem]\nimpenetrable = [\"clay\"]\n").empty());
  expect_fault(soils + "[lem]\nimpenetrable = [@@\"clai\"]\n", "there is no material 'clai'; did you mean 'clay'?");
  expect_fault(soils + "[lem]\nimpenetrable = @@[\"clay\", \"soil\"]\n", "all soil of the section is impenetrable");
}

TEST(SlipSearch, SidesAndSizesAgree) {
  const std::string slides = soils + "[lem]\nslides = @@\"left\"\n[lem.entry_exit]\n";
  EXPECT_TRUE(find_faults(take_mark(slides + "exit = [20, 32]\nentry = [50, 80]\n").text).empty());
  expect_fault(slides + "exit = [50, 80]\nentry = [20, 32]\n",
               "slides = \"left\", but the exits of [lem.entry_exit] lie right of the entries");
  expect_fault(soils + "[lem]\nsearch = \"grid\"\n[lem.entry_exit]\nexit = @@[20, 32]\n",
               "circles about a grid have no such ranges");
  expect_fault(soils + "[lem]\nsmallest_area = @@0\n", "above 0");
  expect_fault(soils + "[lem]\nsmallest_weight = @@-5\n", "above 0");
}

/// The picture has every window and area, the summary lists them, and the result states that they restrict it.
TEST(SlipSearch, IsShownAndStated) {
  std::filesystem::path folder = support::make_scratch("slip_search");
  const std::filesystem::path file = folder / "block.toml", picture = folder / "block.svg", out = folder / "out";
  std::ofstream(file) << change(block, "search =",
                                "methods = [\"spencer\"]\nreferee = false\nyield_acceleration = false\n"
                                "block.surfaces = 300\nsmallest_weight = 50\nslides = \"left\"\nsearch =")
                      << two_windows
                      << "[[lem.exclude]]\nname = \"cellar\"\npoints = [[60, 30], [70, 30], [70, 35], [60, 35]]\n"
                         "[[lem.through]]\nname = \"gap\"\nbox = [[38, 20.5], [42, 24]]\n";
  const support::Outcome checked =
      support::run_program("check '" + file.string() + "' --picture '" + picture.string() + "'");
  EXPECT_EQ(checked.code, 0) << checked.text;
  const std::string svg = support::read_text(picture);
  for (const char* part : {">A<", ">B<", ">cellar<", ">gap<", "LEM: polylines through windows", "slide to the left"})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  const support::Outcome ran = support::run_program("run '" + file.string() + "' --output '" + out.string() + "'");
  ASSERT_EQ(ran.code, 0) << ran.text;
  EXPECT_NE(ran.text.find("restricted by [lem.block], [[lem.exclude]], [[lem.through]], slides, smallest_weight"),
            std::string::npos)
      << ran.text;
  const nlohmann::json search = nlohmann::json::parse(support::read_text(out / "summary.json")).at("lem").at("search");
  EXPECT_EQ(search.at("kind"), "block");
  const nlohmann::json& restrictions = search.at("restrictions");
  EXPECT_EQ(restrictions.at("block").at("windows").size(), 2u);
  EXPECT_EQ(restrictions.at("excluded").at(0).at("name"), "cellar");
  EXPECT_TRUE(restrictions.at("through").at(0).at("is_box"));
  EXPECT_DOUBLE_EQ(restrictions.at("smallest_weight"), 50e3);
  EXPECT_TRUE(restrictions.at("slides_left"));
}

/// An error in an area is marked at its place.
TEST(SlipSearch, FaultsHaveTheirPlaces) {
  std::filesystem::path folder = support::make_scratch("slip_search_faults");
  const std::filesystem::path file = folder / "faulty.toml", picture = folder / "faulty.svg";
  std::ofstream(file) << soils
                      << "[[lem.exclude]]\nname = \"cellar\"\n"
                         "points = [[60, 25], [70, 34], [70, 25], [60, 34]]\n";
  const support::Outcome checked =
      support::run_program("check '" + file.string() + "' --picture '" + picture.string() + "'");
  EXPECT_EQ(checked.code, 2) << checked.text;
  const std::string svg = support::read_text(picture);
  EXPECT_NE(svg.find("data-number=\"1\" data-x=\"70\""), std::string::npos);
}

}  // namespace
}  // namespace talus::input
