// SPDX-License-Identifier: MIT
#include "input/case/partial_factors.hpp"

namespace talus::input {
namespace {

// Values of tables A.3, A.4 and A.14 of EN 1997-1:2004.
void take_actions_1(PartialFactorValues& v) {
  v.permanent_load = 1.35;
  v.variable_load = 1.5;
}

void take_actions_2(PartialFactorValues& v) {
  v.permanent_load = 1;
  v.variable_load = 1.3;
}

void take_materials_2(PartialFactorValues& v) {
  v.friction = 1.25;
  v.cohesion = 1.25;
  v.undrained = 1.4;
  v.weight = 1;
}

PartialFactorValues take_set(DesignApproach set) {
  PartialFactorValues v;
  switch (set) {
    case DesignApproach::none:
      break;
    case DesignApproach::da1_1:
      v.set = "DA1-1";
      take_actions_1(v);
      break;
    case DesignApproach::da1_2:
      v.set = "DA1-2";
      take_actions_2(v);
      take_materials_2(v);
      break;
    case DesignApproach::da2:
      v.set = "DA2";
      take_actions_1(v);
      v.resistance = 1.1;
      break;
    case DesignApproach::da3:
      v.set = "DA3";
      take_actions_2(v);
      take_materials_2(v);
      break;
    case DesignApproach::en_1998_5:
      v.set = "EN 1998-5";
      take_materials_2(v);
      break;
    case DesignApproach::aashto_75:
      v.set = "AASHTO LRFD, φ = 0.75";
      v.resistance = 1 / 0.75;
      break;
    case DesignApproach::aashto_65:
      v.set = "AASHTO LRFD, φ = 0.65";
      v.resistance = 1 / 0.65;
      break;
    case DesignApproach::by_hand:
      v.set = "by hand";
      break;
  }
  return v;
}

}  // namespace

PartialFactorValues find_partial_factors(const PartialFactors& given) {
  PartialFactorValues v = take_set(given.set);
  if (!v.is_active()) return v;
  v.cohesion = given.cohesion.value_or(v.cohesion);
  v.friction = given.friction.value_or(v.friction);
  v.undrained = given.undrained.value_or(v.undrained);
  v.weight = given.weight.value_or(v.weight);
  v.permanent_load = given.permanent_load.value_or(v.permanent_load);
  v.variable_load = given.variable_load.value_or(v.variable_load);
  v.resistance = given.resistance.value_or(v.resistance);
  return v;
}

PartialFactorValues divide_by_permanent(const PartialFactorValues& values) {
  PartialFactorValues v = values;
  v.cohesion *= values.permanent_load;
  v.undrained *= values.permanent_load;
  v.variable_load /= values.permanent_load;
  v.permanent_load = 1;
  return v;
}

}  // namespace talus::input
