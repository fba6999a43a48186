// SPDX-License-Identifier: MIT
#pragma once
// Files that may be damaged, looked at before the HDF5 library of this process reads them.

#include <filesystem>
#include <vector>

namespace talus::output {

/// What is looked at: the structure of a file, which says where its values stand, or all its values too.
enum class Depth { structure, values };

/// Goes through HDF5 files in a child process, because the library crashes on some damaged ones. Every data set has a
/// checksum, which is verified wherever its values are read. Throws Error (wrong_input) with the name of the first file
/// that is damaged; files that are not there are left out.
void examine(const std::vector<std::filesystem::path>& files, Depth depth = Depth::structure);

}  // namespace talus::output
