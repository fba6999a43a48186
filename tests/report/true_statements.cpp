// SPDX-License-Identifier: MIT
// The statements of a report agree with its case: only those that apply, with numbers in the units of the case.

#include <algorithm>

#include "report/folder/numbers.hpp"
#include "report/report.hpp"
#include "report_page.hpp"
#include "schema.hpp"
#include "small_run.hpp"

namespace talus::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json leaf(const json& value, const char* unit = "") {
  return {{"value", value}, {"unit", unit}, {"given", true}};
}

/// A run of one stage in elastic ground that did not move.
json make_summary() {
  return json{{"format", 2},
              {"title", "A run"},
              {"status", "finished"},
              {"mesh", {{"dimension", 2}, {"points", 100}, {"elements", 30}, {"mean_size", 1.0}}},
              {"slope_height", 5},
              {"stages", {{{"name", "only"}, {"end", "time"}, {"time", 2}, {"steps", 10}, {"force_ratio", 1e-5}}}},
              {"input",
               {{"analysis", {{"kind", leaf("run")}}},
                {"initial", {{"stress", leaf("none")}}},
                {"materials", {{"rock", {{"model", leaf("linear_elastic")}}}}},
                {"stage", {{{"name", leaf("only")}, {"duration", leaf(2, "s")}, {"until", leaf("time")}}}}}},
              {"runout",
               {{"moved_volume", 0},
                {"largest_displacement", 0.0003048},
                {"front_advance", 0},
                {"toe_distance", 0},
                {"crest_retreat", 0}}}};
}

json sand() {
  return {{"model", leaf("mohr_coulomb")},
          {"friction_angle", leaf(30, "deg")},
          {"dilatancy_angle", leaf(0, "deg")},
          {"cohesion", leaf(2, "kPa")},
          {"tensile_strength", leaf(0, "kPa")}};
}

class TrueStatements : public testing::Test {
 protected:
  void TearDown() override { fs::remove_all(folder_); }
  json report() {
    std::ofstream(folder_ / "summary.json") << summary_;
    const json document = collect_report(folder_).document.get();
    EXPECT_EQ(find_schema_faults(document), "");
    return document;
  }
  /// All sentences of the answer and the assumptions.
  std::string collect_statements() {
    const json document = report();
    std::string text;
    for (const json& s : document.at("answer").at("sentences")) text += s.get<std::string>() + "\n";
    for (const json& s : document.at("assumptions")) text += s.get<std::string>() + "\n";
    return text;
  }

  fs::path folder_ = make_test_folder("statements");
  json summary_ = make_summary();
};

#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)
#define EXPECT_LACKS(text, part) EXPECT_EQ((text).find(part), std::string::npos) << (text)

TEST_F(TrueStatements, ASlopeAtRestIsReportedAtRest) {
  const std::string text = collect_statements();
  EXPECT_CONTAINS(text, "no soil moves further than 1 % of the height");
  EXPECT_CONTAINS(text, "the time was up after 2 s, with an unbalanced force of 1 × 10⁻⁵ of gravity");
  EXPECT_LACKS(text, "still moving");
  EXPECT_LACKS(text, "Runout:");
}

TEST_F(TrueStatements, ElasticGroundNeitherLocksNorShears) {
  const std::string text = collect_statements();
  for (const char* of_plastic_soil : {"lock", "hear band", "actor", "tensile", "perfectly plastic"})
    EXPECT_LACKS(text, of_plastic_soil);
  EXPECT_CONTAINS(text, "linear elastic): rock");
}

TEST_F(TrueStatements, ARunWithoutAFactorIsNotComparedWithLem) {
  summary_["input"]["materials"]["sand"] = sand();
  const std::string text = collect_statements();
  EXPECT_CONTAINS(text, "sand: the plastic flow keeps its volume (ψ = 0, φ = 30°).\n");
  EXPECT_CONTAINS(text, "The stages: linear triangles without smoothing lock");
  for (const char* of_a_factor : {"LEM", "factor", "curve"}) EXPECT_LACKS(text, of_a_factor);
}

TEST_F(TrueStatements, TensileStrengthIsStatedOfTheSoilThatHasIt) {
  summary_["input"]["materials"]["sand"] = sand();
  summary_["input"]["materials"]["clay"] = sand();
  summary_["input"]["materials"]["clay"]["tensile_strength"] = leaf(5, "kPa");
  const std::string text = collect_statements();
  EXPECT_CONTAINS(text, "A tensile strength is kept in clay:");
  EXPECT_CONTAINS(text, "The other soil has no tensile strength");
}

TEST_F(TrueStatements, ElementsLargerThanTheSlopeAreNotAFractionOfIt) {
  summary_["mesh"]["mean_size"] = 20;
  EXPECT_CONTAINS(collect_statements(), "elements is 4 times the height of the slope.");
}

TEST_F(TrueStatements, K0IsChosenOnlyWhereTheCaseGivesIt) {
  json& initial = summary_["input"]["initial"];
  initial = {{"stress", leaf("k0")}, {"k0", leaf(nullptr)}};
  EXPECT_CONTAINS(collect_statements(), "K0 = ν/(1−ν) of each soil");
  initial["k0"] = leaf(0.45);
  EXPECT_CONTAINS(collect_statements(), "K0 = 0.45,");
}

TEST_F(TrueStatements, SoilThatMovesToBothSidesIsReportedOnEach) {
  const json side = {
      {"moved_volume", 40}, {"front_advance", 1.5}, {"toe_distance", 2}, {"crest_retreat", 3}, {"direction", -1},
      {"toe", 0},           {"initial_toe", 0},     {"crest", 0}};
  json other = side;
  other.update({{"moved_volume", 60}, {"crest_retreat", 0}, {"toe_distance", 0}, {"direction", 1}});
  summary_["runout"].update({{"moved_volume", 100}, {"sides", {side, other}}});
  const std::string text = collect_statements();
  EXPECT_CONTAINS(text, "100 m³ per metre move to both sides");
  EXPECT_CONTAINS(
      text, "On the left the front advances 1.5 m and lies 2.0 m beyond the toe, the crest retreats 3.0 m, and 40 m³");
  EXPECT_CONTAINS(text, "On the right the front advances 1.5 m and stays behind the toe, the crest stays, and 60 m³");
}

TEST_F(TrueStatements, LengthsAreInTheUnitOfTheCase) {
  summary_["units"] = {{"length", "ft"}};
  EXPECT_CONTAINS(collect_statements(), "largest displacement is 0.001 ft");
  // 100 ft³ per foot.
  summary_["runout"]["moved_volume"] = 100 * 0.3048 * 0.3048;
  EXPECT_CONTAINS(collect_statements(), "100 ft³ per foot move");
  const json units = report().at("units");
  EXPECT_EQ(units.at("volume").at("name"), "ft³/ft");
  EXPECT_NEAR(units.at("flow").at("si").get<double>(), 0.3048 * 0.3048, 1e-12);
  EXPECT_EQ(units.at("speed").at("name"), "ft/s");
  std::ofstream(folder_ / "profile.csv") << "x [m],ground before [m],ground after [m]\n0.3048,3.048,\n";
  const json table = report().at("tables").at(0);
  EXPECT_EQ(table.at("x").at("unit"), "ft");
  EXPECT_NEAR(table["x"]["values"][0].get<double>(), 1, 1e-12);
  EXPECT_NEAR(table["columns"][0]["values"][0].get<double>(), 10, 1e-12);
  EXPECT_TRUE(table["columns"][1]["values"][0].is_null());
}

TEST_F(TrueStatements, ARetreatingFrontHasNoNegativeAdvance) {
  summary_["runout"].update(
      {{"moved_volume", 1234.5}, {"deposit_volume", 320}, {"front_advance", 0.061}, {"largest_displacement", 1500}});
  summary_["stages"][0]["end"] = "rest";
  EXPECT_CONTAINS(collect_statements(),
                  "largest displacement is 1500 m, the front advances 0.061 m and stays behind the toe, the crest "
                  "stays, and 1200 m³ per metre move, of which 320 m³ per metre lie over the old ground; after 2 s the "
                  "soil is at rest.");
}

TEST_F(TrueStatements, AFrontAtTheEndOfTheBoxIsReportedAsLimited) {
  summary_["runout"].update({{"moved_volume", 1234.5},
                             {"front_advance", 2.19},
                             {"toe_distance", 78},
                             {"crest_retreat", 68},
                             {"largest_displacement", 59},
                             {"limits", {{"front", true}, {"crest", true}}}});
  EXPECT_CONTAINS(collect_statements(),
                  "the front advances 2.2 m and lies 78 m beyond the toe, where the box ends, which limits them, the "
                  "crest retreats 68 m, to the end of the box, and 1200 m³ per metre move");
}

TEST_F(TrueStatements, ARunoutHasTheDigitsThatItsMeshesLeave) {
  summary_["runout"].update({{"moved_volume", 57.1}, {"front_advance", 1.2508}, {"highest_ground", 8.678}});
  EXPECT_CONTAINS(collect_statements(), "The highest ground lies at y = 8.7 m; one mesh shows no uncertainty.");
  summary_["runout"]["coarser_mesh"] = {{"size", 0.1},        {"front_advance", 1.1314}, {"toe_distance", 0},
                                        {"crest_retreat", 0}, {"moved_volume", 60.9},    {"highest_ground", 8.589}};
  const std::string text = collect_statements();
  EXPECT_CONTAINS(text, "the front advances 1.3 ± 0.4 m");
  EXPECT_CONTAINS(text, "57 ± 11 m³ per metre move");
  EXPECT_CONTAINS(text, "y = 8.7 ± 0.3 m. Behind ± stands three times the difference from elements of 0.1 m.");
}

TEST_F(TrueStatements, AMeasureThatTwoMeshesLeaveOpenIsNotDetermined) {
  summary_["runout"].update({{"moved_volume", 57.1},
                             {"deposit_volume", 12},
                             {"front_advance", 2},
                             {"toe_distance", 3},
                             {"highest_ground", 8.678}});
  summary_["runout"]["coarser_mesh"] = {{"size", 0.1},          {"front_advance", 4},  {"toe_distance", 0},
                                        {"crest_retreat", 1.0}, {"moved_volume", 157}, {"highest_ground", 8.589},
                                        {"deposit_volume", 4}};
  const json metre{{"name", "m"}, {"si", 1}};
  summary_["results"] = {{{"name", "runout.front_advance"},
                          {"title", "advance"},
                          {"value", nullptr},
                          {"unit", metre},
                          {"undetermined", "not determined (two meshes: 2.0 m and 4.0 m)"}}};
  const std::string text = collect_statements();
  EXPECT_CONTAINS(
      text,
      "the advance of the front is not determined (two meshes: 2.0 m and 4.0 m) and its distance beyond the "
      "toe is not determined (two meshes: 3.0 m and 0 m), the retreat of the crest is not determined "
      "(two meshes: 0 m and 1.0 m), and the volume that moves is not determined (two meshes: 57 m³ per "
      "metre and 160 m³ per metre), the volume over the old ground is not determined");
  const json shown = report().at("answer").at("results").at(0);
  EXPECT_TRUE(shown.at("value").is_null());
  EXPECT_EQ(shown.at("text"), "not determined (two meshes: 2.0 m and 4.0 m)");
}

TEST_F(TrueStatements, PointsThatLeftAreTakenOutOfTheAnswer) {
  summary_["budgets"] = {{"points", 30}, {"mass", 25}, {"lost", {{"points", 70}, {"mass", 75}}}};
  EXPECT_CONTAINS(collect_statements(), "70 of 100 points, 75 % of the mass, left the grid");
  summary_["budgets"]["points"] = 0;
  const json metre{{"name", "m"}, {"si", 1}};
  summary_["results"] = {{{"name", "runout.front_advance"}, {"title", "advance"}, {"value", 0}, {"unit", metre}},
                         {{"name", "mesh.points"}, {"title", "points"}, {"value", 100}, {"unit", metre}}};
  EXPECT_EQ(report().at("answer").at("results").size(), 1u) << "a front of no soil has no place";
  const std::string text = collect_statements();
  EXPECT_CONTAINS(text, "All soil has left the grid");
  EXPECT_LACKS(text, "largest displacement");
}

TEST_F(TrueStatements, ComparisonsAreCountedInGrammar) {
  const auto compare = [](const json& computed, bool passes) {
    return json{{"name", "a"},
                {"title", "a"},
                {"unit", {{"name", "m"}, {"si", 1}}},
                {"computed", computed},
                {"published", 1},
                {"tolerance", 1},
                {"tolerance_text", "1"},
                {"source", "hand"},
                {"passes", passes},
                {"note", ""}};
  };
  const json hit = compare(1, true), miss = compare(9, false), absent = compare(nullptr, false);
  const auto describe_comparisons = [&](const json& list) {
    summary_["comparisons"] = list;
    return report().at("answer").at("sentences").back().get<std::string>();
  };
  EXPECT_EQ(describe_comparisons(json::array({hit})), "The comparison that the case names is inside its band.");
  EXPECT_EQ(describe_comparisons(json::array({absent})), "The comparison that the case names was not calculated.");
  EXPECT_EQ(describe_comparisons(json::array({hit, hit})),
            "All 2 comparisons that the case names are inside their bands.");
  EXPECT_EQ(describe_comparisons(json::array({hit, miss, miss, absent})),
            "Of the 4 comparisons that the case names, 1 is inside its band, 2 are outside their bands and 1 was not "
            "calculated.");
}

TEST_F(TrueStatements, LoadsThatChangeWithTimeAreDescribed) {
  const json factor = leaf(json::array({{0, 0}, {2, 1}}), "s");
  summary_["input"]["boundary"] = json::array(
      {{{"on", leaf("right")}, {"fix", leaf("velocity")}, {"velocity", leaf({-0.05, 0}, "m/s")}, {"factor", factor}}});
  summary_["input"]["traction"] =
      json::array({{{"on", leaf("crest")}, {"traction", leaf({0, -50}, "kPa")}, {"factor", factor}}});
  const json model = report().at("model");
  EXPECT_EQ(model.at("boundaries")[0].at("text"),
            "prescribed velocity (−0.05, 0) m/s, times a factor: 0 at 0 s, 1 at 2 s");
  ASSERT_EQ(model.at("loads").size(), 2u);
  EXPECT_EQ(model.at("loads")[0].at("name"), "gravity");
  EXPECT_EQ(model.at("loads")[1].at("text"),
            "(0, −50) kPa, carried by the soil beside the side, times a factor: 0 at 0 s, 1 at 2 s");
}

TEST_F(TrueStatements, TheStageInWhichARunBrokeIsNamed) {
  summary_["status"] = "unstable";
  summary_["stages"] = json::array();
  EXPECT_EQ(report().at("model").at("stages")[0].at("end"), "unstable");
}

TEST_F(TrueStatements, AHistoryThatCannotBeReadCostsItsTableOnly) {
  std::ofstream(folder_ / "history.csv") << "time [s],mass [kg]\n0,1\n";
  std::ofstream(folder_ / "monitors.csv") << "time [s],P_1, right.velocity_x [m/s]\n0,1\n";
  const json document = report();
  ASSERT_EQ(document.at("tables").size(), 1u);
  ASSERT_EQ(document.at("warnings").size(), 1u);
  EXPECT_CONTAINS(document["warnings"][0].get<std::string>(), "Monitors during the stages is not shown: ");
}

TEST_F(TrueStatements, AMonitorKeepsItsName) {
  std::ofstream(folder_ / "monitors.csv") << "time [s],P_1.b.displacement_x [mm]\n0,1\n";
  EXPECT_EQ(report().at("tables")[0].at("columns")[0].at("title"), "P_1.b: displacement x");
}

TEST(ShownNumbers, AreWrittenAsPeopleWriteThem) {
  EXPECT_EQ(show_number(0), "0");
  EXPECT_EQ(show_number(3.226), "3.23");
  EXPECT_EQ(show_number(-0.061), "−0.061");
  EXPECT_EQ(show_number(12345.6), "12346");
  EXPECT_EQ(show_number(4.06e-6), "4.06 × 10⁻⁶");
  EXPECT_EQ(show_number(2.5e12), "2.5 × 10¹²");
  EXPECT_EQ(show_number(std::nan("")), "–");
}

TEST(KilledRuns, HaveTheirMeshAndTheFinishedStages) {
  const fs::path folder = make_test_folder("killed_mesh");
  const json summary = run_small_case(folder);
  fs::remove(folder / "summary.json");
  std::ofstream(folder / "stages.json") << json{{"stages", {summary.at("stages")[0]}}, {"warnings", {"look out"}}};
  const json document = collect_report(folder).document.get();
  EXPECT_EQ(find_schema_faults(document), "");
  const json& mesh = document.at("model").at("mesh");
  for (const char* key : {"nodes", "elements", "points", "mean_size", "smallest_altitude"})
    EXPECT_EQ(mesh.at(key), summary.at("mesh").at(key)) << key;
  ASSERT_EQ(document.at("model").at("stages").size(), 1u);
  EXPECT_EQ(document["model"]["stages"][0]["name"], "gravity");
  EXPECT_EQ(document.at("warnings"), json::array({"look out"}));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace talus::report
