// SPDX-License-Identifier: MIT
#pragma once
// Lines and texts of a drawing (DXF, GeoPackage, GeoJSON), read and written by GDAL in the module libtalus_gdal.so.

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/message.hpp"

namespace talus::drawing {

using Point = std::array<double, 2>;
using Polyline = std::vector<Point>;

/// A polyline; arcs and splines are approximated.
struct DrawnLine {
  std::string layer;
  std::string entity;  ///< "LINE", "LWPOLYLINE"; the kind of geometry where the format has no entities
  std::string handle;  ///< of the entity in its file, for messages
  bool closed = false;
  std::vector<Point> points;  ///< a closed line does not repeat its first point; in units of the drawing
  std::string soil = {};      ///< attribute of a feature of GIS that names its soil
};

/// A text and its place.
struct DrawnText {
  std::string layer, text;
  Point at{};
};

struct Drawing {
  std::string format;  ///< "DXF", "GPKG", "GeoJSON"
  std::vector<DrawnLine> lines;
  std::vector<DrawnText> texts;
  std::vector<std::string> remarks;  ///< what was not read, with its place
  std::optional<std::string> unit;   ///< of length, as in a case file; std::nullopt if the drawing has none
};

template <class Visit>
void visit_members(Visit&& visit, Like<DrawnLine> auto& s) {
  visit(s.layer, s.entity, s.handle, s.closed, s.points, s.soil);
}
template <class Visit>
void visit_members(Visit&& visit, Like<DrawnText> auto& s) {
  visit(s.layer, s.text, s.at);
}

/// Limits of a drawing; beyond them it is rejected.
inline constexpr std::size_t most_lines = 50'000, most_points = 200'000;

/// Reads a drawing in a child process with limited time and memory. Throws Error (wrong_input) with one sentence if the
/// file is not a drawing of these formats, has too many lines, or if this build has no GDAL.
Drawing read_drawing(const std::string& path);

/// The function of the module: reads `path` by the driver of `format` into a Message of an error text (empty: none),
/// lines, texts, remarks, and the name of a geographic coordinate system (empty: none).
using ReadByGdal = void (*)(const char* path, const char* format, Message& out);

// Drawings of results.

/// Layers of a section of `talus export`, beside those of its soils. Slip surfaces are on layers of this prefix, a
/// method, and their name: "slip_lem_spencer_1.434". `talus import` leaves ponds, supports and slip surfaces out.
inline constexpr const char *ground_layer = "ground", *water_layer = "water_table", *pond_layer = "ponds",
                            *support_layer = "supports", *slip_prefix = "slip_";

/// Returns true for an open line on a layer of results, which is no boundary of soils.
bool is_result_line(const DrawnLine& line);

/// A drawing to be written.
struct NewDrawing {
  std::vector<DrawnLine> lines;                ///< `entity` and `handle` are not used
  std::vector<DrawnText> texts;                ///< above the section
  std::vector<DrawnText> labels;               ///< names of regions, within them
  std::map<std::string, std::string> colours;  ///< by layer, "#2f7fd6"
  double text_height = 0;                      ///< in units of the drawing
  int unit_code = 0;                           ///< of $INSUNITS
};

/// Returns the code of $INSUNITS for a unit of length, such as 6 for "m". Throws Error (wrong_input) for a unit that a
/// DXF cannot state.
int find_unit_code(const std::string& unit);

/// Writes `drawing` as DXF (AutoCAD 2004) in a child process. Characters that names of layers may not have become
/// underscores; texts keep them. Throws Error (wrong_input) if this build has no GDAL, and Error (cannot_write).
void write_drawing(const NewDrawing& drawing, const std::filesystem::path& path);

/// The function of the module: writes an error text (empty: none) and the bytes of the file into a Message.
using WriteByGdal = void (*)(const NewDrawing& drawing, Message& out);

/// The function of the module that divides lines where they meet into edges, and returns the outlines of the areas
/// between them; `error` is empty if it succeeds.
using SubdivideByGdal = void (*)(const std::vector<Polyline>& lines, std::vector<Polyline>& edges,
                                 std::vector<Polyline>& faces, std::string& error);

/// Returns true if the module of GDAL can be loaded.
bool has_gdal();

/// Returns the function `name` of the module. Throws Error (wrong_input) in a build without GDAL.
void* load_gdal(const char* name);

}  // namespace talus::drawing
