// SPDX-License-Identifier: MIT
// Soils in a report, mostly Cam-clay and rooted ones: the table of materials, the assumptions and the methods.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "input/echo.hpp"
#include "input/rooted_slope.hpp"
#include "report/content/materials.hpp"
#include "report/words/words.hpp"

namespace talus::report {
namespace {

using input::change;
using nlohmann::json;

/// The results in the folder of a run of this case.
ResultFolder make_folder(const std::string& text) {
  ResultFolder folder;
  folder.run.input = input::read_case_text(text, "slope.toml").echo;
  folder.data = input::read_echo(folder.run.input);
  return folder;
}

/// The one material of a case; `factor`: of safety.
json read_soil(const std::string& text, std::optional<double> factor = {}) {
  return list_materials(make_folder(text), factor).at(0);
}

json find_row(const json& soil, const std::string& key) {
  for (const json& row : soil.at("properties"))
    if (row.at("key") == key) return row;
  return json::object();
}

std::string collect_statements(const std::string& text) {
  std::string all;
  for (const json& sentence : list_assumptions(make_folder(text))) all += sentence.get<std::string>() + "\n";
  return all;
}

std::vector<std::string> name_methods(const std::string& text) {
  return list_methods(make_folder(text)).get<std::vector<std::string>>();
}

bool holds(const std::vector<std::string>& list, const char* word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// tan φ' of a critical state in triaxial compression.
double find_tangent(double slope) {
  const double sine = 3 * slope / (6 + slope);
  return sine / std::sqrt(1 - sine * sine);
}

TEST(SoilWithFlowAlone, HasNoLaw) {
  const std::string text = R"(
analysis.methods = ["seepage"]
mesh.size = 0.25
geometry.polygon = [{ name = "sand", points = [[0, 0], [4, 0], [4, 2], [0, 2]] }]
geometry.line = [{ name = "ground", points = [[0, 2], [4, 2]] }]
regions.sand = "sand"
materials.sand = { unit_weight = 20, porosity = 0.4, water = { retention = "saturated", conductivity = 1e-4 } }
hydraulic = [{ on = "bottom", condition = "total_head", head = 4.2 }, { on = "ground", condition = "total_head", head = 3 }]
)";
  EXPECT_EQ(read_soil(text).at("model"), "soil with flow of water only");
  const std::string given = change(text, "{ unit_weight = 20,", "{ model = \"linear_elastic\", unit_weight = 20,");
  EXPECT_EQ(read_soil(given).at("model"), "soil with flow of water only") << "no method uses the law";
  const std::string strong = change(text, "{ unit_weight = 20,",
                                    "{ model = \"mohr_coulomb\", cohesion = 5, friction_angle = 30, unit_weight = 20,");
  EXPECT_EQ(read_soil(strong).at("model"), "Mohr–Coulomb");
}

TEST(CamClayRows, AreThoseOfTable42) {
  const json soil = read_soil(input::rooted_slope);
  EXPECT_EQ(soil.at("model"), "rooted Cam-clay");
  const std::vector<std::tuple<const char*, const char*, double>> rows{{"lambda", "λ", 0.155},
                                                                       {"kappa", "κ", 0.04},
                                                                       {"critical_state_slope", "M₀", 0.827},
                                                                       {"preconsolidation_ratio", "R₀", 3},
                                                                       {"suction_hardening", "b", 10},
                                                                       {"root_hardening", "Rp", 0.4},
                                                                       {"root_strength", "Ra", 0.18},
                                                                       {"roots_0", "mr", 0.94},
                                                                       {"void_ratio", "e₀", 0.6},
                                                                       {"porosity", "n", 0.375}};
  for (const auto& [key, symbol, value] : rows) {
    const json row = find_row(soil, key);
    ASSERT_FALSE(row.empty()) << key;
    EXPECT_EQ(row.at("symbol"), symbol);
    EXPECT_EQ(row.at("characteristic"), value) << key;
    EXPECT_TRUE(row.at("at_failure").is_null());
  }
  EXPECT_EQ(find_row(soil, "roots_0").at("title"), "root content under 'face', at the ground");
  EXPECT_EQ(find_row(soil, "roots_0").at("unit"), "%");
  EXPECT_NEAR(find_row(soil, "critical_state_slope_rooted").at("characteristic").get<double>(), 0.827 + 0.18 * 0.94,
              1e-12);
  EXPECT_NEAR(find_row(soil, "unit_weight").at("characteristic").get<double>(), 2.71 / 1.6 * 9.81, 1e-9);
  for (const char* other : {"young_modulus", "cohesion", "preconsolidation", "root_breaking_strain", "root_content"})
    EXPECT_TRUE(find_row(soil, other).empty()) << other;
}

TEST(CamClayRows, OfTheReducedStrengthDivideTheTangent) {
  const std::string reduced = change(input::rooted_slope, "duration = 560", "duration = 560\nstrength_factor = 1.25");
  const json soil = read_soil(reduced, 1.4);
  for (const char* key : {"critical_state_slope", "critical_state_slope_rooted"}) {
    const json row = find_row(soil, key);
    const double whole = find_tangent(row.at("characteristic"));
    EXPECT_NEAR(find_tangent(row.at("design")), whole / 1.25, 1e-9);
    EXPECT_NEAR(find_tangent(row.at("at_failure")), whole / 1.4, 1e-9);
  }
  EXPECT_TRUE(find_row(soil, "preconsolidation_ratio").at("design").is_null());
}

TEST(RootCohesionRows, FollowFromTheBundleAndAreDivided) {
  const std::string bundle =
      "[roots.bundle]\nmodel = \"wu_waldron\"\narea_ratios = [1e-3, 2e-4]\nstrengths = [10, 20]\norientation = 1.0\n";
  const json soil = read_soil(input::with_cohesion(bundle), 2.0);
  EXPECT_EQ(soil.at("model"), "Mohr–Coulomb with the cohesion of roots");
  const json row = find_row(soil, "roots_0");
  EXPECT_NEAR(row.at("characteristic").get<double>(), 14, 1e-9) << "10 MPa · 10⁻³ + 20 MPa · 2·10⁻⁴, in kPa";
  EXPECT_NEAR(row.at("at_failure").get<double>(), 7, 1e-9);
  EXPECT_EQ(find_row(soil, "cohesion").at("characteristic"), 2.0);
}

TEST(RootRows, CountWhatIsThereAtTheirAge) {
  const json soil = read_soil(input::with_roots("age = 2.5\ngrowth = [[0, 0], [5, 1]]\n"));
  EXPECT_NEAR(find_row(soil, "roots_0").at("characteristic").get<double>(), 0.47, 1e-12);
  EXPECT_NEAR(find_row(soil, "critical_state_slope_rooted").at("characteristic").get<double>(), 0.827 + 0.18 * 0.47,
              1e-9);
}

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)
#define EXPECT_LACKS(text, part) EXPECT_EQ((text).find(part), std::string::npos) << (text)

TEST(RootedAssumptions, StateWhereTheRootsAreAndThatTheyNeverBreak) {
  const std::string text = collect_statements(input::with_roots("age = 2.5\ngrowth = [[0, 0], [5, 1]]\n"));
  EXPECT_CONTAINS(text,
                  "Roots under 'face': 0.94 % of the dry mass at the ground, the same down to 0.5 m. 50 % of that");
  EXPECT_CONTAINS(text, "one material in loess, and the roots never break");
  EXPECT_CONTAINS(text, "loess: modified Cam-clay");
  for (const char* of_another_soil : {"perfectly plastic", "no tensile strength", "linear elastic", "divides"})
    EXPECT_LACKS(text, of_another_soil);
  EXPECT_CONTAINS(collect_statements(change(input::rooted_slope, "root_strength = 0.18",
                                            "root_strength = 0.18\nroot_breaking_strain = 0.3")),
                  "roots break as the activation strain grows");
}

TEST(RootedAssumptions, OfACohesionNameItsBundle) {
  const std::string text = collect_statements(input::with_cohesion(
      "profile = \"exponential\"\ndecay_depth = 0.2\n[roots.bundle]\nmodel = \"wu_waldron\"\narea_ratios = "
      "[1e-3]\nstrengths = [10]\norientation = 1.0\n"));
  EXPECT_CONTAINS(text,
                  "a cohesion of 10 kPa at the ground (Wu and Waldron's sum over 1 class of roots), falling with "
                  "exp(−z/0.2 m) down to 0.5 m.");
  EXPECT_CONTAINS(text, "perfectly plastic");
  EXPECT_LACKS(text, "Cam-clay");
}

TEST(RootedAssumptions, LimitStatementsOnSoftWaterToWhatTheStressAllows) {
  const std::string text = collect_statements(input::rooted_slope);
  EXPECT_CONTAINS(text, "times less than that of real water");
  EXPECT_LACKS(text, "instead of");
  EXPECT_CONTAINS(collect_statements(input::with_cohesion("cohesion = 5\n")), " % instead of ");
}

TEST(RootedMethods, NameTheModelsInUse) {
  const auto clay = name_methods(input::rooted_slope);
  EXPECT_TRUE(holds(clay, "modified_cam_clay") && holds(clay, "rooted_cam_clay"));
  EXPECT_FALSE(holds(clay, "mohr_coulomb") || holds(clay, "root_cohesion"));
  const auto cohesion = name_methods(input::with_cohesion("cohesion = 5\n"));
  EXPECT_TRUE(holds(cohesion, "mohr_coulomb") && holds(cohesion, "root_cohesion"));
  EXPECT_FALSE(holds(cohesion, "modified_cam_clay"));
}

}  // namespace
}  // namespace talus::report
