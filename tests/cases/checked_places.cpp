// SPDX-License-Identifier: MIT
// talus check refuses walls, struts, blocks, sections and monitors that a run refuses, with the same sentence.

#include <gmock/gmock.h>

#include <ctime>

#include "cases/methods_slope.hpp"
#include "run/check_case.hpp"

namespace talus {
namespace {

/// A cut of 3 m at x = 12 m in a section of 24 m, with a sheet pile wall.
const std::string walled_cut = R"(
geometry.ground = [[0, 3], [12, 3], [12, 0], [24, 0]]
geometry.layer = [{ name = "sand", level = -6 }]
regions.sand = "sand"
analysis.methods = ["fem"]
fem = { size = 2, meshes = 1, resolution = 0.05 }
[materials.sand]
model = "mohr_coulomb"
unit_weight = 18
cohesion = 2
friction_angle = 32
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "30 MPa"
poisson_ratio = 0.3
[support.sheet]
kind = "wall"
line = [[12, 3], [12, -3]]
axial_stiffness = 2e6
bending_stiffness = 5e4
plastic_moment = 180
interface_strength = 0.67
)";

/// Seepage below the same wall.
const std::string flow_below_wall = R"(
geometry.polygon = [{ name = "sand", points = [[0, 0], [20, 0], [20, 6], [10, 6], [10, 10], [0, 10]] }]
geometry.line = [{ name = "bed", points = [[0, 10], [10, 10]] }, { name = "pit", points = [[10, 6], [20, 6]] }]
mesh.size = 1
regions.sand = "sand"
materials.sand = { unit_weight = 20, porosity = 0.4, water = { retention = "saturated", conductivity = 1e-4 } }
hydraulic = [{ on = "bed", condition = "total_head", head = 11 }, { on = "pit", condition = "total_head", head = 6 }]
analysis.methods = ["seepage"]
initial.pore_pressure = "seepage"
)";

/// A cut in stages.
const std::string dug_column = R"(
geometry.polygon = [{ name = "soil", points = [[0, 0], [2, 0], [2, 6], [0, 6]] },
                    { name = "dug", points = [[0, 6], [2, 6], [2, 9], [0, 9]] }]
mesh.size = 1
regions = { soil = "soil", dug = "soil" }
initial = { stress = "k0", k0 = 0.5 }
analysis.methods = ["fem"]
materials.soil = { model = "linear_elastic", unit_weight = 20, young_modulus = 12000, poisson_ratio = 0.25 }
construction = [{ name = "dig", duration = 0, remove = ["dug"], factor = false }]
)";

struct Fault {
  std::string text;
  std::vector<input::Override> changes;
  std::string sentence;
};

std::vector<Fault> list_faults() {
  const auto wall = [](const std::string& line) { return std::vector<input::Override>{{"support.sheet.line", line}}; };
  const auto strut = [](const std::string& level) {
    return std::vector<input::Override>{{"support.sheet.strut_levels", level},
                                        {"support.sheet.strut_stiffness", "2e4"},
                                        {"support.sheet.strut_strength", "200"}};
  };
  return {
      {walled_cut, wall("[[12, 3], [12, 2.999999]]"), "less than 0.001 of the width"},
      {walled_cut, wall("[[12, 3], [12, -3], [12, 2]]"), "meets itself at (12, 2)"},
      {walled_cut, wall("[[12, 3], [12, -3], [11, -2], [13, -2]]"), "meets itself at (11, -2)"},
      {walled_cut, wall("[[12, 3], [12, -6], [14, -6]]"), "lies along the bottom"},
      {walled_cut, strut("[-1]"), "has soil on both sides of the wall"},
      {walled_cut, strut("[4]"), "is above or below the wall"},
      {flow_below_wall,
       {{"seepage.heave", "[{ name = 'block', x = [10, 12], level = 7 }]"}},
       "not in soil with pore water"},
      {flow_below_wall, {{"seepage.section", "[{ name = 'line', points = [[10, 20], [10, 23]] }]"}}, "cross no soil"},
      {dug_column, {{"output.monitor", "[{ name = 'plate', at = [10, 3] }]"}}, "lies outside the section"}};
}

TEST_F(MethodsTest, CheckRefusesWhatARunRefuses) {
  for (const Fault& fault : list_faults()) {
    std::string checked;
    try {
      run::check_methods(input::read_case_text(fault.text, "slope.toml", fault.changes).data);
    } catch (const Error& error) {
      checked = error.what();
    }
    EXPECT_THAT(checked, testing::HasSubstr(fault.sentence));
    EXPECT_EQ(find_fault(fault.text, fault.changes), checked);
  }
  for (const std::string& text : {walled_cut, flow_below_wall, dug_column})
    EXPECT_NO_THROW(run::check_methods(input::read_case_text(text, "slope.toml").data)) << text;
}

/// The mesh of a check does not grow with that of the run.
TEST_F(MethodsTest, CheckOfStagesMeshesCoarsely) {
  const auto begin = std::clock();
  run::check_methods(input::read_case_text(dug_column, "slope.toml", {{"mesh.size", "0.002"}}).data);
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 5);
}

}  // namespace
}  // namespace talus
