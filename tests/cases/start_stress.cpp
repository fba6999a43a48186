// SPDX-License-Identifier: MIT
// MPM with the initial stress of FEM: a stable slope does not move at release and has the same factor as with any other
// initial stress; an unstable slope starts from the equilibrium at a strength reduction factor below 1.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "cases/methods_slope.hpp"
#include "input/case/start.hpp"
#include "run/fem/start_stress.hpp"

namespace talus {
namespace {

/// The dry slope of the source in elements of 1 m, released at once on moving geometry.
std::string write_dry(const std::string& stress, const std::string& more = "") {
  return support::write_slope("dry", {"mesh.size=1", "initial.stress='" + stress + "'", "materials.sand.cohesion=6"}) +
         "[analysis]\nmethods = [\"mpm\"]\n" + more;
}
constexpr const char* let_go = "[[stage]]\nname = \"let go\"\nduration = 2\ndamping = 0.05\n";
constexpr const char* hold =
    "[[stage]]\nname = \"hold\"\nduration = 20\nuntil = \"rest\"\ngeometry = \"frozen\"\ndamping = 0.75\n";

class StartStress : public MethodsTest {};

TEST_F(StartStress, ADrySlopeReleasedAtOnceDoesNotMove) {
  const auto balanced = run(write_dry("elements", let_go));
  EXPECT_EQ(balanced.at("stress_start").at("factor"), 1);
  const double moved = balanced.at("runout").at("largest_displacement");
  RecordProperty("elements", fmt::format("{:.2e} m", moved));
  EXPECT_LT(moved, 1e-3);
  EXPECT_EQ(balanced.at("runout").at("moved_volume"), 0);
  // From a level ground's stress it has to find its balance first.
  const double settled = run(write_dry("k0", let_go)).at("runout").at("largest_displacement");
  RecordProperty("k0", fmt::format("{:.2e} m", settled));
  EXPECT_GT(settled, 5 * moved);
}

TEST_F(StartStress, TheFactorIsThatOfAnyOtherStart) {
  const std::string reduction =
      std::string(hold) +
      "[strength_reduction.curve]\nenabled = false\n[strength_reduction.frozen]\nmeshes = 1\nresolution = 0.01\n";
  const std::vector<input::Override> changes{{"analysis.kind", "'strength_reduction'"}, {"mesh.size", "2"}};
  const auto balanced = run(write_dry("elements", reduction), changes).at("factor_of_safety");
  const auto column = run(write_dry("k0", reduction), changes).at("factor_of_safety");
  RecordProperty("factors",
                 fmt::format("{:.4f}, {:.4f}", balanced.at("value").get<double>(), column.at("value").get<double>()));
  EXPECT_NEAR(balanced.at("value").get<double>(), column.at("value").get<double>(), 0.011);
}

// With φ = 20° the slope needs a little more strength than it has.
TEST_F(StartStress, ASlopeThatFallsBeginsWithTheLeastStrengthThatHoldsIt) {
  const auto divide = [](double factor) {
    constexpr double degree = std::numbers::pi / 180;
    return input::read_case_text(write_dry("elements", let_go), "dry.toml",
                                 {{"mesh.size", "2"},
                                  {"materials.sand.cohesion", fmt::format("{}", 2 / factor)},
                                  {"materials.sand.friction_angle",
                                   fmt::format("{}", std::atan(std::tan(20 * degree) / factor) / degree)}})
        .data;
  };
  EXPECT_FALSE(run::find_balance(divide(1), 1).stands);
  results::StressStart result;
  const auto known = run::find_start_stress(divide(1), 1, result);
  EXPECT_LT(result.factor, 1);
  EXPECT_GT(result.factor, 0.5);
  EXPECT_LT(result.force_residual, 1e-4);
  // The missing strength: with it the slope is stable, with a hundredth less it is not.
  EXPECT_TRUE(run::find_balance(divide(result.factor), 1).stands);
  EXPECT_FALSE(run::find_balance(divide(result.factor + 0.0101), 1).stands);
}

TEST_F(StartStress, ReportsWhatACaseLacks) {
  EXPECT_NE(find_fault(write_dry("elements", let_go), {{"materials.sand.model", "'cam_clay'"}}).size(), 0u);
  const std::string fault = find_fault(
      write_dry("elements", let_go),
      {{"boundary", "[{ on = 'bottom', fix = 'friction', friction = 0.3 }, { on = 'left', fix = 'normal' }]"}});
  EXPECT_NE(fault.find("FEM has no wall with friction"), std::string::npos) << fault;
}

}  // namespace
}  // namespace talus
