// SPDX-License-Identifier: MIT
#pragma once
// The other files that a case names: a ready mesh, tables of series, compiled soils, the result that it starts from.

#include <string>
#include <vector>

#include "input/language/overrides.hpp"

namespace talus::input {

/// Their names as the text of a case with these changes gives them, in the order of their keys, each once; a result is
/// named by its folder. The case was read without a fault before.
std::vector<std::string> list_files(const std::string& text, const std::vector<Override>& overrides);

}  // namespace talus::input
