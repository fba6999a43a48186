// SPDX-License-Identifier: MIT
// Onset of movement: crossing of the threshold, order of the monitors, and the sentence on it.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "input/case/result_names.hpp"
#include "results/run.hpp"
#include "run/common/head.hpp"
#include "run/mpm/record/motion.hpp"
#include "support/scratch.hpp"

namespace talus::run {
namespace {

namespace fs = std::filesystem;

TEST(Onset, IsWhereTheLineBetweenRowsPassesTheThreshold) {
  const std::vector<double> time{0, 10, 20, 30}, u{0, 0.01, 0.05, 0.04};
  EXPECT_DOUBLE_EQ(*find_onset(time, u, 0.03), 15);
  EXPECT_FALSE(find_onset(time, u, 0.05)) << "reached, not exceeded";
  EXPECT_DOUBLE_EQ(*find_onset(time, u, 0.045), 18.75) << "the first time, though it comes back";
  const std::vector<double> lost{0, 0.01, NAN, 1};
  EXPECT_FALSE(find_onset(time, lost, 0.03)) << "what is missing is not guessed";
}

constexpr double threshold = 0.15, failure = 0.45, row = 0.1;

/// A history of 20 s with the displacement `u(t)`.
MovementOnset find_onset_of(const std::function<double(double)>& u) {
  std::vector<double> time, displacement;
  for (int i = 0; i <= 200; ++i) {
    time.push_back(row * i);
    displacement.push_back(u(row * i));
  }
  return find_movement_onset(time, displacement, threshold, failure);
}

/// Displacement of a block that is let go at `start` with the constant acceleration 2 m/s².
double slide(double t, double start) {
  return t > start ? (t - start) * (t - start) : 0;
}

const double until_threshold = std::sqrt(threshold);  // [s], of that block

TEST(MovementOnset, OfABlockIsTheTimeAtWhichItPassesTheThreshold) {
  for (const double start : {0.0, 3.0, 7.0}) {
    const MovementOnset onset = find_onset_of([&](double t) { return slide(t, start); });
    EXPECT_NEAR(onset.time.value(), start + until_threshold, 0.01);
    EXPECT_FALSE(onset.settled);
  }
}

TEST(MovementOnset, IsThatOfTheSlideAfterASettlement) {
  // It settles by 0.2 m within a second, and slides from 7 s.
  const MovementOnset onset = find_onset_of([](double t) { return 0.2 * (1 - std::exp(-t / 0.25)) + slide(t, 7); });
  EXPECT_NEAR(onset.time.value(), 7 + until_threshold, 0.02);
  EXPECT_NEAR(onset.settled.value(), 0.2, 1e-3);
}

TEST(MovementOnset, IsThatOfTheSlideAfterAnOscillation) {
  // An elastic oscillation about 0.2 m, of 0.2 m at first, with a period of 2 s and a damping ratio of 5 %.
  const auto settle = [](double t) { return 0.2 * (1 - std::exp(-0.05 * 3.14 * t) * std::cos(3.14 * t)); };
  const MovementOnset onset = find_onset_of([&](double t) { return settle(t) + slide(t, 7); });
  // It is at least as late as the threshold over the middle, and at most by the overshoot of 0.37 m later.
  EXPECT_GT(onset.time.value(), 7);
  EXPECT_LT(onset.time.value(), 7 + std::sqrt(threshold + 0.2));
  EXPECT_NEAR(onset.settled.value(), settle(1), 0.01);
}

TEST(MovementOnset, IsNotThatOfASettlementAlone) {
  const MovementOnset onset = find_onset_of([](double t) { return 0.2 * (1 - std::exp(-t / 0.25)); });
  EXPECT_FALSE(onset.time);
  EXPECT_NEAR(onset.settled.value(), 0.2, 1e-3);
  const MovementOnset none = find_onset_of([](double) { return 0.0; });
  EXPECT_FALSE(none.time);
  EXPECT_FALSE(none.settled);
}

TEST(MovementOnset, OfAMovementThatNeverRestsIsItsFirstCrossing) {
  // Creep that speeds up, as of a slope that becomes wet; and one at a constant speed that stays below failure.
  EXPECT_NEAR(find_onset_of([](double t) { return 0.01 * std::exp(0.4 * t) - 0.01; }).time.value(), std::log(16) / 0.4,
              0.01);
  EXPECT_NEAR(find_onset_of([](double t) { return 0.02 * t; }).time.value(), 7.5, 1e-6);
  // A slide that stops and goes on began when it began.
  EXPECT_NEAR(find_onset_of([](double t) { return slide(std::min(t, 5.0), 3) + slide(t, 12); }).time.value(),
              3 + until_threshold, 0.01);
}

TEST(MovementOnset, DependsOnNoUnit) {
  std::vector<double> time, metres, feet;
  for (int i = 0; i <= 200; ++i) {
    time.push_back(row * i);
    metres.push_back(0.2 * (1 - std::exp(-row * i / 0.25)) + slide(row * i, 7));
    feet.push_back(metres.back() / 0.3048);
  }
  const MovementOnset a = find_movement_onset(time, metres, threshold, failure),
                      b = find_movement_onset(time, feet, threshold / 0.3048, failure / 0.3048);
  EXPECT_NEAR(a.time.value(), b.time.value(), 1e-9);
  EXPECT_NEAR(a.settled.value(), 0.3048 * b.settled.value(), 1e-9);
}

TEST(Pattern, FollowsTheHeightsOfTheMonitors) {
  const auto find = [](std::optional<double> toe, std::optional<double> middle, std::optional<double> crest) {
    return find_pattern({{"crest", 5, crest}, {"toe", 1, toe}, {"middle", 3, middle}});
  };
  EXPECT_EQ(find(100, 150, 200), results::MotionPattern::upwards);
  EXPECT_EQ(find(200, 150, 100), results::MotionPattern::downwards);
  EXPECT_EQ(find(100, 200, 150), results::MotionPattern::mixed);
  EXPECT_EQ(find(180, 190, 200), results::MotionPattern::together) << "within a tenth of the last";
  EXPECT_EQ(find(179, 190, 200), results::MotionPattern::upwards);
  EXPECT_EQ(find(100, 150, {}), results::MotionPattern::upwards) << "those that moved";
  EXPECT_EQ(find(100, {}, {}), results::MotionPattern::single);
  EXPECT_EQ(find({}, {}, {}), results::MotionPattern::none);
  EXPECT_EQ(find(100, 100, 200), results::MotionPattern::mixed) << "two at once are not one after the other";
}

results::Stage make_stage(const char* name, double start, double end) {
  results::Stage stage;
  stage.name = name;
  stage.start = start;
  stage.time = end;
  return stage;
}

class Motion : public testing::Test {
 protected:
  void SetUp() override {
    data_.stages.resize(2);
    data_.stages[0].name = "weight";
    data_.stages[1].name = "rain";
    data_.stages[1].reset_displacement = true;
    data_.output.monitors = {{"toe", {7, 1, 0}}, {"crest", {3, 5, 0}}};
    // The row at 5 s is from before displacements were set to zero.
    std::ofstream(folder_ / "monitors.csv")
        << "time [s],toe.displacement_x [mm],toe.displacement_y [mm],toe.displacement [mm],crest.displacement_x [mm],"
           "crest.displacement_y [mm],crest.displacement [mm]\n"
           "0,0,0,0,0,0,0\n5,30,40,50,300,400,500\n6,30,-40,50,0,0,0\n7,60,-80,100,6,8,10\n";
  }

  std::optional<results::Motion> find() const { return find_motion(data_, stages_, 4, folder_); }

  const fs::path folder_ = support::make_scratch("motion");
  input::Case data_;
  std::vector<results::Stage> stages_{make_stage("weight", 0, 5), make_stage("rain", 5, 7)};
};

TEST_F(Motion, IsCountedFromTheLastReset) {
  const results::Motion motion = find().value();
  EXPECT_EQ(motion.stage, "rain");
  EXPECT_DOUBLE_EQ(motion.threshold, 0.04);
  EXPECT_DOUBLE_EQ(motion.monitors[0].onset.value_or(0), 0.8);
  EXPECT_DOUBLE_EQ(motion.monitors[0].displacement.value_or(0), 0.1);
  EXPECT_FALSE(motion.monitors[1].onset);
  EXPECT_EQ(motion.pattern, results::MotionPattern::single);
  const std::string& sentence = motion.sentence;
  EXPECT_NE(sentence.find("'toe' after 0.8 s"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("40 mm, 1 % of the relief"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("'crest' does not move"), std::string::npos) << sentence;
}

TEST_F(Motion, CountsFromTheStageThatTheCaseNames) {
  data_.stages[1].reset_displacement = false;
  data_.output.count_from = "rain";
  data_.output.onset_displacement = 0.09;
  // From (30, 40) to (30, -40) mm: the displacement is a difference of vectors, not of lengths.
  const results::Motion motion = find().value();
  EXPECT_NEAR(motion.monitors[0].onset.value_or(0), 1 + 0.01 / (std::hypot(0.03, 0.12) - 0.08), 1e-12);
  EXPECT_NEAR(motion.monitors[0].displacement.value_or(0), std::hypot(0.03, 0.12), 1e-12);
}

TEST_F(Motion, OfARunThatEndedWithinTheStageIsKnown) {
  stages_.pop_back();
  EXPECT_DOUBLE_EQ(find().value().start, 5);
  stages_.clear();
  EXPECT_FALSE(find()) << "it did not come to the stage";
}

TEST_F(Motion, CanBeComparedUnderItsNames) {
  results::RunResult summary;
  summary.motion = find();
  EXPECT_DOUBLE_EQ(*find_result(summary, "onset[toe]"), 0.8);
  EXPECT_FALSE(find_result(summary, "onset[crest]"));
  EXPECT_DOUBLE_EQ(*find_result(summary, "displacement[crest]"), 0.01);
  for (const char* name : {"onset[toe]", "displacement[crest]"}) EXPECT_TRUE(input::find_result_name(data_, name));
  EXPECT_FALSE(input::find_result_name(data_, "onset[middle]"));
}

}  // namespace
}  // namespace talus::run
