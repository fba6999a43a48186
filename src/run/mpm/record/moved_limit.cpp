// SPDX-License-Identifier: MIT
#include "run/mpm/record/moved_limit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "mesh/divide.hpp"
#include "mpm/body/observe.hpp"

namespace talus::run {
namespace {

using Point = std::array<double, 2>;
using Line = std::vector<Point>;

/// Columns of the section, in distances of the points; fewest that make a line.
constexpr double column_width = 1.5;
constexpr std::size_t fewest_columns = 6;
/// Rise of the plane that a wedge of soil sinks along, 45° + φ/2, for φ = 30° [-].
constexpr double wedge_slope = 1.7320508075688772;

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

/// The lower limit of all soil of a section that moved, or of one side of it.
Line find_limit(const MovedSection& section, double threshold) {
  const double width = column_width * section.spacing;
  std::map<long, std::vector<std::pair<double, bool>>> columns;
  for (std::size_t i = 0; i < section.positions.size(); ++i)
    columns[std::lround(std::floor(section.positions[i][0] / width))].emplace_back(section.positions[i][1],
                                                                                   section.displacement[i] > threshold);
  Line longest, current;
  long last = 0;
  for (auto& [c, column] : columns) {
    const auto height = part_column(std::move(column), section.spacing);
    if (!height) continue;
    if (!current.empty() && c - last > 2) current.clear();
    last = c;
    current.push_back({(static_cast<double>(c) + 0.5) * width, *height});
    if (current.size() > longest.size()) longest = current;
  }
  return longest.size() < fewest_columns ? Line{} : smooth(longest);
}

/// Leads the line of a side that ends under the divide, where the other side begins, up to the ground beyond it.
void lead_up(const MovedSection& section, const mesh::Divide& divide, bool is_left, Line& line) {
  const double width = column_width * section.spacing, way = is_left ? 1 : -1;
  const Point end = is_left ? line.back() : line.front();
  if (std::abs(end[0] - divide.x) > 2 * width) return;  // the soil between the sides stayed
  std::map<long, double> tops;
  for (const Point& x : section.positions) {
    const auto [at, is_new] = tops.try_emplace(std::lround(std::floor(x[0] / width)), x[1]);
    if (!is_new) at->second = std::max(at->second, x[1]);
  }
  const double step = section.spacing / 2;
  for (int k = 1;; ++k) {
    const Point next{end[0] + way * k * step, end[1] + wedge_slope * k * step};
    const auto top = tops.find(std::lround(std::floor(next[0] / width)));
    if (top == tops.end()) return;
    line.insert(is_left ? line.end() : line.begin(), next);
    if (next[1] >= top->second) return;
  }
}

}  // namespace

MovedLimit find_moved_limit(const MovedSection& section, double threshold) {
  std::vector<mesh::MovedSoil> soil;
  for (std::size_t i = 0; i < section.positions.size(); ++i)
    if (section.displacement[i] > threshold) soil.push_back({section.positions[i][0], section.across[i], 1});
  const auto divide = mesh::find_divide(std::move(soil), threshold);
  if (!divide) return {find_limit(section, threshold), {}};
  MovedLimit result;
  std::size_t most = 0;
  for (const bool is_left : {true, false}) {
    MovedSection own;
    own.spacing = section.spacing;
    std::size_t moved = 0;
    for (std::size_t i = 0; i < section.positions.size(); ++i) {
      if ((section.positions[i][0] < divide->x) != is_left) continue;
      own.positions.push_back(section.positions[i]);
      own.displacement.push_back(section.displacement[i]);
      moved += section.displacement[i] > threshold ? 1 : 0;
    }
    Line line = find_limit(own, threshold);
    if (line.empty()) continue;
    if (divide->left < 0) lead_up(section, *divide, is_left, line);
    if (moved > most) {
      most = moved;
      result.line = line;
    }
    result.sides.push_back({is_left ? divide->left : -divide->left, std::move(line)});
  }
  if (result.sides.size() < 2) {
    result.sides.clear();
  } else if (result.sides[0].direction > 0) {
    std::swap(result.sides[0], result.sides[1]);
  }
  return result;
}

MovedLimit find_frozen_limit(const mpm::Body<2>& body) {
  MovedSection section;
  double largest = 0, area = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    section.positions.push_back(p.position);
    section.displacement.push_back(norm(p.displacement));
    section.across.push_back(p.displacement[0]);
    largest = std::max(largest, section.displacement.back());
    area += p.volume;
  }
  if (section.positions.empty()) return {};
  section.spacing = std::sqrt(area / static_cast<double>(section.positions.size()));
  return find_moved_limit(section, moved_share * largest);
}

}  // namespace talus::run
