// SPDX-License-Identifier: MIT
#pragma once
// Run of a case by all the methods that [analysis] names: the common entry of `talus run` and `talus study`.

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

}  // namespace talus::run
