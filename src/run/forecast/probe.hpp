// SPDX-License-Identifier: MIT
#pragma once
// How fast this machine steps the soil of a case, found by stepping it for a moment on a coarse mesh.

#include <optional>
#include <vector>

#include "input/case/case.hpp"

namespace talus::run {

struct StagePace {
  double step = 0;         ///< time step on the case's own mesh [s]
  double point_steps = 0;  ///< steps of one point in a second on one thread
};

struct Pace {
  std::vector<StagePace> stages;
  StagePace curve;   ///< of the trials of the displacement curve
  StagePace frozen;  ///< of those at frozen geometry on the case's mesh
};

/// Takes some tenths of a second. Nothing for a case whose start is not made in a moment (a result, a season), that
/// runs a user's library or that has a ready mesh, and for one that cannot be prepared: the run itself says why.
std::optional<Pace> probe(const input::Case& data);

}  // namespace talus::run
