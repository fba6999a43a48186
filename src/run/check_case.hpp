// SPDX-License-Identifier: MIT
#pragma once
// Faults and odd values of a case that are found without a run: the checks of `talus check` beyond those of the file.

#include <string>
#include <vector>

#include "input/read.hpp"

namespace talus::run {

/// Returns warnings for the user before the run, one a line with its place in the file: odd values, gaps, faces that
/// are unstable by inspection. The results contain the same sentences.
std::vector<std::string> list_warnings(const input::LoadedCase& loaded);

/// Reads the mesh file of the case, unless that takes more than a few seconds. Throws Error (wrong_input) if it cannot
/// be read, and InputError if the names of the case are not those of the mesh.
void check_ready_mesh(const input::LoadedCase& loaded);

/// Throws Error (wrong_input) if a method of the case does not support it, without a calculation: the check of `talus
/// check` beyond the faults of the file.
void check_methods(const input::Case& data);

/// Returns true if MPM needs FEM, for its initial stress or its time of release.
bool asks_for_elements(const input::Case& data);

}  // namespace talus::run
