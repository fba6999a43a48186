// SPDX-License-Identifier: MIT
// The factor of safety over time: a dam after drawdown against published factors, the limits of very fast and very slow
// drawdown, and the messages for incomplete cases.

#include <fmt/format.h>

#include <fstream>

#include "cases/methods_slope.hpp"
#include "study/sampling.hpp"
#include "support/water_in_time.hpp"

namespace talus {
namespace {

class Timeline : public MethodsTest {
 protected:
  static std::string read_dam() {
    std::ifstream file(TALUS_SOURCE_DIR "/examples/reservoir_drawdown/case.toml");
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// The dam without a timeline.
  static std::string read_still() {
    std::string text = read_dam();
    text.erase(text.find("[timeline]"), text.find("[analysis]") - text.find("[timeline]"));
    return text;
  }
  static std::vector<input::Override> coarsen(std::vector<input::Override> more = {}) {
    std::vector<input::Override> all = {{"mesh.size", "1"},
                                        {"lem.referee", "false"},
                                        {"lem.entry_exit.entries", "10"},
                                        {"lem.entry_exit.exits", "10"},
                                        {"lem.entry_exit.depths", "8"}};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  static double find_last(const nlohmann::json& summary) {
    return summary.at("timeline").at("factors").back().at("factor");
  }
};

TEST_F(Timeline, DrawdownOfADamIsThePublishedOne) {
  const std::vector<double> published{1.0390, 1.0654, 1.0938, 1.1238, 1.1567, 1.1939, 1.2336};  // from two days on
  const auto summary = run(read_dam(), coarsen({{"lem.referee", "true"},
                                                {"timeline.times",
                                                 "['178298 s', '291181 s', '461858 s', '719916 s', '1110093 s', "
                                                 "'1700031 s', '2592000 s']"}}));
  const auto& factors = summary.at("timeline").at("factors");
  ASSERT_EQ(factors.size(), published.size() + 1);
  EXPECT_NEAR(factors[0].at("factor").get<double>() / 1.6721, 1, 0.02);
  for (std::size_t i = 0; i < published.size(); ++i)
    EXPECT_NEAR(factors[i + 1].at("factor").get<double>() / published[i], 1, 0.02) << factors[i + 1].at("time");
  EXPECT_LT(std::abs(summary.at("timeline").at("weather").at("error").get<double>()), 1e-10);
  // The first one is that of LEM alone, and the least in time governs.
  EXPECT_EQ(factors[0].at("factor"), summary.at("lem").at("critical")[0].at("factor"));
  EXPECT_EQ(summary.at("main_factor"), summary.at("timeline").at("least"));
  EXPECT_EQ(summary.at("main_factor"), factors[1].at("factor"));
}

TEST_F(Timeline, HeadsUnderTheFullPoolAreThePublishedOnesWithADrainOfTenMetresADay) {
  struct Place {
    std::array<double, 2> x;
    double head;
    bool holds;  // with the conductivity of the drain that was published, 1 m a day
  };
  const std::vector<Place> places{
      {{20, 5}, 7.280, true}, {{25, 5}, 6.258, true}, {{30, 3}, 5.008, false}, {{35, 2}, 3.424, false}};
  const double band = 0.01 * 8;
  for (const char* drain : {"1.157e-5 m/s", "1.157e-4 m/s"}) {
    const support::WaterInTime water(
        read_still(),
        {{"hydraulic.0.head", "8"}, {"materials.drain.water.conductivity", std::string("'") + drain + "'"}});
    const bool is_published = std::string(drain) == "1.157e-5 m/s";
    for (const auto& [x, head, holds] : places) {
      const double found = x[1] + water.find(0, x) / 9810;
      RecordProperty(fmt::format("head_{}_{}_{}", x[0], x[1], is_published ? "published" : "tenfold"),
                     fmt::format("{:.3f}", found));
      if (is_published && !holds)
        EXPECT_GT(found, head + band) << "no miss any more: docs/verification.md";
      else
        EXPECT_NEAR(found, head, band) << x[0] << ", " << x[1] << ", " << drain;
    }
  }
}

TEST_F(Timeline, WaterThatFallsSlowlyLeavesADrainedSlope) {
  const auto slow = run(read_dam(), coarsen({{"hydraulic.0.head", "[[0, 8], ['1e10 s', 4]]"},
                                             {"timeline.duration", "'1e10 s'"},
                                             {"timeline.times", "['1e10 s']"}}));
  const auto drained = run(read_still(), coarsen({{"hydraulic.0.head", "4"}}));
  EXPECT_NEAR(find_last(slow) / find_factor(drained, "spencer"), 1, 0.01);
}

TEST_F(Timeline, WaterThatFallsAtOnceLeavesItsPressures) {
  // In soil that stores much water the pressures of the full pool remain, and nothing presses on the face any more.
  const auto summary = run(read_dam(), coarsen({{"timeline.duration", "'1 s'"},
                                                {"timeline.times", "['1 s']"},
                                                {"materials.dam.water.compressibility", "'1 kPa-1'"}}));
  const auto full = run(read_still(), coarsen({{"hydraulic.0.head", "8"}}));
  EXPECT_LT(find_last(summary), 0.6 * find_factor(full, "spencer"));
}

TEST_F(Timeline, TimeOfFailureLiesBetweenTwoTimesThatWereTried) {
  const auto summary = run(read_dam(), coarsen({{"hydraulic.0.head", "[[0, 8], ['4 day', 0]]"},
                                                {"timeline.duration", "'4 day'"},
                                                {"timeline.target", "1.3"},
                                                {"timeline.tolerance", "0.01"}}));
  const auto& timeline = summary.at("timeline");
  ASSERT_FALSE(timeline.at("failure").is_null());
  const auto& failure = timeline.at("failure");
  EXPECT_GE(failure.at("factor_from").get<double>(), 1.3);
  EXPECT_LT(failure.at("factor_to").get<double>(), 1.3);
  EXPECT_LT(failure.at("to").get<double>() - failure.at("from").get<double>(), 4 * 86400 / 64.0);
  bool has_from = false, has_to = false;
  for (const auto& f : timeline.at("factors")) {
    has_from = has_from || f.at("time") == failure.at("from");
    has_to = has_to || f.at("time") == failure.at("to");
  }
  EXPECT_TRUE(has_from && has_to);
  EXPECT_LE(failure.at("earliest").get<double>(), failure.at("from").get<double>());
  EXPECT_GE(failure.at("latest").get<double>(), failure.at("to").get<double>());
  EXPECT_LT(timeline.at("distance").get<double>(), 0.01);
  EXPECT_EQ(timeline.at("states").size(), timeline.at("factors").size());
}

TEST_F(Timeline, AStormFellsTheBareHillsideAndNotTheRootedOne) {
  const auto follow = [&](const std::string& name) {
    const std::string folder = TALUS_SOURCE_DIR "/examples/storm_over_days/";
    std::ifstream file(folder + name);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    for (std::size_t at = text.find("weather.csv"); at != std::string::npos;
         at = text.find("weather.csv", at + folder.size() + 1))
      text.insert(at, folder);
    return run(text, {{"mesh.size", "1.5"},
                      {"timeline.times", "[49, 54.4]"},
                      {"timeline.target", "1.1"},  // circles of a coarse mesh are stronger
                      {"lem.noncircular", "false"},
                      {"lem.referee", "false"}})
        .at("timeline");
  };
  const auto bare = follow("case.toml"), rooted = follow("rooted.toml");
  EXPECT_EQ(bare.at("start"), "2023-03-01");
  EXPECT_EQ(bare.at("duration"), 61 * 86400.0);
  EXPECT_FALSE(bare.at("failure").is_null());
  EXPECT_TRUE(rooted.at("failure").is_null());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_GT(rooted.at("factors")[i].at("factor").get<double>(), bare.at("factors")[i].at("factor").get<double>());
  const auto& weather = rooted.at("weather");
  // All rain of the file on the 46 m of ground enters or runs off, but for what falls on its outermost nodes, which
  // belong to the sides.
  const double rain = 46 * 0.3232;
  EXPECT_NEAR((weather.at("inflow").get<double>() + weather.at("runoff").get<double>()) / rain, 1, 0.03);
  EXPECT_GT(weather.at("transpired"), 0.9 * weather.at("potential").get<double>());
  EXPECT_LT(std::abs(weather.at("error").get<double>()), 1e-9);
}

TEST_F(Timeline, SamplesHaveTheLeastFactorInTime) {
  const std::string text = read_dam() + R"(
[study]
mode = "sample"
samples = 4
[[study.random]]
key = "materials.dam.cohesion"
deviation = 1
)";
  const auto changes = coarsen({{"mesh.size", "1.5"}, {"timeline.times", "['1 day', '10 day']"}});
  const input::LoadedCase base = input::read_case_text(text, "dam.toml", changes);
  study::StudyOptions options;
  options.folder = folder_;
  const study::SamplingResult found = study::run_sampling(base, changes, options);
  ASSERT_TRUE(found.study.sampling->factor);
  EXPECT_EQ(found.study.variants.size(), 5u);  // the means first
  EXPECT_LT(found.study.sampling->factor->largest, 1.3) << "at time 0 it is above 1.4 for each of them";
  EXPECT_GT(found.study.sampling->factor->smallest, 0.7);
  const auto& time = found.study.sampling->failure_time;
  EXPECT_EQ(time ? time->count : 0, found.study.sampling->failure->share.count)
      << "a sample fails when its least factor is below 1";
  EXPECT_EQ(time ? time->count + time->none : 4, 4);
}

TEST_F(Timeline, ReportsWhatACaseLacks) {
  const auto has = [&](const std::vector<input::Override>& changes, const char* sentence) {
    const std::string fault = find_fault(read_dam(), changes);
    EXPECT_NE(fault.find(sentence), std::string::npos) << fault;
  };
  has({{"timeline.times", "['40 day']"}}, "outside the timeline");
  has({{"timeline.times", "['2 day', '1 day']"}}, "must increase");
  has({{"timeline.element_times", "['2 day']"}}, "add \"fem\" to [analysis] methods");
  has({{"timeline.element_times", "['2 day']"},
       {"timeline.times", "['1 day']"},
       {"analysis.methods", "['lem', 'fem']"}},
      "is not one of [timeline] times");
  has({{"timeline.duration", "'-1 day'"}}, "above 0");
  has({{"analysis.methods", "['fem']"}}, "add \"lem\" to [analysis] methods");
  has({{"lem.search", "'none'"}}, "[[lem.surface]]");
  // Before anything is written: soil that stores nothing has no time.
  has({{"materials.dam.water.retention", "'saturated'"},
       {"materials.dam.water.compressibility", "0"},
       {"water.bulk_modulus", "inf"}},
      "store");
  EXPECT_FALSE(std::filesystem::exists(folder_));
}

}  // namespace
}  // namespace talus
