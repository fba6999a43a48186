// SPDX-License-Identifier: MIT
#pragma once
// Checks of a case that need its meshes, which take from tenths of a second to seconds: the page asks for them when the
// user rests.

#include <string>

#include "studio/engine.hpp"

namespace talus::studio {

/// Checks the text of a case as `talus check` does beyond check(): FEM, limit analysis, ready meshes and the memory of
/// a run. Returns {messages} as check(), or {error}. A text with faults has no messages here.
std::string check_methods(const std::string& text, const std::string& name = unnamed_case);

}  // namespace talus::studio
