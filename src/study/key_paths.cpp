// SPDX-License-Identifier: MIT
#include "study/key_paths.hpp"

#include <algorithm>

#include "input/language/overrides.hpp"

namespace talus::study {
namespace {

/// The last `count` parts of a path.
std::string take_end(const std::string& path, std::size_t count) {
  const std::vector<std::string> parts = input::split_path(path);
  std::string text;
  for (std::size_t i = parts.size() - std::min(count, parts.size()); i < parts.size(); ++i)
    text += (text.empty() ? "" : ".") + parts[i];
  return text;
}

}  // namespace

std::string shorten_path(const std::string& path, const std::vector<std::string>& all) {
  for (std::size_t count = 1; count < input::split_path(path).size(); ++count) {
    std::string end = take_end(path, count);
    const auto shares = [&](const std::string& other) { return other != path && take_end(other, count) == end; };
    if (std::none_of(all.begin(), all.end(), shares)) return end;
  }
  return path;
}

}  // namespace talus::study
