// SPDX-License-Identifier: MIT
// A drawing as DXF by GDAL, in memory. GDAL takes header and tables of the file from a template that states inches and
// the code page ANSI 1252; the unit is replaced there, and names of layers are written in that code page.

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "drawing/drawing.hpp"

namespace talus::drawing {
namespace {

constexpr const char *template_path = "/vsimem/talus_header.dxf", *file_path = "/vsimem/talus.dxf";

void CPL_STDCALL keep_first(CPLErr kind, CPLErrorNum, const char* text) {
  auto* error = static_cast<std::string*>(CPLGetErrorHandlerUserData());
  if (kind >= CE_Failure && error->empty()) *error = text;
}

/// Returns the content of a file; empty if it cannot be read.
std::string read_whole(const char* path) {
  vsi_l_offset size = 0;
  GByte* bytes = nullptr;
  if (path == nullptr || VSIIngestFile(nullptr, path, &bytes, &size, -1) == 0) return "";
  std::string text(reinterpret_cast<const char*>(bytes), size);
  VSIFree(bytes);
  return text;
}

/// Writes GDAL's template with another unit. Returns an error; empty if there is none.
std::string write_template(int unit_code) {
  const char* found = CPLFindFile("gdal", "header.dxf");
  std::string text = read_whole(found);
  if (text.empty()) return "the file header.dxf of GDAL's data folder is missing (GDAL_DATA)";
  const std::size_t name = text.find("$INSUNITS"), code = text.find("70", name);
  const std::size_t value = text.find('\n', code), end = text.find('\n', value + 1);
  if (name == std::string::npos || code == std::string::npos || end == std::string::npos)
    return "the file header.dxf of GDAL's data folder has no $INSUNITS";
  text.replace(value + 1, end - value - 1, fmt::format("{:6}", unit_code));
  VSILFILE* file = VSIFOpenL(template_path, "wb");
  if (file == nullptr) return "there is no memory for the template";
  const bool is_whole = VSIFWriteL(text.data(), 1, text.size(), file) == text.size();
  return VSIFCloseL(file) == 0 && is_whole ? "" : "there is no memory for the template";
}

/// Returns the name of a layer with the characters that the format allows, Latin-1 letters as single bytes.
std::string encode_layer(const std::string& name) {
  std::string encoded;
  for (std::size_t i = 0; i < name.size();) {
    const auto byte = [&](std::size_t k) { return k < name.size() ? static_cast<unsigned char>(name[k]) : 0u; };
    const unsigned first = byte(i);
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    const unsigned letter = length == 1 ? first : length == 2 ? (first & 0x1Fu) << 6 | (byte(i + 1) & 0x3Fu) : 0;
    const bool is_plain =
        letter >= ' ' && letter < 0x7F &&
        std::string_view("<>/\\\":;?*|=',`").find(static_cast<char>(letter)) == std::string_view::npos;
    encoded += is_plain || (letter >= 0xA0 && letter <= 0xFF) ? static_cast<char>(letter) : '_';
    i += length;
  }
  return encoded;
}

/// Writes features into the layer of GDAL, which the format takes as the whole drawing.
class Writer {
 public:
  Writer(const NewDrawing& drawing, OGRLayer& layer) : drawing_(drawing), layer_(layer) {}

  bool write() {
    for (const DrawnLine& line : drawing_.lines) add_line(line);
    constexpr int centre = 5, baseline = 1;  // anchors
    for (const DrawnText& text : drawing_.labels) add_text(text, centre);
    for (const DrawnText& text : drawing_.texts) add_text(text, baseline);
    return is_whole_;
  }

 private:
  void add(const std::string& layer, const OGRGeometry& geometry, const std::string& style) {
    const std::unique_ptr<OGRFeature, void (*)(OGRFeature*)> feature(OGRFeature::CreateFeature(layer_.GetLayerDefn()),
                                                                     OGRFeature::DestroyFeature);
    feature->SetField("Layer", name_layer(layer).c_str());
    feature->SetStyleString(style.c_str());
    is_whole_ = feature->SetGeometry(&geometry) == OGRERR_NONE && layer_.CreateFeature(feature.get()) == OGRERR_NONE &&
                is_whole_;
  }

  /// The driver closes a ring without its first point again at the end; a polygon would become a hatch.
  void add_line(const DrawnLine& line) {
    const std::unique_ptr<OGRLineString> points(line.closed ? new OGRLinearRing : new OGRLineString);
    for (const Point& p : line.points) points->addPoint(p[0], p[1]);
    add(line.layer, *points, fmt::format("PEN(c:{})", find_colour(line.layer)));
  }

  void add_text(const DrawnText& text, int anchor) {
    std::string quoted;
    for (const char c : text.text) quoted += c == '"' || c == '\\' ? '\'' : c;
    // g: units of the ground.
    add(text.layer, OGRPoint(text.at[0], text.at[1]),
        fmt::format("LABEL(t:\"{}\",s:{}g,c:{},p:{})", quoted, drawing_.text_height, find_colour(text.layer), anchor));
  }

  std::string find_colour(const std::string& layer) const {
    const auto found = drawing_.colours.find(layer);
    return found == drawing_.colours.end() ? "#000000" : found->second;
  }

  /// Layers whose encoded names are equal remain apart.
  const std::string& name_layer(const std::string& layer) {
    const auto [at, is_new] = names_.try_emplace(layer, encode_layer(layer));
    if (is_new)
      for (int i = 2; !taken_.insert(at->second).second; ++i) at->second = fmt::format("{}_{}", encode_layer(layer), i);
    return at->second;
  }

  const NewDrawing& drawing_;
  OGRLayer& layer_;
  std::map<std::string, std::string> names_;
  std::set<std::string> taken_;
  bool is_whole_ = true;
};

std::string write(const NewDrawing& drawing, std::string& bytes) {
  if (std::string error = write_template(drawing.unit_code); !error.empty()) return error;
  RegisterOGRDXF();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("DXF");
  if (driver == nullptr) return "this GDAL has no driver for DXF";
  const std::string header = fmt::format("HEADER={}", template_path);
  const char* const options[] = {header.c_str(), nullptr};
  std::unique_ptr<GDALDataset> data(driver->Create(file_path, 0, 0, 0, GDT_Unknown, const_cast<char**>(options)));
  if (!data) return "GDAL makes no DXF";
  OGRLayer* layer = data->CreateLayer("entities");
  if (layer == nullptr || !Writer(drawing, *layer).write()) return "GDAL cannot write a line or text";
  data.reset();
  bytes = read_whole(file_path);
  return bytes.empty() ? "GDAL has written nothing" : "";
}

}  // namespace
}  // namespace talus::drawing

extern "C" void talus_write_drawing(const talus::drawing::NewDrawing& drawing, talus::Message& out) {
  std::string heard, bytes;
  CPLPushErrorHandlerEx(talus::drawing::keep_first, &heard);
  std::string error = talus::drawing::write(drawing, bytes);
  if (!error.empty() && !heard.empty()) error += ": " + heard;
  CPLPopErrorHandler();
  out.put_text(error);
  out.put_text(bytes);
}
