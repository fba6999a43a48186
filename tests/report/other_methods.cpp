// SPDX-License-Identifier: MIT
// Reports of LEM and FEM, with and without MPM, against the results.

#include "report/report.hpp"
#include "report_page.hpp"
#include "schema.hpp"
#include "support/run_json.hpp"
#include "support/slopes.hpp"

namespace talus::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Two soils, water, a surcharge; few circles and large elements, so that it takes a second.
const std::string layered_case =
    support::write_slope(
        "dry",
        {"title=Layered slope", "geometry.box=[[0, 0], [44, 15]]", "geometry.line=[]",
         "geometry.polygon=[{ name = 'base', points = [[0, 0], [44, 0], [44, 5], [32, 5], [0, 5]] }, "
         "{ name = 'slope', points = [[0, 5], [32, 5], [12, 15], [0, 15]] }]",
         "regions={ base = 'sand', slope = 'silt' }",
         "materials.sand={ model = 'mohr_coulomb', unit_weight = 19, saturated_unit_weight = 20, "
         "young_modulus = '45 MPa', poisson_ratio = 0.3, cohesion = 5, friction_angle = 30, dilatancy_angle = 0, "
         "tensile_strength = 0 }",
         "materials.silt={ model = 'mohr_coulomb', unit_weight = 18, saturated_unit_weight = 19.5, "
         "young_modulus = '45 MPa', poisson_ratio = 0.3, cohesion = 8, friction_angle = 26, dilatancy_angle = 0, "
         "tensile_strength = 0 }",
         "mesh.size=2.5"}) +
    R"(
[initial]
pore_pressure = "water_table"
water_table = [[0, 11], [12, 9], [32, 5], [44, 5]]

[[surcharge]]
name = "road"
x = [2, 8]
load = ["10 kPa", "10 kPa"]

[analysis]
methods = ["lem", "fem"]

[lem]
methods = ["bishop", "spencer"]
noncircular = false

[lem.entry_exit]
exits = 8
entries = 8
depths = 6

[[lem.surface]]
name = "toe"
centre = [28, 28]
radius = 23

[fem]
resolution = 0.1
)";

json run(const fs::path& folder, const std::vector<input::Override>& overrides = {}) {
  run::RunOptions options;
  options.folder = folder;
  options.overwrite = true;
  return support::run_case(input::read_case_text(layered_case, "layered.toml", overrides), options);
}

class OtherMethods : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new fs::path(make_test_folder("other_methods"));
    summary_ = new json(run(*folder_));
    page_ = new ReadPage(read_text(write_report(*folder_)));
  }
  static void TearDownTestSuite() {
    fs::remove_all(*folder_);
    delete page_;
    delete summary_;
    delete folder_;
  }

  static const json& document() { return page_->document; }
  static bool names_method(const std::string& name) {
    for (const json& m : document().at("methods"))
      if (m == name) return true;
    return false;
  }

  static fs::path* folder_;
  static json* summary_;
  static ReadPage* page_;
};
fs::path* OtherMethods::folder_ = nullptr;
json* OtherMethods::summary_ = nullptr;
ReadPage* OtherMethods::page_ = nullptr;

TEST_F(OtherMethods, KeepTheContractWithoutMaterialPoints) {
  EXPECT_EQ(find_schema_faults(*page_), "");
  for (const char* key : {"sequences", "tables"}) EXPECT_TRUE(document().at(key).empty()) << key;
  EXPECT_TRUE(document().at("model").at("stages").empty());
  EXPECT_EQ(document().at("model").at("bounds"), json::parse("[[0, 0], [44, 15]]")) << "no box: around the polygons";
  for (const char* name : {"limit_equilibrium", "bishop", "spencer", "slip_search", "finite_elements", "mohr_coulomb"})
    EXPECT_TRUE(names_method(name)) << name;
  for (const char* name : {"material_point_method", "time_step", "fellenius"}) EXPECT_FALSE(names_method(name)) << name;
  for (const json& sentence : document().at("assumptions"))
    for (const char* word : {"first stage", "smoothing", "frozen", "Runout"})
      EXPECT_EQ(sentence.get<std::string>().find(word), std::string::npos) << sentence;
}

TEST_F(OtherMethods, NameOneFactorOfEachAndTheSmallestGoverns) {
  std::vector<double> main;
  double least = 1e9;
  std::string governing;
  for (const json& f : document().at("answer").at("factors")) {
    if (f.at("main") == true) main.push_back(f.at("value"));
    if (f.at("main") == true && f.at("method") == "lem") governing = f.at("name");
    if (f.at("method") == "lem" && f.at("by") != "bishop" && !f.at("value").is_null())
      least = std::min(least, f.at("value").get<double>());
    if (f.at("method") == "fem") {
      EXPECT_EQ(f.at("measure"), f.at("lower").is_null() ? "displacement" : "equilibrium") << "which has no bracket";
    }
    EXPECT_EQ(f.at("name").get<std::string>().find("surface["), std::string::npos) << "given surfaces are no answer";
  }
  ASSERT_EQ(main.size(), 2u);
  EXPECT_EQ(main[0], least);
  EXPECT_EQ(document().at("methods_read").at("governing"), governing);
  EXPECT_EQ(main[1], summary_->at("fem").at("runs")[0].at("factor"));
  std::vector<json> surfaces;
  for (const char* list : {"critical", "noncircular", "given"})
    for (const json& surface : summary_->at("lem").at(list)) surfaces.push_back(surface);
  for (const json& surface : summary_->at("methods").at("optimised")) surfaces.push_back(surface);
  EXPECT_EQ(surfaces.at(document().at("slices").at("governing")).at("factor"), least);
  // The strength at failure belongs to the main factor of the run, as does the over-design factor.
  const double stands = summary_->at("main_factor");
  EXPECT_EQ(stands, std::min(main[0], main[1]));
  for (const json& soil : document().at("model").at("materials"))
    for (const json& p : soil.at("properties"))
      if (p.at("key") == "cohesion") {
        EXPECT_NEAR(p.at("at_failure").get<double>() * stands, p.at("characteristic").get<double>(), 1e-9);
      }
}

TEST_F(OtherMethods, KeepTheAnswerShortAndTheReadingInItsPart) {
  std::vector<std::string> result;
  for (const json& group : document().at("methods_read").at("reading"))
    for (const json& sentence : group.at("sentences")) result.push_back(sentence);
  const json& remarks = summary_->at("methods").at("remarks");
  ASSERT_FALSE(remarks.empty());
  EXPECT_EQ(result.size(), remarks.size()) << "every sentence in one group";
  for (const json& remark : remarks)
    EXPECT_EQ(std::count(result.begin(), result.end(), remark.at("text").get<std::string>()), 1) << remark;
  const json& sentences = document().at("answer").at("sentences");
  EXPECT_LE(sentences.size(), 4u) << sentences;
  for (const json& sentence : sentences)
    EXPECT_EQ(std::count(result.begin(), result.end(), sentence.get<std::string>()), 0) << "repeated: " << sentence;
}

TEST_F(OtherMethods, GroupTheReadingByWhatItIsAbout) {
  const fs::path folder = make_test_folder("grouped_reading");
  json summary = *summary_;
  summary["methods"]["remarks"] = json::array();
  for (const char* topic : {"agreement", "slices", "mechanism", "slices", "elements", "seconds"})
    summary["methods"]["remarks"].push_back({{"topic", topic}, {"text", std::string("A sentence on ") + topic}});
  std::ofstream(folder / "summary.json") << summary.dump();
  const ReadPage page(read_text(write_report(folder)));
  std::vector<std::pair<std::string, std::size_t>> groups;
  for (const json& group : page.document.at("methods_read").at("reading"))
    groups.emplace_back(group.at("topic"), group.at("sentences").size());
  const std::vector<std::pair<std::string, std::size_t>> expected{
      {"Agreement", 1}, {"LEM", 2}, {"Mechanism", 1}, {"FEM", 1}, {"Computing time", 1}};
  EXPECT_EQ(groups, expected);
  fs::remove_all(folder);
}

TEST_F(OtherMethods, AreInTheUnitsOfTheCase) {
  const fs::path folder = make_test_folder("other_methods_pounds");
  run(folder, {{"analysis.methods", "[\"lem\"]"},
               {"output.stress_unit", "psf"},
               {"output.length_unit", "ft"},
               {"output.displacement_unit", "in"}});
  const ReadPage page(read_text(write_report(folder)));
  fs::remove_all(folder);
  EXPECT_EQ(find_schema_faults(page), "");
  const json& units = page.document.at("units");
  EXPECT_EQ(units.at("line_force").at("name"), "plf");
  EXPECT_NEAR(units.at("line_force").at("si").get<double>(), 4.4482216152605 / 0.3048, 1e-9);
  // 18 kN/m³ and 8 kPa.
  std::map<std::string, json> rows;
  for (const json& row : page.document.at("model").at("materials").at(1).at("properties")) rows[row.at("key")] = row;
  EXPECT_EQ(rows.at("unit_weight").at("unit"), "pcf");
  EXPECT_NEAR(rows.at("unit_weight").at("characteristic").get<double>(), 18000 / 157.08746384624618, 1e-6);
  EXPECT_EQ(rows.at("cohesion").at("unit"), "psf");
  EXPECT_NEAR(rows.at("cohesion").at("characteristic").get<double>(), 8000 / 47.880258980335840, 1e-6);
  EXPECT_EQ(rows.at("young_modulus").at("unit"), "ksf");
}

TEST_F(OtherMethods, ReportTheDifferenceOfTheMethods) {
  const auto describe = [&](double elements) {
    const fs::path folder = make_test_folder("agreement");
    json summary = *summary_;
    double spencer = 0;
    summary["methods"].erase("optimised");
    for (json& row : summary["methods"]["table"])
      if (row["surface"] == "lem.spencer") spencer = row["factor"];
    for (json& row : summary["methods"]["table"])
      if (row["method"] == "fem") row["factor"] = elements * spencer;
    std::ofstream(folder / "summary.json") << summary.dump();
    const ReadPage page(read_text(write_report(folder)));
    fs::remove_all(folder);
    return page.document.at("answer").at("sentences").at(1).get<std::string>();
  };
  EXPECT_EQ(describe(1.0001), "The two methods agree to three digits.");
  EXPECT_EQ(describe(0.99), "The two methods agree to 1.0 %.");
  EXPECT_EQ(describe(1.05), "The methods lie within 5.0 % of each other.");
}

TEST_F(OtherMethods, SlicesAreInVerticalBalance) {
  // Bishop neglects X: N cosα + T sinα of every slice carries its weight and load.
  const json& s = summary_->at("lem").at("critical")[0].at("slices");
  for (std::size_t i = 0; i < s.at("left").size(); ++i) {
    const auto get = [&](const char* key) { return s.at(key)[i].get<double>(); };
    const double down = get("weight") + get("surface_load");
    const double up = get("normal") * std::cos(get("alpha")) + get("shear") * std::sin(get("alpha"));
    EXPECT_NEAR(up, down, 1e-6 * std::max(down, 1e3)) << i;
  }
}

TEST_F(OtherMethods, TrialsAreThoseOfTheSearch) {
  const json& trials = document().at("slices").at("trials");
  const json file = json::parse(read_text(*folder_ / "lem.json"));
  const std::vector<double> circles = page_->values(trials.at("circles")),
                            factors = page_->values(trials.at("factors"));
  ASSERT_EQ(circles.size(), 5 * file.at("trials").size());
  ASSERT_EQ(factors.size(), 2 * file.at("trials").size());
  for (std::size_t i = 0; i < file.at("trials").size(); ++i) {
    EXPECT_NEAR(circles[5 * i + 2], file["trials"][i][2].get<double>(), 1e-4);
    EXPECT_NEAR(factors[2 * i + 1], file["trials"][i][6].get<double>(), 1e-4);
  }
}

TEST_F(OtherMethods, FieldsOfTheElementsComeBack) {
  const json& fields = document().at("finite_elements").at("fields")[0];
  const json file = json::parse(read_text(*folder_ / "fem.json"));
  const std::vector<double> strain = page_->values(fields.at("shear_strain"));
  const json& stored = file.at("runs")[0].at("shear_strain");
  ASSERT_EQ(strain.size(), stored.size());
  const double step = (fields["shear_strain"]["range"][1].get<double>()) / 65534;
  for (std::size_t i = 0; i < strain.size(); ++i) ASSERT_NEAR(strain[i], stored[i].get<double>(), step);
  const std::vector<double> nodes = page_->values(document()["finite_elements"]["mesh"]["nodes"]);
  EXPECT_NEAR(nodes.back(), file.at("nodes").back()[1].get<double>(), 1e-5);
}

TEST_F(OtherMethods, ADamagedFileCostsItsPicturesOnly) {
  const fs::path folder = make_test_folder("damaged_methods");
  fs::copy(*folder_, folder, fs::copy_options::recursive);
  std::ofstream(folder / "lem.json") << "{\"trials\": [[1, 2";
  std::ofstream(folder / "fem.json") << R"({"nodes": [[0, 0], [1, 0]], "elements": [[0, 1, 2, 3, 4, 5]], "runs": []})";
  const ReadPage page(read_text(write_report(folder)));
  EXPECT_EQ(find_schema_faults(page), "");
  EXPECT_FALSE(page.document.at("slices").contains("trials"));
  EXPECT_FALSE(page.document.contains("finite_elements"));
  EXPECT_EQ(page.results, page_->results);
  std::string warnings;
  for (const json& w : page.document.at("warnings")) warnings += w.get<std::string>() + "\n";
  EXPECT_NE(warnings.find("The trial surfaces are not shown"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("The fields of FEM are not drawn: an element names the node 2 of 2"), std::string::npos)
      << warnings;
  fs::remove_all(folder);
}

TEST_F(OtherMethods, AMethodWithoutAFactorGivesTheReason) {
  const fs::path folder = make_test_folder("failed_method");
  json summary = *summary_;
  summary["fem"] = {{"error", "no equilibrium at any factor"}, {"warnings", json::array()}};
  summary["methods"]["table"] = json::array();
  std::ofstream(folder / "summary.json") << summary.dump();
  const ReadPage page(read_text(write_report(folder)));
  EXPECT_EQ(find_schema_faults(page), "");
  EXPECT_EQ(page.results.at("result").at("fem").at("error"), "no equilibrium at any factor");
  EXPECT_EQ(page.document.at("answer").at("sentences").at(0), "No method found a factor of safety.");
  fs::remove_all(folder);
}

TEST(ExtrapolatedStudy, ReportsTheFactorAtSizeZeroFirst) {
  const fs::path folder = make_test_folder("extrapolated");
  const auto factor = [](const std::string& by, const json& factors, const json& error) {
    return json{{"criterion", "FoS, " + by}, {"by", by},       {"variant", ""},           {"sizes", {1.0, 0.5, 0.25}},
                {"factors", factors},        {"linear", 1.39}, {"standard_error", error}, {"finest_pair", 1.388},
                {"order", nullptr}};
  };
  const json factors{factor("Spencer", {1.44, 1.44, 1.44}, 0.0), factor("frozen", {1.46, 1.43, 1.41}, 0.004)};
  std::ofstream(folder / "study.json") << json{
      {"format", 2},
      {"title", "Meshes"},
      {"variants", json::array({{{"name", "base"}, {"status", "finished"}}})},
      {"extrapolation", {{"key", "mesh.size"}, {"unit", "m"}, {"factors", factors}}}};
  const ReadPage page(read_text(write_report(folder)));
  EXPECT_EQ(find_schema_faults(page), "");
  EXPECT_EQ(page.document.at("answer").at("sentences").at(0),
            "Extrapolated to mesh.size = 0, the factor of safety is 1.390 ± 0.004 (frozen).")
      << "the size is not a variable of LEM: nothing is extrapolated";
  fs::remove_all(folder);
}

TEST(SampledStudy, ReportsItsProbabilityFirst) {
  const fs::path folder = make_test_folder("sampled");
  const json failure{{"limit", 1},      {"count", 24},     {"samples", 1000},    {"probability", 0.024},
                     {"lower", 0.0154}, {"upper", 0.0355}, {"confidence", 0.95}, {"index", 1.977}};
  json sampling{{"samples", 1000},    {"seed", 3},         {"plan", "random"},
                {"failure", failure}, {"factor", nullptr}, {"tornado", nullptr}};
  sampling["numbers"] = json::array({{{"key", "materials.clay.cohesion"}, {"name", "cohesion"}, {"lowest", nullptr}}});
  std::ofstream(folder / "study.json") << json{
      {"format", 2},           {"title", "Uncertain"},     {"mode", "sample"},
      {"vary", json::array()}, {"columns", json::array()}, {"variants", json::array()},
      {"sampling", sampling}};
  const ReadPage page(read_text(write_report(folder)));
  EXPECT_EQ(find_schema_faults(page), "");
  EXPECT_EQ(page.results.at("result").at("status"), "finished");
  EXPECT_EQ(page.document.at("answer").at("sentences")[0],
            "The probability of failure is 2.4 %, between 1.5 % and 3.5 % with 95 % confidence; the reliability index "
            "is 1.98.");
  EXPECT_EQ(page.document.at("methods"), json({"sampling"})) << "nothing else is known of it";
  EXPECT_TRUE(page.results.at("study_result").at("sampling").at("factor").is_null());
  fs::remove_all(folder);
}

/// The same slope by LEM and limit analysis alone.
TEST(BoundsInReports, KeepTheContractAndAreShownOutward) {
  const fs::path folder = make_test_folder("bounds_report");
  const json summary = run(folder, {{"analysis.methods", "[\"lem\", \"bounds\"]"},
                                    {"bounds.gap", "0.15"},
                                    {"bounds.triangles", "400"},
                                    {"bounds.size", "3"}});
  const ReadPage page(read_text(write_report(folder)));
  const json& document = page.document;
  EXPECT_EQ(find_schema_faults(page), "");
  const json &bounds = summary.at("bounds"), &shown = document.at("proven_bounds");
  const double lower = bounds.at("lower"), upper = bounds.at("upper");
  ASSERT_TRUE(shown.contains("holds") && shown.contains("moves"));
  EXPECT_EQ(shown.at("holds").at("utilisation").at("shape")[0], shown.at("holds").at("triangles").at("shape")[0]);
  int rows = 0;
  for (const json& factor : document.at("answer").at("factors"))
    if (factor.at("method") == "bounds") {
      ++rows;
      EXPECT_TRUE(factor.at("value").is_null()) << "an interval is no factor";
      EXPECT_LE(factor.at("lower").get<double>(), lower);
      EXPECT_GE(factor.at("upper").get<double>(), upper);
    }
  EXPECT_EQ(rows, 1);
  bool is_stated = false;
  for (const json& sentence : document.at("answer").at("sentences"))
    is_stated = is_stated || sentence.get<std::string>().find(" by limit analysis.") != std::string::npos;
  EXPECT_TRUE(is_stated);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace talus::report
