// SPDX-License-Identifier: MIT
// `talus check --picture`: the picture of a case, with messages at their places, by the program.

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "methods_slope.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"

namespace talus::input {
namespace {

using support::Outcome;
using support::read_text;
using support::run_program;

struct Drawn {
  Outcome outcome;
  std::string svg;
};

/// Checks a case with a picture.
Drawn draw(const std::string& name, const std::string& text, const std::string& options = "") {
  const std::filesystem::path file = support::name_scratch(name + ".toml"),
                              picture = support::name_scratch(name + ".svg");
  std::ofstream(file) << text;
  std::filesystem::remove(picture);
  const Outcome outcome =
      run_program(fmt::format("check '{}' --picture '{}' {}", file.string(), picture.string(), options));
  return {outcome, read_text(picture)};
}

/// Returns the text of a message in the list below the section.
std::string read_message(const std::string& svg, int number) {
  const std::size_t begin = svg.find(fmt::format("\" data-number=\"{}\">\n", number), svg.find("class=\"messages\""));
  std::string text;
  std::size_t end = svg.find("</g>", begin);
  for (std::size_t at = begin; (at = svg.find("<text", at)) < end;) {
    at = svg.find('>', at) + 1;
    text += svg.substr(at, svg.find('<', at) - at) + " ";
  }
  return text;
}

/// Expects a message with these words, whose mark stands at (x, y).
void expect_mark(const std::string& svg, const std::string& words, double x, double y, double tolerance = 1e-6) {
  for (int number = 1; number < 20; ++number) {
    if (read_message(svg, number).find(words) == std::string::npos) continue;
    const std::size_t at = svg.find(fmt::format("data-number=\"{}\" data-x=\"", number));
    ASSERT_NE(at, std::string::npos) << words << " has no mark";
    std::array<double, 2> place{};
    for (std::size_t d = 0; d < 2; ++d) {
      const char* key = d == 0 ? "data-x=\"" : "data-y=\"";
      place[d] = std::stod(svg.substr(svg.find(key, at) + 8, 30));
    }
    EXPECT_NEAR(place[0], x, tolerance) << words;
    EXPECT_NEAR(place[1], y, tolerance) << words;
    return;
  }
  FAIL() << "no message with: " << words;
}

TEST(CheckPicture, DrawsACaseOfAllMethods) {
  const Drawn drawn = draw("good", all_three);
  EXPECT_EQ(drawn.outcome.code, 0) << drawn.outcome.text;
  EXPECT_TRUE(drawn.outcome.text.ends_with("good.svg\n")) << drawn.outcome.text;
  for (const char* part : {"data-region=\"soil\" data-material=\"sand\"", "class=\"box\"", "class=\"mesh\"",
                           "class=\"support\"", "class=\"range\"", "MPM: elements of 0.75 m, ", " material points."})
    EXPECT_NE(drawn.svg.find(part), std::string::npos) << part;
  EXPECT_EQ(drawn.svg.find("class=\"mark "), std::string::npos);
  EXPECT_EQ(drawn.svg.find("nan"), std::string::npos);
}

TEST(CheckPicture, MarksErrorsAtTheirPlaces) {
  std::string text = change(slices_alone, "[30, 25], [0, 25]]", "[30, 25], [30, 25], [0, 25]]");
  text = change(text, "cohesion = 3\n", "");
  text += R"(
[initial]
pore_pressure = "water_table"
water_table = [[0, 24], [60, 30], [50, 28]]
[[hydraulic]]
on = "top"
condition = "total_head"
[[geometry.line]]
name = "toe"
points = [[0, 25], [10, 25], [30, "far"]]
)";
  const Drawn drawn = draw("faulty", text);
  EXPECT_EQ(drawn.outcome.code, 2) << drawn.outcome.text;
  EXPECT_NE(drawn.outcome.text.find("faulty.svg\n"), std::string::npos) << drawn.outcome.text;
  expect_mark(drawn.svg, "repeats its point (30, 25)", 30, 25);
  expect_mark(drawn.svg, "missing key &#39;cohesion&#39;", 67.5, 27.5, 15);
  expect_mark(drawn.svg, "goes from x = 60 m to x = 50 m", 50, 28);
  expect_mark(drawn.svg, "missing key &#39;head&#39;", 45, 35);
  expect_mark(drawn.svg, "&#39;far&#39;", 5, 25);
  EXPECT_NE(drawn.svg.find("class=\"water-table\""), std::string::npos);
  EXPECT_NE(drawn.svg.find("class=\"soil\" data-region=\"soil\""), std::string::npos);
}

TEST(CheckPicture, MarksAnOverlapWhereItIs) {
  const Drawn drawn = draw("overlap", R"(geometry.polygon = [
  { name = "a", points = [[0, 0], [40, 0], [40, 5], [0, 5]] },
  { name = "b", points = [[0, 4], [20, 4], [20, 12], [0, 12]] }]
materials.s = { model = "mohr_coulomb", unit_weight = 18, cohesion = 5, friction_angle = 28 }
regions = { a = "s", b = "s" }
analysis.methods = ["lem"]
)");
  EXPECT_EQ(drawn.outcome.code, 2) << drawn.outcome.text;
  expect_mark(drawn.svg, "overlap", 10, 4.5);
}

TEST(CheckPicture, MarksAWarningOfTheGroundInUnitsOfTheCase) {
  const std::string text =
      change(change(slices_alone, "[50, 35], [30, 25]", "[50, 35], [40, 25]"), "cohesion = 3", "cohesion = 0");
  const Drawn drawn = draw("steep", text);
  EXPECT_EQ(drawn.outcome.code, 0) << drawn.outcome.text;
  expect_mark(drawn.svg, "rises at 45.0°", 45, 30);
  const Drawn in_feet = draw("steep_in_feet", text, "--set output.length_unit=ft");
  expect_mark(in_feet.svg, "rises at 45.0°", 45 / 0.3048, 30 / 0.3048, 1e-2);
}

TEST(CheckPicture, DrawsLayersFromBoreholes) {
  const std::string text = R"([geometry]
ground = [[0, 20], [20, 20], [40, 10], [60, 10]]
[[geometry.layer]]
name = "silt"
depths = [[10, 4], [50, 2]]
[[geometry.layer]]
name = "rock"
level = 0
[materials.soil]
model = "mohr_coulomb"
unit_weight = 20
cohesion = 3
friction_angle = 35
[regions]
silt = "soil"
rock = "soil"
[analysis]
methods = ["lem"]
)";
  const Drawn drawn = draw("layers", text);
  EXPECT_EQ(drawn.outcome.code, 0) << drawn.outcome.text;
  EXPECT_NE(drawn.svg.find("data-region=\"silt\""), std::string::npos);
  expect_mark(drawn.svg, "no borehole from x = 0 m to x = 10 m", 5, 16, 4.1);
  const Drawn crossed = draw("crossed", change(text, "level = 0", "bottom = [[0, 18], [30, 5], [60, 0]]"));
  EXPECT_EQ(crossed.outcome.code, 2) << crossed.outcome.text;
  EXPECT_NE(crossed.svg.find("class=\"mark error\""), std::string::npos);
}

TEST(CheckPicture, RefusesWhatIsNoSection) {
  const Drawn in_3d = draw("solid", change(slope, "dimension = 2", "dimension = 3\nthickness = 2"));
  EXPECT_EQ(in_3d.outcome.code, 2) << in_3d.outcome.text;
  EXPECT_NE(in_3d.outcome.text.find("a picture shows a plane section, but this case has 'dimension' = 3"),
            std::string::npos)
      << in_3d.outcome.text;
  EXPECT_TRUE(in_3d.svg.empty());
  const Outcome pdf = run_program("check no.toml --picture no.pdf");
  EXPECT_EQ(pdf.code, 2);
  EXPECT_NE(pdf.text.find("'no.pdf' cannot be drawn: the name of the picture of a case ends with .svg or .png"),
            std::string::npos)
      << pdf.text;
}

TEST(CheckPicture, IsAPngByTheEndingOfItsName) {
  const std::filesystem::path file = support::name_scratch("raster.toml"),
                              picture = support::name_scratch("raster.png");
  std::ofstream(file) << slices_alone;
  std::filesystem::remove(picture);
  const std::string command = fmt::format("check '{}' --picture '{}'", file.string(), picture.string());
  if (std::system("rsvg-convert --version >/dev/null 2>&1") == 0) {
    const Outcome drawn = run_program(command);
    EXPECT_EQ(drawn.code, 0) << drawn.text;
    EXPECT_TRUE(read_text(picture).starts_with("\x89PNG\r\n"));
    std::filesystem::remove(picture);
  }
  const std::string before = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  const Outcome without = run_program(command);
  setenv("PATH", before.c_str(), 1);
  EXPECT_EQ(without.code, 6) << without.text;
  EXPECT_NE(without.text.find("rsvg-convert is not installed"), std::string::npos) << without.text;
  EXPECT_NE(without.text.find("ends with .svg needs no other program"), std::string::npos) << without.text;
  EXPECT_FALSE(std::filesystem::exists(picture));
  EXPECT_FALSE(std::filesystem::exists(picture.string() + ".part"));
}

TEST(CheckPicture, ShowsWarningsBesideErrors) {
  // The cohesion is unusual.
  std::string text = change(slices_alone, "friction_angle = ", "unknown = 1\nfriction_angle = ");
  text = change(text, "cohesion = 3", "cohesion = 3000");
  const Drawn drawn = draw("both", text);
  EXPECT_EQ(drawn.outcome.code, 2) << drawn.outcome.text;
  EXPECT_NE(drawn.svg.find("class=\"message error\""), std::string::npos);
  EXPECT_NE(drawn.svg.find("class=\"message warning\""), std::string::npos) << drawn.outcome.text;
}

TEST(CheckPicture, ATextThatIsNotTomlHasItsMessage) {
  const Drawn drawn = draw("not_toml", "title = \"<b>\nx = ");
  EXPECT_EQ(drawn.outcome.code, 2);
  EXPECT_NE(drawn.svg.find("No section could be read"), std::string::npos);
  EXPECT_NE(drawn.svg.find("class=\"message error\""), std::string::npos);
}

}  // namespace
}  // namespace talus::input
