// SPDX-License-Identifier: MIT
#pragma once
// A body and its stage as a checkpoint, from which a run resumes bitwise identically.

#include "output/files/archive.hpp"
#include "run/mpm/stage/stage.hpp"

namespace talus::run {

/// Writes the mesh, so that it is not generated again on resuming: another machine might generate another one.
template <int D>
void put_mesh(output::ArchiveWriter& archive, const mesh::Mesh<D>& mesh);
template <int D>
mesh::Mesh<D> get_mesh(const output::ArchiveReader& archive);

/// Writes all arrays of the body.
template <int D>
void put_body(output::ArchiveWriter& archive, const mpm::Body<D>& body);
void put_stage(output::ArchiveWriter& archive, const StageState& state);

/// Throws Error (wrong_input) if the archive, named `what` in the message, was written by a build with another lane
/// width; the message advises to `purpose` ("resume") with the same one.
void check_lane_width(const output::ArchiveReader& archive, const std::string& what, const char* purpose);

/// Overwrites the arrays of `body`, which must come from prepare on the same case and mesh. Throws Error (wrong_input)
/// if the archive was written by a build with another lane width.
template <int D>
void get_body(const output::ArchiveReader& archive, mpm::Body<D>& body);
StageState get_stage(const output::ArchiveReader& archive);

}  // namespace talus::run
