// SPDX-License-Identifier: MIT
#pragma once
// Ground investigations in the AGS format, versions 3 and 4: groups of rows, of which the boreholes and their layers
// are read.

#include <string>
#include <vector>

namespace talus::drawing {

/// A group as a comma-separated table with its units. Its rows keep the numbers of their lines.
struct AgsGroup {
  std::string name, text;
  int first_line = 1;
};

/// Returns true for names that end with ".ags".
bool is_ags(const std::string& path);

/// Returns the positions (LOCA, or HOLE of AGS 3) and the layers (GEOL) of the boreholes. Rows that a line <CONT>
/// continues are joined, and codes of soils are replaced by their descriptions in the group ABBR. Throws Error
/// (wrong_input) with one sentence if the file cannot be read or lacks a group.
std::vector<AgsGroup> read_ags(const std::string& path);

}  // namespace talus::drawing
