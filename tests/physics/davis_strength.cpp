// SPDX-License-Identifier: MIT
// Davis's strengths in place of a flow rule with ψ < φ, in the strength reduction by FEM.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "material/every_law.hpp"
#include "run/fem/solid_of_case.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

using input::DavisRule;
constexpr double degree = std::numbers::pi / 180;

TEST(DavisStrength, HasTheSharesOfItsThreeRules) {
  const double phi = 38 * degree, psi = 8 * degree, factor = 1.4;
  const auto find = [](double f, double p) { return std::cos(p) * std::cos(f) / (1 - std::sin(p) * std::sin(f)); };
  const double phi_f = std::atan(std::tan(phi) / factor), psi_f = std::atan(std::tan(psi) / factor);
  EXPECT_EQ(run::compute_davis_share(DavisRule::none, phi, psi, factor), 1);
  EXPECT_NEAR(run::compute_davis_share(DavisRule::a, phi, psi, factor), find(phi, psi), 1e-14);
  EXPECT_NEAR(run::compute_davis_share(DavisRule::b, phi, psi, factor), find(phi_f, psi_f), 1e-14);
  EXPECT_NEAR(run::compute_davis_share(DavisRule::c, phi, psi, factor), find(phi_f, psi), 1e-14);
  for (const DavisRule rule : {DavisRule::a, DavisRule::b, DavisRule::c}) {
    EXPECT_NEAR(run::compute_davis_share(rule, phi, phi, 1), 1, 1e-14) << "associated soil keeps its strength";
    EXPECT_EQ(run::compute_davis_share(rule, 0, 0, factor), 1);
  }
  EXPECT_EQ(run::compute_davis_share(DavisRule::c, phi, phi, factor), 1) << "ψ above the reduced φ";
}

class DavisSlope : public testing::Test {
 protected:
  double find_factor(double cohesion, double tangent, double psi, const std::string& fem) {
    run::RunOptions options;
    options.folder = folder_ / "run";
    options.overwrite = true;
    const double phi = std::atan(tangent) / degree;
    const std::string text = fmt::format(R"(
analysis.methods = ["fem"]
mesh.size = 1.5
fem = {{ meshes = 1, from = 1.0, to = 1.6, resolution = 0.002, {} }}
geometry.polygon = [{{ name = "soil", points = [[-10, -4], [32, -4], [32, 10], [12, 10], [0, 0], [-10, 0]] }}]
regions = {{ soil = "soil" }}
boundary = [{{ on = "bottom", fix = "full" }}, {{ on = "left", fix = "normal" }}, {{ on = "right", fix = "normal" }}]
[materials.soil]
model = "mohr_coulomb"
unit_weight = 18
young_modulus = 20000
poisson_ratio = 0.3
cohesion = {}
friction_angle = {}
dilatancy_angle = {}
tensile_strength = 0
)",
                                         fem, cohesion, phi, psi);
    const nlohmann::json summary =
        support::run_case(input::read_case_text(text, (folder_ / "slope.toml").string()), options);
    return summary.at("fem").at("runs")[0].at("factor").get<double>();
  }
  const std::filesystem::path folder_ = support::make_scratch("davis");
};

TEST_F(DavisSlope, IsTheAssociatedFactorOfTheWeakerSoil) {
  const double tangent = std::tan(35 * degree);
  const double a = find_factor(8, tangent, 0, R"(davis = "a")"), b = find_factor(8, tangent, 0, R"(davis = "b")"),
               c = find_factor(8, tangent, 0, R"(davis = "c")");
  // With ψ = 0 the share is cos φ: of the φ as given for A, of the reduced one for B and C.
  const double share = std::cos(35 * degree);
  EXPECT_NEAR(a, find_factor(8 * share, tangent * share, 0, R"(flow = "associated")"), 0.004);
  EXPECT_NEAR(b, c, 1e-12);
  const double reduced = std::cos(std::atan(tangent / b));
  EXPECT_NEAR(b, find_factor(8 * reduced, tangent * reduced, 0, R"(flow = "associated")"), 0.004);
  EXPECT_LT(a, b);
  EXPECT_LT(b, find_factor(8, tangent, 0, R"(flow = "associated")"));
}

/// β acts in soil that F does not divide: with ψ = 0 and φ = 30° it has tan φ cos φ.
TEST(DavisStrength, ActsInSoilThatIsNotReduced) {
  const std::string soil = R"(
model = "mohr_coulomb"
unit_weight = 18
young_modulus = 20000
poisson_ratio = 0.3
cohesion = 5
friction_angle = 30
dilatancy_angle = 0
tensile_strength = 0
)";
  const std::string text = R"(
analysis.methods = ["fem"]
mesh.size = 2
fem.davis = "a"
geometry.polygon = [
  { name = "fill", points = [[0, 2], [4, 2], [4, 4], [0, 4]] }, { name = "clay", points = [[0, 0], [4, 0], [4, 2], [0, 2]] }]
regions = { fill = "fill", clay = "clay" }
boundary = [{ on = "bottom", fix = "full" }]
)";
  const input::Case data =
      input::read_case_text(text + "[materials.clay]" + soil + "[materials.fill]" + soil + "reduced = false\n",
                            "slope.toml")
          .data;
  const site::Site site(data);
  run::SolidOfCase<2> solid = run::make_solid<2>(site);
  run::set_trial_laws<2>(site, solid, false);
  for (const std::string name : {"fill", "clay"}) {
    const auto& names = solid.mesh->region_names;
    const auto region = static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
    const auto law = std::get<material::MohrCoulomb>(solid.model.make_law(region, 2));
    const double divisor = name == "fill" ? 1 : 2;
    EXPECT_NEAR(std::tan(law.strength().friction_angle), std::sin(30 * degree) / divisor, 1e-12) << name;
    EXPECT_NEAR(law.strength().cohesion, 5e3 * std::cos(30 * degree) / divisor, 1e-9) << name;
  }
}

}  // namespace
}  // namespace talus
