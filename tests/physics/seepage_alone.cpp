// SPDX-License-Identifier: MIT
// Flow of water alone against closed forms: columns, layers, and the cut-off of Pavlovsky and Harr.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "support/run_json.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

constexpr double gamma_w = 9810;

nlohmann::json run(const std::string& text) {
  run::RunOptions options;
  options.folder = support::make_scratch("seepage_alone") / "run";
  options.overwrite = true;
  return support::run_case(input::read_case_text(text, "flow.toml"), options);
}

const nlohmann::json& last_state(const nlohmann::json& summary) {
  return summary.at("flow").at("states").back();
}

TEST(SeepageAlone, OfAColumnIsExact) {
  // 2 m of sand under 1 m of water; the head at its base is 1.2 m above the pond.
  const nlohmann::json summary = run(R"(
analysis.methods = ["seepage"]
mesh.size = 0.25
geometry.polygon = [{ name = "sand", points = [[0, 0], [4, 0], [4, 2], [0, 2]] }]
geometry.line = [{ name = "ground", points = [[0, 2], [4, 2]] }]
regions.sand = "sand"
materials.sand = { unit_weight = 20, porosity = 0.4, water = { retention = "saturated", conductivity = 1e-4 } }
hydraulic = [{ on = "bottom", condition = "total_head", head = 4.2 }, { on = "ground", condition = "total_head", head = 3 }]
seepage.section = [{ name = "across", points = [[4, 1], [0, 1]] }, { name = "half", points = [[2, 1.1], [0, 1.1]] }]
seepage.heave = [{ name = "all", x = [1, 3], level = 0.5 }]
)");
  const nlohmann::json& state = last_state(summary);
  const double gradient = 0.6, critical = 20e3 / gamma_w - 1;
  EXPECT_NEAR(state.at("inflow").get<double>(), 4 * 1e-4 * gradient, 1e-9);
  EXPECT_NEAR(state.at("sections")[0].at("discharge").get<double>(), 4 * 1e-4 * gradient, 1e-9);
  EXPECT_NEAR(state.at("sections")[1].at("discharge").get<double>(), 2 * 1e-4 * gradient, 1e-9);
  ASSERT_EQ(state.at("exits").size(), 1u);
  EXPECT_EQ(state.at("exits")[0].at("name"), "ground");
  EXPECT_NEAR(state.at("exits")[0].at("gradient").get<double>(), gradient, 1e-7);
  EXPECT_NEAR(state.at("exits")[0].at("factor").get<double>(), critical / gradient, 1e-6);
  EXPECT_FALSE(state.at("exits")[0].at("grows").get<bool>());
  // 1.5 m of sand on a base with an excess head of 0.9 m.
  EXPECT_NEAR(state.at("heaves")[0].at("factor").get<double>(), critical * 1.5 / 0.9, 1e-6);
  EXPECT_EQ(summary.at("main_factor"), nullptr);
}

TEST(SeepageAlone, LiftsABlanket) {
  // 2 m of clay on gravel with a standpipe level of 3.5 m above its base; standing water of 0.5 m presses on both.
  for (const double water : {0.0, 0.5}) {
    const nlohmann::json summary = run(fmt::format(R"(
analysis.methods = ["seepage"]
mesh.size = 0.25
geometry.polygon = [
  {{ name = "gravel", points = [[0, 0], [4, 0], [4, 1], [0, 1]] }}, {{ name = "clay", points = [[0, 1], [4, 1], [4, 3], [0, 3]] }}]
geometry.line = [{{ name = "ground", points = [[0, 3], [4, 3]] }}]
regions = {{ gravel = "gravel", clay = "clay" }}
materials.gravel = {{ unit_weight = 20, porosity = 0.4, water = {{ retention = "saturated", conductivity = 1e-3 }} }}
materials.clay = {{ unit_weight = 17, porosity = 0.4, water = {{ retention = "saturated", conductivity = 1e-9 }} }}
hydraulic = [{{ on = "bottom", condition = "total_head", head = 4.5 }}, {{ on = "ground", condition = "total_head", head = {} }}]
)",
                                                   3 + water));
    const nlohmann::json& uplift = last_state(summary).at("uplift");
    EXPECT_EQ(uplift.at("layer"), "clay");
    EXPECT_NEAR(uplift.at("factor").get<double>(), 17e3 * 2 / (gamma_w * (3.5 - water)), 1e-4) << water;
    EXPECT_NEAR(uplift.at("at")[1].get<double>(), 1, 1e-9);
  }
}

TEST(SeepageAlone, FollowsSeries) {
  // Incompressible saturated soil follows the boundary at once.
  const nlohmann::json summary = run(R"(
analysis.methods = ["seepage"]
mesh.size = 0.5
geometry.polygon = [{ name = "sand", points = [[0, 0], [4, 0], [4, 2], [0, 2]] }]
geometry.line = [{ name = "ground", points = [[0, 2], [4, 2]] }]
regions.sand = "sand"
materials.sand = { unit_weight = 20, porosity = 0.4, water = { retention = "saturated", conductivity = 1e-4 } }
hydraulic = [
  { on = "bottom", condition = "total_head", head = [[0, 3], ["2 day", 5]] },
  { on = "ground", condition = "total_head", head = 2 }]
seepage.times = [1, 2]
)");
  const nlohmann::json& states = summary.at("flow").at("states");
  ASSERT_EQ(states.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(states[i].at("time").get<double>(), 86400.0 * static_cast<double>(i));
    EXPECT_NEAR(states[i].at("exits")[0].at("gradient").get<double>(), (1 + static_cast<double>(i)) / 2, 1e-6);
  }
  // The worst of all times is the named result.
  for (const auto& result : summary.at("results")) {
    if (result.at("name") == "flow.exit_gradient[ground]") {
      EXPECT_NEAR(result.at("value").get<double>(), 1.5, 1e-6);
    }
  }
}

TEST(SeepageAlone, DrainsFreelyUnderAGradientOfOne) {
  // Water stands at the ground: q = k and no pressure anywhere. Less rain, q = k exp(−αs), has the suction ln(k/q)/α.
  const auto run_column = [](const char* ground) {
    return run(std::string(R"(
analysis.methods = ["seepage"]
mesh.size = 0.25
geometry.polygon = [{ name = "sand", points = [[0, 0], [4, 0], [4, 2], [0, 2]] }]
geometry.line = [{ name = "ground", points = [[0, 2], [4, 2]] }]
regions.sand = "sand"
seepage.section = [{ name = "half", points = [[3, 0.7], [1, 1.3]] }]
[materials.sand]
porosity = 0.4
[materials.sand.water]
retention = "exponential"
relative_conductivity = "exponential"
decay = 0.2
conductivity = 1e-4
[[hydraulic]]
on = "bottom"
condition = "free_drainage"
[[hydraulic]]
on = "top"
)") + ground);
  };
  const nlohmann::json full = run_column("condition = \"total_head\"\nhead = 2\n");
  EXPECT_NEAR(last_state(full).at("outflow").get<double>(), 4e-4, 1e-10);
  EXPECT_NEAR(last_state(full).at("sections")[0].at("discharge").get<double>(), -2e-4, 1e-10) << "it flows down";
  EXPECT_NEAR(full.at("seepage").at("largest_suction").get<double>(), 0, 1);
  EXPECT_TRUE(last_state(full).at("exits").empty());
  const nlohmann::json rain = run_column("condition = \"rain\"\nrate = \"2.5e-5 m/s\"\n");
  EXPECT_NEAR(last_state(rain).at("outflow").get<double>(), 1e-4, 1e-10);
  EXPECT_NEAR(rain.at("seepage").at("largest_suction").get<double>(), std::log(4.0) / 0.2e-3, 1);
}

/// One half of a cut-off of depth s in a layer of thickness T: below its tip the head is the mean of both sides.
nlohmann::json run_cut_off(double s, double thickness, double head) {
  return run(fmt::format(R"(
analysis.methods = ["seepage"]
mesh = {{ size = 0.3, refine = [
  {{ near = [[0, 0], [0, {0}]], size = 0.03, distance = 1.5 }}, {{ near = [[0, {0}]], size = 0.02, distance = 0.3 }}] }}
geometry.polygon = [{{ name = "sand", points = [[0, {1}], [50, {1}], [50, 0], [0, 0]] }}]
geometry.line = [{{ name = "ground", points = [[0, 0], [50, 0]] }}, {{ name = "below", points = [[0, {1}], [0, {0}]] }}]
regions.sand = "sand"
materials.sand = {{ unit_weight = 20, porosity = 0.4, water = {{ retention = "saturated", conductivity = 1e-5 }} }}
hydraulic = [{{ on = "below", condition = "total_head", head = {2} }}, {{ on = "ground", condition = "total_head", head = 0 }}]
seepage.section = [{{ name = "below the tip", points = [[0.5, {1}], [0.5, 0]] }}]
)",
                         -s, -thickness, head / 2));
}

TEST(SeepageAlone, UnderACutOffFollowsHarr) {
  // Harr (1962), 5-2: q = k h K'/(2K) with the modulus sin(πs/2T), and the exit gradient beside the wall is
  // π h/(4 K T sin(πs/2T)), which becomes h/(πs) in a deep layer.
  const double thickness = 10, head = 3;
  for (const double s : {2.0, 5.0}) {
    const nlohmann::json summary = run_cut_off(s, thickness, head);
    const nlohmann::json& state = last_state(summary);
    const double modulus = std::sin(std::numbers::pi * s / (2 * thickness)), whole = std::comp_ellint_1(modulus),
                 other = std::comp_ellint_1(std::sqrt(1 - modulus * modulus));
    EXPECT_NEAR(state.at("outflow").get<double>() / (1e-5 * head * other / (2 * whole)), 1, 0.01) << s;
    const nlohmann::json* exit = nullptr;
    for (const auto& e : state.at("exits"))
      if (e.at("name") == "ground") exit = &e;
    ASSERT_NE(exit, nullptr);
    const double exact = std::numbers::pi * head / (4 * whole * thickness * modulus);
    EXPECT_NEAR(exit->at("gradient").get<double>() / exact, 1, 0.01) << s;
    EXPECT_NEAR(exit->at("at")[0].get<double>(), 0, 0.1);
    EXPECT_FALSE(exit->at("grows").get<bool>());
  }
}

}  // namespace
}  // namespace talus
