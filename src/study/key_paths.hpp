// SPDX-License-Identifier: MIT
#pragma once
// Short names of keys.

#include <string>
#include <vector>

namespace talus::study {

/// The shortest end of `path` that no other of `all` ends with.
std::string shorten_path(const std::string& path, const std::vector<std::string>& all);

}  // namespace talus::study
