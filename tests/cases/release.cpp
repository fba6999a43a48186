// SPDX-License-Identifier: MIT
// FEM and MPM with the pore water of one time of a timeline: factors beside those of LEM, no movement of a stable
// slope, and the message if no slope fails in the timeline.

#include <fmt/format.h>

#include "base/progress.hpp"
#include "cases/methods_slope.hpp"
#include "mesh/generate.hpp"
#include "output/files/history.hpp"
#include "run/timeline/moment.hpp"

namespace talus {
namespace {

/// A bank of silt over its water table, in a day of rain.
const char* const bank = R"(
title = "Bank in the rain"
[geometry]
box = [[0, 0], [14, 6]]
[[geometry.polygon]]
name = "soil"
points = [[0, 0], [14, 0], [14, 1.5], [9, 1.5], [5, 5], [0, 5]]
[[geometry.line]]
name = "ground"
points = [[0, 5], [5, 5], [9, 1.5], [14, 1.5]]
[mesh]
size = 0.7
[materials.silt]
model = "mohr_coulomb"
grain_density = 2650
porosity = 0.42
young_modulus = "15 MPa"
poisson_ratio = 0.3
cohesion = "3 kPa"
friction_angle = 32
dilatancy_angle = 0
tensile_strength = 1
[materials.silt.water]
conductivity = "5e-6 m/s"
retention = "van_genuchten"
reference_pressure = "8 kPa"
lambda = 0.4
relative_conductivity = "mualem"
air_entry = "0.5 kPa"
[regions]
soil = "silt"
[[boundary]]
on = "bottom"
fix = "full"
[[boundary]]
on = "left"
fix = "normal"
[[boundary]]
on = "right"
fix = "normal"
[[hydraulic]]
on = "ground"
condition = "rain"
rate = [[0, "6 mm/h"], ["1 day", "6 mm/h"]]
[initial]
stress = "k0"
pore_pressure = "water_table"
water_table = [[0, 2], [14, 1]]
largest_suction = 15
[[stage]]
name = "hold"
duration = 20
until = "rest"
water = "held"
geometry = "frozen"
damping = 0.75
[[stage]]
name = "let go"
duration = 1
reset_displacement = true
[lem]
methods = ["spencer"]
noncircular = false
referee = false
minima = 1
[lem.entry_exit]
exits = 12
entries = 12
depths = 8
[analysis]
methods = ["lem", "mpm"]
)";

std::string write_released_bank(const std::string& timeline) {
  return std::string(bank) + timeline;
}

class Release : public MethodsTest {};

TEST_F(Release, NothingMovesOnAStableSlope) {
  const auto summary = run(write_released_bank("[timeline]\nduration = 1\n[timeline.release]\ntime = 0.5\n"));
  const auto& releases = summary.at("timeline").at("releases");
  ASSERT_EQ(releases.size(), 3u);
  EXPECT_EQ(releases[0].at("time"), 43200);
  EXPECT_LT(releases[1].at("time"), 43200);
  EXPECT_GT(releases[2].at("time"), 43200);
  for (const auto& release : releases) {
    EXPECT_TRUE(release.at("rests"));
    EXPECT_LT(release.at("largest_displacement").get<double>(), 1e-3);
    EXPECT_EQ(release.at("moved_volume"), 0);
    EXPECT_GT(release.at("factor").get<double>(), 1);
  }
  EXPECT_EQ(summary.at("runout").at("largest_displacement"), releases[0].at("largest_displacement"));
  // The history ends with the front of the summary.
  const output::HistoryTable history = output::read_history(folder_ / "history.csv");
  for (std::size_t k = 0; k < history.columns.size(); ++k) {
    const std::string& name = history.columns[k].name;
    if (name != "front_advance" && name != "toe_distance") continue;
    EXPECT_EQ(history.values[k].back(), summary.at("runout").at(name).get<double>()) << name;
  }
  for (const auto& release : {releases[1], releases[2]})
    EXPECT_TRUE(std::filesystem::exists(folder_ / release.at("folder").get<std::string>() / "summary.json"));
  // The rain infiltrates before MPM starts, and continues.
  const auto start = run(write_released_bank("[timeline]\nduration = 1\n[timeline.release]\ntime = 0\napart = 0\n"));
  EXPECT_EQ(start.at("timeline").at("releases").size(), 1u);
  EXPECT_GT(summary.at("water").at("initial").get<double>(), 1.02 * start.at("water").at("initial").get<double>());
}

// A season is the same weather before the run, solved on the mesh of the points.
TEST_F(Release, BeginsWithTheWaterThatASeasonLeaves) {
  const auto released =
      run(write_released_bank("[timeline]\nduration = 1\n[timeline.release]\ntime = 0.5\napart = 0\n"));
  const auto season = run(bank, {{"initial.season", "'12 h'"},
                                 {"hydraulic.0.rate", "[[\"-12 h\", \"6 mm/h\"], [\"12 h\", \"6 mm/h\"]]"},
                                 {"analysis.methods", "['mpm']"}});
  const double stored = season.at("water").at("initial");
  EXPECT_NEAR(released.at("water").at("initial").get<double>(), stored, 1e-4 * stored);
  for (const char* key : {"stored", "entered"}) {
    const double flow = season.at("water").at(key);
    EXPECT_NEAR(released.at("water").at(key).get<double>(), flow, 0.02 * std::abs(flow) + 1e-3) << key;
  }
}

// Water under a table that was found on another mesh is the water under the table: finite elements and points find the
// factors that they find without it.
TEST_F(Release, HasTheFactorOfTheSameWater) {
  const std::vector<input::Override> changes{{"analysis.methods", "['fem', 'mpm']"},
                                             {"analysis.kind", "'strength_reduction'"},
                                             {"fem.meshes", "1"},
                                             {"fem.flow", "'as_given'"},
                                             {"strength_reduction.frozen.meshes", "1"},
                                             {"strength_reduction.curve.enabled", "false"},
                                             {"strength_reduction.frozen.resolution", "0.01"}};
  input::LoadedCase loaded = input::read_case_text(bank, "bank.toml", changes);
  loaded.data.stages.resize(1);
  const auto direct = [&] {
    run::RunOptions options;
    options.folder = folder_;
    options.overwrite = true;
    return support::run_case(loaded, options);
  };
  const auto before = direct();
  auto known = std::make_shared<input::KnownWater>();
  mesh::Plan finer = loaded.data.mesh;
  finer.size = 0.3;
  known->mesh = mesh::generate<2>(finer);
  for (const auto& x : known->mesh.nodes) known->pressure.push_back(std::min(9810.0 * (x[1] - (2 - x[0] / 14)), 15e3));
  known->seepage.assign(known->mesh.elements.size(), {});
  loaded.data.initial.water.known = known;
  loaded.data.initial.water.pressure = input::InitialPressure::zero;
  const auto after = direct();
  EXPECT_NEAR(after.at("factor_of_safety").at("value").get<double>(),
              before.at("factor_of_safety").at("value").get<double>(), 0.011);
  EXPECT_NEAR(after.at("fem").at("runs")[0].at("factor").get<double>(),
              before.at("fem").at("runs")[0].at("factor").get<double>(), 0.011);
}

// LEM and FEM on the water of the same times.
TEST_F(Release, FiniteElementsReduceStrengthAtTimesOfTheTimeline) {
  const auto summary =
      run(write_released_bank("[timeline]\nduration = 1\ntimes = [0.5, 1]\nelement_times = [0.5, 1]\n"),
          // One mesh: on meshes as coarse as these the extrapolation would move the factor by more than the band.
          {{"analysis.methods", "['lem', 'fem']"},
           {"fem.flow", "'as_given'"},
           {"fem.resolution", "0.01"},
           {"fem.meshes", "1"}});
  const auto& timeline = summary.at("timeline");
  const auto& elements = timeline.at("elements");
  ASSERT_EQ(elements.size(), 2u);
  double before = summary.at("fem").at("runs")[0].at("factor");
  for (std::size_t i = 0; i < 2; ++i) {
    const double slices = timeline.at("factors")[i + 1].at("factor"), factor = elements[i].at("runs")[0].at("factor");
    EXPECT_NEAR(factor / slices, 1, 0.05) << elements[i].at("time");
    EXPECT_LT(factor, before);
    EXPECT_TRUE(std::filesystem::exists(folder_ / elements[i].at("folder").get<std::string>() / "fem.vtu"));
    before = factor;
  }
  EXPECT_EQ(summary.at("main_factor").get<double>(), std::min(before, timeline.at("least").get<double>()));
}

// The state at a jump of a series is that before it, with the pool and the rain that go with it.
TEST_F(Release, ATimeAtWhichAPoolJumpsIsBeforeTheJump) {
  const std::vector<input::Override> changes{
      {"analysis.methods", "['lem', 'fem']"},
      {"fem.flow", "'as_given'"},
      {"fem.resolution", "0.01"},
      {"initial.water_table", "[[0, 4], [14, 4]]"},
      {"hydraulic",
       "[{ on = 'ground', condition = 'total_head', head = [[0, 4], [\"0.5 day\", 4], [\"0.5 day\", 1.5], "
       "[\"1 day\", 1.5]] }, { on = 'left', condition = 'no_flow' }]"}};
  const auto summary =
      run(write_released_bank("[timeline]\nduration = 1\ntimes = [0.5, 1]\nelement_times = [0.5]\n"), changes);
  const double first = summary.at("fem").at("runs")[0].at("factor");
  const auto& timeline = summary.at("timeline");
  EXPECT_NEAR(timeline.at("elements")[0].at("runs")[0].at("factor").get<double>(), first, 0.011);
  EXPECT_NEAR(timeline.at("factors")[1].at("factor").get<double>(),
              timeline.at("factors")[0].at("factor").get<double>(), 0.002);
  EXPECT_LT(timeline.at("factors")[2].at("factor").get<double>(),
            0.9 * timeline.at("factors")[0].at("factor").get<double>())
      << "the jump does nothing";
}

TEST(BeginLater, ASeriesThatJumpsThereHasItsOldValueFirst) {
  const auto loaded = input::read_case_text(
      write_released_bank("[timeline]\nduration = 1\n"), "bank.toml",
      {{"hydraulic.0.rate", "[[0, \"6 mm/h\"], [\"12 h\", \"6 mm/h\"], [\"12 h\", 0], [\"1 day\", 0]]"}});
  const auto water = std::make_shared<const input::KnownWater>();
  const input::Case later = run::begin_later(loaded.data, 43200, water);
  const double rain = 6e-3 / 3600;
  EXPECT_NEAR(later.hydraulics[0].rate.at(0), rain, 1e-12 * rain);
  EXPECT_EQ(later.hydraulics[0].rate.at(1e-8 * 86400), 0);
  EXPECT_EQ(later.initial.water.known, water);
  EXPECT_FALSE(later.timeline);
  const input::Case first = run::begin_later(loaded.data, 0, nullptr);
  EXPECT_EQ(first.initial.water.pressure, loaded.data.initial.water.pressure);
}

// Interrupted when several times are searched; what is found until then is not searched again.
TEST_F(Release, AnInterruptedTimelineResumes) {
  const std::string text = write_released_bank("[timeline]\nduration = 1\ntolerance = 0.001\n");
  const std::vector<input::Override> changes{{"analysis.methods", "['lem']"}};
  const auto whole = run(text, changes).at("timeline");
  Progress interrupting([rounds = 0](const ProgressReport& report) mutable {
    if (report.line.find("searches") != std::string::npos && ++rounds == 3) request_interrupt();
  });
  run::RunOptions options;
  options.folder = folder_;
  options.overwrite = true;
  options.progress = &interrupting;
  const input::LoadedCase loaded = input::read_case_text(text, "slope.toml", changes);
  EXPECT_THROW(support::run_case(loaded, options), Error);
  request_interrupt(false);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "timeline.json"));
  std::string most;  // searches
  Progress counting([&](const ProgressReport& report) {
    if (report.line.find("searches") != std::string::npos && most.empty()) most = report.line;
  });
  options.overwrite = false;
  options.resume = true;
  options.progress = &counting;
  const auto resumed = support::run_case(loaded, options).at("timeline");
  EXPECT_NE(most, "timeline: 2 searches") << "the first one after time 0 is known";
  EXPECT_FALSE(std::filesystem::exists(folder_ / "timeline.json"));
  ASSERT_EQ(resumed.at("factors").size(), whole.at("factors").size());
  for (std::size_t i = 0; i < whole.at("factors").size(); ++i) {
    const auto &a = resumed.at("factors")[i], &b = whole.at("factors")[i];
    EXPECT_EQ(a.at("time"), b.at("time"));
    EXPECT_NEAR(a.at("factor").get<double>(), b.at("factor").get<double>(), 1e-5);
  }
}

TEST_F(Release, AStableSlopeIsNotReleased) {
  const auto summary = run(write_released_bank("[timeline]\nduration = 0.25\n[timeline.release]\n"));
  EXPECT_TRUE(summary.at("timeline").at("releases").empty());
  EXPECT_NE(summary.at("timeline").at("notes").dump().find("MPM does not start"), std::string::npos);
  EXPECT_FALSE(summary.contains("runout"));
}

TEST_F(Release, TheTimeOfFailureIsTheFirstBelowTheTarget) {
  const auto summary =
      run(write_released_bank("[timeline]\nduration = 1\ntarget = 1.6\n[timeline.release]\napart = \"1 h\"\n"),
          {{"lem.entry_exit.exits", "8"}, {"lem.entry_exit.entries", "8"}});
  const auto& timeline = summary.at("timeline");
  ASSERT_FALSE(timeline.at("failure").is_null());
  const auto& releases = timeline.at("releases");
  EXPECT_EQ(releases[0].at("time"), timeline.at("failure").at("to"));
  for (std::size_t i = 1; i < releases.size(); ++i)
    EXPECT_NEAR(std::abs(releases[i].at("time").get<double>() - releases[0].at("time").get<double>()), 3600, 1800);
}

// MPM starts from the stress and the water of FEM, and nothing holds the points.
TEST_F(Release, NothingMovesFromTheStressOfFem) {
  const auto summary = run(write_released_bank("[timeline]\nduration = 1\n[timeline.release]\ntime = 0.5\n"),
                           {{"initial.stress", "'elements'"},
                            {"stage", "[{ name = 'let go', duration = 1 }, { name = 'go on', duration = 1 }]"}});
  const auto& releases = summary.at("timeline").at("releases");
  ASSERT_EQ(releases.size(), 3u);
  for (const auto& release : releases) {
    EXPECT_EQ(release.at("start_factor"), 1);
    EXPECT_LT(release.at("largest_displacement").get<double>(), 1e-3);
    EXPECT_EQ(release.at("moved_volume"), 0);
  }
}

// Each release has the uncertainty that a coarser mesh of its own leaves, those beside the first one too.
TEST_F(Release, EveryMovingReleaseHasTheUncertaintyOfItsFront) {
  const auto summary = run(write_released_bank("[timeline]\nduration = 1\n[timeline.release]\ntime = 0.5\n"),
                           {{"materials.silt.cohesion", "0"},
                            {"materials.silt.friction_angle", "15"},
                            {"materials.silt.tensile_strength", "0"},
                            {"stage", "[{ name = 'let go', duration = 2 }]"}});
  const auto& releases = summary.at("timeline").at("releases");
  ASSERT_EQ(releases.size(), 3u);
  for (const auto& release : releases) {
    EXPECT_GT(release.at("moved_volume").get<double>(), 0);
    EXPECT_TRUE(release.contains("front_uncertainty")) << release;
  }
}

// FEM loses equilibrium where its factor passes 1.
TEST_F(Release, EquilibriumIsLostWhereTheFactorOfElementsPassesOne) {
  const std::vector<input::Override> weak{{"materials.silt.cohesion", "0.4"},
                                          {"materials.silt.friction_angle", "27"},
                                          {"materials.silt.tensile_strength", "0.2"},
                                          {"fem.flow", "'as_given'"},
                                          {"fem.resolution", "0.005"},
                                          {"mesh.size", "1"},
                                          {"initial.stress", "'elements'"}};
  const auto summary =
      run(write_released_bank("[timeline]\nduration = 1\n[timeline.release]\ncriterion = \"equilibrium\"\n"
                              "apart = 0\n"),
          weak);
  const auto& timeline = summary.at("timeline");
  const auto& loss = timeline.at("equilibrium");
  ASSERT_FALSE(loss.at("from").is_null()) << loss;
  ASSERT_FALSE(loss.at("to").is_null()) << loss;
  ASSERT_EQ(timeline.at("releases").size(), 1u);
  EXPECT_EQ(timeline.at("releases")[0].at("time"), loss.at("to"));
  EXPECT_LT(timeline.at("releases")[0].at("start_factor").get<double>(), 1);
  // The same times with strength reduction.
  const double from = loss.at("from").get<double>() / 86400, to = loss.at("to").get<double>() / 86400;
  std::vector<input::Override> reduced = weak;
  reduced.push_back({"analysis.methods", "['lem', 'fem']"});
  const auto elements =
      run(write_released_bank(fmt::format("[timeline]\nduration = 1\nelement_times = [{}, {}]\n", from, to)), reduced)
          .at("timeline")
          .at("elements");
  ASSERT_EQ(elements.size(), 2u);
  // Loading at full strength and reducing the strength afterwards leads to the same equilibrium.
  constexpr double resolution = 0.005;
  EXPECT_GE(elements[0].at("runs")[0].at("stable").get<double>(), 1 - resolution);
  EXPECT_LE(elements[1].at("runs")[0].at("failed").get<double>(), 1 + resolution);
}

TEST_F(Release, ReportsWhatACaseLacks) {
  const auto has = [&](const std::string& timeline, const std::vector<input::Override>& changes, const char* sentence) {
    const std::string fault = find_fault(write_released_bank("[timeline]\nduration = 1\n" + timeline), changes);
    EXPECT_NE(fault.find(sentence), std::string::npos) << fault;
  };
  has("[timeline.release]\n", {{"analysis.methods", "['lem']"}}, "add \"mpm\" to [analysis] methods");
  has("[timeline.release]\n", {{"analysis.kind", "'strength_reduction'"}}, "not a reduction of strength");
  has("[timeline.release]\ntime = 2\n", {}, "outside the timeline");
  has("times = [0.5]\n[timeline.release]\ntime = 0.2\n", {}, "is not one of [timeline] times");
  has("[timeline.release]\ntime = 0.5\ncriterion = \"equilibrium\"\n", {}, "no criterion finds it");
  EXPECT_FALSE(std::filesystem::exists(folder_));
  // Samples are calculated by LEM only: other settings of the timeline are ignored.
  EXPECT_EQ(find_fault(write_released_bank("[timeline]\nduration = 1\nelement_times = [0.5]\n[timeline.release]\n"),
                       {{"analysis.methods", "['lem']"},
                        {"study.mode", "'sample'"},
                        {"study.random", "[{ key = 'materials.silt.friction_angle', deviation = 2 }]"}}),
            "");
}

}  // namespace
}  // namespace talus
