// SPDX-License-Identifier: MIT
#pragma once
// The results folder of a run before it begins: whether it may be used, and what is there already.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "base/file_list.hpp"
#include "base/progress.hpp"
#include "input/read.hpp"
#include "results/run.hpp"

namespace talus::run {

// How a case is run.

/// What takes bodies of points through their steps.
enum class DeviceKind {
  cpu,
  gpu,
  emulated  ///< the kernels of a GPU on this processor: for tests
};

struct RunOptions {
  std::filesystem::path folder;  ///< where results go; made when it does not exist
  int threads = 1;
  DeviceKind device = DeviceKind::cpu;
  bool resume = false;           ///< go on from the folder's checkpoint; a finished run is not run again
  bool overwrite = false;        ///< replace results that are there
  Progress* progress = nullptr;  ///< where progress is shown, or nowhere
  std::string label;             ///< before the name of a stage in the line of progress
};

// A method beside others: what it cannot do becomes a part of the results.

/// Runs `part`. Returns the sentence of the Error that it throws, where the case has other methods as well. Throws it
/// on where it was an interruption, or the method is `alone`.
template <class Part>
std::optional<std::string> attempt(const RunOptions& options, bool alone, Part part) {
  try {
    part();
  } catch (const Error& error) {
    if (options.progress) options.progress->clear();
    if (alone || error.code() == ExitCode::interrupted) throw;
    return error.what();
  }
  return std::nullopt;
}

/// Throws Error (folder_exists) when the folder holds something and neither --overwrite nor --resume was given, when
/// the case starts from the result in it, when --overwrite or --resume find no list of files in it, and what
/// check_replaced() throws.
void check_folder(const input::LoadedCase& loaded, const RunOptions& options);

/// Returns true for paths, relative to a folder, that are to be written there.
using IsWritten = std::function<bool(const std::filesystem::path&)>;
/// IsWritten of the run of a case.
bool is_of_run(const input::Case& data, const std::filesystem::path& file);

/// Throws Error (folder_exists) when --overwrite must not replace the folder: it is or holds a file of the case, the
/// current or home folder, or a repository; it has no list; or a file that no run wrote is in the way of one that will
/// be written. Files whose size is right are not read.
void check_replaced(const input::LoadedCase& loaded, const std::filesystem::path& folder, const IsWritten& is_written);
/// Removes what runs wrote into the folder (base/file_list.hpp) and notes what else is there. Throws Error
/// (folder_exists), before anything is removed, when that is in the way.
void replace_folder(const std::filesystem::path& folder, const IsWritten& is_written, Progress* progress);

/// Throws Error (folder_exists) when the folder has no list of files.
void require_list(const std::filesystem::path& folder);
/// Throws Error (wrong_input) when a file that a run wrote is missing or has changed, except for report and pictures.
/// The state at the end may be missing.
void check_kept(const std::filesystem::path& folder);

/// A finished run that --resume keeps. Throws Error (wrong_input) when it is of another input.
std::optional<results::RunResult> load_finished(const RunOptions& options, const std::string& input_hash);

}  // namespace talus::run
