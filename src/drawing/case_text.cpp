// SPDX-License-Identifier: MIT
#include "drawing/case_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace talus::drawing {

std::string clean_text(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '"' || c == '\\' || c == 127) c = '_';
  return text;
}

std::string take_name(std::set<std::string>& taken, std::string wanted) {
  wanted = clean_text(std::move(wanted));
  std::replace(wanted.begin(), wanted.end(), '.', '_');
  if (wanted.empty()) wanted = "soil";
  std::string unique = wanted;
  for (int i = 2; !taken.insert(unique).second; ++i) unique = fmt::format("{} {}", wanted, i);
  return unique;
}

std::string write_points(const mesh::Polyline& points) {
  constexpr std::size_t longest = 110;
  std::string text = "[", line;
  for (std::size_t i = 0; i < points.size(); ++i) {
    // A millionth of a metre is below any survey.
    const auto round = [](double v) { return std::round(v * 1e6) / 1e6 + 0.0; };
    const std::string item =
        fmt::format("[{}, {}]{}", round(points[i][0]), round(points[i][1]), i + 1 < points.size() ? ", " : "");
    if (line.size() + item.size() > longest) text += line + "\n  ", line.clear();
    line += item;
  }
  return text + line + "]";
}

}  // namespace talus::drawing
