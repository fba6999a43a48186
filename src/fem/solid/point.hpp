// SPDX-License-Identifier: MIT
#pragma once
// One integration point: stress, state and consistent tangent after a strain increment. Internal to fem/.

#include "material/law.hpp"

namespace talus::fem {

/// Outcome of an update beside stress and state.
struct PointAnswer {
  bool yields = false;    ///< plastic in this increment
  bool symmetric = true;  ///< of the tangent
};

/// Updates stress and state (NS and state_size numbers) by the increment `d_epsilon`. If `tangent` (NS × NS, by rows)
/// is given, also computes ∂σ/∂Δε (T19.3): by automatic differentiation of the law, or by differences for external
/// models.
template <int NS>
PointAnswer update_point(const material::Law& law, double saturation, const double* d_epsilon, double* sigma,
                         double* state, double* tangent);

/// Computes the elastic stiffness of a law at a stress and state (NS × NS, by rows).
template <int NS>
void find_elastic_stiffness(const material::Law& law, const double* sigma, const double* state, double* stiffness);

}  // namespace talus::fem
