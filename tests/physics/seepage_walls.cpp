// SPDX-License-Identifier: MIT
// Impermeable walls in seepage: the cut-off of Harr with a wall, and a wall to the base, whose sides have waters of
// their own in LEM and FEM.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "run/common/section_of_case.hpp"
#include "run/fem/solid_of_case.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

constexpr double gamma_w = 9810;

nlohmann::json run(const std::string& text) {
  run::RunOptions options;
  options.folder = support::make_scratch("seepage_walls") / "run";
  options.overwrite = true;
  return support::run_case(input::read_case_text(text, "flow.toml"), options);
}

/// A layer with a wall at x = 0, and heads of `head` at its left and 0 at its right.
std::string write_wall(double depth, double thickness, double head, const std::string& permeable,
                       const std::string& methods) {
  return fmt::format(R"(
analysis.methods = [{4}]
geometry.polygon = [{{ name = "sand", points = [[-40, -{1}], [40, -{1}], [40, 0], [0, 0], [-40, 0]] }}]
geometry.line = [{{ name = "upstream", points = [[-40, 0], [0, 0]] }}, {{ name = "downstream", points = [[0, 0], [40, 0]] }}]
regions.sand = "sand"
hydraulic = [{{ on = "upstream", condition = "total_head", head = {2} }}, {{ on = "downstream", condition = "total_head", head = 0 }}]
[mesh]
size = 0.8
refine = [{{ near = [[0, 0], [0, -{0}]], size = 0.06, distance = 3 }}, {{ near = [[0, -{0}]], size = 0.03, distance = 0.4 }}]
[materials.sand]
model = "mohr_coulomb"
unit_weight = 20
porosity = 0.4
cohesion = 50
friction_angle = 30
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "20 MPa"
poisson_ratio = 0.3
[materials.sand.water]
retention = "saturated"
conductivity = 1e-5
[initial]
pore_pressure = "seepage"
[support.sheet]
kind = "wall"
line = [[0, 0], [0, -{0}]]
interface_strength = 0.7
axial_stiffness = 1e6
bending_stiffness = 1e4
{3}
)",
                     depth, thickness, head, permeable, methods);
}

TEST(SeepageWalls, CutOffFollowsHarr) {
  // As SeepageAlone.UnderACutOffFollowsHarr, which has one half of the section.
  const double thickness = 10, head = 3;
  for (const double s : {2.0, 5.0}) {
    const nlohmann::json summary =
        run(write_wall(s, thickness, head, "permeable = false", "\"seepage\"") +
            "[seepage]\nsection = [{ name = \"below\", points = [[0, -10], [0, -" + std::to_string(s) + "]] }]\n");
    const nlohmann::json& state = summary.at("flow").at("states").back();
    const double modulus = std::sin(std::numbers::pi * s / (2 * thickness)), whole = std::comp_ellint_1(modulus),
                 other = std::comp_ellint_1(std::sqrt(1 - modulus * modulus));
    const double flow = 1e-5 * head * other / (2 * whole);
    EXPECT_NEAR(state.at("outflow").get<double>() / flow, 1, 0.01) << s;
    EXPECT_NEAR(state.at("inflow").get<double>() / flow, 1, 0.01) << s;
    // The line ends at the tip, where the gradient is infinite: it has the flow of the boundary all the same.
    EXPECT_NEAR(state.at("sections")[0].at("discharge").get<double>() / state.at("outflow").get<double>(), 1, 1e-8)
        << s;
    const double exact = std::numbers::pi * head / (4 * whole * thickness * modulus);
    double gradient = 0;
    for (const auto& e : state.at("exits"))
      if (e.at("name") == "downstream") gradient = e.at("gradient").get<double>();
    EXPECT_NEAR(gradient / exact, 1, 0.02) << s;
  }
}

TEST(SeepageWalls, PermeableWallsDoNotStopTheFlow) {
  // The lower water begins a metre behind the wall: with water on both sides of a node heads would contradict.
  const auto write = [](const char* permeable) {
    std::string text = write_wall(9.5, 10, 3, permeable, "\"seepage\"");
    const std::string downstream = "points = [[0, 0], [40, 0]]", condition = "head = 0 }";
    text.replace(text.find(downstream), downstream.size(),
                 "points = [[1, 0], [40, 0]] }, { name = \"strip\", points = [[0, 0], [1, 0]]");
    return text.replace(text.find(condition), condition.size(),
                        "head = 0 }, { on = \"strip\", condition = \"no_flow\" }");
  };
  const nlohmann::json open = run(write("permeable = true")), closed = run(write("permeable = false"));
  const auto flow = [](const nlohmann::json& summary) {
    return summary.at("flow").at("states").back().at("outflow").get<double>();
  };
  EXPECT_LT(flow(closed), 0.35 * flow(open));
}

TEST(SeepageWalls, ToTheBaseSeparatesTheWatersOfFemAndLem) {
  const site::Site site(
      input::read_case_text(write_wall(10, 10, 3, "permeable = false", "\"fem\", \"lem\""), "flow.toml").data);
  const auto find_pressure = [](double x, double y) { return gamma_w * ((x < 0 ? 3 : 0) - y); };
  const run::SolidOfCase<2> solid = run::make_solid<2>(site, 4);
  const mesh::Mesh<2>& mesh = *solid.mesh;
  ASSERT_EQ(solid.model.pore_stress.size(), mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    double middle = 0;
    for (const int n : mesh.elements[e]) middle += mesh.nodes[n][0] / 3;
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_NEAR(-solid.model.pore_stress[e][k], find_pressure(middle, mesh.nodes[mesh.elements[e][k]][1]), 1)
          << "x = " << middle;
  }
  const lem::Section section = run::make_section(site).section;
  ASSERT_TRUE(section.pressure_grid);
  const lem::PressureLocator water(*section.pressure_grid);
  for (const double y : {-1.0, -5.0, -9.0})
    for (const double x : {-20.0, -1e-3, 1e-3, 20.0}) {
      const auto u = water.find({x, y});
      ASSERT_TRUE(u);
      EXPECT_NEAR(*u, find_pressure(x, y), 1) << x << " " << y;
    }
}

TEST(SeepageWalls, NeedToSayWhetherWaterPasses) {
  try {
    input::read_case_text(write_wall(5, 10, 3, "", "\"seepage\""), "flow.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("support 'sheet': give 'permeable'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace talus
