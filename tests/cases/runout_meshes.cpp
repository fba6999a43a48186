// SPDX-License-Identifier: MIT
// Runout on two meshes: the coarser run equals the case with elements of twice the size, and resumes after an
// interruption.

#include <fstream>

#include "base/progress.hpp"
#include "cases/methods_slope.hpp"

namespace talus {
namespace {

using nlohmann::json;

class RunoutMeshes : public MethodsTest {
 protected:
  void TearDown() override {
    request_interrupt(false);
    MethodsTest::TearDown();
  }

  /// The column of sand that docs/verification_data/column_collapse.md refines, for a second.
  json collapse(const std::string& size, std::vector<input::Override> more = {}, bool resume = false) {
    std::ifstream file(TALUS_SOURCE_DIR "/tests/data/misleading/granular_column.toml");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    more.push_back({"mesh.size", size});
    more.push_back({"stage.collapse.duration", "1"});
    return run(text, more, resume);
  }
};

TEST_F(RunoutMeshes, TheCoarserIsTheCaseWithElementsTwiceAsLarge) {
  const json fine = collapse("0.1").at("runout");
  const json& out = fine.at("coarser_mesh");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "coarser_mesh" / "summary.json"));
  const json coarse = collapse("0.2", {{"output.runout_meshes", "1"}}).at("runout");
  EXPECT_FALSE(coarse.contains("coarser_mesh"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "coarser_mesh")) << "of the run that this one overwrote";
  EXPECT_EQ(out.at("size"), 0.2);
  for (const char* key :
       {"front_advance", "toe_distance", "crest_retreat", "moved_volume", "deposit_volume", "highest_ground"})
    EXPECT_EQ(out.at(key), coarse.at(key)) << key;
  EXPECT_GT(fine.at("front_advance"), coarse.at("front_advance")) << "a finer mesh has a thinner front";
}

TEST_F(RunoutMeshes, ColumnsThatDoNotMoveAreNotRunTwice) {
  const json run = collapse("0.2", {{"materials.sand.cohesion", "50 kPa"}});
  EXPECT_EQ(run.at("runout").at("moved_volume"), 0);
  EXPECT_FALSE(run.at("runout").contains("coarser_mesh"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "coarser_mesh"));
}

TEST_F(RunoutMeshes, AnInterruptionInTheCoarserOneKeepsTheFinerOne) {
  const json whole = collapse("0.1");
  std::filesystem::remove_all(folder_);
  int stages = 0;
  Progress progress([&](const ProgressReport& report) {
    if (report.line.find("the runout on elements of 0.2 m") != std::string::npos) request_interrupt();
    if (report.stage == "collapse" && report.label.empty()) ++stages;
  });
  progress_ = &progress;
  EXPECT_THROW(collapse("0.1"), Error);
  request_interrupt(false);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "checkpoint.h5"));
  stages = 0;
  Progress later([&](const ProgressReport& report) {
    if (report.stage == "collapse" && report.label.empty()) ++stages;
  });
  progress_ = &later;
  const json resumed = collapse("0.1", {}, true);
  EXPECT_EQ(stages, 0) << "the finer run was at its end";
  EXPECT_EQ(resumed.at("runout"), whole.at("runout"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "checkpoint.h5")) << "of a finished run";
}

TEST_F(RunoutMeshes, AFailureOfTheCoarserOneIsAWarning) {
  std::filesystem::create_directories(folder_);
  FileList{folder_};  // a run that was stopped has left it
  std::ofstream(folder_ / "coarser_mesh") << "a file where a folder should be";
  const json run = collapse("0.2", {}, true);
  EXPECT_EQ(run.at("status"), "finished");
  EXPECT_FALSE(run.at("runout").contains("coarser_mesh"));
  const std::string warning = run.at("warnings").back();
  EXPECT_NE(warning.find("have no interval, because the mesh with elements of 0.4 m failed: "), std::string::npos)
      << warning;
}

TEST_F(RunoutMeshes, TrialsThatRunOutHaveTwoMeshesEach) {
  std::ifstream file(TALUS_SOURCE_DIR "/examples/dry_slope/case.toml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const json result = run(text, {{"mesh.size", "2"},
                                 {"strength_reduction.frozen.enabled", "false"},
                                 {"strength_reduction.curve.to", "1.75"},
                                 {"strength_reduction.curve.step", "0.75"},
                                 {"strength_reduction.curve.refine", "false"},
                                 {"strength_reduction.curve.window", "1"},
                                 {"strength_reduction.curve.runout", "[1.75]"},
                                 {"strength_reduction.curve.runout_time", "3"}});
  ASSERT_EQ(result.at("runouts").size(), 1u);
  const json& runout = result.at("runouts")[0].at("runout");
  EXPECT_GT(runout.at("moved_volume"), 0);
  EXPECT_EQ(runout.at("coarser_mesh").at("size"), 4);
  EXPECT_EQ(runout.at("coarser_mesh").at("moved_volume"), 0) << "the locking of large elements holds the slope";
  const auto keys = runout.at("undetermined").get<std::vector<std::string>>();
  EXPECT_NE(std::find(keys.begin(), keys.end(), "moved_volume"), keys.end());
  for (const json& entry : result.at("results"))
    if (entry.at("name") == "runout[1.75].moved_volume") {
      EXPECT_TRUE(entry.at("value").is_null());
      EXPECT_NE(entry.at("undetermined").get<std::string>().find("not determined (two meshes: "), std::string::npos);
    }
}

}  // namespace
}  // namespace talus
