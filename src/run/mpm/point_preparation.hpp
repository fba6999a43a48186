// SPDX-License-Identifier: MIT
#pragma once
// MPM on a case before its first step: the body in its initial state, from the mesh, from another result, or on the
// mesh of a checkpoint.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/read.hpp"
#include "mpm/state/body.hpp"
#include "output/files/archive.hpp"
#include "results/run.hpp"
#include "run/common/run_folder.hpp"
#include "run/mpm/record/runout.hpp"
#include "site/season.hpp"
#include "site/seepage_results.hpp"

namespace talus::run {

/// The body of a case, and what its stages and results need beside it.
template <int D>
struct PreparedPoints {
  std::string checkpoint_hash;                        ///< of the input and the state that the run starts from
  JsonTree mesh_input;                                ///< echo of the case for which the mesh was generated
  std::unique_ptr<output::ArchiveReader> checkpoint;  ///< null: the run starts anew
  mpm::Body<D> body;
  mpm::Work work_before;  ///< of the result that the case starts from
  std::optional<site::SeasonRecord> season;
  site::WaterResult water;
  RunoutStart runout_start;
  double slope_height = 0;   ///< [m]
  double profile_bin = 0;    ///< [m]
  double initial_water = 0;  ///< [kg]
  double seconds = 0;
  std::vector<std::string> warnings;
};

/// Prepares mesh, points and their initial state, and describes them in `run`. Throws InputError if names do not fit
/// the mesh, and what meshing and preparation throw; writes nothing.
template <int D>
PreparedPoints<D> prepare_points(const input::LoadedCase& loaded, const input::Case& data, const RunOptions& options,
                                 const std::string& input_hash, results::RunResult& run);

}  // namespace talus::run
