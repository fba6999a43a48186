// SPDX-License-Identifier: MIT
// Mass scaling that makes the soil too slow for its loading: closed forms of the two times, and the warning.

#include <gtest/gtest.h>

#include <cmath>

#include "run/mpm/stage/stage_warnings.hpp"
#include "support/wet_case.hpp"

namespace talus {
namespace {

constexpr double young = 10e6, poisson = 0.3, height = 2;
constexpr double constrained = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));

mpm::Body<2> make_wet_column(const input::Case& data) {
  return run::prepare<2>(data,
                         support::make_box_mesh<2>(
                             {2, 21}, {0.2, 2.1}, {"soil"}, [](const Vec<2>& x) { return x[1] < height ? 0 : -1; }, 0));
}

TEST(SlowWave, TimesAreTheClosedForms) {
  const input::Case data = support::make_box_case<2>(support::make_wet_soil(young));
  const mpm::Body<2> body = make_wet_column(data);
  const run::StagePlan<2> plan = support::make_stage(data, body, 10, {.mass_scaling = 1e4});
  const run::DrainedWave wave = run::find_drained_wave(body, plan);
  const double density = 0.6 * 2650 + 0.4 * 1000;  // between the outermost points, a part of an element is missing
  EXPECT_NEAR(wave.crossing, height * std::sqrt(1e4 * density / constrained), 0.03 * wave.crossing);
  ASSERT_TRUE(wave.drainage);
  EXPECT_NEAR(*wave.drainage, height * height / (1e-4 * constrained / (1000 * 9.81)), 0.06 * *wave.drainage);
}

TEST(SlowWave, ReportsTheTimeThatIsTooShortAndARemedy) {
  const input::Case data = support::make_box_case<2>(support::make_wet_soil(young));
  const mpm::Body<2> body = make_wet_column(data);
  const auto describe_wave = [&](double scaling, double duration, bool until_rest = false, double factor = 1) {
    run::StagePlan<2> plan =
        support::make_stage(data, body, duration, {.mass_scaling = scaling, .conductivity_factor = factor});
    plan.until_rest = until_rest;
    return run::describe_slow_wave(body, plan).value_or("");
  };
  EXPECT_EQ(describe_wave(1, 1e-3), "") << "nothing is scaled";
  EXPECT_EQ(describe_wave(100, 1000), "") << "0.24 s in 28 s";
  EXPECT_NE(describe_wave(1e5, 1000).find("the soil drains in 28 s"), std::string::npos) << describe_wave(1e5, 1000);
  EXPECT_NE(describe_wave(1e4, 10).find("the stage lasts 10 s"), std::string::npos) << describe_wave(1e4, 10);
  EXPECT_EQ(describe_wave(1e4, 10, true, 1e-3), "") << "it ends at rest, however long that takes, and hardly drains";
  // The proposed scaling keeps it below a tenth.
  const std::string message = describe_wave(1e5, 1000);
  const double proposed = std::stod(message.substr(message.find("up to ") + 6));
  EXPECT_LT(proposed, 1e5);
  EXPECT_EQ(describe_wave(proposed, 1000), "");
}

TEST(FastWater, IsReportedOfPermeableSoilInTheDarcyFormulation) {
  input::Material gravel = support::make_wet_soil(young);
  gravel.water.conductivity = 0.05;
  const input::Case data = support::make_box_case<2>(gravel);
  const mpm::Body<2> body = make_wet_column(data);
  const auto describe_wave = [&](input::StepSettings settings) {
    return run::describe_fast_water(body, support::make_stage(data, body, 10, settings)).value_or("");
  };
  EXPECT_EQ(describe_wave({.water = input::WaterMotion::flows}), "");
  EXPECT_NE(describe_wave({.water = input::WaterMotion::seeps}).find("conductivity of 0.05 m/s"), std::string::npos);
  EXPECT_EQ(describe_wave({.water = input::WaterMotion::seeps, .conductivity_factor = 0.1}), "");
}

/// Undrained water carries σ, drained water only u: the mean of σ' = γ'(H - y).
TEST(UndrainedWeight, IsReportedOfSoilAtRestUnderExcessPressure) {
  input::Material silt = support::make_wet_soil(young);
  silt.water.conductivity = 1e-8;
  input::Case data = support::make_box_case<2>(silt);
  data.initial.water.pressure = input::InitialPressure::water_table;
  data.initial.water.water_table = {{0, height}};
  for (const bool is_held : {true, false}) {
    mpm::Body<2> body = make_wet_column(data);
    input::StepSettings settings{.damping = 0.5};
    if (is_held) settings.geometry = input::Geometry::frozen, settings.water = input::WaterMotion::held;
    const run::CarriedWeight before = run::find_carried_weight(body);
    EXPECT_EQ(support::run_plan(body, support::make_rest_stage(data, body, 20, settings)), results::StageEnd::rest);
    const run::CarriedWeight after = run::find_carried_weight(body);
    const double buoyant = 0.6 * (2650 - 1000) * 9.81 * height / 2;
    const std::string message = run::describe_undrained_weight(body, "gravity", before, {}).value_or("");
    if (is_held) {
      EXPECT_NEAR(after.grains, buoyant, 0.03 * buoyant);
      EXPECT_EQ(message, "");
    } else {
      EXPECT_LT(after.grains, 0.1 * buoyant);
      EXPECT_NE(message.find("stage 'gravity': at its end the pore water carries"), std::string::npos) << message;
    }
  }
}

}  // namespace
}  // namespace talus
