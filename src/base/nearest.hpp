// SPDX-License-Identifier: MIT
#pragma once
// Which of the known words a mistyped one was meant to be.

#include <string>
#include <string_view>
#include <vector>

namespace talus {

/// The smallest number of letters to insert, delete, replace or swap with their neighbour to turn `a` into `b`
/// (optimal string alignment distance); upper and lower case count as half different, rounded up over the word.
int measure_edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, or an empty string when none is near: more than a third of its letters differ.
std::string find_nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace talus
