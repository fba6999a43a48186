// SPDX-License-Identifier: MIT
// A bank of 2 m with steady seepage and rain, from its case file to its results: the flow remains steady, the water
// budget closes, and fixed pore pressures carry their part of the weight.

#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/parallel.hpp"
#include "output/files/frames_reader.hpp"
#include "output/files/history.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class WetBank : public testing::Test {
 protected:
  json run(const std::vector<input::Override>& overrides) {
    run::RunOptions options;
    options.folder = folder_;
    options.threads = default_threads();
    options.overwrite = true;
    return support::run_case(input::read_case_text(support::write_slope("wet_bank"), "bank.toml", overrides), options);
  }
  const fs::path folder_ = support::name_scratch("wet_bank");
};

double get(const json& summary, const std::string& name) {
  for (const json& r : summary.at("results"))
    if (r.at("name") == name) return r.at("value").get<double>();
  ADD_FAILURE() << "no result " << name;
  return NAN;
}

/// Σ of the last values of the columns that end so.
double sum_last(const output::HistoryTable& history, const std::string& ending) {
  double sum = 0;
  for (std::size_t c = 0; c < history.columns.size(); ++c)
    if (history.columns[c].name.ends_with(ending)) sum += history.values[c].back();
  return sum;
}

TEST_F(WetBank, SteadySeepageIsUnchangedWhenTheSoilIsReleased) {
  const json summary = run({});
  EXPECT_EQ(summary.at("stages")[0].at("end"), "rest");
  EXPECT_LT(summary.at("stages")[1].at("displacement").get<double>(), 1e-4) << "the bank is stable";
  EXPECT_LT(get(summary, "water.budget_error"), 1e-9);

  const output::HistoryTable history = output::read_history(folder_ / "history.csv");
  const double flow = summary.at("seepage").at("inflow");
  EXPECT_GT(flow, 1e-4);
  EXPECT_NEAR(sum_last(history, ".inflow"), flow, 0.1 * flow) << "steady seepage and MPM";
  EXPECT_NEAR(sum_last(history, ".outflow"), flow, 0.1 * flow);

  const output::ResultsReader frames(folder_);
  const output::Frame first = frames.read(0), last = frames.read(frames.size() - 1);
  const auto &before = output::find(first.point_fields, "pore_pressure")->values,
             &after = output::find(last.point_fields, "pore_pressure")->values;
  double squares = 0;
  for (std::size_t i = 0; i < before.size(); ++i) squares += (after[i] - before[i]) * (after[i] - before[i]);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(before.size())), 60) << "Pa, of up to 19 kPa";
  EXPECT_NEAR(*std::max_element(before.begin(), before.end()), 19e3, 1e3) << "positive in compression";
}

TEST_F(WetBank, SteadyRainInfiltratesAsInFem) {
  // 20 m/h are more than the soil takes: k is 3.6 m/h.
  const json summary = run({{"hydraulic.2.rate", "20000"}});
  const output::HistoryTable history = output::read_history(folder_ / "history.csv");
  const double enters = -get(summary, "seepage.discharge[crest]");
  EXPECT_NEAR(sum_last(history, "crest.inflow"), enters, 0.03 * enters);
  EXPECT_GT(sum_last(history, "crest.runoff"), 5 * enters);
}

TEST_F(WetBank, RainOnDrySoilEntersOrRunsOffAndIsAllCounted) {
  // Rain starts while the weight is applied at constant pressures; only rain during stages with moving water counts.
  const json summary = run({{"hydraulic.2.rate", "[[0, 0], [0.3, 0], [0.3, 20000]]"}});
  const json& stage = summary.at("stages")[1];
  const double lasts = stage.at("time").get<double>() - stage.at("start").get<double>();
  EXPECT_NEAR(lasts, 0.3, 1e-9);
  const double fell = 20.0 / 3600 * 4 * lasts, entered = get(summary, "water.inflow[crest]"),
               ran_off = get(summary, "water.runoff[crest]");
  // Half a side of the face belongs to the crest's last node.
  EXPECT_NEAR(entered + ran_off, fell * (1 + 0.5 * 0.17 / 4), 0.01 * fell);
  EXPECT_GT(entered, 1e-3 * 4 * lasts) << "at least under a unit gradient";
  EXPECT_LT(get(summary, "water.budget_error"), 1e-9);
  const json& water = summary.at("water");
  EXPECT_GT(water.at("stored").get<double>() - water.at("initial").get<double>(), 900 * entered);
}

}  // namespace
}  // namespace talus
