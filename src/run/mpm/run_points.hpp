#pragma once
// Material points: a case from its file to its results folder. run/run_case.hpp has the entry for all methods.

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "base/progress.hpp"
#include "input/read.hpp"

namespace talus::run {

struct RunOptions {
  std::filesystem::path folder;  ///< where results go; made when it does not exist
  int threads = 1;
  bool resume = false;           ///< go on from the folder's checkpoint; a finished run is not run again
  bool overwrite = false;        ///< replace results that are there
  Progress* progress = nullptr;  ///< where progress is shown, or nowhere
  /// Other methods on the same case, which write into its summary: `begin` when the input is checked and the folder
  /// clear, before the first stage, `end` before the results are listed. Both may be empty.
  std::function<void(nlohmann::json&summary)> begin, end;
};

/// Hash of what decides the state of a run. A run may be resumed with other outputs, and after an instability with a
/// smaller Courant number, so neither counts.
std::string hash_input(nlohmann::json echo);

/// Runs the case and writes its folder: results.vtkhdf, histories, checkpoint, trials, summary.json. Returns the
/// summary. Throws InputError before anything is written when names do not fit the mesh; Error (folder_exists,
/// cannot_write, unstable, interrupted) as its code says.
nlohmann::json run_points(const input::LoadedCase& loaded, const RunOptions& options);

}  // namespace talus::run
