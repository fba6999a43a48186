// SPDX-License-Identifier: MIT
#pragma once
// The factors of safety at the end of a stage of construction, by the methods of the case.

#include <string>
#include <vector>

#include "fem/solid/solid.hpp"
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
/// `known`: the deformations of bars and walls at that end, for FEM.
StageFactors find_stage_factors(const input::LoadedCase& loaded, const input::Case& later, const std::string& title,
                                const RunOptions& options, const std::string& hash,
                                const std::vector<fem::KnownSpring>& known = {});

/// Runs LEM and limit analysis, those that the case names, for a failure without drainage from `later`, whose stresses
/// are known. Each repeats with the strengths of its own factor. Results and errors are as those of
/// find_stage_factors(), each method in a folder of its own; none where every strength is that without drainage
/// already. `guess` of the factors.
StageFactors find_undrained_factors(const input::LoadedCase& loaded, const input::Case& later, const std::string& title,
                                    const RunOptions& options, const std::string& hash, double guess);

}  // namespace talus::run
