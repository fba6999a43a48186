// SPDX-License-Identifier: MIT
#include "input/case/partial_factors.hpp"

#include <algorithm>
#include <array>

namespace talus::input {
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
