#pragma once
// Dotted paths of keys: their parts and their short names.

#include <string>
#include <vector>

namespace talus::study {

std::vector<std::string> split_path(const std::string& path);

/// The shortest end of `path` that no other of `all` ends with.
std::string shorten_path(const std::string& path, const std::vector<std::string>& all);

}  // namespace talus::study
