// SPDX-License-Identifier: MIT
#pragma once
// Options of a run, and its results folder before the run starts: whether it may be used, and its present contents.

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

/// State at the end of the stages, from which another case can start.
inline constexpr const char* end_state_file = "end_state.h5";
/// Slip line of the smallest factor at frozen geometry that failed, in the folder of each mesh; plane strain only.
inline constexpr const char* slip_line_file = "slip_line.json";

/// Device for MPM.
enum class DeviceKind {
  cpu,
  gpu,
  emulated  ///< the kernels of a GPU emulated on the processor, for tests
};

struct RunOptions {
  std::filesystem::path folder;  ///< results folder; created if it does not exist
  int threads = 1;
  DeviceKind device = DeviceKind::cpu;
  bool resume = false;                    ///< resume from the checkpoint of the folder; a finished run is not repeated
  bool overwrite = false;                 ///< replace existing results
  bool keeps_present = false;             ///< write the results so far during the run (results/present.hpp)
  std::function<void()> store_present{};  ///< set by the run itself: stores the results so far, if it is time
  Progress* progress = nullptr;           ///< display of progress; null: none
  std::string label;                      ///< precedes the name of a stage in the progress line

  /// Returns the options of a run in a folder below that of this one, which stores no results so far.
  RunOptions make_nested(const std::filesystem::path& nested) const;
  /// Calls store_present if there is one.
  void store() const {
    if (store_present) store_present();
  }
};

/// Throws Error (folder_exists) if the folder is not empty and neither --overwrite nor --resume was given, if the case
/// starts from the result in it, if --overwrite or --resume find no list of files in it, and what check_replaced()
/// throws.
void check_folder(const input::LoadedCase& loaded, const RunOptions& options);

/// Returns true for paths, relative to a folder, that will be written there.
using IsWritten = std::function<bool(const std::filesystem::path&)>;
/// IsWritten of the run of a case.
bool is_of_run(const input::Case& data, const std::filesystem::path& file);

/// Throws Error (folder_exists) if --overwrite must not replace the folder: it is or holds a file of the case, the
/// current or home folder, or a repository; it has no list; or a file that no run wrote is in the way of one that will
/// be written. Files of unchanged size are not read.
void check_replaced(const input::LoadedCase& loaded, const std::filesystem::path& folder, const IsWritten& is_written);
/// Removes the files of runs from the folder (base/file_list.hpp) and records what else is there. Throws Error
/// (folder_exists), before anything is removed, if a foreign file is in the way.
void replace_folder(const std::filesystem::path& folder, const IsWritten& is_written, Progress* progress);

/// Removes the results so far, those of an earlier run that was killed included.
void remove_present(const RunOptions& options);

/// Throws Error (folder_exists) if the folder has no list of files.
void require_list(const std::filesystem::path& folder);
/// Throws Error (wrong_input) if a file of a run is missing or has changed, except for report and pictures. The end
/// state may be missing.
void check_kept(const std::filesystem::path& folder);

/// Reads a finished run that --resume keeps; nullopt if there is none. Throws Error (wrong_input) if it is of another
/// input.
std::optional<results::RunResult> load_finished(const RunOptions& options, const std::string& input_hash);

}  // namespace talus::run
