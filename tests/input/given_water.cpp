// SPDX-License-Identifier: MIT
// Faults of [seepage], [[initial.piezometric_line]], [initial.pressure_grid] and [[slurry]]: one sentence each.

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "slope.hpp"
#include "support/scratch.hpp"

namespace talus::input {
namespace {

const std::string column = R"(mesh.size = 0.25
geometry.polygon = [{ name = "sand", points = [[0, 0], [4, 0], [4, 2], [0, 2]] }]
geometry.line = [{ name = "ground", points = [[0, 2], [4, 2]] }]
regions.sand = "sand"
materials.sand = { unit_weight = 20, porosity = 0.4, water = { retention = "saturated", conductivity = 1e-4 } }
hydraulic = [{ on = "bottom", condition = "total_head", head = 4 }, { on = "ground", condition = "total_head", head = 3 }]
)";
const std::string bank = R"(analysis.methods = ["lem"]
geometry.polygon = [{ name = "clay", points = [[0, 0], [16, 0], [16, 3], [10, 3], [5, 8], [0, 8]] }]
regions.clay = "clay"
materials.clay = { model = "mohr_coulomb", unit_weight = 20, cohesion = 5, friction_angle = 25 }
)";
const std::string flow = "analysis.methods = [\"seepage\"]\n" + column;

/// Expects a single fault with this part; `names` resolves files beside the case.
void expect_water_fault(const std::string& text, const std::string& part, const std::string& name = "case.toml") {
  const auto faults = find_faults(text, {}, name);
  ASSERT_EQ(faults.size(), 1u) << part;
  EXPECT_NE(faults[0].sentence.find(part), std::string::npos) << faults[0].sentence;
}

TEST(Seepage, NeedsNoStrength) {
  const LoadedCase loaded = read_case_text(flow, "case.toml");
  EXPECT_EQ(loaded.data.initial.water.pressure, InitialPressure::seepage);
  // A slope needs it.
  EXPECT_FALSE(find_faults("analysis.methods = [\"lem\"]\n" + column).empty());
}

TEST(Seepage, NamesItsFaults) {
  expect_water_fault(bank + "seepage.times = [1]\n", "needs \"seepage\" among the 'methods'");
  expect_water_fault(flow + "seepage.times = [2, 1]\n", "the times must increase");
  expect_water_fault(flow + "seepage.section = [{ name = \"a\", points = [[1, 1]] }]\n",
                     "'points' has 1 point; a line needs two");
  expect_water_fault(flow + "seepage.section = [{ name = \"a\", points = [[1, 1], [1, 1]] }]\n",
                     "the same point twice");
  expect_water_fault(flow + "seepage.heave = [{ name = \"a\", x = [3, 1], level = 1 }]\n", "the second must be larger");
  expect_water_fault(flow + "seepage.section = [{ name = \"a\", points = [[1, 2.1], [3, 2.1]] }]\n",
                     "'points' of section 'a' cross no soil with pore water");
  expect_water_fault(flow + "seepage.heave = [{ name = \"a\", x = [3, 5], level = 1 }]\n",
                     "the base of block 'a' is not in soil with pore water at x = 4.00");
  EXPECT_TRUE(find_faults(flow + "seepage.section = [{ name = \"a\", points = [[-1, 2], [5, 2]] }]\n" +
                          "seepage.heave = [{ name = \"a\", x = [0, 4], level = 0 }]\n")
                  .empty());
  // Water passes a line in the soil; a wall stops it.
  const std::string line = "geometry.line = [{ name = \"slab\", points = [[1, 1], [3, 1]] }, ";
  const std::string closed = "hydraulic = [{ on = \"slab\", condition = \"no_flow\" }, ";
  expect_water_fault(change(change(flow, "geometry.line = [", line), "hydraulic = [", closed),
                     "no_flow on 'slab', which lies inside");
  expect_water_fault(flow + "initial = { pore_pressure = \"water_table\", water_table = [[0, 1]] }\n", "nothing flows");
}

TEST(PiezometricLines, NameTheirFaults) {
  const auto with = [](const std::string& lines, const std::string& rest = "water_table = [[0, 1]]") {
    return bank + "initial = { pore_pressure = \"water_table\", " + rest + ", piezometric_line = [" + lines + "] }\n";
  };
  EXPECT_TRUE(find_faults(with("{ materials = [\"clay\"], points = [[0, 6], [9, 3]] }")).empty());
  expect_water_fault(with("{ materials = [\"sand\"], points = [[0, 6]] }"), "there is no material 'sand'");
  expect_water_fault(with("{ materials = [], points = [[0, 6]] }"), "'materials' is empty");
  expect_water_fault(with("{ materials = [\"clay\"], points = [[9, 6], [0, 3]] }"), "must run from left to right");
  expect_water_fault(
      with("{ materials = [\"clay\"], points = [[0, 6]] }, { materials = [\"clay\"], points = [[0, 5]] }"),
      "material 'clay' has a piezometric line already, number 1");
  expect_water_fault(flow + "initial = { piezometric_line = [{ materials = [\"sand\"], points = [[0, 3]] }] }\n",
                     "belong to pore_pressure = \"water_table\"");
}

class PressureGrid : public ::testing::Test {
 protected:
  void expect_table_fault(const std::string& table, const std::string& quantity, const std::string& part) {
    std::ofstream(folder_ / "grid.csv") << table;
    expect_water_fault(
        bank + fmt::format("initial = {{ pore_pressure = \"grid\", pressure_grid = {{ file = \"grid.csv\", "
                           "quantity = \"{}\" }} }}\n",
                           quantity),
        part, (folder_ / "case.toml").string());
  }
  const std::filesystem::path folder_ = support::make_scratch("pressure_grid");
};

TEST_F(PressureGrid, NamesItsFaults) {
  expect_table_fault("x,y,pressure\n0,0,1\n1,0,1\n0,1,1\n", "pressure", "has no unit; head it 'pressure [kPa]'");
  expect_table_fault("x,y,head [m]\n0,0,1\n1,0,1\n", "head", "there are 2 points; three are needed");
  expect_table_fault("x,y,head [m]\n0,0,1\n1,1,1\n2,2,1\n", "head", "lie on one line");
  expect_table_fault("x,y,head [m]\n0,0,1\n1,0,1\n0,1,1\n0,0,4\n", "head", "points 1 and 4 lie at one place");
  expect_table_fault("x,y,r_u\n0,0,0.2\n1,0,1.5\n0,1,0.2\n", "r_u", "grid.csv:3: r_u is 1.5");
  expect_table_fault("x,y,head [m]\n0,0,1\n1,0,high\n0,1,1\n", "head", "high");
  expect_table_fault("x,y,level\n0,0,1\n1,0,1\n0,1,1\n", "head", "head");
  expect_water_fault(bank + "initial.pore_pressure = \"grid\"\n", "needs the block [initial.pressure_grid]");
}

TEST_F(PressureGrid, WarnsOfSoilOutsideItsPoints) {
  const std::string text =
      bank + "initial = { pore_pressure = \"grid\", pressure_grid = { file = \"grid.csv\", quantity = \"head\" } }\n";
  for (const bool is_wide : {true, false}) {
    std::ofstream(folder_ / "grid.csv") << "x,y,head [m]\n-1,-1,3\n"
                                        << (is_wide ? "20" : "14") << ",-1,3\n20,9,3\n-1,9,3\n";
    const LoadedCase loaded = read_case_text(text, (folder_ / "case.toml").string());
    ASSERT_EQ(loaded.warnings.size(), is_wide ? 0u : 1u);
    if (!is_wide) {
      EXPECT_NE(loaded.warnings[0].sentence.find("the soil at (16, 0) m lies outside the points of 'grid.csv'"),
                std::string::npos)
          << loaded.warnings[0].sentence;
    }
  }
}

TEST(Slurry, NamesItsFaults) {
  const auto with = [](const std::string& keys) { return bank + "slurry = [{ name = \"mud\", " + keys + " }]\n"; };
  EXPECT_TRUE(find_faults(with("x = [10, 16], level = 5, unit_weight = 11")).empty());
  expect_water_fault(with("x = [12, 10], level = 5, unit_weight = 11"), "the second must be larger");
  expect_water_fault(with("x = [10, 30], level = 5, unit_weight = 11"), "reaches beyond the ground");
  expect_water_fault(with("x = [10, 16], level = 5, unit_weight = 0"), "must be above 0");
}

}  // namespace
}  // namespace talus::input
