// SPDX-License-Identifier: MIT
#pragma once
// Parts of the text of a case file that is made of a drawing.

#include <set>
#include <string>

#include "mesh/planar.hpp"

namespace talus::drawing {

/// Returns the text without what ends a comment or a string of a case file: control characters, quotation marks and
/// backslashes become underscores.
std::string clean_text(std::string text);

/// Returns a clean name that is not in `taken`, and adds it. Dots, which divide paths of keys, become underscores.
std::string take_name(std::set<std::string>& taken, std::string wanted);

/// Writes points as [[x, y], …], rounded to a millionth of a metre, on as many lines as needed.
std::string write_points(const mesh::Polyline& points);

}  // namespace talus::drawing
