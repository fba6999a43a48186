// SPDX-License-Identifier: MIT
// The report of element tests satisfies the contract of the page, alone and together with a run.

#include <fstream>

#include "laboratory/point_test.hpp"
#include "report/report.hpp"
#include "report_page.hpp"
#include "schema.hpp"
#include "support/slopes.hpp"

namespace talus::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string soil = support::write_slope("sand", {"title=Sand"}) + R"(
[[test]]
name = "loose"
material = "sand"
kind = "drained_triaxial"
confining_pressure = 100
axial_strain = [0.02, 0.01, 0.04]
steps = 3000

[[test]]
name = "dense"
material = "sand"
kind = "drained_triaxial"
confining_pressure = 100
axial_strain = [0.02, 0.01, 0.04]
set = { friction_angle = 40 }

[[test]]
name = "too much"
material = "sand"
kind = "oedometer"
vertical_stress = 100
k0 = 0.5
axial_strain = 0.01
)";

void make_tests(const fs::path& folder) {
  const auto loaded = input::read_case_text(soil, "soil.toml", {}, input::CaseScope::whole_or_tests);
  laboratory::run_point_tests(loaded, {folder, {}, "svg"});
}

TEST(PointReport, OfTestsAloneKeepsTheContract) {
  const fs::path folder = make_test_folder("point_alone");
  make_tests(folder);
  const ReadPage page(read_text(write_report(folder)));
  EXPECT_EQ(find_schema_faults(page), "");
  EXPECT_EQ(page.document.at("kind"), "tests");
  EXPECT_EQ(page.results.at("result").at("status"), "finished");
  const json& tests = page.results.at("point_tests").at("tests");
  ASSERT_EQ(tests.size(), 3u);
  EXPECT_NEAR(tests[0]["peak_q"].get<double>(), 200e3, 1);
  EXPECT_EQ(tests[1]["set"], "friction_angle = 40");
  EXPECT_EQ(page.results["point_tests"]["groups"].size(), 2u) << "triaxial and compression";
  fs::remove_all(folder);
}

TEST(PointReport, CurvesAreThinnedButKeepTheirTurningPoints) {
  const fs::path folder = make_test_folder("point_thin");
  make_tests(folder);
  const json columns = collect_report(folder).document.get()["point_columns"];
  std::vector<double> strain, q;
  for (const json& column : columns[0]) {
    if (column["name"] == "axial_strain") strain = column["values"].get<std::vector<double>>();
    if (column["name"] == "q") q = column["values"].get<std::vector<double>>();
    EXPECT_EQ(column["unit"], column["name"] == "axial_strain" || column["name"] == "volumetric_strain" ? "%"
                              : column["name"] == "void_ratio"                                          ? "-"
                                                                                                        : "kPa");
  }
  ASSERT_EQ(strain.size(), q.size());
  EXPECT_LT(strain.size(), 300u);
  EXPECT_EQ(std::count(strain.begin(), strain.end(), 2.0), 1);
  EXPECT_GE(std::count(strain.begin(), strain.end(), 1.0), 1);
  EXPECT_EQ(strain.back(), 4.0);
  EXPECT_NEAR(q.back(), 200, 1e-3);
  fs::remove_all(folder);
}

TEST(PointReport, AFolderWithoutResultsIsReported) {
  const fs::path folder = make_test_folder("point_none");
  fs::create_directories(folder / "point");
  EXPECT_THROW(collect_report(folder), Error);
  std::ofstream(folder / "point" / "point.json") << "[]";
  try {
    collect_report(folder);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("point.json' is no result of Talus"), std::string::npos) << error.what();
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace talus::report
