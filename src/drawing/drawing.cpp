// SPDX-License-Identifier: MIT
#include "drawing/drawing.hpp"

#include <filesystem>
#include <map>

#include "base/error.hpp"
#include "base/foreign_code.hpp"
#include "base/text.hpp"
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
    fail_input("'{}' does not end in .dxf, .gpkg, .geojson or .json, the drawings that can be read", path);
  return found->second;
}

/// Returns the unit of $INSUNITS in the header of a DXF; std::nullopt if there is none, or none of a survey.
std::optional<std::string> find_unit(const std::string& text) {
  const std::size_t at = text.find("$INSUNITS");
  if (at == std::string::npos) return std::nullopt;
  const std::size_t end = text.find('\n', at), code = text.find("70", end), number = text.find('\n', code);
  if (number == std::string::npos) return std::nullopt;
  const std::map<int, const char*> units{{1, "inch"},  {2, "ft"},  {4, "mm"},
                                         {5, "cm"},    {6, "m"},   {7, "km"},
                                         {10, "yard"}, {14, "dm"}, {21, "US_survey_foot"}};
  const auto found = units.find(std::atoi(text.c_str() + number));
  return found == units.end() ? std::nullopt : std::optional<std::string>(found->second);
}

}  // namespace

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
      std::string why;
      void* read = load_module("libtalus_gdal.so", "talus_read_drawing", false, why);
      if (read == nullptr)
        fail_input("this build of the program cannot read drawings, because it has no GDAL ({})", why);
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
  return drawing;
}

}  // namespace talus::drawing
