// SPDX-License-Identifier: MIT
// A study of runs: onset and displacement of the monitors relative to the reference, and sections.

#include <cmath>

#include "output/files/history.hpp"
#include "run/mpm/record/motion.hpp"
#include "study_slope.hpp"
#include "support/run_json.hpp"
#include "support/sliding_bank.hpp"

namespace talus::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(StudyOfRuns, ListsMotionOverThatOfTheReference) {
  const StudyPlan plan = plan_text(sliding_banks);
  ASSERT_EQ(plan.variants.size(), 2u) << "15° is the base case";
  EXPECT_EQ(plan.reference, 0u) << "also under the name that equals the base case";
  const fs::path folder = make_test_folder();
  const auto rows = run_study(plan, write_to(folder));
  ASSERT_FALSE(find_failure(rows));
  const auto table = make_study_table(plan, rows);
  const results::StudyColumn onset = get_column(table, "onset of toe"), u = get_column(table, "displacement of crest"),
                             ratio = get_column(table, "displacement of crest over that of base");
  EXPECT_EQ(onset.unit, "s");
  const double weak = std::stod(u.cells[0].full), strong = std::stod(u.cells[1].full);
  EXPECT_LT(strong, weak) << "friction holds it back";
  EXPECT_EQ(ratio.cells[0].full, "1");
  EXPECT_NEAR(std::stod(ratio.cells[1].full), strong / weak, 1e-12);
  // The onset is where monitors.csv passes 5 cm, after the start of the stage.
  const double start = rows[0].result->stages->at(1).start;
  const auto history = output::read_history(folder / "base" / "monitors.csv");
  const auto column = std::find_if(history.columns.begin(), history.columns.end(),
                                   [](const output::Column& c) { return c.name == "toe.displacement"; });
  ASSERT_NE(column, history.columns.end());
  const auto& toe = history.values[static_cast<std::size_t>(column - history.columns.begin())];
  std::size_t i = 0;
  while (history.values[0][i] <= start || toe[i] <= 50) ++i;
  const double at = std::stod(onset.cells[0].full) + start;
  EXPECT_LE(at, history.values[0][i]);
  EXPECT_GE(at, history.values[0][i - 1]);
  EXPECT_GT(std::stod(get_column(table, "runout beyond the toe").cells[0].full), 0);
  EXPECT_FALSE(get_column(table, "order of movement").cells[0].full.empty());
}

TEST(StudyOfRuns, RefusesAReferenceThatIsNoVariant) {
  try {
    plan_text(sliding_banks, {{"study.reference", "friction_angle = 20 deg"}});
    FAIL() << "the reference is no variant";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'friction_angle = 25 deg'"), std::string::npos) << error.what();
  }
}

TEST(Sections, HoldTheStressUnderTheWeightOfTheSoil) {
  run::RunOptions options;
  options.folder = make_test_folder();
  const json summary = support::run_case(input::read_case_text(sliding_bank, "bank.toml", {}), options);
  EXPECT_EQ(summary.at("sections")[0].at("width"), 1.0);
  const auto table = output::read_history(options.folder / "sections" / "A.csv");
  const auto get = [&](const char* name) {
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      if (table.columns[c].name == name) return table.values[c];
    ADD_FAILURE() << name;
    return std::vector<double>(table.values[0].size());
  };
  const double start = summary.at("clock").at("start");
  int rows = 0;
  for (std::size_t i = 0; i < table.values[0].size(); ++i) {
    if (table.values[0][i] != start) continue;
    ++rows;
    EXPECT_EQ(get("displacement_y")[i], 0) << "they are counted from here";
    EXPECT_NEAR(get("stress_yy")[i], -0.6 * 2650 * 9.81 * (5 - get("y")[i]), 0.25 * 0.6 * 2650 * 9.81 * 5);
  }
  EXPECT_EQ(rows, 5);
  // With another section a finished run is not calculated again, and has its table.
  options.resume = true;
  const auto time = fs::last_write_time(options.folder / "monitors.csv");
  const json again =
      support::run_case(input::read_case_text(sliding_bank, "bank.toml",
                                              {{"output.section.0.name", "B"}, {"output.onset_displacement", "1 m"}}),
                        options);
  EXPECT_TRUE(fs::exists(options.folder / "sections" / "B.csv"));
  EXPECT_GT(again.at("motion").at("threshold").get<double>(), summary.at("motion").at("threshold").get<double>());
  EXPECT_EQ(fs::last_write_time(options.folder / "monitors.csv"), time);
}

}  // namespace
}  // namespace talus::study
