// SPDX-License-Identifier: MIT
#pragma once
// A whole case by all the methods that [analysis] names: the one entry behind `talus run` and `talus study`.

#include <string>
#include <vector>

#include "input/read.hpp"
#include "results/run.hpp"
#include "run/run_folder.hpp"

namespace talus::run {

/// Each method is prepared, then slices, finite elements and material points are calculated one after the other, then
/// they are compared. Writes summary.json and what each method leaves in the folder, also when a method ends early;
/// with options.resume parts that are done are kept. Nothing is written before every method is prepared and slices, if
/// they are alone, have found a surface. Throws InputError when the case needs more memory than is free or names do not
/// fit the mesh, Error (wrong_input) for what a method cannot take, Error (folder_exists, cannot_write, unstable,
/// interrupted) as its code says; where slices or finite elements find no answer beside another method, the reason
/// stands in the results and the run goes on.
results::RunResult run_case(const input::LoadedCase& loaded, const RunOptions& options);

/// What a person should look at before the case is calculated, a line each with its place in the file: odd values,
/// gaps, faces that are unstable by inspection. The results hold the same sentences.
std::vector<std::string> list_warnings(const input::LoadedCase& loaded);

/// Reads a ready mesh of the case, unless that takes more than a few seconds. Throws Error (wrong_input) when it cannot
/// be read, and InputError when the names of the case are not those of the mesh.
void check_ready_mesh(const input::LoadedCase& loaded);

/// Throws Error (wrong_input) when the case cannot be taken by the methods that it names, without calculating: what
/// `talus check` says beside the faults of the file.
void check_methods(const input::Case& data);

}  // namespace talus::run
