// SPDX-License-Identifier: MIT
// Lines and texts of a drawing by GDAL, and the areas that lines enclose, by GEOS. Only the drivers of three formats
// are registered, since others, such as virtual formats, open further files that a drawing names.

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "drawing/drawing.hpp"

namespace talus::drawing {
namespace {

constexpr int deepest = 8;  // collections in collections

/// Messages of GDAL while a drawing is read.
struct Heard {
  std::string error;
  std::vector<std::string> remarks;
};

void CPL_STDCALL hear(CPLErr kind, CPLErrorNum, const char* text) {
  auto* heard = static_cast<Heard*>(CPLGetErrorHandlerUserData());
  const std::string_view message(text);
  if (kind >= CE_Failure && heard->error.empty()) heard->error = message;
  const bool ignores = message.find("gnoring") != std::string_view::npos;
  if (kind <= CE_Warning && ignores) heard->remarks.push_back(std::string(message.substr(message.find(": ") + 1)));
}

/// The z of a drawing, point by point of its lines and text by text.
struct Heights {
  std::vector<std::vector<double>> of_lines;
  std::vector<double> of_texts;
};

class Reader {
 public:
  Reader(Drawing& drawing, Heights& heights) : drawing_(drawing), heights_(heights) {}

  void read(OGRLayer& layer) {
    for (const OGRFeatureUniquePtr& feature : layer) {
      const OGRGeometry* geometry = feature->GetGeometryRef();
      feature_ = feature.get();
      DrawnLine line;
      line.soil = get_text({"soil", "Soil", "SOIL", "material", "Material"});
      line.layer = get_text({"Layer", "layer", "soil", "material", "name"});
      if (line.layer.empty()) line.layer = layer.GetName();
      line.entity = get_text({"SubClasses"});
      line.entity = line.entity.substr(line.entity.rfind(':') + 1);
      line.handle = get_text({"EntityHandle"});
      if (line.handle.empty()) line.handle = std::to_string(feature->GetFID());
      if (line.entity.empty() && geometry != nullptr) line.entity = OGRGeometryTypeToName(geometry->getGeometryType());
      if (get_text({"PaperSpace"}) == "1") {
        remark(line, "is in paper space");
        continue;
      }
      if (geometry == nullptr)
        remark(line, "has no geometry");
      else
        add(*geometry, line, 0);
    }
  }

 private:
  std::string get_text(std::initializer_list<const char*> names) const {
    for (const char* name : names) {
      const int field = feature_->GetFieldIndex(name);
      if (field >= 0 && feature_->IsFieldSetAndNotNull(field)) return feature_->GetFieldAsString(field);
    }
    return "";
  }

  void remark(const DrawnLine& line, const char* what) {
    drawing_.remarks.push_back(fmt::format("{} {} on layer '{}' {}", line.entity, line.handle, line.layer, what));
  }

  void add(const OGRGeometry& geometry, const DrawnLine& head, int depth) {
    if (depth > deepest) return remark(head, "is nested too deeply");
    switch (wkbFlatten(geometry.getGeometryType())) {
      case wkbPoint:
        if (const std::string text = get_text({"Text", "soil", "Soil", "SOIL", "material", "label", "name"});
            !text.empty()) {
          drawing_.texts.push_back({head.layer, text, {geometry.toPoint()->getX(), geometry.toPoint()->getY()}});
          heights_.of_texts.push_back(geometry.toPoint()->getZ());
        } else {
          remark(head, "is a point");
        }
        return;
      case wkbLineString:
        return add_line(*geometry.toLineString(), head, false);
      case wkbPolygon:
        if (geometry.toPolygon()->getNumInteriorRings() > 0) remark(head, "has holes, which are separate lines now");
        for (const OGRLinearRing* ring : *geometry.toPolygon()) add_line(*ring, head, true);
        return;
      case wkbMultiLineString:
      case wkbMultiPolygon:
      case wkbMultiPoint:
      case wkbGeometryCollection:
        for (const OGRGeometry* part : *geometry.toGeometryCollection()) add(*part, head, depth + 1);
        return;
      default:
        if (geometry.hasCurveGeometry()) {
          const std::unique_ptr<OGRGeometry> straight(geometry.getLinearGeometry());
          if (straight && !straight->hasCurveGeometry()) return add(*straight, head, depth + 1);
        }
        return remark(head, "is neither a line nor an area");
    }
  }

  void add_line(const OGRLineString& from, const DrawnLine& head, bool closed) {
    DrawnLine line = head;
    std::vector<double> heights;
    for (int i = 0; i < from.getNumPoints(); ++i) {
      line.points.push_back({from.getX(i), from.getY(i)});
      heights.push_back(from.getZ(i));
    }
    // In a section of x and z, ends at one place in plan may lie at different levels.
    const bool meets =
        line.points.size() > 1 && line.points.front() == line.points.back() && heights.front() == heights.back();
    line.closed = closed || (line.points.size() > 3 && meets);
    if (line.closed && meets) line.points.pop_back();
    points_ += line.points.size();
    if (drawing_.lines.size() >= most_lines || points_ > most_points)
      throw std::length_error(fmt::format("it has more than {} lines or {} points", most_lines, most_points));
    heights.resize(line.points.size());
    heights_.of_lines.push_back(std::move(heights));
    drawing_.lines.push_back(std::move(line));
  }

  Drawing& drawing_;
  Heights& heights_;
  OGRFeature* feature_ = nullptr;
  std::size_t points_ = 0;
};

/// The least and the largest of some values.
struct Span {
  double low = HUGE_VAL, high = -HUGE_VAL;
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  double length() const { return high > low ? high - low : 0; }
};

/// Takes z as y where a section is drawn in x and z. Returns the error of a drawing with lines that rise in z
/// otherwise; empty without any.
std::string settle_heights(Drawing& drawing, const Heights& heights) {
  Span x, y, z;
  double rise = 0;
  const DrawnLine* rising = nullptr;
  for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
    Span of_line;
    for (const Point& p : drawing.lines[i].points) x.add(p[0]), y.add(p[1]);
    for (const double height : heights.of_lines[i]) z.add(height), of_line.add(height);
    if (of_line.length() > rise) rise = of_line.length(), rising = &drawing.lines[i];
  }
  // Relative to the size of the drawing, and to its extent in y: profiles of point clouds keep what lies off their
  // plane.
  constexpr double level = 1e-6, scatter = 0.1;
  const double size = std::max({x.length(), y.length(), z.length()});
  if (rising == nullptr || rise <= level * size) return "";
  if (rise <= scatter * y.length()) {
    drawing.remarks.push_back(fmt::format("z, which changes by up to {:.3g} along a line, is not used", rise));
    return "";
  }
  if (y.length() > level * size)
    return fmt::format(
        "it is drawn in space: z changes by {:.6g} along the line {} on layer '{}', and y by {:.6g} in the drawing; a "
        "section is drawn in x and y, or in x and z",
        rise, rising->handle, rising->layer, y.length());
  for (std::size_t i = 0; i < drawing.lines.size(); ++i)
    for (std::size_t k = 0; k < drawing.lines[i].points.size(); ++k)
      drawing.lines[i].points[k][1] = heights.of_lines[i][k];
  for (std::size_t i = 0; i < drawing.texts.size(); ++i) drawing.texts[i].at[1] = heights.of_texts[i];
  drawing.remarks.push_back("the section is drawn in x and z; z is the level");
  return "";
}

std::string read(const char* path, const char* format, Drawing& drawing, std::string& geographic, Heard& heard) {
  RegisterOGRDXF();
  RegisterOGRGeoPackage();
  RegisterOGRGeoJSON();
  const char* const drivers[] = {format, nullptr};
  const std::unique_ptr<GDALDataset> data(GDALDataset::Open(path, GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers));
  Heights heights;
  if (!data) return heard.error.empty() ? fmt::format("it is not a file of format {}", format) : heard.error;
  try {
    for (OGRLayer* layer : data->GetLayers()) {
      const OGRSpatialReference* system = layer->GetSpatialRef();
      // GeoPackages without a system have an undefined one.
      if (system != nullptr && system->IsGeographic() && !std::string_view(system->GetName()).starts_with("Undefined"))
        geographic = system->GetName();
      Reader(drawing, heights).read(*layer);
    }
    if (std::string fault = settle_heights(drawing, heights); !fault.empty()) return fault;
  } catch (const std::length_error& error) {
    return error.what();
  }
  return "";
}

Polyline copy_points(const OGRSimpleCurve& from) {
  Polyline points;
  for (int i = 0; i < from.getNumPoints(); ++i) points.push_back({from.getX(i), from.getY(i)});
  return points;
}

/// Adds the lines or the outlines of polygons within a geometry.
void collect(const OGRGeometry& geometry, std::vector<Polyline>& lines, int depth) {
  if (depth > deepest) return;
  switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbLineString:
      return lines.push_back(copy_points(*geometry.toLineString()));
    case wkbPolygon:
      if (const OGRLinearRing* ring = geometry.toPolygon()->getExteriorRing())
        lines.push_back(copy_points(*ring)), lines.back().pop_back();
      return;
    case wkbMultiLineString:
    case wkbMultiPolygon:
    case wkbGeometryCollection:
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) collect(*part, lines, depth + 1);
      return;
    default:
      return;  // points, in which lines touch
  }
}

std::string subdivide(const std::vector<Polyline>& lines, std::vector<Polyline>& edges, std::vector<Polyline>& faces) {
  if (!OGRGeometryFactory::haveGEOS()) return "this build of GDAL has no GEOS";
  OGRMultiLineString all;
  for (const Polyline& points : lines) {
    auto line = std::make_unique<OGRLineString>();
    for (const auto& p : points) line->addPoint(p[0], p[1]);
    all.addGeometryDirectly(line.release());
  }
  // The union with one of the lines divides all of them where they meet (UnaryUnion() came with GDAL 3.7).
  const std::unique_ptr<OGRGeometry> noded(all.IsEmpty() ? nullptr : all.Union(all.getGeometryRef(0)));
  if (!noded) return "GEOS found no intersections";
  collect(*noded, edges, 0);
  const std::unique_ptr<OGRGeometry> areas(noded->Polygonize());
  if (areas) collect(*areas, faces, 0);
  return "";
}

}  // namespace
}  // namespace talus::drawing

extern "C" void talus_subdivide(const std::vector<talus::drawing::Polyline>& lines,
                                std::vector<talus::drawing::Polyline>& edges,
                                std::vector<talus::drawing::Polyline>& faces, std::string& error) {
  using namespace talus::drawing;
  Heard heard;
  CPLPushErrorHandlerEx(hear, &heard);
  error = subdivide(lines, edges, faces);
  if (!error.empty() && !heard.error.empty()) error = heard.error;
  CPLPopErrorHandler();
}

extern "C" void talus_read_drawing(const char* path, const char* format, talus::Message& out) {
  using namespace talus::drawing;
  Heard heard;
  CPLSetConfigOption("CPL_DEBUG", "DXF");
  CPLPushErrorHandlerEx(hear, &heard);
  Drawing drawing;
  std::string geographic, error = read(path, format, drawing, geographic, heard);
  if (error.empty() && drawing.lines.empty()) error = heard.error.empty() ? "it has no lines" : heard.error;
  drawing.remarks.insert(drawing.remarks.end(), heard.remarks.begin(), heard.remarks.end());
  out.put_text(error);
  talus::Putting put(out);
  put(drawing.lines, drawing.texts);
  out.put(drawing.remarks.size());
  for (const std::string& remark : drawing.remarks) out.put_text(remark);
  out.put_text(geographic);
  CPLPopErrorHandler();
}
