// SPDX-License-Identifier: MIT
#pragma once
// Rapid drawdown on one slip surface: strengths that soil keeps from the stresses before it, and the stages.

#include "lem/slices/solve.hpp"

namespace talus::lem {

/// Effective strength of a soil.
struct EffectiveStrength {
  double cohesion = 0;        ///< c' [Pa]
  double friction_angle = 0;  ///< φ', above 0 [rad]
};

/// Undrained strength [Pa] of soil that was consolidated under the effective normal stress `normal` and the shear
/// stress `shear` on the slip surface [Pa]. By the Corps of Engineers (1970) the lower of the R envelope and the
/// effective one; by the other methods between τ(Kc = 1) and τ(Kc = Kf), by the ratio K1 of the principal stresses,
/// with the lower of the two where one of them would be a tension (USACE EM 1110-2-1902, 2003, appendix G). Never below
/// 0. K1 is not taken beyond Kf: soil is not consolidated beyond failure.
double find_undrained_strength(DrawdownMethod method, const UndrainedEnvelope& envelope,
                               const EffectiveStrength& effective, double normal, double shear);

/// Keeps the strengths of a surface that was just cut, so that its stages can begin again. Nothing without a drawdown.
void keep_drained_strengths(CutSurface& cut);

/// What solve() does where the slope has a drawdown. Stages: before drawdown; after it with undrained strengths from
/// the stresses before; and with the drained strength where that is lower (three_stage).
Solution solve_drawdown(const Slope& slope, CutSurface& cut, Method method, const Checks& checks, bool keep_forces);

}  // namespace talus::lem
