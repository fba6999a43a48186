// SPDX-License-Identifier: MIT
#pragma once
// Shapes and places of walls that no method computes, judged from the section alone.

#include <vector>

#include "run/common/walls_of_case.hpp"
#include "site/site.hpp"

namespace talus::run {

/// Throws Error (wrong_input) for a wall shorter than 1/1000 of the width of the section, a piece along the bottom of
/// the section, and two walls that lie on each other. Sections without polygons are judged by the lengths only.
void check_walls(const site::Site& site, const std::vector<WallLine>& walls);

}  // namespace talus::run
