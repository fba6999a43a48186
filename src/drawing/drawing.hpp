// SPDX-License-Identifier: MIT
#pragma once
// Lines and texts of a drawing (DXF, GeoPackage, GeoJSON), read by GDAL in the module libtalus_gdal.so.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/message.hpp"

namespace talus::drawing {

using Point = std::array<double, 2>;

/// A polyline; arcs and splines are approximated.
struct DrawnLine {
  std::string layer;
  std::string entity;  ///< "LINE", "LWPOLYLINE"; the kind of geometry where the format has no entities
  std::string handle;  ///< of the entity in its file, for messages
  bool closed = false;
  std::vector<Point> points;  ///< a closed line does not repeat its first point; in units of the drawing
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
  visit(s.layer, s.entity, s.handle, s.closed, s.points);
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
/// lines, texts and remarks.
using ReadByGdal = void (*)(const char* path, const char* format, Message& out);

}  // namespace talus::drawing
