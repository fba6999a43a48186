// SPDX-License-Identifier: MIT
// Sections by layers: reading, faults, and the same case as one of polygons.

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "input/echo.hpp"
#include "slope.hpp"
#include "support/scratch.hpp"

namespace talus::input {
namespace {

/// A slope of two layers; `layers` replaces the second one.
std::string write_layers(const std::string& geometry) {
  return geometry + R"(
[regions]
fill = "sand"
clay = "sand"

[materials.sand]
model = "mohr_coulomb"
unit_weight = 19
cohesion = 5
friction_angle = 30

[analysis]
methods = ["lem"]
)";
}

const std::string layered = R"([geometry]
ground = [[0, 15], [12, 15], [32, 5], [44, 5]]

[[geometry.layer]]
name = "fill"
bottom = [[0, 9], [44, 3]]

[[geometry.layer]]
name = "clay"
level = 0
)";

std::string fault_of(const std::string& text) {
  const auto faults = find_faults(text);
  EXPECT_LE(faults.size(), 1u);
  return faults.empty() ? "" : faults[0].sentence;
}

TEST(Layers, GiveTheCaseOfTheirPolygons) {
  const LoadedCase layers = read_case_text(write_layers(layered), "slope.toml");
  const LoadedCase polygons = read_case_text(write_layers(R"([[geometry.polygon]]
name = "fill"
points = [[0, 15], [12, 15], [32, 5], [44, 5], [44, 3], [0, 9]]
[[geometry.polygon]]
name = "clay"
points = [[0, 9], [44, 3], [44, 0], [0, 0]]
)"),
                                             "slope.toml");
  ASSERT_EQ(layers.data.mesh.polygons.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(layers.data.mesh.polygons[i].points, polygons.data.mesh.polygons[i].points);
  EXPECT_EQ(write_calculated(layers.echo), write_calculated(polygons.echo));
}

TEST(Layers, MayBeGivenByBoreholes) {
  const auto level = [](const std::string& keys) {
    const LoadedCase loaded =
        read_case_text(write_layers(change(layered, "bottom = [[0, 9], [44, 3]]", keys)), "slope.toml");
    double least = 15;
    for (const auto& p : loaded.data.mesh.polygons[0].points) least = std::min(least, p[1]);
    return least;
  };
  // Below the ground at y = 15 and 5 m, and as deep beyond the last borehole.
  EXPECT_DOUBLE_EQ(level("depths = [[4, 3], [40, 3.5]]"), 1.5);
  EXPECT_DOUBLE_EQ(level("depths = [[12, 3]]"), 2);
  // The smooth curve does not overshoot its lowest borehole.
  EXPECT_DOUBLE_EQ(level("depths = [[2, 3], [10, 3], [34, 4], [40, 3]]\nbetween = \"spline\""), 1);
}

TEST(Layers, HaveFaultsInOneSentence) {
  const auto fails = [](const std::string& old_part, const std::string& new_part, const std::string& sentence) {
    expect_fault(write_layers(change(layered, old_part, new_part)), sentence);
  };
  const std::string bottom = "bottom = [[0, 9], [44, 3]]";
  fails("[32, 5], [44, 5]]", "@@[8, 5], [44, 5]]", "the ground folds back from x = 12 m to x = 8 m");
  fails(bottom, "bottom = [[20, 9], @@[10, 3]]", "the lower boundary of layer 'fill' folds back");
  fails(bottom, "bottom = @@[[20, 9]]", "the lower boundary of layer 'fill' has 1 point; it needs at least 2");
  fails(bottom, "depths = [[4, 3], @@[50, 2]]", "the borehole at x = 50 m of layer 'fill' is outside the ground");
  fails(bottom, "depths = [[4, 3], @@[14, -2]]", "has a negative depth");
  fails(bottom, "depths = [[4, 3], @@[4, 2]]", "two boreholes at x = 4 m");
  fails(bottom, "bottom = { file = @@7 }", "a text in quotation marks");
  fails(bottom, "bottom = @@{ file = \"a.csv\", x = \"x\" }", "the columns 'x' and 'y' together or not at all");
  fails(bottom, "bottom = @@{ file = \"absent.csv\" }", "there is no table 'absent.csv'");
  fails(bottom, bottom + "\nbetween = @@\"spline\"", "'between' has no meaning without 'depths'");
  fails("ground = [[0, 15], [12, 15], [32, 5], [44, 5]]\n\n[[geometry.layer]]", "\n@@[[geometry.layer]]",
        "needs 'ground' in [geometry]");
  EXPECT_NE(fault_of(write_layers(change(layered, bottom, ""))).find("layer 'fill' has no lower boundary"),
            std::string::npos);
  EXPECT_NE(
      fault_of(write_layers(change(layered, bottom, bottom + "\nlevel = 3"))).find("has both 'bottom' and 'level'"),
      std::string::npos);
  EXPECT_EQ(fault_of(write_layers(change(layered, "level = 0", "level = 4"))),
            "the lower boundary of layer 'clay' is above the one of the layer above from x = 36.66667 m to x = 44 m, "
            "by up to 1 "
            "m: correct it, or write cut = true where the boundary above cuts it");
}

TEST(Layers, AreLimitedInNumberOfPoints) {
  std::string fine = "bottom = [[0, 9]";
  for (int i = 1; i < 5000; ++i) fine += fmt::format(", [{}, 8]", 0.005 * i);
  EXPECT_EQ(fault_of(write_layers(change(layered, "bottom = [[0, 9], [44, 3]]", fine + "]"))),
            "the ground and the boundaries have 5004 points, and a section has at most 5000");
}

TEST(Layers, ThatAreCutOrEndAreWarnings) {
  const LoadedCase cut =
      read_case_text(write_layers(change(layered, "level = 0", "level = 4\ncut = true")), "slope.toml");
  ASSERT_EQ(cut.warnings.size(), 1u);
  EXPECT_NE(cut.warnings[0].sentence.find("is cut by the one above"), std::string::npos);
  EXPECT_EQ(cut.warnings[0].line, 8);
  const LoadedCase ends = read_case_text(write_layers(change(layered, "[44, 3]]", "[30, 3]]")), "slope.toml");
  ASSERT_EQ(ends.warnings.size(), 1u);
  EXPECT_NE(ends.warnings[0].sentence.find("ends inside the section and continues level from x = 30 m to x = 44 m"),
            std::string::npos);
}

/// A case beside tables, in a folder of its own.
TEST(Layers, MayBeRead) {
  const std::filesystem::path folder = support::make_scratch("layers");
  const auto read = [&](const std::string& table, const std::string& source) {
    std::ofstream(folder / "line.csv") << table;
    const std::string text = write_layers(change(layered, "bottom = [[0, 9], [44, 3]]", source));
    return read_case_text(text, (folder / "slope.toml").string()).data.mesh.polygons[0].points.back();
  };
  const std::string file = "bottom = { file = \"line.csv\" }";
  const std::array<double, 2> end{0, 9};
  EXPECT_EQ(read("x,y\n0,9\n44,3\n", file), end);
  EXPECT_EQ(read("0 9\n44 3\n", file), end) << "blanks, no header";
  EXPECT_EQ(read("  0.0\t9.0\r\n44.0\t3.0\r\n", file), end) << "tabs";
  EXPECT_EQ(read("# survey\nx;y\n0,0;9,0\n44,0;3,0\n", file), end) << "decimal commas";
  EXPECT_EQ(read("y [mm],x [cm]\n9000,0\n3000,4400\n", "bottom = { file = \"line.csv\", x = \"x\", y = \"y\" }"), end);
  EXPECT_EQ(read("x,fill,clay\n0,6,10\n30,,2\n44,2,3\n", "depths = { file = \"line.csv\", x = \"x\", y = \"fill\" }"),
            end)
      << "the second borehole ends above";
}

}  // namespace
}  // namespace talus::input
