// SPDX-License-Identifier: MIT
#pragma once
// A checkpoint: a body, its stage and its leg, from which a run resumes bitwise identically.

#include <filesystem>
#include <memory>
#include <string>

#include "run/mpm/stage/plan.hpp"
#include "run/mpm/start/body_archive.hpp"

namespace talus::run {

/// Opens the checkpoint at `path`; null if there is none. Throws Error (wrong_input) if it belongs to another case.
std::unique_ptr<output::ArchiveReader> open_checkpoint(const std::filesystem::path& path,
                                                       const std::string& input_hash);

/// Index of the leg in which the checkpoint was written.
int get_leg(const output::ArchiveReader& checkpoint);

void put_stage(output::ArchiveWriter& archive, const StageState& state);
StageState get_stage(const output::ArchiveReader& archive);

}  // namespace talus::run
