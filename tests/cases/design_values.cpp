// SPDX-License-Identifier: MIT
// Partial factors: exact factors of safety, and the set of parameters that are divided.

#include "site/design_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "input/case/support.hpp"
#include "lem/search/search.hpp"
#include "run/lem/run_lem.hpp"
#include "support/slopes.hpp"

namespace talus::site {
namespace {

/// The dry homogeneous slope of the source: 10 m at 2:1, c = 2 kPa, φ = 30°.
input::Case read(const std::string& more, const std::vector<input::Override>& changes = {}) {
  return input::read_case_text(
             support::write_slope("dry", {"materials.sand.grain_density=2650", "materials.sand.porosity=0.4",
                                          "analysis.methods=['lem']", "lem.noncircular=false"}) +
                 more,
             "dry_slope.toml", changes)
      .data;
}

std::map<lem::Method, lem::Critical> search(const input::Case& data) {
  const run::PreparedSlope prepared = run::prepare_slope(data);
  std::map<lem::Method, lem::Critical> found;
  for (lem::Critical& c : lem::search(*prepared.slope, run::make_search_options(data, 1)).circular) {
    const lem::Method method = c.method;
    found.emplace(method, std::move(c));
  }
  return found;
}

/// All strengths over one number: F over it, on every surface and by every method. The published pairs are 1.4403 and
/// 1.1522 by Bishop, 1.4394 and 1.1515 by Spencer.
TEST(DesignValues, DrainedSlopeHasItsFactorOver125) {
  const DesignValues design = apply_partial_factors(read("[partial_factors]\nset = \"DA1-2\"\n"));
  const auto plain = search(read("")), factored = search(design.data);
  ASSERT_EQ(plain.size(), factored.size());
  ASSERT_GE(plain.size(), 3u);
  const run::PreparedSlope slope = run::prepare_slope(design.data);
  for (const auto& [method, critical] : plain) {
    lem::Checks checks;
    checks.reject = false;
    lem::CutSurface cut = lem::cut_surface(*slope.slope, critical.surface, 50, checks);
    const lem::Solution same = lem::solve(*slope.slope, cut, method, checks, false);
    EXPECT_NEAR(same.factor, critical.solution.factor / 1.25, 2e-4) << to_word(method);
    EXPECT_NEAR(factored.at(method).solution.factor, critical.solution.factor / 1.25, 1e-3) << to_word(method);
  }
  EXPECT_NEAR(factored.at(lem::Method::bishop).solution.factor, 1.1522, 0.005 * 1.1522);
  EXPECT_NEAR(factored.at(lem::Method::spencer).solution.factor, 1.1515, 0.005 * 1.1515);
}

/// γ_G on all weight and c/γ_G are the same slope: the factor with DA1-1 is that of a slope 1.35 times as heavy.
TEST(DesignValues, PermanentActionsAreTheWeightOfTheSoil) {
  const DesignValues design = apply_partial_factors(read("[partial_factors]\nset = \"DA1-1\"\n"));
  input::Case heavy = read("");
  heavy.materials.at("sand").grain_density *= 1.35;
  const auto a = search(design.data), b = search(heavy);
  for (const auto& [method, critical] : a)
    EXPECT_NEAR(critical.solution.factor, b.at(method).solution.factor, 1e-5) << to_word(method);
}

TEST(DesignValues, AreThoseOfTheSet) {
  const std::string soils = R"(
[materials.clay]
model = "mohr_coulomb"
unit_weight = "19 kN/m3"
cohesion = "42 kPa"
friction_angle = 0
cohesion_gradient = "1.4 kPa/m"
cohesion_level = 0
[[geometry.polygon]]
name = "below"
points = [[0, -5], [44, -5], [44, 0], [0, 0]]
[[surcharge]]
name = "road"
x = [2, 10]
load = [20, 20]
[[surcharge]]
name = "traffic"
x = [2, 10]
load = [10, 10]
variable = true
[partial_factors]
set = ")";
  const auto apply = [&](const std::string& set, const std::string& by_hand = "") {
    return apply_partial_factors(
        read(soils + set + "\"\n" + by_hand, {{"regions.below", "clay"}, {"geometry.box", "[[0, -5], [44, 15]]"}}));
  };
  const double tan_30 = std::tan(std::numbers::pi / 6);
  {
    const DesignValues d = apply("DA1-2");
    const input::Material &sand = d.data.materials.at("sand"), &clay = d.data.materials.at("clay");
    EXPECT_NEAR(sand.cohesion, 1600, 1e-9);
    EXPECT_NEAR(std::tan(sand.friction_angle), tan_30 / 1.25, 1e-12);
    EXPECT_NEAR(clay.cohesion, 30e3, 1e-9);
    EXPECT_NEAR(clay.cohesion_gradient, 1000, 1e-9);
    EXPECT_NEAR(*clay.slices.unit_weight, 19e3, 1e-9);
    EXPECT_NEAR(d.data.surcharges[0].load[0], 20e3, 1e-9);
    EXPECT_NEAR(d.data.surcharges[1].load[0], 13e3, 1e-9);
    EXPECT_EQ(d.resistance, 1);
  }
  {
    const DesignValues d = apply("DA2");
    EXPECT_NEAR(d.data.materials.at("sand").cohesion, 2000 / 1.35, 1e-9);
    EXPECT_NEAR(std::tan(d.data.materials.at("sand").friction_angle), tan_30, 1e-12);
    EXPECT_NEAR(d.data.surcharges[0].load[0], 20e3, 1e-9);
    EXPECT_NEAR(d.data.surcharges[1].load[0], 10e3 * 1.5 / 1.35, 1e-9);
    EXPECT_EQ(d.resistance, 1.1);
    results::DesignStatement statement = *d.statement;
    state_over_design(statement, d.resistance, 1.21);
    EXPECT_NEAR(statement.over_design.value_or(0), 1.1, 1e-12);
    EXPECT_NE(statement.text.find("1.100, which is at least 1"), std::string::npos);
  }
  {
    const DesignValues d = apply("EN1998-5");
    EXPECT_NEAR(d.data.materials.at("sand").cohesion, 1600, 1e-9);
    EXPECT_NEAR(std::tan(d.data.materials.at("sand").friction_angle), tan_30 / 1.25, 1e-12);
    EXPECT_NEAR(d.data.materials.at("clay").cohesion, 30e3, 1e-9) << "γ_cu = 1.4";
    EXPECT_NEAR(d.data.surcharges[1].load[0], 10e3, 1e-9) << "actions have no factors";
    EXPECT_EQ(d.resistance, 1);
  }
  {
    const DesignValues d = apply("AASHTO-0.75");
    EXPECT_NEAR(d.data.materials.at("sand").cohesion, 2000, 1e-9);
    EXPECT_NEAR(1 / d.resistance, 0.75, 1e-12);
    EXPECT_NEAR(1 / apply("AASHTO-0.65").resistance, 0.65, 1e-12);
  }
  {
    const DesignValues d = apply("by_hand", "friction = 1.3\nweight = 1.1\n");
    EXPECT_NEAR(d.data.materials.at("sand").cohesion, 2000, 1e-9);
    EXPECT_NEAR(std::tan(d.data.materials.at("sand").friction_angle), tan_30 / 1.3, 1e-12);
    EXPECT_NEAR(*d.data.materials.at("clay").slices.unit_weight, 19e3 / 1.1, 1e-9);
    EXPECT_NEAR(d.data.materials.at("sand").grain_density, 2650 / 1.1, 1e-9);
  }
}

/// Nails with friction and an anchor with prestress in the dry slope, which falls from (12, 15) to (32, 5).
const std::string supports = R"(
[support.nails]
kind = "nail"
first = [14, 14]
rows = 3
row_spacing = 3
inclination = 10
length = 12
out_of_plane_spacing = 1.5
tensile_strength = 100
plate = inf
bond_adhesion = 10
bond_friction = 25
diameter = 0.1
[support.tie]
kind = "anchor"
heads = [[28, 7]]
inclination = 20
length = 14
bond_length = 6
out_of_plane_spacing = 2
tensile_strength = 400
plate = 300
bond = 60
prestress = 120
[support.row]
kind = "pile"
x = [30]
length = 4
out_of_plane_spacing = 2
lateral_law = "ito_matsui"
diameter = 0.5
shear_strength = 30
plastic_moment = 50
)";

TEST(DesignValues, DivideTheResistancesOfSupports) {
  const std::string factors = "[partial_factors]\nset = \"by_hand\"\nbond = 1.1\ntensile = 1.25\nlateral = 1.4\n";
  const DesignValues d = apply_partial_factors(read(supports + factors));
  const input::Support &nails = d.data.supports.at("nails"), &tie = d.data.supports.at("tie"),
                       &row = d.data.supports.at("row");
  EXPECT_NEAR(nails.tensile_strength, 80e3, 1e-6);
  EXPECT_TRUE(std::isinf(nails.plate));
  EXPECT_NEAR(*nails.bond_adhesion, 10e3 / 1.1, 1e-6);
  EXPECT_NEAR(nails.bond_scale, 1 / 1.1, 1e-12);
  EXPECT_NEAR(tie.plate, 240e3, 1e-6);
  EXPECT_NEAR(*tie.bond, 60e3 / 1.1, 1e-6);
  EXPECT_NEAR(tie.prestress, 120e3, 1e-6) << "a favourable action";
  EXPECT_NEAR(*row.shear_strength, 30e3 / 1.4, 1e-6);
  EXPECT_NEAR(*row.plastic_moment, 50e3 / 1.4, 1e-6);
  std::map<std::string, double> design;
  for (const results::DesignValue& v : d.statement->materials) design[v.material + ", " + v.quantity] = v.design;
  EXPECT_NEAR(design.at("support nails, tensile strength"), 80, 1e-9);
  EXPECT_NEAR(design.at("support tie, bond"), 60 / 1.1, 1e-9);
  EXPECT_FALSE(design.contains("support nails, resistance of plate and head"));
  std::string notes;
  for (const std::string& note : d.statement->notes) notes += note + "\n";
  EXPECT_NE(notes.find("support tie, tensile strength 400 → 320 kN"), std::string::npos) << notes;
  EXPECT_NE(notes.find("lateral force of support 'row' by Ito and Matsui follows from the design strengths"),
            std::string::npos);
}

/// A wall on the bench below the dry slope.
TEST(DesignValues, DivideTheResistancesOfWalls) {
  const std::string wall = R"(
[support.sheet]
kind = "wall"
line = [[12, 15], [12, 8]]
bond_adhesion = 5
plastic_moment = 100
plastic_force = 700
shear_strength = 280
strut_levels = [15]
strut_stiffness = 1e4
strut_strength = 140
strut_prestress = 27
)";
  const DesignValues d =
      apply_partial_factors(read(wall + "[partial_factors]\nset = \"by_hand\"\nlateral = 1.4\nbond = 1.25\n"));
  const input::Support& sheet = d.data.supports.at("sheet");
  EXPECT_NEAR(*sheet.plastic_moment, 100e3 / 1.4, 1e-6);
  EXPECT_NEAR(*sheet.plastic_force, 500e3, 1e-6);
  EXPECT_NEAR(*sheet.shear_strength, 200e3, 1e-6);
  EXPECT_NEAR(sheet.strut_strength, 100e3, 1e-6);
  EXPECT_NEAR(sheet.strut_prestress, 27e3, 1e-6);
  EXPECT_NEAR(*sheet.bond_adhesion, 4e3, 1e-6);
  const DesignValues heavy = apply_partial_factors(read(wall + "[partial_factors]\nset = \"DA1-1\"\n"));
  EXPECT_NEAR(heavy.data.supports.at("sheet").strut_prestress, 20e3, 1e-6);
  EXPECT_NEAR(heavy.data.supports.at("sheet").strut_strength, 140e3 / 1.35, 1e-6);
}

/// γ_G multiplies the weight. Resistances and prestress, which it does not, are divided by it instead; friction of the
/// bond follows the weight.
TEST(DesignValues, PermanentActionsLeaveForcesOfSupportsAlone) {
  const DesignValues design = apply_partial_factors(read(supports + "[partial_factors]\nset = \"DA1-1\"\n"));
  EXPECT_NEAR(design.data.supports.at("tie").prestress, 120e3 / 1.35, 1e-6);
  EXPECT_EQ(design.data.supports.at("nails").bond_scale, 1);
  input::Case heavy = read(supports);
  heavy.materials.at("sand").grain_density *= 1.35;
  const auto a = search(design.data), b = search(heavy);
  ASSERT_FALSE(a.empty());
  for (const auto& [method, critical] : a)
    EXPECT_NEAR(critical.solution.factor, b.at(method).solution.factor, 1e-5) << to_word(method);
}

TEST(DesignValues, WarnOfFactoredActionsBesideAnEarthquake) {
  const auto describe = [](const std::string& set, const std::string& quake) {
    return describe_factored_quake(read("[partial_factors]\nset = \"" + set + "\"\n" + quake));
  };
  const std::string quake = "[earthquake]\nhorizontal = 0.1\n";
  EXPECT_NE(describe("DA2", quake).find("γ_G = 1.35"), std::string::npos);
  const std::string traffic = "[[surcharge]]\nname = \"traffic\"\nx = [2, 10]\nload = [10, 10]\nvariable = true\n";
  EXPECT_NE(describe("DA1-2", quake + traffic).find("γ_Q = 1.3"), std::string::npos);
  EXPECT_EQ(describe("DA1-2", quake), "") << "no variable action";
  EXPECT_EQ(describe("EN1998-5", quake), "");
  EXPECT_EQ(describe("DA2", ""), "");
}

/// The report's table of design values has the values of the case.
TEST(DesignValues, StatementListsTheChangedValues) {
  const DesignValues d = apply_partial_factors(read("[partial_factors]\nset = \"DA3\"\n"));
  std::map<std::string, std::pair<double, double>> result;
  for (const results::DesignValue& row : d.statement->materials) result[row.symbol] = {row.characteristic, row.design};
  EXPECT_NEAR(result.at("c'").first, 2, 1e-12);
  EXPECT_NEAR(result.at("c'").second, 1.6, 1e-12);
  EXPECT_NEAR(result.at("φ'").first, 30, 1e-10);
  EXPECT_NEAR(result.at("φ'").second, 24.7913, 1e-4);
  EXPECT_FALSE(result.contains("γ"));  // its factor is 1
  EXPECT_FALSE(apply_partial_factors(read("")).statement);
}

TEST(DesignValues, ASoilWithoutFrictionAngleIsRefusedByName) {
  input::Case data = read("[partial_factors]\nset = \"DA3\"\n");
  data.materials.at("sand").model = material::model_of<material::ModifiedCamClay>;
  try {
    apply_partial_factors(data);
    FAIL() << "was taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'sand'"), std::string::npos);
  }
}

TEST(DesignValues, FailureInTimeIsJudgedByTheResistanceFactor) {
  input::Case data = read("[partial_factors]\nset = \"DA2\"\n");
  data.timeline.emplace().target = 1.2;
  EXPECT_NEAR(apply_partial_factors(data).data.timeline->target, 1.2 * 1.1, 1e-12) << "F/1.1 < 1.2";
  data = read("[partial_factors]\nset = \"DA1-2\"\n");
  data.timeline.emplace().target = 1.2;
  EXPECT_EQ(apply_partial_factors(data).data.timeline->target, 1.2);
}

}  // namespace
}  // namespace talus::site
