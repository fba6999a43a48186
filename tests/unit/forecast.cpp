// SPDX-License-Identifier: MIT
// The forecast of a run: counts against the meshes made afterwards, and free memory from the text of the system.
#include "run/forecast/forecast.hpp"

#include <gtest/gtest.h>

#include "base/memory.hpp"
#include "mesh/generate.hpp"
#include "run/common/mesh_estimate.hpp"
#include "run/mpm/stage/stage.hpp"
#include "run/mpm/start/prepare.hpp"
#include "study/study.hpp"
#include "support/slopes.hpp"

namespace talus::run {
namespace {

input::LoadedCase read(const std::vector<std::string>& changes = {}) {
  std::vector<input::Override> overrides;
  for (const std::string& change : changes) overrides.push_back(input::parse_override(change));
  return input::read_case_text(support::write_slope("dry") + "[[stage]]\nname = \"gravity\"\nduration = 10\n",
                               "slope.toml", overrides);
}

template <int D>
double count_soil(const mesh::Mesh<D>& mesh) {
  double soil = 0;
  for (int e = 0; e < mesh.element_count(); ++e) soil += mesh.element_region[e] >= 0 ? 1 : 0;
  return soil;
}

TEST(Forecast, CountsElementsAsTheMesherMakesThem) {
  for (const char* change :
       {"mesh.size=0.75", "mesh.size=0.4", "mesh.refine=[{ near = [[12, 15], [32, 5]], size = 0.2, distance = 4 }]"}) {
    const input::LoadedCase loaded = read({change});
    const mesh::Mesh<2> mesh = mesh::generate<2>(loaded.data.mesh);
    const ElementCount count = count_elements(loaded.data.mesh);
    EXPECT_NEAR(count.all, mesh.element_count(), 0.05 * count.all) << change;
    EXPECT_NEAR(count.soil, count_soil(mesh), 0.05 * count.soil) << change;
  }
}

TEST(Forecast, CountsTetrahedraWithinAFifth) {
  const input::LoadedCase loaded = read({"geometry.dimension=3", "geometry.thickness=4", "mesh.size=1.5"});
  const mesh::Mesh<3> mesh = mesh::generate<3>(loaded.data.mesh);
  const ElementCount count = count_elements(loaded.data.mesh);
  EXPECT_NEAR(count.all, mesh.element_count(), 0.2 * mesh.element_count());
}

TEST(Forecast, TheTimeStepOfACoarseMeshGivesThatOfTheCase) {
  const input::LoadedCase loaded = read({"mesh.size=0.3"});
  const auto pace = probe(loaded.data);
  ASSERT_TRUE(pace.has_value());
  mpm::Body<2> body = prepare<2>(loaded.data, mesh::generate<2>(loaded.data.mesh));
  const StagePlan<2> plan = make_plan<2>(loaded.data, loaded.data.stages.at(0), 10, 1);
  set_strength(body, loaded.data, {}, 1);
  const double step = find_critical_step(body, plan).dt * plan.step.courant;
  EXPECT_NEAR(pace->stages.at(0).step, step, 0.2 * step);
  EXPECT_GT(pace->stages.at(0).point_steps, 1e5);
}

TEST(Forecast, ATimelineTakesMoreTheMoreTimesItHas) {
  double before = 0;
  for (const char* times : {"timeline.times=[1]", "timeline.times=[1, 2, 3, 4]"}) {
    input::LoadedCase loaded =
        input::read_case(TALUS_SOURCE_DIR "/examples/reservoir_drawdown/case.toml", {input::parse_override(times)});
    const MethodForecast f = forecast(loaded.data, false).at(0);
    EXPECT_GT(f.seconds, 1.5 * before) << times;
    EXPECT_NE(describe(f).find(fmt::format(" {:.0f} time", f.times)), std::string::npos) << describe(f);
    before = f.seconds;
  }
}

TEST(Forecast, WhatIsUsualIsNoMoreThanTheMost) {
  for (const char* example : {"dry_slope/four_methods.toml", "storm_on_a_bank/case.toml"})
    for (const MethodForecast& f :
         forecast(input::read_case(std::string(TALUS_SOURCE_DIR "/examples/") + example).data, true)) {
      EXPECT_GT(f.seconds, 0) << example;
      EXPECT_LE(f.seconds, f.most_seconds) << example << ": " << describe(f);
    }
}

TEST(Forecast, AStudyTakesAsLongAsItsRuns) {
  const std::vector<input::Override> none;
  const auto describe_example = [&](const char* example) {
    const std::string file = std::string(TALUS_SOURCE_DIR "/examples/") + example;
    return study::forecast_study(input::read_case(file), none);
  };
  EXPECT_EQ(describe_example("rapid_drawdown/case.toml"), "");
  const std::string varied = describe_example("dry_slope/convergence_elements.toml");
  EXPECT_TRUE(varied.starts_with("  a study varies 1 key: 4 runs, about ")) << varied;
  const std::string drawn = describe_example("probability_of_failure/case.toml");
  EXPECT_TRUE(drawn.starts_with("  a study draws 10000 samples of 4 uncertain numbers, about ")) << drawn;
}

TEST(Forecast, FreeMemoryIsTheLeastEstimateOfTheSystem) {
  EXPECT_FALSE(find_free_memory("", "", "").has_value());
  EXPECT_DOUBLE_EQ(*find_free_memory("MemTotal: 9 kB\nMemAvailable:   2000 kB\n", "max\n", "5\n"), 2048000);
  EXPECT_DOUBLE_EQ(*find_free_memory("MemAvailable: 2000 kB\n", "1000000\n", "400000\n"), 600000);
  EXPECT_DOUBLE_EQ(*find_free_memory("MemAvailable: 2000 kB\n", "1000000\n", "1400000\n"), 0);
  EXPECT_EQ(write_bytes(3.4e13), "34 TB");
  EXPECT_EQ(write_bytes(2.34e9), "2.3 GB");
  EXPECT_EQ(write_bytes(4.1e8), "410 MB");
}

TEST(Forecast, CoarserMeshOfARunoutNeedsMemoryBesideTheFirst) {
  const auto find_bytes = [](const char* meshes) {
    return forecast(read({"analysis.kind=run", "mesh.size=0.01", meshes}).data, false).at(0).bytes;
  };
  EXPECT_NEAR(find_bytes("output.runout_meshes=2") / find_bytes("output.runout_meshes=1"), 1.25, 0.01);
}

TEST(Forecast, TheSizeThatFitsNeedsNoMoreThanIsFree) {
  for (const char* methods : {"analysis.methods=[\"mpm\"]", "analysis.methods=[\"fem\"]"}) {
    input::LoadedCase loaded = read({"mesh.size=0.0003", methods});
    constexpr double free = 2e9;
    ASSERT_GT(forecast(loaded.data, false).at(0).bytes, 1e12);
    const auto size = find_size_that_fits(loaded.data, loaded.data.methods.at(0), free);
    ASSERT_TRUE(size.has_value());
    loaded.data.mesh.size = *size;
    const double bytes = forecast(loaded.data, false).at(0).bytes;
    EXPECT_LE(bytes, free);
    EXPECT_GT(bytes, 0.7 * free) << "and is not much larger than it must be";
    EXPECT_THROW(refuse_above_memory(read({"mesh.size=0.0003", methods})), InputError);
  }
}

}  // namespace
}  // namespace talus::run
