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

void describe(Visitor& v, PartialFactors& p);

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
