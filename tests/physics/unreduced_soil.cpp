// SPDX-License-Identifier: MIT
// Soil whose strength the factor of safety does not divide: a factor by hand, the definition in all methods of slices,
// and the search and FEM on one slope.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "support/lem_sections.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

using lem::degree;

/// A slope of 1:2 whose upper half is fill on a foundation.
lem::Section make_two_soils(const lem::Soil& foundation, const lem::Soil& fill) {
  lem::Section section = lem::make_section({{-40, 0}, {0, 0}, {20, 10}, {60, 10}}, foundation, -10);
  section.soils.push_back(fill);
  section.regions.push_back({1, {{10, 5}, {60, 5}, {60, 10}, {20, 10}}});
  return section;
}

double find_factor(const lem::Section& section, const lem::Surface& surface, lem::Method method) {
  return lem::find_factor(lem::Slope(section), surface, method);
}

std::vector<lem::Surface> list_surfaces() {
  return {lem::make_arc({8, 20}, 22, 8 - std::sqrt(22. * 22 - 20. * 20), 8 + std::sqrt(22. * 22 - 10. * 10)),
          lem::make_polyline({{-2, 0}, {4, -2}, {14, -1}, {26, 10}})};
}

TEST(UnreducedSoil, ResistsWithItsWholeStrengthOnACircle) {
  // φ = 0: moments about the centre give F = R Σ s l of the reduced soil over Σ W x - R Σ s l of the other.
  lem::Section section = make_two_soils(lem::make_soil(25, 0, 18), lem::make_soil(12, 0, 18));
  const lem::Surface circle = list_surfaces()[0];
  constexpr double none = 1e-9;
  section.soils[0].cohesion = 25, section.soils[1].cohesion = none;
  const double foundation = find_factor(section, circle, lem::Method::bishop);  // R Σ s l / Σ W x of each soil
  section.soils[0].cohesion = none, section.soils[1].cohesion = 12;
  const double fill = find_factor(section, circle, lem::Method::bishop);
  section.soils[0].cohesion = 25;
  section.soils[1].reduced = false;
  for (const lem::Method method : {lem::Method::fellenius, lem::Method::bishop, lem::Method::spencer})
    EXPECT_NEAR(find_factor(section, circle, method), foundation / (1 - fill), 1e-6) << get_title(method);
}

TEST(UnreducedSoil, HasTheFactorOfSoilThatIsThatMuchStronger) {
  lem::Soil fill = lem::make_soil(6, 30, 18);
  fill.reduced = false;
  const lem::Section section = make_two_soils(lem::make_soil(12, 22, 19), fill);
  for (const lem::Surface& surface : list_surfaces())
    for (const lem::Method method : lem::all_methods) {
      if (method == lem::Method::bishop && !surface.circle) continue;
      const double factor = find_factor(section, surface, method);
      lem::Section stronger = section;
      // Janbu's correction multiplies the factor, and does not enter the equations.
      const double correction =
          method == lem::Method::janbu_corrected ? factor / find_factor(section, surface, lem::Method::janbu) : 1;
      stronger.soils[1].reduced = true;
      stronger.soils[1].cohesion *= factor / correction;
      stronger.soils[1].friction_angle = std::atan(factor / correction * std::tan(30 * degree));
      EXPECT_GT(factor, 0.5);
      EXPECT_NEAR(find_factor(stronger, surface, method), factor, 1e-6 * factor) << get_title(method);
    }
}

TEST(UnreducedSoil, MayHaveACurvedEnvelope) {
  const auto bend = [](double times) {
    return std::make_shared<const StrengthLaw>(
        StrengthLaw{[times](const StrengthPlane& plane) {
                      const double at = std::max(1.0, plane.normal);
                      return StrengthTangent{times * 1.5 * std::sqrt(at), times * 1.5 / std::sqrt(at)};
                    },
                    true, false});
  };
  lem::Soil fill = lem::make_soil(6, 30, 18);
  fill.law = bend(1);
  fill.reduced = false;
  lem::Section section = make_two_soils(lem::make_soil(12, 22, 19), fill);
  for (const lem::Surface& surface : list_surfaces()) {
    const double factor = find_factor(section, surface, lem::Method::spencer);
    lem::Section stronger = section;
    stronger.soils[1].law = bend(factor);
    stronger.soils[1].reduced = true;
    EXPECT_NEAR(find_factor(stronger, surface, lem::Method::spencer), factor, 1e-5 * factor);
  }
}

TEST(UnreducedSoil, ThatHoldsTheMassAloneHasNoFactor) {
  lem::Soil fill = lem::make_soil(500, 0, 18);
  fill.reduced = false;
  const lem::Section section = make_two_soils(lem::make_soil(25, 0, 18), fill);
  const lem::Slope slope(section);
  lem::CutSurface cut = lem::cut_surface(slope, list_surfaces()[0], 50, lem::report_only());
  const lem::Solution solution = lem::solve(slope, cut, lem::Method::bishop, lem::report_only(), false);
  EXPECT_EQ(solution.refusal, lem::Refusal::held);
  EXPECT_EQ(solution.factor, 0);
}

class UnreducedSoilCase : public testing::Test {
 protected:
  nlohmann::json run(const std::string& methods, const std::string& fill) {
    run::RunOptions options;
    options.folder = folder_ / "run";
    options.overwrite = true;
    const std::string text = fmt::format(R"(
analysis.methods = [{}]
mesh.size = 1.2
fem = {{ meshes = 1, flow = "associated", from = 1.2, to = 1.6, resolution = 0.005 }}
lem.methods = ["spencer"]
lem.referee = false
bounds = {{ gap = 0.06, tension = "apex" }}
geometry.polygon = [
  {{ name = "base", points = [[-15, -5], [40, -5], [40, 5], [10, 5], [0, 0], [-15, 0]] }},
  {{ name = "fill", points = [[10, 5], [40, 5], [40, 10], [20, 10]] }},
]
regions = {{ base = "clay", fill = "crust" }}
boundary = [{{ on = "bottom", fix = "full" }}, {{ on = "left", fix = "normal" }}, {{ on = "right", fix = "normal" }}]
[materials.clay]
model = "mohr_coulomb"
unit_weight = 18
young_modulus = 20000
poisson_ratio = 0.3
cohesion = 9
friction_angle = 22
dilatancy_angle = 22
tensile_strength = 0
[materials.crust]
model = "mohr_coulomb"
unit_weight = 18
young_modulus = 20000
poisson_ratio = 0.3
tensile_strength = 0
{}
)",
                                         methods, fill);
    return support::run_case(input::read_case_text(text, (folder_ / "slope.toml").string()), options);
  }
  const std::filesystem::path folder_ = support::make_scratch("unreduced_soil");
};

TEST_F(UnreducedSoilCase, RaisesTheFactorAlikeInAllMethods) {
  const std::string crust = "cohesion = 6\nfriction_angle = 28\ndilatancy_angle = 28\n";
  const auto find = [&](const std::string& fill) {
    const nlohmann::json summary = run(R"("lem", "fem", "bounds")", fill);
    return std::array{summary.at("lem").at("critical")[0].at("factor").get<double>(),
                      summary.at("fem").at("runs")[0].at("factor").get<double>(),
                      summary.at("bounds").at("lower").get<double>(), summary.at("bounds").at("upper").get<double>()};
  };
  const auto all = find(crust), kept = find(crust + "reduced = false\n");
  EXPECT_GT(kept[0], 1.03 * all[0]) << "it must matter to test anything";
  for (const auto& [lem, fem, lower, upper] : {all, kept}) {
    EXPECT_NEAR(fem, lem, 0.03 * lem);
    EXPECT_LT(lower, upper);
    EXPECT_LT(lower, 1.01 * lem);
    EXPECT_GT(upper, 0.98 * lem);
    EXPECT_GT(fem, 0.99 * lower);
  }
}

}  // namespace
}  // namespace talus
