// SPDX-License-Identifier: MIT
#pragma once
// Frames of the variants of a study, packed so that they can be put side by side.

#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "report/folder.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

/// A variant with frames.
struct PictureSource {
  std::string title;
  ResultFolder folder;
};

/// A sequence, and what `StudyRow.frames` says of it.
struct Pictures {
  JsonTree sequence, frames;
};

/// One entry for each source, in their order; both parts empty where a source has no clock or no frames. Displacement,
/// strain, pore water and preconsolidation at the times that are shown and at some more between them; of many variants
/// only the first are shown.
std::vector<Pictures> pack_pictures(const std::vector<PictureSource>& sources, Packer& packer);

}  // namespace talus::report
