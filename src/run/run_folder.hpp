// SPDX-License-Identifier: MIT
#pragma once
// The results folder of a run before it begins: whether it may be used, and what is there already.

#include <filesystem>
#include <functional>
#include <optional>

#include "base/file_list.hpp"
#include "input/read.hpp"
#include "results/run.hpp"
#include "run/options.hpp"

namespace talus::run {

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
