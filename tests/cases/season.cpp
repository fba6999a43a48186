// SPDX-License-Identifier: MIT
// The example of a season by `talus run`: the water budget of the month, the start of the run at its end, and no effect
// on a run without a season.

#include "cases/water_run.hpp"

namespace talus {
namespace {

const char* const example = "../season_before_a_storm/case.toml";

/// The greatest suction at the start of the run [kPa].
double find_largest_start(const WaterRun& run) {
  const auto pressure = take(run.frame(0), "pore_pressure");  // positive in compression
  return -1e-3 * *std::min_element(pressure.begin(), pressure.end());
}

std::vector<input::Override> shorten(const std::string& season) {
  return {{"mesh.size", "0.5"},
          {"initial.season", season},
          {"stage.before the storm.duration", "0.01"},
          {"stage.before the storm.until", "time"},
          {"stage.storm.duration", "0.05"}};
}

TEST(Season, MonthsWeatherAddsUpAndIsWhereTheRunBegins) {
  const WaterRun run(example, shorten("30 day"));
  const nlohmann::json& season = run.summary.at("season");
  EXPECT_LT(std::abs(season.at("error").get<double>()), 1e-8);
  // 14 m of ground: 20 days of 4 mm and 10 of 2 mm are the potential; 6 h of 1 mm/h and 6 h of 2 mm/h fall.
  EXPECT_NEAR(season.at("potential").get<double>(), 14 * 0.1, 1e-9);
  const double drawn = season.at("transpired").get<double>(), in = season.at("inflow").get<double>(),
               out = season.at("outflow").get<double>(), growth = season.at("growth").get<double>();
  EXPECT_NEAR(in + season.at("runoff").get<double>(), 14 * 0.018, 1e-9);
  EXPECT_GT(drawn, 0.3 * 1.4);
  EXPECT_LT(drawn, 1.4);
  EXPECT_NEAR(in - out - drawn, growth, 1e-8 * drawn);
  EXPECT_LT(run.budget_error, 1e-11);

  const output::HistoryTable table = output::read_history(run.path("season.csv"));
  ASSERT_EQ(table.values[0].size(), 101u);
  EXPECT_EQ(table.values[0].front(), -30 * 86400.0);
  EXPECT_EQ(table.values[0].back(), 0);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const std::string& name = table.columns[c].name;
    const double last = table.values[c].back();
    EXPECT_EQ(last, name == "transpired" ? drawn : name == "stored" ? growth : last);
  }
  // The driest node of the season's end is a bound of the points' suctions at the start of the run.
  double driest = 0;
  for (const auto& layer : season.at("layers")) driest = std::max(driest, layer.at("greatest").get<double>() / 1e3);
  const double start = find_largest_start(run);
  EXPECT_LE(start, driest);
  EXPECT_GT(start, 0.6 * driest);
}

TEST(Season, WithoutOneThePlantsHaveNotDried) {
  const WaterRun without(example, shorten("0 day"));
  EXPECT_FALSE(without.summary.contains("season"));
  EXPECT_FALSE(std::filesystem::exists(without.path("season.csv")));
  const double still = find_largest_start(without);
  EXPECT_LT(still, 35) << "hydrostatic over 3.5 m";
  const WaterRun run(example, shorten("30 day"));
  EXPECT_GT(find_largest_start(run), 1.2 * still);
}

}  // namespace
}  // namespace talus
