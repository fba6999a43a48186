// SPDX-License-Identifier: MIT
#pragma once
// The clock of a case ([output] count_from) and the stored frames that are shown by it.

#include <cstddef>
#include <vector>

#include "results/motion.hpp"

namespace talus::report {

/// Which of the ascending `times` [s] of the run are shown: those nearest to the times that are asked for (of two at
/// one time the later one), or five evenly spread from the start of the clock on.
std::vector<std::size_t> choose_shown(const std::vector<double>& times, const results::Clock& clock);

}  // namespace talus::report
