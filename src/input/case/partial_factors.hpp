// SPDX-License-Identifier: MIT
#pragma once
// [partial_factors]: sets of partial factors of design codes for slope stability, and the parameters to which they
// apply.

#include <array>
#include <optional>
#include <string>

#include "input/language/spec.hpp"

namespace talus::input {

/// EN 1997-1 Annex A, EN 1998-5, AASHTO LRFD, or factors given by hand.
enum class DesignApproach { none, da1_1, da1_2, da2, da3, en_1998_5, aashto_75, aashto_65, by_hand };

struct PartialFactors {
  DesignApproach set = DesignApproach::none;
  // Given values replace those of the set:
  std::optional<double> cohesion;                ///< γ_c' divides c'
  std::optional<double> friction;                ///< γ_φ' divides tanφ'
  std::optional<double> undrained;               ///< γ_cu divides c of soils with φ = 0
  std::optional<double> weight;                  ///< γ_γ divides the weight
  std::optional<double> permanent_load;          ///< γ_G multiplies unfavourable permanent surcharges
  std::optional<double> variable_load;           ///< γ_Q multiplies unfavourable variable surcharges
  std::optional<double> resistance;              ///< γ_R;e divides the factor of safety
  std::optional<double> bond, tensile, lateral;  ///< divide resistances of supports
};

template <>
inline constexpr auto choices<DesignApproach> = std::array{
    Choice{DesignApproach::none, "none", "characteristic values"},
    Choice{DesignApproach::da1_1, "DA1-1", "A1 + M1 + R1: γ_G 1.35, γ_Q 1.5"},
    Choice{DesignApproach::da1_2, "DA1-2", "A2 + M2 + R1: γ_Q 1.3, γ_φ' 1.25, γ_c' 1.25, γ_cu 1.4"},
    Choice{DesignApproach::da2, "DA2", "A1 + M1 + R2: γ_G 1.35, γ_Q 1.5, γ_R;e 1.1"},
    Choice{DesignApproach::da3, "DA3",
           "A2 + M2 + R3: γ_Q 1.3, γ_φ' 1.25, γ_c' 1.25, γ_cu 1.4; loads on a slope count as geotechnical actions"},
    Choice{DesignApproach::en_1998_5, "EN1998-5",
           "earthquake, EN 1998-5:2004, 3.1(3): γ_φ' 1.25, γ_cu 1.4, and γ_c' 1.25 as γ_φ'; actions without factors"},
    Choice{DesignApproach::aashto_75, "AASHTO-0.75",
           "AASHTO LRFD, 9th edition, overall stability: resistance factor 0.75, load factors 1; well defined soil, no "
           "structure on the slope"},
    Choice{DesignApproach::aashto_65, "AASHTO-0.65",
           "the same with 0.65: limited information, or a structure on the slope"},
    Choice{DesignApproach::by_hand, "by_hand", "the factors below; those not given are 1"},
};

void describe(auto& v, PartialFactors& p) {
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

/// The factors of a set, replaced where given by hand [-].
struct PartialFactorValues {
  std::string set;                            ///< "DA1-2", "by hand"; empty: none
  double cohesion = 1;                        ///< γ_c'
  double friction = 1;                        ///< γ_φ'
  double undrained = 1;                       ///< γ_cu
  double weight = 1;                          ///< γ_γ
  double permanent_load = 1;                  ///< γ_G, also for the weight of soil and water
  double variable_load = 1;                   ///< γ_Q
  double resistance = 1;                      ///< γ_R;e
  double bond = 1, tensile = 1, lateral = 1;  ///< of supports

  bool is_active() const { return !set.empty(); }
};

/// Returns the factors of a set. EN 1997-1:2004, Annex A, recommended values for slopes and overall stability (tables
/// A.3, A.4 and A.14): DA1-1: A1+M1+R1, DA1-2: A2+M2+R1, DA2: A1+M1+R2, DA3: A2+M2+R3, as all loads on a slope are
/// geotechnical actions (2.4.7.3.4.4, note 2). EN 1998-5:2004, 3.1(3): material factors in seismic design situations,
/// without factors on actions (EN 1990, 6.4.3.4). AASHTO LRFD, 9th edition (2020), 11.6.3.7: γ_R = 1/φ with load
/// factors of 1.
PartialFactorValues find_partial_factors(const PartialFactors& given);

/// Returns equivalent factors with γ_G = 1. The factor of safety is a ratio: multiplying weight, water and permanent
/// loads by γ_G, as actions from a single source (2.4.2(9)P), is equivalent to dividing all strengths except friction,
/// and variable loads, by γ_G.
PartialFactorValues divide_by_permanent(const PartialFactorValues& values);

}  // namespace talus::input
