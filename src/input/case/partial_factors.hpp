#pragma once
// Partial factors of Eurocode 7 for the stability of slopes: the named sets, and what is divided or multiplied.

#include <string>

#include "input/case/limit_equilibrium.hpp"

namespace talus::input {

/// The factors of a set with those given by hand in their places [-].
struct PartialFactorValues {
  std::string set;            ///< "DA1-2", "by hand"; empty: none
  double cohesion = 1;        ///< γ_c'
  double friction = 1;        ///< γ_φ'
  double undrained = 1;       ///< γ_cu
  double weight = 1;          ///< γ_γ
  double permanent_load = 1;  ///< γ_G, also of the weight of soil and water
  double variable_load = 1;   ///< γ_Q
  double resistance = 1;      ///< γ_R;e

  bool is_active() const { return !set.empty(); }
};

/// EN 1997-1:2004, Annex A, recommended values for slopes and overall stability (tables A.3, A.4 and A.14):
/// DA1-1: A1+M1+R1, DA1-2: A2+M2+R1, DA2: A1+M1+R2, DA3: A2+M2+R3, as all loads on a slope count as geotechnical
/// actions (2.4.7.3.4.4, note 2).
PartialFactorValues find_partial_factors(const PartialFactors& given);

/// The same with γ_G = 1. The factor of safety is a ratio: multiplying weight, water and permanent loads by γ_G, as
/// actions from one source (2.4.2(9)P), is the same as dividing all strengths that are not friction by it, and variable
/// loads by it as well.
PartialFactorValues divide_by_permanent(const PartialFactorValues& values);

}  // namespace talus::input
