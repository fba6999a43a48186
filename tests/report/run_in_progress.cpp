// SPDX-License-Identifier: MIT
// The report of a run in progress has what its methods have found so far; the folder of an ended run has no trace of
// it.

#include "base/progress.hpp"
#include "report/report.hpp"
#include "results/present.hpp"
#include "schema.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string three_methods = support::write_slope("dry", {"mesh.size=3"}) +
                                  R"(
[analysis]
methods = ["lem", "fem", "bounds"]

[lem]
methods = ["bishop"]
noncircular = false
referee = false

[fem]
size = 3
meshes = 1
resolution = 0.1

[bounds]
gap = 0.05
)";

/// Runs the case; `look` receives every value of progress.
json follow(const std::string& text, const fs::path& folder, bool keeps_present,
            const std::function<void(const ProgressValues&)>& look) {
  Progress progress(Progress::Listener([&](const ProgressReport& report) {
    if (!report.values.method.empty()) look(report.values);
  }));
  run::RunOptions options;
  options.folder = folder;
  options.keeps_present = keeps_present;
  options.progress = &progress;
  return support::run_case(input::read_case_text(text, "three.toml", {}), options);
}
/// The same of the case with three methods; `look` receives the method.
json run(const fs::path& folder, bool keeps_present, const std::function<void(const std::string&)>& look) {
  return follow(three_methods, folder, keeps_present, [&](const ProgressValues& values) { look(values.method); });
}

/// An earthquake acts in both directions, one after the other: bounds of the first one are not those of the case.
TEST(RunInProgress, BoundsOfOneDirectionAreNotThoseOfTheCase) {
  const fs::path folder = support::make_scratch("directions_in_progress");
  int meshes = 0;
  const json result =
      follow(three_methods + "[earthquake]\nhorizontal = 0.1\n", folder, true, [&](const ProgressValues& values) {
        if (values.method != "bounds") return;
        ++meshes;
        EXPECT_FALSE(values.lower || values.upper);
        EXPECT_FALSE(fs::exists(folder / results::present_bounds_file));
      });
  EXPECT_GT(meshes, 1);
  EXPECT_LT(result["bounds"]["lower"], result["bounds"]["upper"]);
}

TEST(RunInProgress, ReportHasTrialsFieldsAndBoundsSoFar) {
  const fs::path folder = support::make_scratch("run_in_progress");
  int trials = 0, meshes = 0;
  json reduction, bounds;
  run(folder, true, [&](const std::string& method) {
    // A value precedes its file, so that the second one finds the file of the first.
    if (method == "fem" && ++trials == 2) {
      const Content content = collect_report(folder);
      EXPECT_EQ(find_schema_faults(content.document.get()), "");
      reduction = content.document.get()["reduction"];
      EXPECT_GT(content.results.get()["result"]["lem"]["critical"][0]["factor"], 1);
      EXPECT_EQ(content.results.get()["result"]["status"], "unfinished");
    }
    if (method == "bounds" && ++meshes == 2) bounds = collect_report(folder).results.get()["result"]["bounds"];
  });
  EXPECT_EQ(reduction["trials"].size(), 1u);
  EXPECT_TRUE(reduction.contains("stable") || reduction.contains("failed")) << reduction;
  EXPECT_TRUE(reduction.contains("mesh") && reduction.contains("fields")) << reduction;
  EXPECT_LT(bounds["lower"], bounds["upper"]);
  EXPECT_FALSE(fs::exists(folder / results::present_folder));
  const Content ended = collect_report(folder);
  EXPECT_FALSE(ended.document.get().contains("reduction"));
  EXPECT_EQ(ended.results.get()["result"]["status"], "finished");
}

/// A lift of a day on clay, by elements of 2 m, with the factor at its end.
const char* const lift = R"(
title = "Lift"
[[geometry.polygon]]
name = "clay"
points = [[0, 0], [20, 0], [20, 6], [0, 6]]
[[geometry.polygon]]
name = "lift"
points = [[0, 6], [10, 6], [7, 8], [0, 8]]
[materials.clay]
model = "mohr_coulomb"
unit_weight = 17
porosity = 0.5
cohesion = 12
friction_angle = 24
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "4 MPa"
poisson_ratio = 0.33
[materials.clay.water]
retention = "saturated"
conductivity = "2e-9 m/s"
[materials.fill]
model = "mohr_coulomb"
unit_weight = 19
cohesion = 4
friction_angle = 33
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "20 MPa"
poisson_ratio = 0.3
[regions]
clay = "clay"
lift = "fill"
[initial]
stress = "k0"
k0 = 0.6
pore_pressure = "water_table"
water_table = [[0, 6], [20, 6]]
[analysis]
methods = ["fem"]
[fem]
size = 2
meshes = 1
resolution = 0.1
[[construction]]
name = "lift"
duration = 10
add = ["lift"]
)";

TEST(RunInProgress, ReportHasTheStepsOfAStage) {
  const fs::path folder = support::make_scratch("stage_in_progress");
  std::size_t steps = 0;
  Progress progress(Progress::Listener([&](const ProgressReport&) {
    if (steps > 0 || !fs::exists(folder / results::present_summary_file)) return;
    const json result = collect_report(folder).results.get()["result"];
    if (const auto found = result.find("construction"); found != result.end() && !(*found)["stages"].empty())
      steps = (*found)["stages"][0]["steps"].size();
  }));
  run::RunOptions options;
  options.folder = folder;
  options.keeps_present = true;
  options.progress = &progress;
  const json result = support::run_case(input::read_case_text(lift, "lift.toml", {}), options);
  EXPECT_GT(steps, 0u);
  // FEM at the end of the stage is a run of its own, which keeps nothing.
  EXPECT_GT(result["construction"]["least"], 0.5);
  EXPECT_FALSE(fs::exists(folder / "stage_1" / results::present_folder));

  const Content content = collect_report(folder);
  EXPECT_EQ(find_schema_faults(content.document.get()), "");
  const json& drawn = content.document.get()["construction_stages"];
  ASSERT_EQ(drawn["stages"].size(), 1U);
  EXPECT_EQ(drawn["stages"][0]["stage"], "lift");
  EXPECT_EQ(drawn["stages"][0]["displacement"]["shape"][0], drawn["nodes"]["shape"][0]);
  EXPECT_TRUE(drawn["stages"][0].contains("pressure"));
}

TEST(RunInProgress, SeepageStoresEveryState) {
  int stored = 0;
  run::RunOptions options;
  options.folder = support::make_scratch("seepage_in_progress");
  options.store_present = [&] { ++stored; };
  const json result = support::run_case(input::read_case_text(R"(
analysis.methods = ["seepage"]
mesh.size = 0.5
geometry.polygon = [{ name = "sand", points = [[0, 0], [4, 0], [4, 2], [0, 2]] }]
geometry.line = [{ name = "ground", points = [[0, 2], [4, 2]] }]
regions.sand = "sand"
materials.sand = { unit_weight = 20, porosity = 0.4, water = { retention = "saturated", conductivity = 1e-4 } }
hydraulic = [
  { on = "bottom", condition = "total_head", head = [[0, 3], ["2 day", 5]] },
  { on = "ground", condition = "total_head", head = 2 }]
seepage.times = [1, 2]
)",
                                                              "flow.toml", {}),
                                        options);
  EXPECT_EQ(result["flow"]["states"].size(), 3u);  // the first one is the steady state at the start
  EXPECT_EQ(stored, 2);
}

TEST(RunInProgress, RunThatIsNotAskedKeepsNothing) {
  const fs::path folder = support::make_scratch("run_not_asked");
  run(folder, false, [&](const std::string&) { EXPECT_FALSE(fs::exists(folder / results::present_folder)); });
}

TEST(RunInProgress, DataOfThePageAreThoseOfTheReport) {
  const fs::path folder = support::make_scratch("data_of_page");
  run(folder, false, [](const std::string&) {});
  const json data = json::parse(write_data(folder));
  const Content content = collect_report(folder);
  // NaN becomes null in a file.
  EXPECT_TRUE(data["report"] == json::parse(content.document.write()));
  EXPECT_TRUE(data["results"] == json::parse(content.results.write()));
  EXPECT_EQ(data["arrays"].size(), content.arrays.size());
}

}  // namespace
}  // namespace talus::report
