// SPDX-License-Identifier: MIT
#pragma once
// What a study will need, before it begins.

#include <string>
#include <vector>

#include "input/read.hpp"

namespace talus::study {

/// "a study varies 3 keys: 24 runs, about 10 minutes"; empty where the case has no study. The time is that of runs one
/// after another. Throws InputError with the faults of the variants.
std::string describe_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides);

}  // namespace talus::study
