// SPDX-License-Identifier: MIT
#pragma once
// A case file from files of others: tables, a drawing, or an analysis of GeoStudio.

#include <string>
#include <vector>

#include "drawing/geostudio.hpp"

namespace talus::drawing {

/// Options of `talus import`; an empty text stands for the default.
struct ImportOptions {
  std::vector<std::string> files;
  std::string units, role, form, base, snap, analysis;
  std::vector<std::string> layers, boreholes;
};

/// Returns the case that the files describe, by their endings. Throws Error (wrong_input) with one sentence.
ImportedCase import_files(const ImportOptions& options);

}  // namespace talus::drawing
