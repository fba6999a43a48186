// SPDX-License-Identifier: MIT
// A slope whose critical surfaces end in a dry crack that the search added: the report draws and lists it.

#include "report/report.hpp"
#include "report_page.hpp"
#include "schema.hpp"
#include "support/run_json.hpp"

namespace talus::report {
namespace {

/// The steep slope of tests/physics/lem_lost_circles.cpp.
constexpr const char* steep = R"(
[[geometry.polygon]]
name = "soil"
points = [[0, 0], [35.773503, 0], [35.773503, 15], [20.773503, 15], [15, 5], [0, 5]]
[materials.clay]
model = "mohr_coulomb"
unit_weight = 20
cohesion = "33.066704 kPa"
friction_angle = 11.947134
[regions]
soil = "clay"
[analysis]
methods = ["lem"]
[lem]
methods = ["spencer"]
noncircular = false
referee = false
)";

TEST(AddedCrackReport, DrawsAndListsTheCrackOfTheSearch) {
  const std::filesystem::path folder = make_test_folder("added_crack");
  run::RunOptions options;
  options.folder = folder;
  options.overwrite = true;
  const auto summary = support::run_case(input::read_case_text(steep, "case.toml", {}), options);
  const double depth = summary.at("lem").at("critical")[0].at("crack").get<double>();
  const ReadPage page(read_text(write_report(folder)));
  EXPECT_EQ(find_schema_faults(page), "");
  const auto& model = page.document.at("model");
  EXPECT_NEAR(model.at("crack").at("depth").get<double>(), depth, 1e-9);
  EXPECT_EQ(model.at("crack").at("water"), 0);
  EXPECT_NE(model.at("loads").dump().find("the search added a dry crack"), std::string::npos);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace talus::report
