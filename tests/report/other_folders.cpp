// SPDX-License-Identifier: MIT
// Reports of unfinished runs, of studies, and of folders without results.

#include "base/error.hpp"
#include "report/report.hpp"
#include "report_page.hpp"
#include "schema.hpp"
#include "small_run.hpp"
#include "study/study.hpp"

namespace talus::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string find_refusal(const fs::path& folder) {
  try {
    write_report(folder);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    return error.what();
  }
  return "";
}

TEST(OtherFolders, AFolderThatIsNoResultIsRefused) {
  const fs::path folder = make_test_folder("nothing");
  EXPECT_NE(find_refusal(folder).find("is no folder of results"), std::string::npos);
  EXPECT_NE(find_refusal(folder / "absent").find("there is no folder"), std::string::npos);
  fs::create_directories(folder / "frames");  // a run that was killed before its first frame
  EXPECT_NE(find_refusal(folder).find("is no folder of results"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "report.html"));
  fs::remove_all(folder);
}

TEST(OtherFolders, ResultsOfAnotherVersionAreRefused) {
  const fs::path folder = make_test_folder("another_version");
  for (const auto& [text, version] : {std::pair{R"({"title": "Old"})", "1"}, std::pair{R"({"format": 9})", "9"}}) {
    std::ofstream(folder / "summary.json") << text;
    EXPECT_EQ(find_refusal(folder), "'" + (folder / "summary.json").string() +
                                        "' was written by another version of Talus (result format " + version +
                                        ", this is 2): run the case again");
  }
  fs::remove_all(folder);
}

TEST(OtherFolders, ARunThatWasKilledShowsWhatItLeft) {
  const fs::path folder = make_test_folder("killed");
  const json summary = run_small_case(folder);
  // The files after a kill: no summary, no curve, the last trial without its result.
  fs::remove(folder / "summary.json");
  fs::remove(folder / "curve.csv");
  fs::remove(folder / "trials" / "srf_1.8000" / "trial.json");
  const ReadPage page(read_text(write_report(folder)));
  EXPECT_EQ(find_schema_faults(page), "");
  EXPECT_EQ(page.results.at("result").at("status"), "unfinished");
  EXPECT_NE(page.document.at("answer").at("sentences")[0].get<std::string>().find("has not finished"),
            std::string::npos);
  const json& points = page.results.at("result").at("curve").at("points");
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0].at("displacement"), summary.at("curve").at("points")[0].at("displacement"));
  EXPECT_EQ(page.sequence("stages").at("point_count"), summary.at("mesh").at("points"));
  EXPECT_EQ(page.document.at("model").at("dimension"), 2);
  fs::remove_all(folder);
}

TEST(OtherFolders, AnInterruptedRunGivesTheReason) {
  const fs::path folder = make_test_folder("interrupted");
  std::ofstream(folder / "summary.json")
      << R"({"format": 2, "title": "Cut", "status": "unstable", "error": "stage 'slide' became unstable at t = 2 s",
             "mesh": {"dimension": 3, "nodes": 8, "elements": 6, "points": 24}})";
  const ReadPage page(read_text(write_report(folder)));
  EXPECT_EQ(find_schema_faults(page), "");
  EXPECT_EQ(page.results.at("result").at("status"), "unstable");
  EXPECT_EQ(page.results.at("result").at("error"), "stage 'slide' became unstable at t = 2 s");
  EXPECT_NE(page.document.at("answer").at("sentences")[0].get<std::string>().find("became unstable"),
            std::string::npos);
  EXPECT_TRUE(page.document.at("sequences").empty());
  fs::remove_all(folder);
}

TEST(OtherFolders, AStudyShowsItsTableAndItsCurves) {
  const fs::path folder = make_test_folder("study");
  const std::string text = small_case +
                           "[study]\nmode = \"one_at_a_time\"\n[[study.vary]]\n"
                           "key = \"strength_reduction.curve.damping\"\nvalues = [0.01, 0.2]\n";
  const std::vector<input::Override> overrides{{"strength_reduction.frozen.enabled", "false"},
                                               {"strength_reduction.curve.runout", "[]"}};
  const study::StudyPlan plan = study::plan_study(input::read_case_text(text, "small.toml", overrides), overrides);
  study::StudyOptions options;
  options.folder = folder / "results";
  options.threads = 2;
  const auto rows = study::run_study(plan, options);
  const ReadPage page(read_text(write_report(options.folder)));
  EXPECT_EQ(find_schema_faults(page), "");
  EXPECT_EQ(page.document.at("kind"), "study");
  EXPECT_EQ(page.results.at("result").at("status"), "finished");
  const json& study = page.document.at("study");
  ASSERT_EQ(study.at("rows").size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const json& points = study.at("rows")[i].at("curve").at("points");
    EXPECT_EQ(points.back().at("displacement"), rows[i].result->curve->points.back().displacement);
  }
  for (const json& c : study.at("columns")) {
    ASSERT_EQ(c.at("values").size(), rows.size());
    if (c.at("name") == "points") {
      EXPECT_EQ(c.at("values")[0], rows[0].result->mesh->points);
    }
    if (c.at("name") == "result") {
      EXPECT_TRUE(c.at("values")[0].is_null()) << "a word has no value";
    }
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace talus::report
