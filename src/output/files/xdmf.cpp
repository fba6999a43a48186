// SPDX-License-Identifier: MIT
#include "output/files/xdmf.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace talus::output {
namespace {

std::string escape(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

/// Where the views of a step stand. The grid belongs to its part, which steps may share.
std::string grid_path(const SeriesStep& step, const char* array) {
  return fmt::format("xdmf/grid_{:06d}/{}", step.part, array);
}
std::string data_path(std::size_t index, const char* group, const std::string& field) {
  return fmt::format("xdmf/step_{:06d}/{}/{}", index, group, field);
}

std::string describe_data(const std::string& file, const std::string& path, std::int64_t rows, int columns,
                          bool integer, int precision) {
  return fmt::format(
      "<DataItem Format=\"HDF\" NumberType=\"{}\" Precision=\"{}\" Dimensions=\"{}{}\">{}:/{}</DataItem>\n",
      integer ? "Int" : "Float", precision, rows, columns > 1 ? fmt::format(" {}", columns) : "", escape(file),
      escape(path));
}

std::string describe_fields(const std::vector<SeriesField>& fields, const char* group, const char* center,
                            const std::string& file, std::size_t index, std::int64_t rows) {
  std::string text;
  for (const SeriesField& field : fields) {
    // Six components stay a matrix: XDMF's Tensor6 has another order (xx xy xz yy yz zz) than VTK and this file.
    const char* type = field.components == 1 ? "Scalar" : field.components == 3 ? "Vector" : "Matrix";
    text += fmt::format("        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">\n", escape(field.name),
                        type, center);
    text += fmt::format("          <Information Name=\"unit\" Value=\"{}\"/>\n          ", escape(field.unit));
    text += describe_data(file, data_path(index, group, field.name), rows, field.components, field.integer,
                          field.integer ? 4 : 8);
    text += "        </Attribute>\n";
  }
  return text;
}

std::size_t to_size(std::int64_t n) {
  return static_cast<std::size_t>(n);
}

}  // namespace

void write_views(hid_t file, const Series& series) {
  std::int64_t parts = 0;
  for (std::size_t i = 0; i < series.steps.size(); ++i) {
    const SeriesStep& step = series.steps[i];
    if (step.points == 0) continue;
    if (step.part >= parts) {
      parts = step.part + 1;
      hdf5::write_view(file, grid_path(step, "Points"), "/VTKHDF/Points", to_size(step.first_point),
                       to_size(step.points));
      hdf5::write_view(file, grid_path(step, "Connectivity"), "/VTKHDF/Connectivity", to_size(step.first_connectivity),
                       to_size(step.cells * count_nodes(series.type)));
    }
    for (const SeriesField& field : series.point_fields)
      hdf5::write_view(file, data_path(i, "PointData", field.name), "/VTKHDF/PointData/" + field.name,
                       to_size(step.first_point_data), to_size(step.points));
    for (const SeriesField& field : series.cell_fields)
      hdf5::write_view(file, data_path(i, "CellData", field.name), "/VTKHDF/CellData/" + field.name,
                       to_size(step.first_cell_data), to_size(step.cells));
  }
}

std::string describe_series(const Series& series, const std::string& heavy_file, const std::string& name) {
  const int per_cell = count_nodes(series.type);
  const char* topology = series.type == CellType::vertex     ? "Polyvertex"
                         : series.type == CellType::triangle ? "Triangle"
                                                             : "Tetrahedron";
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n"
      "    <Grid Name=\"" +
      escape(name) + "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t i = 0; i < series.steps.size(); ++i) {
    const SeriesStep& step = series.steps[i];
    if (step.points == 0) continue;
    text += fmt::format("      <Grid Name=\"{}\" GridType=\"Uniform\">\n        <Time Value=\"{}\"/>\n", escape(name),
                        step.time);
    text +=
        fmt::format("        <Topology TopologyType=\"{}\" NumberOfElements=\"{}\" NodesPerElement=\"{}\">\n          ",
                    topology, step.cells, per_cell);
    text += describe_data(heavy_file, grid_path(step, "Connectivity"), step.cells * per_cell, 1, true, 8);
    text += "        </Topology>\n        <Geometry GeometryType=\"XYZ\">\n          ";
    text += describe_data(heavy_file, grid_path(step, "Points"), step.points, 3, false, 8);
    text += "        </Geometry>\n";
    text += describe_fields(series.point_fields, "PointData", "Node", heavy_file, i, step.points);
    text += describe_fields(series.cell_fields, "CellData", "Cell", heavy_file, i, step.cells);
    text += "      </Grid>\n";
  }
  return text + "    </Grid>\n  </Domain>\n</Xdmf>\n";
}

}  // namespace talus::output
