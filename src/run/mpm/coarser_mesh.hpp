// SPDX-License-Identifier: MIT
#pragma once
// The same runout on elements twice as large: what the mesh does to front, distance and height.

#include <optional>
#include <string>

#include "input/read.hpp"
#include "results/run.hpp"
#include "run/run_folder.hpp"

namespace talus::run {

/// Calculates the points of `data` once more on elements twice as large, in the folder coarser_mesh, and adds what
/// came of each runout there to that of `run`. Does nothing where no soil moved, where the case asks for one mesh,
/// where the mesh is a file or that of another result, and on several ranks. Returns why the coarser mesh has no
/// such runout, as a warning. Throws Error (interrupted).
template <int D>
std::optional<std::string> compare_with_coarser_mesh(const input::LoadedCase& loaded, const input::Case& data,
                                                     const RunOptions& options, const std::string& input_hash,
                                                     results::RunResult& run);

}  // namespace talus::run
