// SPDX-License-Identifier: MIT
#pragma once
// Sentences on the supports of a result: the convention of their forces, and what limits them.

#include <string>

#include "results/slices.hpp"

namespace talus::results {

/// Returns the convention of the factors of LEM: "supports 'nails' passive: F divides their forces"; empty in a case
/// without supports.
std::string describe_support_sense(const SliceResult& slices);

/// "tensile strength", "pull-out behind the surface", …
const char* get_title(SupportLimit limit);

}  // namespace talus::results
