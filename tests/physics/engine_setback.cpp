// SPDX-License-Identifier: MIT
// A stage that becomes unstable returns to its last good state and is repeated with a smaller step; records of the
// discarded part are removed.

#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.hpp"
#include "mpm/solver/observe.hpp"
#include "output/files/history.hpp"
#include "run/mpm/record/recorder.hpp"
#include "run/mpm/stage/stage.hpp"
#include "support/box_case.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

mpm::Body<2> make_column(const input::Case& data) {
  auto mesh =
      support::make_box_mesh<2>({6, 6}, {1.2, 1.2}, {"soil"}, [](const Vec<2>& x) { return x[1] < 0.8 ? 0 : -1; });
  return run::prepare<2>(data, std::move(mesh));
}

TEST(Retry, AStepBeyondTheStableOneIsHalvedUntilItIsStable) {
  const input::Case data = support::make_box_case<2>(support::make_elastic(10e6));
  mpm::Body<2> body = make_column(data), calm = make_column(data);
  run::StageState state;
  EXPECT_EQ(run::run_stage(body, support::make_stage(data, body, 2, {.damping = 0.5, .courant = 3}), state),
            results::StageEnd::time);
  ASSERT_GE(state.setbacks.size(), 1u);
  ASSERT_LE(state.setbacks.size(), run::most_setbacks);
  for (std::size_t i = 0; i < state.setbacks.size(); ++i) {
    const results::Retry& s = state.setbacks[i];
    EXPECT_DOUBLE_EQ(s.courant, 3 * std::pow(0.5, static_cast<double>(i + 1)));
    EXPECT_LT(s.back_to, s.time);
    EXPECT_NE(s.reason.find("m/s"), std::string::npos) << s.reason;
  }
  EXPECT_NEAR(body.time, 2, 1e-9);
  // At rest both bear the same weight, whatever happened on the way.
  support::run_plan(calm, support::make_stage(data, calm, 2, {.damping = 0.5, .courant = 0.5}));
  const double settled = mpm::find_largest_displacement(calm).value;
  EXPECT_GT(settled, 0);
  EXPECT_NEAR(mpm::find_largest_displacement(body).value, settled, 1e-2 * settled);
}

TEST(Retry, TheSmoothingThatMayBeTheCauseIsLeftOut) {
  run::StagePlan<2> plan;
  plan.step.courant = 0.8;
  const auto smooth = [&](input::Smoothing asked, std::size_t setbacks, bool wet) {
    plan.step.smoothing = asked;
    plan.step.water = input::WaterMotion::flows;
    return run::make_retry_plan(plan, setbacks, wet).step.smoothing;
  };
  using input::Smoothing;
  EXPECT_EQ(smooth(Smoothing::stable, 0, true), Smoothing::stable);
  EXPECT_EQ(smooth(Smoothing::stable, 1, true), Smoothing::none) << "two-velocity formulation and averaged stress";
  EXPECT_EQ(smooth(Smoothing::strain, 1, false), Smoothing::stable);
  EXPECT_EQ(smooth(Smoothing::stable, 1, false), Smoothing::stable) << "dry: first only a smaller step";
  EXPECT_EQ(smooth(Smoothing::stable, 2, false), Smoothing::none);
  EXPECT_EQ(smooth(Smoothing::none, 3, true), Smoothing::none);
  EXPECT_DOUBLE_EQ(run::make_retry_plan(plan, 3, false).step.courant, 0.1);
}

TEST(Retry, HistoriesHoldNothingOfWhatWasLost) {
  const fs::path folder = support::make_scratch("setback") / "run";
  input::Case data = support::make_box_case<2>(support::make_elastic(10e6));
  data.output.history_interval = 0.002;
  mpm::Body<2> body = make_column(data);
  const run::StagePlan<2> plan = support::make_stage(data, body, 0.5, {.damping = 0.5, .courant = 3});
  run::RecorderSettings settings;
  settings.folder = folder;
  settings.data = &data;
  settings.frame_interval = 0.01;
  run::StageState state;
  auto recorder = run::Recorder<2>::start(settings, body);
  const auto hooks = recorder.begin_leg(0, plan, body, state);
  run::run_stage(body, plan, state, hooks);
  recorder.end_leg(body);
  recorder.finish(true);
  ASSERT_FALSE(state.setbacks.empty());
  const output::HistoryTable history = output::read_history(folder / "history.csv");
  const auto column = [&](const std::string& name) {
    for (std::size_t c = 0; c < history.columns.size(); ++c)
      if (history.columns[c].name == name) return history.values[c];
    return std::vector<double>{};
  };
  const std::vector<double> time = column("time"), speed = column("nodal_speed"), step = column("time_step");
  ASSERT_GT(time.size(), 100u);
  for (std::size_t i = 1; i < time.size(); ++i) {
    EXPECT_GT(time[i], time[i - 1]);
    EXPECT_LT(time[i] - time[i - 1], 0.01) << "no gap either";
    EXPECT_LT(speed[i], 1) << "at " << time[i];
  }
  EXPECT_NEAR(step.back(), state.dt, 1e-3 * state.dt) << "the smaller step, not the one that was asked for";
  const output::ResultsReader frames(folder);
  for (int i = 1; i < frames.size(); ++i) EXPECT_GT(frames.times()[i], frames.times()[i - 1]);
}

}  // namespace
}  // namespace talus
