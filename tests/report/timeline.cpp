// SPDX-License-Identifier: MIT
// The report of a run with a timeline: the least factor in time stands first, and its figure has all times.

#include <fstream>

#include "report/report.hpp"
#include "report_page.hpp"
#include "schema.hpp"
#include "support/run_json.hpp"

namespace talus::report {
namespace {

TEST(TimelineReport, LeadsWithTheLeastFactorAndKeepsTheContract) {
  const std::filesystem::path folder = make_test_folder("timeline");
  std::ifstream file(TALUS_SOURCE_DIR "/examples/reservoir_drawdown/case.toml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  run::RunOptions options;
  options.folder = folder;
  options.overwrite = true;
  const auto summary = support::run_case(input::read_case_text(text, "case.toml",
                                                               {{"mesh.size", "1.5"},
                                                                {"timeline.times", "['1 day', '10 day']"},
                                                                {"lem.entry_exit.entries", "6"},
                                                                {"lem.entry_exit.exits", "6"}}),
                                         options);
  const ReadPage page(read_text(write_report(folder)));
  const nlohmann::json& document = page.document;
  EXPECT_EQ(find_schema_faults(document), "");
  const auto& timeline = document.at("timeline");
  ASSERT_EQ(timeline.at("factors").size(), 3u);
  EXPECT_EQ(timeline.at("states").size(), 3u);
  EXPECT_EQ(timeline.at("unit").at("name"), "days");
  EXPECT_TRUE(timeline.contains("water_mesh"));
  for (const auto& state : timeline.at("states")) EXPECT_TRUE(state.at("fields").contains("pressure"));
  const auto& factors = document.at("answer").at("factors");
  EXPECT_EQ(factors[0].at("name"), "timeline.least");
  EXPECT_TRUE(factors[0].at("main"));
  EXPECT_EQ(factors[0].at("value"), summary.at("main_factor"));
  for (std::size_t i = 1; i < factors.size(); ++i) EXPECT_FALSE(factors[i].at("main").get<bool>());
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace talus::report
