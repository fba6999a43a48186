// SPDX-License-Identifier: MIT
// Tresca soil in element tests, LEM, FEM and MPM: against frictionless Mohr–Coulomb, to which it is equivalent if the
// strength is uniform with depth, and otherwise between methods.

#include <array>
#include <limits>

#include "cases/methods_slope.hpp"
#include "material/tresca.hpp"
#include "site/design_values.hpp"

namespace talus {
namespace {

using nlohmann::json;

constexpr const char* tresca = "model = \"tresca\"\nundrained_strength = 25\n";
constexpr const char* growing = "undrained_gradient = 1.5\nundrained_level = 15\n";
// Without friction nothing but this key limits tension; Tresca's has no limit of its own.
constexpr const char* frictionless =
    "model = \"mohr_coulomb\"\ncohesion = 25\nfriction_angle = 0\ndilatancy_angle = 0\ntensile_strength = 1e12\n";
constexpr const char* growing_cohesion = "cohesion_gradient = 1.5\ncohesion_level = 15\n";

/// The dry slope of the source in another soil; `soil` gives its model and strength.
std::string write_soil(const std::string& methods, const std::string& soil, const std::string& more) {
  std::string text = write_case(methods, more);
  for (const char* key : {"model", "cohesion", "friction_angle", "dilatancy_angle", "tensile_strength"}) {
    const auto at = text.find("\n" + std::string(key) + " =", text.find("[materials.sand]"));
    text.erase(at, text.find('\n', at + 1) - at);
  }
  return text.insert(text.find('\n', text.find("[materials.sand]")) + 1, soil);
}

class TrescaTest : public MethodsTest {};

TEST(Tresca, ShearsAtItsStrengthDividedByTheFactorAndKeepsItsMeanStress) {
  const auto elastic = material::LinearElastic::from_young(10e6, 0.49);
  for (const double factor : {1.0, 1.25}) {
    const material::Tresca law(elastic, 25e3, factor);
    std::array<double, 4> stress{-40e3, -40e3, -40e3, 0}, d{0, 0, 0, 0.05};
    std::array<double, 2> state{0, 10e3};  // 10 kPa more than at the level
    EXPECT_TRUE((law.update<4, double>(stress.data(), d.data(), state.data(), true)).any_plastic);
    EXPECT_NEAR(stress[3], 35e3 / factor, 1e-3);
    EXPECT_NEAR((stress[0] + stress[1] + stress[2]) / 3, -40e3, 1e-3);
    EXPECT_EQ(state[1], 10e3) << "the strength moves with the soil";
  }
}

TEST_F(TrescaTest, SlicesGiveTheFactorOfFrictionlessSoil) {
  for (const bool grows : {false, true}) {
    const double factor =
        find_factor(run(write_soil("\"lem\"", std::string(tresca) + (grows ? growing : ""), few_circles)), "spencer");
    const double other = find_factor(
        run(write_soil("\"lem\"", std::string(frictionless) + (grows ? growing_cohesion : ""), few_circles)),
        "spencer");
    EXPECT_EQ(factor, other);
    EXPECT_GT(factor, grows ? 1.2 : 0.8);
  }
}

TEST_F(TrescaTest, ElementsGiveTheFactorOfFrictionlessSoil) {
  const std::string fem = "[fem]\nsize = 2.5\nresolution = 0.05\n";
  for (const bool grows : {false, true}) {
    const json a = run(write_soil("\"fem\"", std::string(tresca) + (grows ? growing : ""), fem));
    const json b = run(write_soil("\"fem\"", std::string(frictionless) + (grows ? growing_cohesion : ""), fem));
    EXPECT_EQ(support::find_result(a, "fem.factor"), support::find_result(b, "fem.factor"));
    EXPECT_TRUE(support::find_result(a, "fem.factor").has_value());
  }
}

TEST_F(TrescaTest, PointsGiveTheFactorOfFrictionlessSoilAndFollowAStrengthThatGrows) {
  const std::string more = R"(
[strength_reduction.curve]
enabled = false
[strength_reduction.frozen]
meshes = 1
resolution = 0.05
[[stage]]
name = "weight"
duration = 10
until = "rest"
geometry = "frozen"
damping = 0.5
)";
  const auto reduce = [&](const std::string& soil) {
    return *support::find_result(run(write_soil("\"lem\", \"mpm\"", soil, std::string(few_circles) + more),
                                     {{"analysis.kind", "\"strength_reduction\""}}),
                                 "factor_of_safety");
  };
  EXPECT_EQ(reduce(tresca), reduce(frictionless));
  const double factor = reduce(std::string(tresca) + growing);
  const double slices = find_factor(run(write_soil("\"lem\"", std::string(tresca) + growing, few_circles)), "spencer");
  // Elements of H/4 lock: the factor lies above that of LEM by some per cent.
  EXPECT_NEAR(factor, slices, 0.15 * slices);
}

TEST_F(TrescaTest, TakesNoPoreWaterNoFrictionAndNoCohesion) {
  const std::string sound = write_soil("\"lem\"", tresca, few_circles);
  EXPECT_NE(
      find_fault(sound + "[materials.sand.water]\nretention = \"saturated\"\nconductivity = 1e-5\n")
          .find("material 'sand' is described in total stresses, model = \"tresca\": it has no pore water of its own"),
      std::string::npos);
  EXPECT_NE(find_fault(write_soil("\"lem\"", std::string(tresca) + "cohesion = 5\n", few_circles))
                .find("'cohesion' in [materials.sand] has a meaning only with model = \"mohr_coulomb\""),
            std::string::npos);
  EXPECT_NE(
      find_fault(write_soil("\"lem\"", "model = \"tresca\"\n", few_circles)).find("missing key 'undrained_strength'"),
      std::string::npos);
}

TEST_F(TrescaTest, InStagesPoreWaterChangesNoFactor) {
  // "Undrained B": pore pressures carry weight and leave the strength as it is, that of frictionless soil.
  const std::string circle = R"(
[lem]
methods = ["spencer"]
search = "none"
referee = false
yield_acceleration = false
[[lem.surface]]
name = "circle"
centre = [25, 23]
radius = 19
)";
  const std::string stages = circle + R"(
[materials.sand.water]
retention = "saturated"
conductivity = "1e-8 m/s"
[initial]
stress = "k0"
k0 = 0.6
pore_pressure = "water_table"
water_table = [[0, 5], [44, 5]]
[fem]
size = 4
meshes = 1
resolution = 0.1
[[construction]]
name = "rest"
duration = 30
drainage = "drained"
)";
  const std::string soil = std::string(tresca) + growing, other = std::string(frictionless) + growing_cohesion;
  const std::string weight = fmt::format("{}", (0.6 * 2650 + 0.4 * 1000) * 9.81e-3);
  const json total = run(write_soil("\"lem\"", soil, circle),
                         {{"materials.sand.unit_weight", weight}, {"materials.sand.grain_density", ""}});
  const double factor = total.at("lem").at("given")[0].at("factor");
  const json found = run(write_soil("\"fem\", \"lem\"", soil, stages));
  // The water table is one more side of slices.
  EXPECT_NEAR(support::find_result(found, "construction[rest].lem").value_or(0), factor, 1e-4 * factor);
  EXPECT_EQ(support::find_result(found, "construction[rest].fem"),
            support::find_result(run(write_soil("\"fem\"", other, stages)), "construction[rest].fem"));
  EXPECT_NE(find_fault(write_soil("\"fem\", \"mpm\"", soil, stages)).find("it has no pore water of its own"),
            std::string::npos);
}

TEST_F(TrescaTest, PartialFactorsDivideTheUndrainedStrengthAndItsGrowth) {
  const input::Case data =
      input::read_case_text(write_soil("\"lem\"", std::string(tresca) + growing,
                                       "[partial_factors]\nset = \"by_hand\"\nundrained = 1.4\nfriction = 1.25\n"),
                            "slope.toml")
          .data;
  const site::DesignValues design = site::apply_partial_factors(data);
  const material::TrescaInput& soil = design.data.materials.at("sand");
  EXPECT_NEAR(soil.undrained_strength, 25e3 / 1.4, 1e-6);
  EXPECT_NEAR(soil.undrained_gradient, 1.5e3 / 1.4, 1e-6);
}

}  // namespace
}  // namespace talus
