// SPDX-License-Identifier: MIT
#pragma once
// Back-analysis: the value of a key at which a result of the case reaches a target. The implementation of `talus find`;
// its folder is that of a study whose values are chosen one after another.

#include <optional>
#include <string>
#include <vector>

#include "study/study.hpp"

namespace talus::study {

struct BackAnalysisRequest {
  std::string key;       ///< dotted path, as for --set
  std::string target;    ///< "factor=1.0"
  std::string from, to;  ///< bracket in the unit of the key or with a unit; both empty: expanded from the present value
  double tolerance = 1e-3;             ///< width of the bracket relative to the value
  std::vector<std::string> further{};  ///< further targets, searched after the first in the same range and runs
};

struct BackAnalysisOutcome {
  results::BackAnalysis finding;
  std::string tables;            ///< the outcome in words, and the table of the runs
  std::optional<Error> failure;  ///< interrupted, or no value of the key reaches a target
};

/// Searches the value of `request.key` for the case, which was read with `overrides`, and writes the tables of a study
/// after each run. Throws InputError or Error (wrong_input) for a request that is not possible, and Error
/// (folder_exists), before anything is written; Error (cannot_write, no_memory) of a run.
BackAnalysisOutcome search_key(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                               const BackAnalysisRequest& request, const StudyOptions& options);

}  // namespace talus::study
