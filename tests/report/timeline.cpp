// SPDX-License-Identifier: MIT
// The report of a run with a timeline: the smallest factor over time comes first, and its figure contains all times.

#include <algorithm>
#include <fstream>

#include "output/files/frames_reader.hpp"
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
  EXPECT_EQ(find_schema_faults(page), "");
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
  // In words as well, before the bounds at time 0.
  const auto& sentences = document.at("answer").at("sentences");
  EXPECT_EQ(sentences[0], timeline.at("sentence"));
  EXPECT_TRUE(std::any_of(sentences.begin() + 1, sentences.end(), [](const nlohmann::json& sentence) {
    return sentence.get<std::string>().starts_with("At time 0 limit analysis of the soil of limit equilibrium");
  })) << sentences;
  for (std::size_t i = 1; i < factors.size(); ++i) EXPECT_FALSE(factors[i].at("main").get<bool>());
  std::filesystem::remove_all(folder);
}

TEST(TimelineReport, HasThePointsOfEveryReleaseWhereTheyCameToLie) {
  const std::filesystem::path folder = make_test_folder("released");
  std::ifstream file(TALUS_SOURCE_DIR "/tests/ranks/release.toml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  run::RunOptions options;
  options.folder = folder;
  options.overwrite = true;
  support::run_case(input::read_case_text(text, "case.toml", {{"lem.referee", "false"}}), options);
  const ReadPage page(read_text(write_report(folder)));
  EXPECT_EQ(find_schema_faults(page), "");
  std::vector<std::string> ids, titles;
  for (const auto& sequence : page.document.at("sequences")) {
    ids.push_back(sequence.at("id"));
    titles.push_back(sequence.at("title"));
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"stages", "released_earlier", "released_later"}));
  EXPECT_EQ(titles.front(), "Released at 12 h");
  for (const std::string& id : ids) {
    const std::filesystem::path results = id == "stages" ? folder : folder / id;
    const output::ResultsReader reader(results);
    const output::Frame last = reader.read(reader.size() - 1);
    const auto& sequence = page.sequence(id);
    const auto positions = page.values(sequence.at("positions"));
    const std::size_t count = sequence.at("point_count"), start = (sequence.at("frames").size() - 1) * count;
    ASSERT_EQ(count, last.ids.size());
    // A thousandth of an element of 0.7 m.
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t d = 0; d < 2; ++d)
        ASSERT_NEAR(positions[2 * (start + i) + d], last.positions[3 * i + d], 0.0007) << id;
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace talus::report
