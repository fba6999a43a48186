// SPDX-License-Identifier: MIT
#pragma once
// The factors of safety at the end of a stage of construction, by the methods of the case.

#include <string>
#include <vector>

#include "input/read.hpp"
#include "results/run.hpp"
#include "run/common/run_folder.hpp"

namespace talus::run {

struct StageFactors {
  std::vector<results::StageFactor> factors;
  std::vector<std::string> warnings;
};

/// Runs LEM, FEM and limit analysis, those that the case names, on `later`, the case at the end of a stage. Their
/// results are written into the folder of `options` as those of a run of `later` with this title. Throws Error
/// (interrupted); other errors are part of the factors.
StageFactors find_stage_factors(const input::LoadedCase& loaded, const input::Case& later, const std::string& title,
                                const RunOptions& options, const std::string& hash);

}  // namespace talus::run
