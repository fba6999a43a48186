// SPDX-License-Identifier: MIT
#pragma once
// The results folder of a run before it begins: whether it may be used, and what is there already.

#include <optional>

#include "input/case/case.hpp"
#include "results/run.hpp"
#include "run/options.hpp"

namespace talus::run {

/// Throws Error (folder_exists) when the folder holds something and neither --overwrite nor --resume was given, or the
/// case starts from the result in it.
void check_folder(const input::Initial& initial, const RunOptions& options);

/// Removes the results that --overwrite replaces, and nothing else.
void clear_folder(const RunOptions& options);

/// A finished run that --resume keeps. Throws Error (wrong_input) when it is of another input.
std::optional<results::RunResult> load_finished(const RunOptions& options, const std::string& input_hash);

}  // namespace talus::run
