#include "study/key_paths.hpp"

#include <algorithm>

namespace talus::study {
namespace {

/// The last `count` parts of a path.
std::string take_end(const std::string& path, std::size_t count) {
  const std::vector<std::string> parts = split_path(path);
  std::string text;
  for (std::size_t i = parts.size() - std::min(count, parts.size()); i < parts.size(); ++i)
    text += (text.empty() ? "" : ".") + parts[i];
  return text;
}

}  // namespace

std::vector<std::string> split_path(const std::string& path) {
  std::vector<std::string> parts(1);
  for (const char c : path) {
    if (c == '.')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::string shorten_path(const std::string& path, const std::vector<std::string>& all) {
  for (std::size_t count = 1; count < split_path(path).size(); ++count) {
    const std::string end = take_end(path, count);
    const auto shares = [&](const std::string& other) { return other != path && take_end(other, count) == end; };
    if (std::none_of(all.begin(), all.end(), shares)) return end;
  }
  return path;
}

}  // namespace talus::study
