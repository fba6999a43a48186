// SPDX-License-Identifier: MIT
#pragma once
// Mesh dependence of a runout: front, distance and height on elements twice as large.

#include <optional>
#include <string>

#include "input/read.hpp"
#include "results/run.hpp"
#include "run/common/run_folder.hpp"

namespace talus::run {

/// Repeats the MPM run of `data` on elements twice as large, in the folder coarser_mesh, and adds each runout to the
/// corresponding one of `run`. Does nothing if no soil moved, if the case requests one mesh, and if the mesh comes from
/// a file or another result. All ranks call it together. Returns a warning with the reason if the coarser mesh has no
/// such runout. Throws Error (interrupted).
template <int D>
std::optional<std::string> compare_with_coarser_mesh(const input::LoadedCase& loaded, const input::Case& data,
                                                     const RunOptions& options, const std::string& input_hash,
                                                     results::RunResult& run);

}  // namespace talus::run
