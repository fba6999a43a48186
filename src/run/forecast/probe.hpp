// SPDX-License-Identifier: MIT
#pragma once
// How fast this machine steps the soil of a case, found by stepping it for a moment on a coarse mesh.

#include <optional>
#include <vector>

#include "input/case/case.hpp"

namespace talus::run {

struct Pace {
  std::vector<double> steps;  ///< time step of each stage on the case's own mesh [s]
  double curve_step = 0;      ///< and of the trials of the displacement curve [s]
  double frozen_step = 0;     ///< and of those at frozen geometry on the case's mesh [s]
  double point_steps = 0;     ///< steps of one point in a second on one thread
};

/// Takes some tenths of a second. Nothing for a case whose start is not made in a moment (a result, a season), that
/// runs a user's library or that has a ready mesh, and for one that cannot be prepared: the run itself says why.
std::optional<Pace> probe(const input::Case& data);

}  // namespace talus::run
