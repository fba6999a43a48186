// SPDX-License-Identifier: MIT
#include "run/mpm/record/moved_limit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "mpm/body/observe.hpp"

namespace talus::run {
namespace {

using Line = std::vector<std::array<double, 2>>;

/// Columns of the section, in distances of the points; fewest that make a line.
constexpr double column_width = 1.5;
constexpr std::size_t fewest_columns = 6;

/// The height that separates best the moved soil from the rest in a column; nothing where nothing moved.
std::optional<double> part_column(std::vector<std::pair<double, bool>> column, double spacing) {
  std::sort(column.begin(), column.end());
  // With the limit under all points those that stayed are on the wrong side; it then climbs point by point.
  long wrong = std::count_if(column.begin(), column.end(), [](const auto& p) { return !p.second; });
  if (wrong == static_cast<long>(column.size())) return std::nullopt;
  long fewest = wrong;
  double height = column.front().first - spacing / 2;
  for (std::size_t k = 0; k + 1 < column.size(); ++k) {
    wrong += column[k].second ? 1 : -1;
    if (wrong >= fewest) continue;
    fewest = wrong;
    height = (column[k].first + column[k + 1].first) / 2;
  }
  return height;
}

Line smooth(const Line& line) {
  Line result = line;
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    result[i][1] = (line[i - 1][1] + 2 * line[i][1] + line[i + 1][1]) / 4;
  return result;
}

}  // namespace

Line find_moved_limit(const Line& positions, const std::vector<double>& displacement, double spacing,
                      double threshold) {
  const double width = column_width * spacing;
  std::map<long, std::vector<std::pair<double, bool>>> columns;
  for (std::size_t i = 0; i < positions.size(); ++i)
    columns[std::lround(std::floor(positions[i][0] / width))].emplace_back(positions[i][1],
                                                                           displacement[i] > threshold);
  Line longest, current;
  long last = 0;
  for (auto& [c, column] : columns) {
    const auto height = part_column(std::move(column), spacing);
    if (!height) continue;
    if (!current.empty() && c - last > 2) current.clear();
    last = c;
    current.push_back({(static_cast<double>(c) + 0.5) * width, *height});
    if (current.size() > longest.size()) longest = current;
  }
  return longest.size() < fewest_columns ? Line{} : smooth(longest);
}

Line find_frozen_limit(const mpm::Body<2>& body) {
  Line positions;
  std::vector<double> displacement;
  double largest = 0, area = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    positions.push_back(p.position);
    displacement.push_back(norm(p.displacement));
    largest = std::max(largest, displacement.back());
    area += p.volume;
  }
  if (positions.empty()) return {};
  return find_moved_limit(positions, displacement, std::sqrt(area / static_cast<double>(positions.size())),
                          moved_share * largest);
}

}  // namespace talus::run
