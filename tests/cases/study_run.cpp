// SPDX-License-Identifier: MIT
// Studies of a coarse slope: table rows, resumption, and failed variants.

#include <cmath>

#include "base/progress.hpp"
#include "study_slope.hpp"
#include "support/run_json.hpp"

namespace talus::study {
namespace {

namespace fs = std::filesystem;

/// Displacement [m] at `factor` in a curve.csv.
double read_displacement(const fs::path& path, const std::string& factor) {
  const std::string text = read_text(path);
  const auto at = text.find("\n" + factor + ",");
  EXPECT_NE(at, std::string::npos) << path;
  return at == std::string::npos ? NAN : std::stod(text.substr(at + factor.size() + 2));
}

TEST(Study, TableHoldsWhatEachVariantAloneGives) {
  const StudyPlan plan = plan_text(cohesion_study);
  const fs::path folder = make_test_folder();
  const auto rows = run_study(plan, write_to(folder));
  EXPECT_FALSE(find_failure(rows));
  const auto table = make_study_table(plan, rows);
  EXPECT_EQ(table.front().name, "variant");
  EXPECT_EQ(table.back().name, "result");
  const results::StudyColumn cohesion = get_column(table, "materials.sand.cohesion");
  const results::StudyColumn small = get_column(table, "displacement at SRF 1.4"),
                             large = get_column(table, "displacement at SRF 2");
  EXPECT_EQ(cohesion.unit, "kPa");
  EXPECT_EQ(small.unit, "mm");
  const std::string cohesions[] = {"2", "4", "8"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(cohesion.cells[i].full, cohesions[i]);
    EXPECT_EQ(get_column(table, "result").cells[i].full, "finished");
    // The case calculated alone, by several threads, is bitwise identical.
    run::RunOptions alone;
    alone.folder = folder.string() + "_alone_" + cohesions[i];
    alone.threads = 2;
    fs::remove_all(alone.folder);
    support::run_case(input::read_case_text(coarse_slope, "slope.toml", {{"materials.sand.cohesion", cohesions[i]}}),
                      alone);
    EXPECT_EQ(std::stod(small.cells[i].full), read_displacement(alone.folder / "curve.csv", "1.4") / 0.001);
    EXPECT_EQ(std::stod(large.cells[i].full), read_displacement(alone.folder / "curve.csv", "2") / 0.001);
  }
  // Cohesion holds a slope: the more, the less it moves.
  for (const results::StudyColumn& u : {small, large})
    for (std::size_t i = 1; i < 3; ++i) EXPECT_LT(std::stod(u.cells[i].full), std::stod(u.cells[i - 1].full)) << u.name;

  const std::string csv = read_text(folder / "study.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
  EXPECT_EQ(
      csv.rfind("variant,materials.sand.cohesion [kPa],displacement at SRF 1.4 [mm],displacement at SRF 2 [mm],", 0),
      0u);
  EXPECT_NE(csv.find("\ncohesion_4_kPa,4," + small.cells[1].full + "," + large.cells[1].full + ","), std::string::npos)
      << csv;
  EXPECT_NE(read_text(folder / "study.md").find("| cohesion = 8 | 8 | " + small.cells[2].shown + " |"),
            std::string::npos);
  EXPECT_NE(read_text(folder / "study.svg").find("cohesion = 8"), std::string::npos) << "the legend names the variants";
}

TEST(Study, ResumingRunsNothingThatIsFinished) {
  const StudyPlan plan = plan_text(cohesion_study);
  const fs::path folder = make_test_folder();
  run_study(plan, write_to(folder));
  const std::string tables = read_text(folder / "study.csv");
  std::vector<std::pair<fs::path, fs::file_time_type>> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().parent_path() != folder)
      files.emplace_back(entry.path(), entry.last_write_time());
  ASSERT_GT(files.size(), 9u);
  const auto rows = run_study(plan, write_to(folder, true));
  for (const StudyRow& row : rows) EXPECT_TRUE(row.kept);
  EXPECT_FALSE(find_failure(rows));
  for (const auto& [path, time] : files) EXPECT_EQ(fs::last_write_time(path), time) << path;
  EXPECT_EQ(read_text(folder / "study.csv"), tables) << "wall times are those of the first run";
}

TEST(Study, ResumingRunsWhatIsMissing) {
  const fs::path folder = make_test_folder();
  const StudyPlan plan = plan_text(cohesion_study);
  run_study(plan, write_to(folder));
  const std::string curve = read_text(folder / "cohesion_8" / "curve.csv");
  const auto untouched = fs::last_write_time(folder / "base" / "summary.json");
  fs::remove_all(folder / "cohesion_8");
  const auto rows = run_study(plan, write_to(folder, true));
  EXPECT_TRUE(rows[0].kept && rows[1].kept);
  EXPECT_FALSE(rows[2].kept);
  EXPECT_EQ(read_text(folder / "cohesion_8" / "curve.csv"), curve);
  EXPECT_EQ(fs::last_write_time(folder / "base" / "summary.json"), untouched);
}

TEST(Study, InterruptedStartsNoOtherVariantAndResumesLater) {
  const fs::path folder = make_test_folder();
  const StudyPlan plan = plan_text(cohesion_study);
  request_interrupt();
  auto rows = run_study(plan, write_to(folder));
  request_interrupt(false);
  for (const StudyRow& row : rows) EXPECT_EQ(row.summary.status, results::VariantStatus::not_started);
  ASSERT_TRUE(find_failure(rows));
  EXPECT_EQ(find_failure(rows)->code(), ExitCode::interrupted);
  rows = run_study(plan, write_to(folder, true));
  EXPECT_FALSE(find_failure(rows));
}

TEST(Study, AVariantThatFailsLeavesTheOthersAlone) {
  // Under a hundred million g the first steps are faster than any wave.
  const StudyPlan plan = plan_text(coarse_slope + R"(
[study]
factors = [1.4]

[[study.vary]]
key = "gravity.acceleration"
values = [1e9, 8]
)");
  const fs::path folder = make_test_folder();
  const auto rows = run_study(plan, write_to(folder));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].summary.status, results::VariantStatus::finished);
  EXPECT_EQ(rows[1].summary.status, results::VariantStatus::unstable);
  EXPECT_EQ(rows[2].summary.status, results::VariantStatus::finished);
  const auto failure = find_failure(rows);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->code(), ExitCode::unstable);
  EXPECT_NE(std::string(failure->what()).find("1 of 3 variants did not finish"), std::string::npos) << failure->what();
  const std::string page = read_text(folder / "study.md");
  EXPECT_NE(page.find("- acceleration = 1000000000.0: the calculation became unstable in stage 'gravity'"),
            std::string::npos)
      << page;
  const auto table = make_study_table(plan, rows);
  const results::StudyColumn u = get_column(table, "displacement at SRF 1.4");
  EXPECT_TRUE(u.cells[1].full.empty());
  EXPECT_LT(std::stod(u.cells[2].full), std::stod(u.cells[0].full)) << "less weight, less displacement";
}

TEST(Study, RefusesAFolderInUseAndResultsOfAnotherInput) {
  const fs::path folder = make_test_folder();
  fs::create_directories(folder);
  std::ofstream(folder / "notes.txt") << "mine";
  const StudyPlan plan = plan_text(cohesion_study);
  try {
    run_study(plan, write_to(folder));
    ADD_FAILURE() << "the folder was used";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::folder_exists);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
  fs::remove(folder / "notes.txt");
  run_study(plan, write_to(folder));
  const auto before = fs::last_write_time(folder / "study.csv");
  try {
    run_study(plan_text(cohesion_study, {{"materials.sand.friction_angle", "25"}}), write_to(folder, true));
    ADD_FAILURE() << "results of two inputs were mixed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    EXPECT_NE(std::string(error.what()).find("'base', 'cohesion_4_kPa', 'cohesion_8'"), std::string::npos)
        << error.what();
  }
  EXPECT_EQ(fs::last_write_time(folder / "study.csv"), before);
}

TEST(Study, ListsRunoutsForCasesWithoutStrengthReduction) {
  std::string text = cohesion_study;
  text.replace(text.find("\"strength_reduction\""), 20, "\"run\"");
  text.erase(text.find("factors ="), text.find("\n", text.find("factors =")) - text.find("factors ="));
  // Hardly any friction: the slope flows, and cohesion holds some of it back.
  // One mesh: two of these sizes leave the front open.
  const StudyPlan plan = plan_text(text, {{"materials.sand.friction_angle", "5"},
                                          {"output.runout_meshes", "1"},
                                          {"stage.gravity.duration", "2"},
                                          {"stage.gravity.until", "time"},
                                          {"stage.gravity.damping", "0"}});
  const auto rows = run_study(plan, write_to(make_test_folder()));
  EXPECT_FALSE(find_failure(rows));
  const auto table = make_study_table(plan, rows);
  const results::StudyColumn front = get_column(table, "front advance"), u = get_column(table, "largest displacement");
  EXPECT_EQ(front.unit, "m");
  for (std::size_t i = 1; i < 3; ++i) EXPECT_LT(std::stod(u.cells[i].full), std::stod(u.cells[i - 1].full));
  EXPECT_GT(std::stod(front.cells[0].full), 0);
  for (const results::StudyColumn& c : table) EXPECT_EQ(c.name.find("FoS"), std::string::npos);
}

/// Sets with a resistance factor are comparable by F/γ_R alone, and a factor that governs stands under its own method.
TEST(Study, OfPartialFactorsListsTheRatioToTheResistanceFactor) {
  const std::string text =
      support::write_slope("dry", {"analysis.methods=['lem']", "lem.methods=['janbu_corrected', 'corps_1']",
                                   "lem.search=none", "lem.referee=false", "lem.yield_acceleration=false"}) +
      "[[lem.surface]]\nname = \"arc\"\ncentre = [30, 35]\nradius = 31\n"
      "[partial_factors]\nset = \"DA2\"\n"
      "[study]\n[[study.vary]]\nkey = \"partial_factors.set\"\nvalues = [\"AASHTO-0.65\", \"none\"]\n";
  const StudyPlan plan = plan_text(text);
  const auto table = make_study_table(plan, run_study(plan, write_to(make_test_folder())));
  const results::StudyColumn factor = get_column(table, "FoS, governing"),
                             ratio = get_column(table, "over-design factor F/γ_R");
  ASSERT_EQ(factor.cells.size(), 3u);
  const auto read = [](const results::StudyCell& cell) { return std::stod(cell.full); };
  EXPECT_NEAR(read(ratio.cells[0]), read(factor.cells[0]) / 1.1, 1e-12);
  EXPECT_NEAR(read(ratio.cells[1]), read(factor.cells[1]) * 0.65, 1e-12);
  EXPECT_TRUE(ratio.cells[2].full.empty());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_TRUE(std::any_of(table.begin(), table.end(), [&](const results::StudyColumn& c) {
      return c.name != factor.name && c.cells[i].full == factor.cells[i].full;
    })) << i;
}

}  // namespace
}  // namespace talus::study
