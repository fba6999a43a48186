// SPDX-License-Identifier: MIT
#pragma once
// A mesh and a body in an archive: the part that checkpoints and end states have in common.

#include "mpm/state/body.hpp"
#include "output/files/archive.hpp"

namespace talus::run {

/// Writes the mesh, so that it is not generated again on resuming: another machine might generate another one.
template <int D>
void put_mesh(output::ArchiveWriter& archive, const mesh::Mesh<D>& mesh);
template <int D>
mesh::Mesh<D> get_mesh(const output::ArchiveReader& archive);

/// Writes all arrays of the body.
template <int D>
void put_body(output::ArchiveWriter& archive, const mpm::Body<D>& body);

/// Throws Error (wrong_input) if the archive, named `what` in the message, was written by a build with another lane
/// width; the message advises to `purpose` ("resume") with the same one.
void check_lane_width(const output::ArchiveReader& archive, const std::string& what, const char* purpose);

/// Overwrites the arrays of `body`, which must come from prepare on the same case and mesh. Throws Error (wrong_input)
/// if the archive was written by a build with another lane width.
template <int D>
void get_body(const output::ArchiveReader& archive, mpm::Body<D>& body);

}  // namespace talus::run
