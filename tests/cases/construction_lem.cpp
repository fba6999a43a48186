// SPDX-License-Identifier: MIT
// Stages of an embankment on soft clay against limit equilibrium: lifts that fail undrained against LEM with the
// undrained strength of their initial or consolidated stress, and the consolidated embankment against Spencer's method.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "cases/methods_slope.hpp"
#include "mesh/locate.hpp"
#include "run/construction/stage_model.hpp"
#include "run/construction/undrained_strengths.hpp"
#include "run/fem/start_stress.hpp"

namespace talus {
namespace {

constexpr double degree = std::numbers::pi / 180, friction = 24 * degree, cohesion = 3e3, depth = 6;

/// Two lifts on clay whose ground drains. Soil bears tension up to the apex of its criterion, as in LEM.
const char* const embankment = R"(
title = "Embankment on soft clay"
[[geometry.polygon]]
name = "clay"
points = [[0, 0], [34, 0], [34, 6], [0, 6]]
[[geometry.polygon]]
name = "lift_1"
points = [[0, 6], [16, 6], [11.5, 7.5], [0, 7.5]]
[[geometry.polygon]]
name = "lift_2"
points = [[0, 7.5], [11.5, 7.5], [8.5, 8.5], [0, 8.5]]
[[geometry.line]]
name = "ground"
points = [[0, 6], [34, 6]]
[materials.clay]
model = "mohr_coulomb"
unit_weight = 17
porosity = 0.5
cohesion = 3
friction_angle = 24
dilatancy_angle = 0
tensile_strength = 6.7
young_modulus = "4 MPa"
poisson_ratio = 0.33
[materials.clay.water]
retention = "saturated"
conductivity = "2e-9 m/s"
[materials.fill_1]
model = "mohr_coulomb"
unit_weight = 18
cohesion = 1
friction_angle = 32
dilatancy_angle = 0
tensile_strength = 1.6
young_modulus = "10 MPa"
poisson_ratio = 0.3
[materials.fill_2]
model = "mohr_coulomb"
unit_weight = 18
cohesion = 1
friction_angle = 32
dilatancy_angle = 0
tensile_strength = 1.6
young_modulus = "10 MPa"
poisson_ratio = 0.3
[regions]
clay = "clay"
lift_1 = "fill_1"
lift_2 = "fill_2"
[initial]
stress = "k0"
k0 = 0.6
pore_pressure = "water_table"
water_table = [[0, 6], [34, 6]]
[[hydraulic]]
on = "ground"
condition = "total_head"
head = 6
[analysis]
methods = ["fem"]
[fem]
size = 0.75
meshes = 1
[[construction]]
name = "first"
duration = 0
add = ["lift_1"]
[[construction]]
name = "pause"
duration = "20 year"
[[construction]]
name = "second"
duration = 0
add = ["lift_2"]
)";

const char* const slices = R"(
[lem]
methods = ["spencer"]
noncircular = false
yield_acceleration = false
minima = 1
referee = false
)";

using Changes = std::vector<input::Override>;

/// The stages one after the other, with their stresses.
class Stages {
 public:
  explicit Stages(const Changes& changes) : loaded_(input::read_case_text(embankment, "embankment.toml", changes)) {
    std::vector<std::string> notes;
    mesh_ = run::make_whole_mesh(loaded_.data, notes);
    stage_ = run::make_stage_model(loaded_.data, run::before_stages, mesh_, nullptr);
    fem::SolidModel<2> solid = stage_->solid.model;
    solid.pore_stress = fem::find_corner_stress<2>(stage_->model, stage_->model.steady_head);
    const auto found = fem::find_equilibrium<2>(solid, run::make_solid_options(loaded_.data.fem, 1));
    EXPECT_TRUE(found.converged);
    state_ = {found.at, stage_->model.steady_head};
  }
  /// Computes the next stage and returns the fraction of its change that is in equilibrium.
  double advance(int load_steps = 10, int halvings = 3) {
    const int number = next_++;
    const auto water = std::make_shared<const input::KnownWater>(
        input::KnownWater{*stage_->solid.mesh, run::find_pressures(*stage_, state_.head),
                          std::vector<std::array<double, 2>>(mesh_->elements.size())});
    auto next = run::make_stage_model(loaded_.data, number, mesh_, water);
    const auto start = fem::carry_state<2>(stage_->model, state_, next->model, next->elevation);
    fem::ConsolidationSchedule schedule;
    schedule.start = run::find_stage_start(loaded_.data, number);
    schedule.duration = loaded_.data.construction[static_cast<std::size_t>(number)].duration;
    schedule.load_steps = load_steps;
    schedule.most_halvings = halvings;
    schedule.threads = 1;
    const auto result = fem::run_stage<2>(next->model, start, schedule);
    stage_ = std::move(next);
    state_ = result.outputs.back().at;
    return result.reached;
  }
  /// s_u = c cos φ + s' sin φ at a place, with the mean effective stress s' in the plane, which undrained shearing of
  /// soil without dilation keeps.
  double find_strength(const Vec<2>& x) const {
    const int e = mesh::find_element(*mesh_, x, 0);
    const auto xi = mesh::to_local(*mesh_, e, x);
    const std::array<double, 3> share{1 - xi[0] - xi[1], xi[0], xi[1]};
    const auto mesh = fem::make_quadratic<2>(*stage_->solid.mesh, fem::list_cuts(stage_->solid.model));
    const auto k = static_cast<std::size_t>(std::find(mesh.linear_element.begin(), mesh.linear_element.end(), e) -
                                            mesh.linear_element.begin());
    std::array<double, 3> mean;
    for (std::size_t q = 0; q < 3; ++q)
      mean[q] = -(state_.solid.stress[3 * k + q][0] + state_.solid.stress[3 * k + q][1]) / 2;
    // Linear in the element: the points have the shares 2/3, 1/6, 1/6.
    double s = 0;
    for (std::size_t q = 0; q < 3; ++q) s += share[q] * (2 * mean[q] - (mean[0] + mean[1] + mean[2]) / 3);
    return cohesion * std::cos(friction) + std::max(0.0, s) * std::sin(friction);
  }

 private:
  input::LoadedCase loaded_;
  std::shared_ptr<const mesh::Mesh<2>> mesh_;
  std::unique_ptr<run::StageModel> stage_;
  fem::ConsolidationState<2> state_;
  int next_ = 0;
};

void remove_part(std::string& text, const std::string& from, const std::string& to) {
  const auto begin = text.find(from);
  text.erase(begin, text.find(to, begin) - begin);
}

/// The case without the second lift.
std::string make_low_embankment() {
  std::string text = embankment;
  remove_part(text, "[[geometry.polygon]]\nname = \"lift_2\"", "[[geometry.line]]");
  remove_part(text, "[materials.fill_2]", "[regions]");
  remove_part(text, "lift_2 =", "[initial]");
  text.erase(text.rfind("[[construction]]"));
  return text;
}

/// The case for LEM with the undrained strengths of the present stress, in total stresses.
std::string make_undrained_case(std::string text, const Stages& stages) {
  std::vector<double> places, levels, strengths;
  for (double x = 0.25; x < 34; x += 1) places.push_back(x);
  for (double y = depth - 0.05; y > 0; y -= 0.6) levels.push_back(y);
  for (const double x : places)
    for (const double y : levels) strengths.push_back(stages.find_strength({x, y}) / 1e3);
  remove_part(text, "[materials.clay]", "[materials.fill_1]");
  remove_part(text, "[initial]", "[analysis]");
  text.erase(text.find("[[construction]]"));
  return text + slices +
         fmt::format(
             "[materials.clay]\nmodel = \"tresca\"\nunit_weight = 17\nprofile_x = {}\nprofile_levels = {}\n"
             "profile_strengths = {}\n",
             places, levels, strengths);
}

class ConstructionLem : public MethodsTest {
 protected:
  /// Spencer's factor with the undrained strengths of the present stress under a lift of this unit weight [kN/m³].
  double find_undrained_factor(const std::string& text, const std::string& lift, double unit_weight) {
    return find_factor(run(text, {{"analysis.methods", "[\"lem\"]"},
                                  {"materials." + lift + ".unit_weight", fmt::format("{}", unit_weight)}}),
                       "spencer");
  }
};

/// The fill spreads and is at its tensile strength, where the tangent has no stiffness: Newton's method alone fails.
TEST_F(ConstructionLem, FillAtItsTensileStrengthCreepsToRest) {
  Stages stages(Changes{{"fem.size", "0.43"}});
  EXPECT_EQ(stages.advance(1, 0), 1);
}

TEST_F(ConstructionLem, FirstLiftFailsAtTheStrengthOfTheGround) {
  Stages stages(Changes{{"materials.fill_1.unit_weight", "26"}, {"fem.size", "0.375"}});
  // Level ground: s' = γ' z (1 + K_0)/2.
  const double middle = cohesion * std::cos(friction) + (17e3 - 9810) * 3 * 0.8 * std::sin(friction);
  EXPECT_NEAR(stages.find_strength({22, 3}), middle, 0.03 * middle);
  const std::string text = make_undrained_case(make_low_embankment(), stages);
  const double reached = stages.advance();
  ASSERT_LT(reached, 1);
  const double factor = find_undrained_factor(text, "fill_1", 26 * reached);
  RecordProperty("factor", fmt::format("{:.4f}", factor));
  EXPECT_NEAR(factor, 1, 0.03);
}

TEST_F(ConstructionLem, SecondLiftFailsAtTheStrengthOfConsolidatedGround) {
  Stages stages(Changes{{"materials.fill_2.unit_weight", "60"}});
  const double before = stages.find_strength({6, 3});
  EXPECT_EQ(stages.advance(), 1);
  // Shearing without flow keeps the strength, consolidation increases it.
  EXPECT_NEAR(stages.find_strength({6, 3}), before, 0.01 * before);
  EXPECT_EQ(stages.advance(), 1);
  EXPECT_GT(stages.find_strength({6, 3}), 1.5 * before);
  const std::string text = make_undrained_case(embankment, stages);
  const double reached = stages.advance();
  ASSERT_LT(reached, 1);
  const double factor = find_undrained_factor(text, "fill_2", 60 * reached);
  RecordProperty("factor", fmt::format("{:.4f}", factor));
  RecordProperty("reached", fmt::format("{:.4f}", reached));
  EXPECT_NEAR(factor, 1, 0.03);
}

TEST_F(ConstructionLem, SecondLiftFailsEarlierWithoutThePause) {
  Stages hasty(Changes{{"materials.fill_2.unit_weight", "60"}, {"construction.1.duration", "1"}});
  EXPECT_EQ(hasty.advance(), 1);
  EXPECT_EQ(hasty.advance(), 1);
  EXPECT_LT(hasty.advance(), 0.4);
}

TEST_F(ConstructionLem, ConsolidatedEmbankmentHasSpencersFactor) {
  const auto summary = run(make_low_embankment() + slices,
                           {{"analysis.methods", "[\"lem\", \"fem\"]"}, {"construction.0.factor", "false"}});
  const auto& stage = summary.at("construction").at("stages").at(1);
  EXPECT_LT(stage.at("steps").back().at("excess").get<double>(), 100);
  const double lem = stage.at("factors")[0].at("factor"), fem = stage.at("factors")[1].at("factor");
  EXPECT_NEAR(fem, lem, 0.03 * lem);
}

/// The methods without drainage divide the same strength by the same factor: they agree as in a drained slope.
TEST_F(ConstructionLem, MethodsAgreeOnAFailureWithoutDrainage) {
  const auto summary = run(make_low_embankment() + slices, {{"analysis.methods", R"(["lem", "fem", "bounds"])"},
                                                            {"construction.1.factor", "false"},
                                                            {"construction.1.duration", "1"},
                                                            {"fem.size", "0.43"},
                                                            {"bounds.gap", "0.03"}});
  std::map<std::string, double> drained, undrained;
  for (const auto& factor : summary.at("construction").at("stages").at(0).at("factors"))
    (factor.contains("undrained") ? undrained : drained)[factor.at("method")] = factor.at("factor");
  ASSERT_EQ(undrained.size(), 3);
  EXPECT_NEAR(undrained["lem"], undrained["fem"], 0.03 * undrained["fem"]);
  EXPECT_LT(undrained["bounds"], std::min(undrained["lem"], undrained["fem"]) * 1.005);
  EXPECT_GT(undrained["bounds"], undrained["fem"] * 0.95);
  for (const auto& [method, factor] : drained) EXPECT_LT(undrained[method], factor) << method;
  EXPECT_EQ(summary.at("construction").at("least"), std::min(undrained["lem"], undrained["bounds"]));
}

TEST_F(ConstructionLem, StrengthOfLevelGroundIsThatOfItsStress) {
  const std::string text = make_low_embankment();
  input::Case data = input::read_case_text(text, "embankment.toml", {}).data;
  auto stress = std::make_shared<input::KnownStress>();
  std::vector<std::string> notes;
  stress->mesh = *run::make_whole_mesh(data, notes);
  stress->elements.resize(stress->mesh.elements.size());
  for (int e = 0; e < stress->mesh.element_count(); ++e)
    for (std::size_t q = 0; q < 3; ++q) {
      Vec<2> xi{1.0 / 6, 1.0 / 6};
      if (q > 0) xi[q - 1] = 2.0 / 3;
      const double vertical = (17e3 - 9810) * std::max(0.0, depth - mesh::to_global(stress->mesh, e, xi)[1]);
      stress->elements[static_cast<std::size_t>(e)].stress[q] = {-0.6 * vertical, -vertical, -0.6 * vertical, 0, 0, 0};
    }
  data.initial.known_stress = stress;
  const run::UndrainedStrengths strengths(data);
  ASSERT_EQ(strengths.fault(), "");
  for (const double factor : {1.0, 1.5}) {
    const input::Case made = strengths.make_case(factor);
    EXPECT_EQ(made.materials.at("fill_1").known_strength, nullptr);
    const StrengthLaw& law = *made.materials.at("clay").known_strength;
    const double reduced = std::atan(std::tan(friction) / factor);
    for (const double z : {0.0, 1.3, 5.9}) {
      const double mean = 0.8 * (17e3 - 9810) * z,
                   expected = factor * (cohesion / factor * std::cos(reduced) + mean * std::sin(reduced));
      const StrengthTangent found = law.find_tangent({{12.3, depth - z}});
      EXPECT_NEAR(found.cohesion, expected, 1e-9 * expected) << z;
      EXPECT_EQ(found.tan_friction, 0);
    }
  }
  // A result below the factor of its strength is that of a weaker soil: F = found · cos φ_F / cos φ_1.5.
  const auto cosine = [&](double factor) { return std::cos(std::atan(std::tan(friction) / factor)); };
  const double corrected = strengths.correct(1.45, 1.5);
  EXPECT_LT(corrected, 1.45);
  EXPECT_NEAR(corrected, 1.45 * cosine(corrected) / cosine(1.5), 1e-12);
  EXPECT_EQ(strengths.correct(1.6, 1.5), 1.5);
}

TEST_F(ConstructionLem, ClayThatDilatesHasNoKnownStrengthWithoutDrainage) {
  const auto summary = run(make_low_embankment() + slices, {{"analysis.methods", R"(["lem", "fem"])"},
                                                            {"materials.clay.dilatancy_angle", "5"},
                                                            {"construction.1.factor", "false"}});
  const auto& factors = summary.at("construction").at("stages").at(0).at("factors");
  ASSERT_EQ(factors.size(), 4);
  EXPECT_TRUE(factors[3].at("undrained"));
  EXPECT_TRUE(factors[3].at("factor").is_null());
  EXPECT_THAT(factors[3].at("error").get<std::string>(), testing::HasSubstr("dilates"));
}

}  // namespace
}  // namespace talus
