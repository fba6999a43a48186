// SPDX-License-Identifier: MIT
#include "run/mpm/record/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/atomic_file.hpp"
#include "base/encoding.hpp"
#include "base/error.hpp"
#include "base/file_name.hpp"
#include "output/files/frames_reader.hpp"
#include "output/files/history.hpp"
#include "run/mpm/record/motion.hpp"

namespace talus::run {
namespace {

namespace fs = std::filesystem;

/// A component of a field.
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

/// Sums of one part of the line.
struct Part {
  int points = 0;
  double volume = 0, distance = 0;
  std::vector<double> values, volumes;  ///< [column]
};

std::string write_row(double time, const SectionRow& row, int dimension) {
  std::string text = output::to_shortest(time) + "," + output::to_shortest(row.distance);
  for (int d = 0; d < dimension; ++d) text += "," + output::to_shortest(row.position[static_cast<std::size_t>(d)]);
  text += fmt::format(",{}", row.points);
  for (const double value : row.values) text += "," + output::to_shortest(value);
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
      if (!std::isfinite(value)) continue;  // a quantity that the soil there does not have
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

}  // namespace talus::run
