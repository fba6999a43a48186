// SPDX-License-Identifier: MIT
#pragma once
// Parts of the text of a case file that is made of a drawing.

#include <set>
#include <string>

#include "mesh/planar.hpp"

namespace talus::drawing {

/// Returns a name that is not in `taken`, and adds it: without control characters, quotation marks, backslashes and
/// dots, which have a meaning in a case file and its paths.
std::string take_name(std::set<std::string>& taken, std::string wanted);

/// Writes points as [[x, y], …], rounded to a millionth of a metre, on as many lines as needed.
std::string write_points(const mesh::Polyline& points);

}  // namespace talus::drawing
