// SPDX-License-Identifier: MIT
#include "input/case/partial_factors.hpp"

#include <algorithm>
#include <array>
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, PartialFactors& p) {
  const auto none = DesignApproach::none;
  v.key("set", p.set, plain(),
        "Partial factors of a code: DA1 to DA3 are those of EN 1997-1:2004, Annex A (recommended values). Factors that "
        "are given replace those of the set.");
  v.key("cohesion", p.cohesion, plain().above(0).allowed_unless("set", p.set, none).example("1.25"),
        "γ_c', which divides c' and the cohesion of roots. M1: 1, M2: 1.25.");
  v.key("friction", p.friction, plain().above(0).allowed_unless("set", p.set, none).example("1.25"),
        "γ_φ', which divides tan φ' (and tan φᵇ). M1: 1, M2: 1.25.");
  v.key("undrained", p.undrained, plain().above(0).allowed_unless("set", p.set, none).example("1.4"),
        "γ_cu, which divides the cohesion of soils with φ = 0. M1: 1, M2: 1.4.");
  v.key("weight", p.weight, plain().above(0).allowed_unless("set", p.set, none).example("1.0"),
        "γ_γ, which divides the unit weight. M1 and M2: 1.");
  v.key("permanent_load", p.permanent_load, plain().above(0).allowed_unless("set", p.set, none).example("1.35"),
        "γ_G of permanent actions: surcharges, and the weight of soil and water, whose driving and resisting parts "
        "come from one source and share one factor (2.4.2(9)P). A1: 1.35, A2: 1. As only ratios count, strengths in "
        "kPa are divided by γ_G, permanent actions keep their value, and variable ones are multiplied by γ_Q/γ_G.");
  v.key("variable_load", p.variable_load, plain().above(0).allowed_unless("set", p.set, none).example("1.5"),
        "γ_Q of variable surcharges, which are to stand only where they are unfavourable. A1: 1.5, A2: 1.3.");
  v.key("resistance", p.resistance, plain().above(0).allowed_unless("set", p.set, none).example("1.1"),
        "γ_R;e, which divides the factor of safety. R1 and R3: 1, R2: 1.1; AASHTO: one over its resistance factor.");
  v.key("bond", p.bond, plain().above(0).allowed_unless("set", p.set, none).example("1.1"),
        "Divides the pull-out resistance of supports. No set has a factor of its own for supports: 1 if not given.");
  v.key("tensile", p.tensile, plain().above(0).allowed_unless("set", p.set, none).example("1.15"),
        "Divides tensile strength, plate and connection of supports.");
  v.key("lateral", p.lateral, plain().above(0).allowed_unless("set", p.set, none).example("1.4"),
        "Divides lateral resistance and shear strength of piles.");
}
namespace {

// Values of tables A.3, A.4 and A.14 of EN 1997-1:2004, and of the other standards.
struct FactorSet {
  DesignApproach word;
  PartialFactorValues values;
};
const std::array sets{
    // cohesion, friction, undrained, weight, permanent load, variable load, resistance
    FactorSet{DesignApproach::da1_1, {"DA1-1", 1, 1, 1, 1, 1.35, 1.5, 1}},
    FactorSet{DesignApproach::da1_2, {"DA1-2", 1.25, 1.25, 1.4, 1, 1, 1.3, 1}},
    FactorSet{DesignApproach::da2, {"DA2", 1, 1, 1, 1, 1.35, 1.5, 1.1}},
    FactorSet{DesignApproach::da3, {"DA3", 1.25, 1.25, 1.4, 1, 1, 1.3, 1}},
    FactorSet{DesignApproach::en_1998_5, {"EN 1998-5", 1.25, 1.25, 1.4, 1, 1, 1, 1}},
    FactorSet{DesignApproach::aashto_75, {"AASHTO LRFD, φ = 0.75", 1, 1, 1, 1, 1, 1, 1 / 0.75}},
    FactorSet{DesignApproach::aashto_65, {"AASHTO LRFD, φ = 0.65", 1, 1, 1, 1, 1, 1, 1 / 0.65}},
    FactorSet{DesignApproach::by_hand, {"by hand"}},
};

}  // namespace

PartialFactorValues find_partial_factors(const PartialFactors& given) {
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const FactorSet& s) { return s.word == given.set; });
  if (found == sets.end()) return {};
  PartialFactorValues v = found->values;
  v.cohesion = given.cohesion.value_or(v.cohesion);
  v.friction = given.friction.value_or(v.friction);
  v.undrained = given.undrained.value_or(v.undrained);
  v.weight = given.weight.value_or(v.weight);
  v.permanent_load = given.permanent_load.value_or(v.permanent_load);
  v.variable_load = given.variable_load.value_or(v.variable_load);
  v.resistance = given.resistance.value_or(v.resistance);
  v.bond = given.bond.value_or(v.bond);
  v.tensile = given.tensile.value_or(v.tensile);
  v.lateral = given.lateral.value_or(v.lateral);
  return v;
}

PartialFactorValues divide_by_permanent(const PartialFactorValues& values) {
  PartialFactorValues v = values;
  v.cohesion *= values.permanent_load;
  v.undrained *= values.permanent_load;
  v.bond *= values.permanent_load;
  v.tensile *= values.permanent_load;
  v.lateral *= values.permanent_load;
  v.variable_load /= values.permanent_load;
  v.permanent_load = 1;
  return v;
}

}  // namespace talus::input
