// SPDX-License-Identifier: MIT
#pragma once
// Rapid drawdown on one slip surface: undrained strengths from the stresses before drawdown, and the stages.

#include "lem/slices/solve.hpp"

namespace talus::lem {

/// Drained strength of a soil.
struct EffectiveStrength {
  double cohesion = 0;        ///< c' [Pa]
  double friction_angle = 0;  ///< φ', above 0 [rad]
};

/// Returns the undrained strength [Pa] of soil consolidated under the effective normal stress `normal` and the shear
/// stress `shear` on the slip surface [Pa]. By the Corps of Engineers (1970) it is the lower of the R envelope and the
/// effective one (T18.13); by the other methods it is interpolated between τ(Kc = 1) and τ(Kc = Kf) by the ratio K1 of
/// the principal stresses (T18.14), and the lower of the two where one of these stresses would be a tension (USACE EM
/// 1110-2-1902, 2003, appendix G). It is not negative, and K1 does not exceed Kf, as soil is not consolidated beyond
/// failure.
double find_undrained_strength(DrawdownMethod method, const UndrainedEnvelope& envelope,
                               const EffectiveStrength& effective, double normal, double shear);

/// Stores the strengths of a surface after it was cut, so that its stages can be repeated. Does nothing without a
/// drawdown.
void keep_drained_strengths(CutSurface& cut);

/// Computes the factor of a slope with a drawdown, for solve(). Stages: before drawdown; after it with undrained
/// strengths from the stresses before; and with the drained strength where that is lower (three_stage).
Solution solve_drawdown(const Slope& slope, CutSurface& cut, Method method, const Checks& checks, bool keep_forces);

}  // namespace talus::lem
