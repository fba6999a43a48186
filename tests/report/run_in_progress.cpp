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

/// Runs the case; `look` receives the method of every value of progress.
json run(const fs::path& folder, bool keeps_present, const std::function<void(const std::string&)>& look) {
  Progress progress(Progress::Listener([&](const ProgressReport& report) {
    if (!report.values.method.empty()) look(report.values.method);
  }));
  run::RunOptions options;
  options.folder = folder;
  options.keeps_present = keeps_present;
  options.progress = &progress;
  return support::run_case(input::read_case_text(three_methods, "three.toml", {}), options);
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
