// SPDX-License-Identifier: MIT
#pragma once
// Title block, provenance, timing, the stored frames selected on the clock of the case ([output] count_from), and the
// results by name.

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "report/folder/result_folder.hpp"
#include "results/runout.hpp"

namespace talus::report {

/// Returns the indices of the shown frames. `times` [s] are ascending and on the clock of the run. The frames are those
/// nearest to the requested times (the later of two at the same time), or five equally spaced ones from the start of
/// the clock.
std::vector<std::size_t> choose_shown(const std::vector<double>& times, const results::Clock& clock);

/// Returns `ShownResult[]` of web/src/contract/. Runout results are omitted if all soil left the grid, since they are
/// zero.
nlohmann::json list_named_results(const ResultFolder& folder);

}  // namespace talus::report
