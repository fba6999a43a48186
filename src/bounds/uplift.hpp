// SPDX-License-Identifier: MIT
#pragma once
// Pore pressures on the free border that no stress field can carry, whatever the factor.

#include <optional>

#include "base/vec.hpp"
#include "bounds/problem.hpp"

namespace talus::bounds {

struct Uplift {
  Vec<2> place{};    ///< [m]
  double pull = 0;   ///< effective tension across the border, σ'_n = t_n + u [Pa]
  double limit = 0;  ///< largest one that the criterion admits, c / tan φ [Pa]
};

/// Searches the corner of the border where the effective tension exceeds the apex by most. The load fixes the total
/// normal stress t_n (tension positive) of a side without fixity, so that σ'_n = t_n + u there in every field in
/// equilibrium; the criterion admits no tension above its apex, c / tan φ, which does not depend on F (T21.1). Then no
/// factor has a stress field. Returns nothing where no corner exceeds it. Sides on which the head of a bar presses, and
/// soil without friction, which has no apex, are left out.
std::optional<Uplift> search_uplift(const Problem& problem);

}  // namespace talus::bounds
