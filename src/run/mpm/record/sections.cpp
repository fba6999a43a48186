// SPDX-License-Identifier: MIT
#include "run/mpm/record/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/user_file.hpp"
#include "mesh/planar.hpp"
#include "mpm/solver/observe.hpp"
#include "output/files/frames_reader.hpp"
#include "output/files/history.hpp"
#include "run/mpm/record/motion.hpp"

namespace talus::run {

namespace {

namespace fs = std::filesystem;

struct Component {
  const output::Field* field;
  std::size_t index;
  std::string name;
};

std::vector<Component> list_components(const output::Frame& frame, int dimension) {
  static const char* const letters[] = {"x", "y", "z"};
  static const char* const pairs[] = {"xx", "yy", "zz", "xy", "yz", "xz"};
  std::vector<Component> list;
  for (const output::Field& f : frame.point_fields) {
    const bool plane = dimension == 2;
    const std::size_t count = f.components == 3 ? (plane ? 2 : 3) : f.components == 6 ? (plane ? 4 : 6) : 1;
    for (std::size_t c = 0; c < count; ++c)
      list.push_back({&f, c, count == 1 ? f.name : f.name + "_" + (f.components == 3 ? letters[c] : pairs[c])});
  }
  return list;
}

void set_displacements_zero(output::Frame& frame) {
  for (output::Field& f : frame.point_fields)
    if (f.name == "displacement") std::fill(f.values.begin(), f.values.end(), 0.0);
}

/// Sums over one interval of the line.
struct Part {
  int points = 0;
  double volume = 0, distance = 0;
  std::vector<double> values, volumes;  ///< [column]
};

std::string write_row(double time, const SectionRow& row, int dimension) {
  std::string text = write_shortest(time) + "," + write_shortest(row.distance);
  for (int d = 0; d < dimension; ++d) text += "," + write_shortest(row.position[static_cast<std::size_t>(d)]);
  text += fmt::format(",{}", row.points);
  for (const double value : row.values) text += "," + write_shortest(value);
  return text + "\n";
}

}  // namespace

std::vector<SectionColumn> list_section_columns(const output::Frame& frame, int dimension) {
  std::vector<SectionColumn> columns;
  for (const Component& c : list_components(frame, dimension)) columns.push_back({c.name, c.field->unit});
  return columns;
}

std::vector<SectionRow> cut_section(const output::Frame& frame, const input::SectionLine& section, int dimension,
                                    double width) {
  const std::vector<Component> components = list_components(frame, dimension);
  const output::Field* volumes = output::find(frame.point_fields, "volume");
  std::array<double, 3> along{};
  double length = 0;
  for (std::size_t d = 0; d < 3; ++d) length += (section.to[d] - section.from[d]) * (section.to[d] - section.from[d]);
  length = std::sqrt(length);
  for (std::size_t d = 0; d < 3; ++d) along[d] = (section.to[d] - section.from[d]) / length;
  std::map<int, Part> parts;
  for (std::size_t i = 0; i < frame.ids.size(); ++i) {
    double distance = 0, square = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double x = frame.positions[3 * i + d] - section.from[d];
      distance += x * along[d];
      square += x * x;
    }
    if (distance < 0 || distance > length || square - distance * distance > 0.25 * width * width) continue;
    Part& part = parts[static_cast<int>(distance / width)];
    const double volume = volumes == nullptr ? 1 : volumes->values[i];
    ++part.points;
    part.volume += volume;
    part.distance += volume * distance;
    part.values.resize(components.size());
    part.volumes.resize(components.size());
    for (std::size_t k = 0; k < components.size(); ++k) {
      const output::Field& f = *components[k].field;
      const double value = f.values[i * static_cast<std::size_t>(f.components) + components[k].index];
      if (!std::isfinite(value)) continue;  // the law of the point does not have this quantity
      part.values[k] += volume * value;
      part.volumes[k] += volume;
    }
  }
  std::vector<SectionRow> rows;
  for (const auto& [number, part] : parts) {
    SectionRow row;
    row.distance = part.distance / part.volume;
    row.points = part.points;
    for (std::size_t d = 0; d < 3; ++d) row.position[d] = section.from[d] + along[d] * row.distance;
    for (std::size_t k = 0; k < components.size(); ++k)
      row.values.push_back(part.volumes[k] > 0 ? part.values[k] / part.volumes[k]
                                               : std::numeric_limits<double>::quiet_NaN());
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<results::SectionLine> write_sections(const input::Case& data, const std::vector<results::Stage>& stages,
                                                 double size, const fs::path& folder) {
  std::vector<results::SectionLine> list;
  if (data.output.sections.empty()) return list;
  if (!output::holds_frames(folder)) return list;
  const std::optional<results::Clock> clock = find_clock(data, stages);
  const output::ResultsReader reader(folder);
  const int dimension = data.mesh.dimension;
  std::vector<std::string> texts(data.output.sections.size());
  std::vector<SectionColumn> columns;
  for (int i = 0; i < reader.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (i + 1 < reader.size() && reader.times()[k] == reader.times()[k + 1]) continue;
    output::Frame frame = reader.read(i);
    if (clock && clock->resets && frame.time == clock->start) set_displacements_zero(frame);
    if (columns.empty()) columns = list_section_columns(frame, dimension);
    for (std::size_t s = 0; s < texts.size(); ++s) {
      const input::SectionLine& section = data.output.sections[s];
      for (const SectionRow& row : cut_section(frame, section, dimension, section.width.value_or(size)))
        if (row.values.size() == columns.size()) texts[s] += write_row(frame.time, row, dimension);
    }
  }
  std::string header = "time [s],distance [m]";
  for (int d = 0; d < dimension; ++d) header += fmt::format(",{} [m]", "xyz"[d]);
  header += ",points [-]";
  for (const SectionColumn& c : columns) header += fmt::format(",{} [{}]", c.name, c.unit);
  make_folder(folder / "sections");
  for (std::size_t s = 0; s < texts.size(); ++s) {
    const input::SectionLine& section = data.output.sections[s];
    write_atomically(join_name(folder / "sections", make_printable(section.name), ".csv"), header + "\n" + texts[s]);
    list.push_back({section.name, section.from, section.to, section.width.value_or(size)});
  }
  return list;
}

namespace {

using Point = std::array<double, 2>;
using Line = std::vector<Point>;

/// Width of the columns of a section, in mean distances of the points, and the fewest columns that make a line.
constexpr double column_width = 1.5;
constexpr std::size_t fewest_columns = 6;
/// Slope of the active wedge, tan(45° + φ/2), for φ = 30° [-].
constexpr double wedge_slope = 1.7320508075688772;

/// Returns the height that best separates moved from unmoved soil in a column; nullopt if nothing moved.
std::optional<double> part_column(std::vector<std::pair<double, bool>> column, double spacing) {
  std::sort(column.begin(), column.end());
  // The limit starts below all points, where every unmoved point is on the wrong side, and then rises point by point.
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

/// Returns the lower limit of all moved soil of a section, or of one side of it.
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

/// Extends the line of a side that ends under the divide, where the other side begins, up to the ground beyond it.
void lead_up(const MovedSection& section, const mesh::Divide& divide, bool is_left, Line& line) {
  const double width = column_width * section.spacing, way = is_left ? 1 : -1;
  const Point end = is_left ? line.back() : line.front();
  if (std::abs(end[0] - divide.x) > 2 * width) return;  // the soil between the two sides did not move
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
