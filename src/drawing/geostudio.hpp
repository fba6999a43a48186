// SPDX-License-Identifier: MIT
#pragma once
// GeoStudio files (.gsz): a SLOPE/W analysis as a case file. Read are regions, Mohr–Coulomb and undrained strengths,
// piezometric surfaces by material, entry and exit ranges, and an earthquake.

#include <string>
#include <vector>

namespace talus::drawing {

struct ImportedCase {
  std::string text;                  ///< of the case file
  std::vector<std::string> remarks;  ///< what was not translated
};

/// Returns the model of a .gsz, the XML file at the root of the archive. Throws Error (wrong_input) if the file is no
/// such archive, or if the model is larger than 50 MB or expands more than 300 times.
std::string read_model(const std::string& path);

/// Translates the SLOPE/W analysis of this name, or the first one if it is empty. Throws Error (wrong_input) if the
/// text is not the XML of a GeoStudio model, or has no such analysis or no regions.
ImportedCase translate_model(const std::string& xml, const std::string& analysis, const std::string& source);

}  // namespace talus::drawing
