// SPDX-License-Identifier: MIT
// The report of a study of runs: movement of the monitors, sections and pictures of each variant.

#include <cmath>

#include "output/files/frames_reader.hpp"
#include "output/files/history.hpp"
#include "report/report.hpp"
#include "report_page.hpp"
#include "results/json.hpp"
#include "schema.hpp"
#include "study/study.hpp"
#include "support/sliding_bank.hpp"

namespace talus::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class ReportOfRuns : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = make_test_folder("study_of_runs");
    const study::StudyPlan plan = study::plan_study(input::read_case_text(sliding_banks, "bank.toml", {}), {});
    study::StudyOptions options;
    options.folder = folder_ / "results";
    options.threads = 2;
    rows_ = study::run_study(plan, options);
    page_ = std::make_unique<ReadPage>(read_text(write_report(options.folder)));
    run_ = std::make_unique<ReadPage>(read_text(write_report(options.folder / "base")));
  }
  static void TearDownTestSuite() {
    fs::remove_all(folder_);
    page_.reset();
    run_.reset();
  }
  static const json& study() { return page_->document.at("study"); }

  inline static fs::path folder_;
  inline static std::vector<study::StudyRow> rows_;
  inline static std::unique_ptr<ReadPage> page_, run_;
};

TEST_F(ReportOfRuns, KeepsTheContract) {
  EXPECT_EQ(find_schema_faults(*page_), "");
  EXPECT_EQ(find_schema_faults(*run_), "");
  EXPECT_EQ(page_->results.at("study_result").at("reference"), "base");
}

TEST_F(ReportOfRuns, ShowsThePathsOfItsMonitors) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const json& row = study().at("rows")[i];
    EXPECT_EQ(row.at("motion").at("monitors"), results::to_json(*rows_[i].result).at("motion").at("monitors"));
    const json& paths = row.at("paths");
    EXPECT_EQ(paths.at("time")[0], 0);
    EXPECT_NEAR(paths.at("time").back().get<double>(), 1.5, 1e-9);
    for (std::size_t m = 0; m < 2; ++m)
      EXPECT_NEAR(paths.at("paths")[m].at("displacement").back().get<double>(),
                  row.at("motion").at("monitors")[m].at("displacement").get<double>(), 1e-12);
  }
}

TEST_F(ReportOfRuns, ShowsSectionsAtTimesOfTheClock) {
  const json& section = study().at("rows")[0].at("sections")[0];
  EXPECT_EQ(section.at("name"), "A");
  ASSERT_GE(section.at("profiles").size(), 3u);
  EXPECT_NEAR(section.at("profiles")[0].at("time").get<double>(), 0, 1e-9);
  EXPECT_NEAR(section.at("profiles").back().at("time").get<double>(), 1.5, 1e-9);
  const auto table = output::read_history(folder_ / "results" / "base" / "sections" / "A.csv");
  const auto& fields = section.at("fields");
  for (std::size_t f = 0; f < fields.size(); ++f) {
    std::size_t column = 0;
    while (table.columns[column].name != fields[f].at("name")) ++column;
    EXPECT_EQ(section.at("profiles").back().at("values")[f].back(), table.values[column].back())
        << fields[f].at("name");
  }
  EXPECT_EQ(run_->document.at("sections")[0].at("profiles"), section.at("profiles"));
}

TEST_F(ReportOfRuns, PutsPicturesSideBySide) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const json& frames = study().at("rows")[i].at("frames");
    const json& sequence = page_->sequence(frames.at("sequence"));
    ASSERT_EQ(frames.at("clock").size(), sequence.at("frames").size());
    EXPECT_EQ(frames.at("pictures").front(), 0);
    EXPECT_EQ(frames.at("pictures").back(), frames.at("clock").size() - 1);
    EXPECT_NEAR(frames.at("clock").back().get<double>(), 1.5, 1e-9);
    std::set<std::string> names;
    for (const json& f : sequence.at("fields")) names.insert(f.at("name"));
    EXPECT_TRUE(names.contains("deviatoric_strain"));
    EXPECT_FALSE(names.contains("stress_xx")) << "a study shows what its pictures need";
  }
}

TEST_F(ReportOfRuns, DescribesTheOrderOfMovementInWords) {
  const std::string sentence = rows_[0].result->motion->sentence;
  bool in_study = false, in_run = false;
  for (const json& s : page_->document.at("answer").at("sentences"))
    in_study = in_study || s.get<std::string>() == "base: " + sentence;
  for (const json& s : run_->document.at("answer").at("sentences")) in_run = in_run || s == sentence;
  EXPECT_TRUE(in_study) << sentence;
  EXPECT_TRUE(in_run) << sentence;
}

}  // namespace
}  // namespace talus::report
