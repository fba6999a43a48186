// SPDX-License-Identifier: MIT
#pragma once
// Run of a case by all the methods that [analysis] names: the common entry of `talus run` and `talus study`.

#include <string>
#include <vector>

#include "input/read.hpp"
#include "results/run.hpp"
#include "run/common/run_folder.hpp"

namespace talus::run {

/// Prepares each method, then runs LEM, FEM and MPM one after the other, and compares them. Writes summary.json and
/// the files of each method, also when a method ends early; with options.resume finished parts are kept. Nothing is
/// written before every method is prepared and LEM, if it is the only method, has found a surface. Throws InputError
/// if the case needs more memory than is free or names do not fit the mesh; Error (wrong_input) for input that a
/// method does not support; Error (folder_exists, cannot_write, unstable, interrupted). If LEM or FEM fails beside
/// another method, the reason is part of the results and the run continues.
results::RunResult run_case(const input::LoadedCase& loaded, const RunOptions& options);

/// Returns warnings for the user before the run, one a line with its place in the file: odd values, gaps, faces that
/// are unstable by inspection. The results contain the same sentences.
std::vector<std::string> list_warnings(const input::LoadedCase& loaded);

/// Reads the mesh file of the case, unless that takes more than a few seconds. Throws Error (wrong_input) if it cannot
/// be read, and InputError if the names of the case are not those of the mesh.
void check_ready_mesh(const input::LoadedCase& loaded);

/// Throws Error (wrong_input) if a method of the case does not support it, without a calculation: the check of `talus
/// check` beyond the faults of the file.
void check_methods(const input::Case& data);

}  // namespace talus::run
