// SPDX-License-Identifier: MIT
// A Cam-clay bank from its case file: the preconsolidation pressure is set once, from the equilibrium stage, also with
// an interruption, a start from the result of another run, and a strength reduction.

#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <thread>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "output/files/frames_reader.hpp"
#include "support/child.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string write_bank(const std::string& soil) {
  return support::write_slope(
      "bank", {"geometry.box=[[0, 0], [12, 5]]",
               "geometry.polygon.soil.points=[[0, 0], [12, 0], [12, 2], [9, 2], [5, 4], [0, 4]]",
               "geometry.line=[{ name = 'ground', points = [[0, 4], [5, 4], [9, 2], [12, 2]] }]",
               "materials.silt={ grain_density = 2650, porosity = 0.4, poisson_ratio = 0.3, " + soil + " }"});
}

const std::string clay = write_bank(
                             "model = 'rooted_cam_clay', lambda = 0.089, kappa = 0.022, critical_state_slope = 1.2, "
                             "preconsolidation_ratio = 2, smallest_pressure = 5, root_hardening = 0.28, "
                             "root_strength = 0.18") +
                         "[[roots]]\nground = \"ground\"\ndepth = 1\ncontent = 0.88\n";

/// From the stress of the weight: Cam-clay without stress is as soft as its smallest pressure makes it.
const std::string settle = R"(
[initial]
stress = "k0"
[[stage]]
name = "weight"
duration = 0.3
damping = 0.5
)";
const std::string go_on = R"(
[[stage]]
name = "on"
duration = 60
damping = 0.2
[output]
checkpoint_interval = 0.001
frame_interval = 1000
)";

class PreconsolidationOfARun : public testing::Test {
 protected:
  void TearDown() override { request_interrupt(false); }
  json run(const std::string& text, const std::string& name, bool resume = false) const {
    run::RunOptions options;
    options.folder = folder_ / name;
    options.threads = default_threads();
    options.resume = resume;
    return support::run_case(input::read_case_text(text, (folder_ / "case.toml").string(), {}), options);
  }
  const fs::path folder_ = support::make_scratch("preconsolidation");
};

TEST_F(PreconsolidationOfARun, IsSetAtTheEndOfTheStageAndSoOnlyOnceWhenTheRunIsResumed) {
  const std::string text = clay + settle + go_on;
  const json whole = run(text, "whole");
  const json& set = whole.at("stages")[0].at("preconsolidation");
  EXPECT_EQ(set.at("points"), whole.at("mesh").at("points"));
  // At least R_0 times the smallest pressure, which governs at the ground, and roots there.
  EXPECT_GT(set.at("smallest").get<double>(), 9.9e3);
  EXPECT_LT(set.at("largest").get<double>(), 2 * 2650 * 0.6 * 9.81 * 4);
  EXPECT_FALSE(whole.at("stages")[1].contains("preconsolidation"));

  // Interrupted at once, then as soon as the first stage is over, then to the end.
  request_interrupt();
  EXPECT_THROW(run(text, "parts"), Error);
  request_interrupt(false);
  std::thread watch([&] {
    support::wait_for_file(folder_ / "parts" / "stages.json", getpid());
    request_interrupt();
  });
  EXPECT_THROW(run(text, "parts", true), Error);
  watch.join();
  request_interrupt(false);
  const json parts = run(text, "parts", true);
  EXPECT_EQ(parts.at("stages")[0].at("preconsolidation"), set);
  EXPECT_FALSE(parts.at("stages")[1].contains("preconsolidation"));
  const output::ResultsReader a(folder_ / "whole"), b(folder_ / "parts");
  const output::Frame last_a = a.read(a.size() - 1), last_b = b.read(b.size() - 1);
  EXPECT_EQ(last_a.positions, last_b.positions);
}

TEST_F(PreconsolidationOfARun, ContinuesInACaseThatStartsFromTheResult) {
  const json first = run(clay + settle, "first");
  EXPECT_TRUE(first.at("stages")[0].contains("preconsolidation"));
  const json second = run(clay + go_on + "[initial]\nresult = \"first\"\n", "second");
  EXPECT_FALSE(second.at("stages")[0].contains("preconsolidation"));
  const output::ResultsReader a(folder_ / "first"), b(folder_ / "second");
  const output::Frame end = a.read(a.size() - 1), start = b.read(0);
  for (const char* name : {"preconsolidation_pressure", "void_ratio", "root_content", "root_activation_strain"}) {
    const output::Field *left = output::find(end.point_fields, name), *found = output::find(start.point_fields, name);
    ASSERT_TRUE(left != nullptr && found != nullptr) << name;
    EXPECT_EQ(left->values, found->values) << name;
  }
}

TEST_F(PreconsolidationOfARun, StaysWhenOtherRootsArePlantedOnTheResult) {
  run(clay + settle, "first");
  std::string more = clay;
  more.replace(more.find("0.88"), 4, "0.44");
  run(more + go_on + "[initial]\nresult = \"first\"\n", "second");
  const output::ResultsReader a(folder_ / "first"), b(folder_ / "second");
  const output::Frame end = a.read(a.size() - 1), start = b.read(0);
  const auto get = [](const output::Frame& frame, const char* name) -> const std::vector<double>& {
    return output::find(frame.point_fields, name)->values;
  };
  int rooted = 0;
  for (std::size_t i = 0; i < end.ids.size(); ++i) {
    const double content = get(start, "root_content")[i];
    // The saturated soil without roots keeps its preconsolidation: p'_c falls by the hardening of 0.44 % of roots.
    ASSERT_NEAR(get(start, "preconsolidation_pressure")[i],
                get(end, "preconsolidation_pressure")[i] * std::exp(-0.28 * (get(end, "root_content")[i] - content)),
                1e-12 * get(end, "preconsolidation_pressure")[i]);
    rooted += content > 0 ? 1 : 0;
  }
  EXPECT_GT(rooted, 20);
  EXPECT_LT(rooted, static_cast<int>(end.ids.size()));
}

TEST_F(PreconsolidationOfARun, BeginsInACaseThatStartsFromAnElasticResult) {
  const json first = run(write_bank("model = 'linear_elastic', young_modulus = '5 MPa'") + settle, "first");
  const json second = run(clay + go_on + "[initial]\nresult = \"first\"\n", "second");
  EXPECT_EQ(second.at("stages")[0].at("preconsolidation").at("points"), second.at("mesh").at("points"));
}

TEST_F(PreconsolidationOfARun, IsThereWhenTheStrengthIsReduced) {
  const json summary = run(clay + settle + R"(
[analysis]
kind = "strength_reduction"
[strength_reduction.curve]
enabled = false
[strength_reduction.frozen]
meshes = 1
from = 1
to = 6
resolution = 0.5
)",
                           "reduced");
  // Soil that stayed elastic would be stable at every factor.
  const double factor = summary.at("factor_of_safety").at("frozen").at("factor");
  EXPECT_GT(factor, 1);
  EXPECT_LT(factor, 6);
}

}  // namespace
}  // namespace talus
