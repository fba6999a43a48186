// SPDX-License-Identifier: MIT
#include "drawing/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/foreign_code.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "base/user_file.hpp"

namespace talus::drawing {
namespace {

constexpr double longest_reading = 60;  // of processor time [s]
constexpr double most_memory = 2e9;     // [bytes]
constexpr std::uint64_t largest_drawing = 200 * largest_file::megabyte;

std::string get_format(const std::string& path) {
  const std::string ending = to_lower(std::filesystem::path(path).extension().string());
  const std::map<std::string, std::string> formats{
      {".dxf", "DXF"}, {".gpkg", "GPKG"}, {".geojson", "GeoJSON"}, {".json", "GeoJSON"}};
  const auto found = formats.find(ending);
  if (found == formats.end())
    fail_input("'{}' does not end in .dxf, .gpkg, .geojson, .json, .gsz, .csv or .ags, the files that can be read",
               path);
  return found->second;
}

/// Units of length by their code of $INSUNITS.
const std::map<int, const char*>& list_units() {
  static const std::map<int, const char*> units{{1, "inch"},  {2, "ft"},  {4, "mm"},
                                                {5, "cm"},    {6, "m"},   {7, "km"},
                                                {10, "yard"}, {14, "dm"}, {21, "US_survey_foot"}};
  return units;
}

/// Returns the unit of $INSUNITS in the header of a DXF; std::nullopt if there is none, or none of a survey.
std::optional<std::string> find_unit(const std::string& text) {
  const std::size_t at = text.find("$INSUNITS");
  if (at == std::string::npos) return std::nullopt;
  const std::size_t end = text.find('\n', at), code = text.find("70", end), number = text.find('\n', code);
  if (number == std::string::npos) return std::nullopt;
  const auto found = list_units().find(std::atoi(text.c_str() + number));
  return found == list_units().end() ? std::nullopt : std::optional<std::string>(found->second);
}

/// Returns true if all coordinates may be degrees and the lines extend over less than a section would.
bool are_degrees(const Drawing& drawing) {
  constexpr double smallest_section = 0.25;
  Point low{1e300, 1e300}, high{-1e300, -1e300};
  for (const DrawnLine& line : drawing.lines)
    for (const Point& p : line.points)
      for (std::size_t d = 0; d < 2; ++d) low[d] = std::min(low[d], p[d]), high[d] = std::max(high[d], p[d]);
  return low[0] >= -180 && high[0] <= 180 && low[1] >= -90 && high[1] <= 90 &&
         std::max(high[0] - low[0], high[1] - low[1]) < smallest_section;
}

[[noreturn]] void fail_without_gdal(const char* act, const std::string& why) {
  fail_input(
      "this build of the program cannot {} drawings, because it has no GDAL ({}); 'make program "
      "CMAKE_ARGS=-DTALUS_GDAL=ON' in its source folder adds it",
      act, why);
}

}  // namespace

bool has_gdal() {
  std::string why;
  return load_module("libtalus_gdal.so", "talus_subdivide", false, why) != nullptr;
}

void* load_gdal(const char* name) {
  std::string why;
  void* function = load_module("libtalus_gdal.so", name, false, why);
  if (function == nullptr) fail_without_gdal("read", why);
  return function;
}

Drawing read_drawing(const std::string& path) {
  Drawing drawing;
  drawing.format = get_format(path);
  std::string text;
  if (const auto fault = try_user_file(path, largest_drawing, text))
    fail_input("the drawing '{}' cannot be read: {}", path, fault->why);
  if (drawing.format == "DXF") {
    if (text.starts_with("AutoCAD Binary DXF")) fail_input("'{}' is a binary DXF; save it as an ASCII DXF", path);
    drawing.unit = find_unit(text);
  } else if (drawing.format == "GeoJSON") {
    drawing.unit = "m";
  }
  Message message;
  try {
    message = do_in_child("reading the drawing", [&](Message& out) {
      void* read = load_gdal("talus_read_drawing");
      limit_processor_time(longest_reading);
      limit_memory(most_memory);
      reinterpret_cast<ReadByGdal>(read)(path.c_str(), drawing.format.c_str(), out);
    });
  } catch (const ChildCrash& crash) {
    fail_input("the drawing '{}' cannot be read: {}", path, crash.what());
  }
  if (const std::string error = message.get_text(); !error.empty())
    fail_input("the drawing '{}' cannot be read: {}", path, error);
  Taking take(message);
  take(drawing.lines, drawing.texts);
  drawing.remarks.resize(message.get<std::size_t>());
  for (std::string& remark : drawing.remarks) remark = message.get_text();
  // GeoJSON without a coordinate system counts as longitude and latitude for GDAL; here it is a section in metres.
  const std::string geographic = message.get_text();
  const bool is_stated = drawing.format != "GeoJSON" || text.find("\"crs\"") != std::string::npos;
  if (!geographic.empty() && (is_stated || are_degrees(drawing)))
    fail_input(
        "'{}' has longitudes and latitudes ({}), a map and not a section: bring x along the section and y as "
        "elevation, "
        "in a projected or no coordinate system",
        path, geographic);
  return drawing;
}

bool is_result_line(const DrawnLine& line) {
  if (line.closed) return false;
  if (line.layer == pond_layer || line.layer == support_layer) return true;
  // A soil may be called slip_zone, so the prefix alone does not count.
  constexpr std::array methods{"lem", "fem", "bounds", "mpm"};
  return std::any_of(methods.begin(), methods.end(), [&](const char* method) {
    return line.layer.starts_with(std::string(slip_prefix) + method + "_");
  });
}

int find_unit_code(const std::string& unit) {
  const double si = units::parse_as_si("1 " + unit, "m", "--units");
  std::string known;
  for (const auto& [code, name] : list_units()) {
    if (std::abs(units::get_si_factor(name) / si - 1) < 1e-9) return code;
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  fail_input("a DXF cannot state the unit '{}'; it can state {}", unit, known);
}

void write_drawing(const NewDrawing& drawing, const std::filesystem::path& path) {
  Message message;
  try {
    message = do_in_child("writing the drawing", [&](Message& out) {
      std::string why;
      void* write = load_module("libtalus_gdal.so", "talus_write_drawing", false, why);
      if (write == nullptr) fail_without_gdal("write", why);
      limit_processor_time(longest_reading);
      limit_memory(most_memory);
      reinterpret_cast<WriteByGdal>(write)(drawing, out);
    });
  } catch (const ChildCrash& crash) {
    throw Error(ExitCode::cannot_write, "cannot write '{}': {}", path.string(), crash.what());
  }
  if (const std::string error = message.get_text(); !error.empty())
    throw Error(ExitCode::cannot_write, "cannot write '{}': {}", path.string(), error);
  write_atomically(path, message.get_text());
}

}  // namespace talus::drawing
