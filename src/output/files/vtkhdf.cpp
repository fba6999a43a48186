// SPDX-License-Identifier: MIT
#include "output/files/vtkhdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace talus::output {

namespace {

const std::string root = "VTKHDF";
const std::string steps_group = "VTKHDF/Steps";

std::size_t to_size(std::int64_t n) {
  return static_cast<std::size_t>(n);
}

void append_one(hid_t file, const std::string& name, std::int64_t value) {
  hdf5::append<std::int64_t>(file, name, std::span(&value, 1));
}

void append_missing(hid_t file, const std::string& name, std::size_t rows, int components) {
  const std::vector<double> nothing(rows * static_cast<std::size_t>(components),
                                    std::numeric_limits<double>::quiet_NaN());
  hdf5::append<double>(file, name, nothing, static_cast<std::size_t>(components));
}

void write_column(hid_t file, const std::string& name, const Series& series, auto member) {
  std::vector<std::int64_t> column;
  for (const SeriesStep& step : series.steps) column.push_back(step.*member);
  hdf5::write<std::int64_t>(file, name, column);
}

}  // namespace

SeriesWriter::SeriesWriter(hid_t file, CellType type) : file_(file) {
  series_.type = type;
  hdf5::make_group(file_, root);
  const std::array<std::int64_t, 2> version{2, 0};
  hdf5::write_attribute(file_, root, "Version", version);
  hdf5::write_attribute(file_, root, "Type", std::string("UnstructuredGrid"));
  for (const char* group : {"/PointData", "/CellData", "/Steps", "/Steps/PointDataOffsets", "/Steps/CellDataOffsets"})
    hdf5::make_group(file_, root + group);
}

void SeriesWriter::append_grid(SeriesStep& step, std::span<const double> points, std::span<const int> connectivity) {
  if (parts_ > 0 && std::ranges::equal(points, last_points_) && std::ranges::equal(connectivity, last_connectivity_)) {
    const SeriesStep& last = series_.steps.back();
    step.part = last.part;
    step.first_point = last.first_point;
    step.first_cell = last.first_cell;
    step.first_connectivity = last.first_connectivity;
    return;
  }
  step.part = parts_++;
  step.first_point = points_;
  step.first_cell = cells_;
  step.first_connectivity = connectivity_;
  hdf5::append<double>(file_, root + "/Points", points, 3);
  const std::vector<std::int64_t> nodes(connectivity.begin(), connectivity.end());
  hdf5::append<std::int64_t>(file_, root + "/Connectivity", nodes);
  // Each part has one more offset than cells; VTK reads them from first_cell + part.
  std::vector<std::int64_t> offsets(to_size(step.cells) + 1);
  for (std::size_t i = 0; i < offsets.size(); ++i)
    offsets[i] = static_cast<std::int64_t>(i) * count_nodes(series_.type);
  hdf5::append<std::int64_t>(file_, root + "/Offsets", offsets);
  const std::vector<std::uint8_t> types(to_size(step.cells), static_cast<std::uint8_t>(series_.type));
  hdf5::append<std::uint8_t>(file_, root + "/Types", types);
  append_one(file_, root + "/NumberOfPoints", step.points);
  append_one(file_, root + "/NumberOfCells", step.cells);
  append_one(file_, root + "/NumberOfConnectivityIds", static_cast<std::int64_t>(connectivity.size()));
  points_ += step.points;
  cells_ += step.cells;
  connectivity_ += static_cast<std::int64_t>(connectivity.size());
  last_points_.assign(points.begin(), points.end());
  last_connectivity_.assign(connectivity.begin(), connectivity.end());
}

void SeriesWriter::append_fields(const std::string& group, const std::vector<Field>& fields,
                                 std::vector<SeriesField>& known, std::size_t before, std::size_t rows) {
  for (const Field& field : fields) {
    const std::string name = fmt::format("{}/{}", group, field.name);
    const auto same = [&field](const SeriesField& k) { return k.name == field.name; };
    const bool is_new = std::ranges::none_of(known, same);
    if (is_new && before > 0) append_missing(file_, name, before, field.components);
    hdf5::append<double>(file_, name, field.values, static_cast<std::size_t>(field.components));
    if (!is_new) continue;
    known.push_back({field.name, field.unit, field.components, false});
    hdf5::write_attribute(file_, name, "unit", field.unit);
  }
  for (const SeriesField& k : known)
    if (!k.integer && find(fields, k.name) == nullptr)
      append_missing(file_, fmt::format("{}/{}", group, k.name), rows, k.components);
}

void SeriesWriter::append(double time, std::int64_t number, std::span<const double> points,
                          std::span<const int> connectivity, const std::vector<Field>& point_fields,
                          const std::vector<Field>& cell_fields,
                          const std::vector<std::pair<std::string, std::span<const int>>>& integers) {
  SeriesStep step;
  step.time = time;
  step.number = number;
  step.points = static_cast<std::int64_t>(points.size() / 3);
  step.cells = static_cast<std::int64_t>(connectivity.size()) / count_nodes(series_.type);
  append_grid(step, points, connectivity);
  step.first_point_data = point_data_;
  step.first_cell_data = cell_data_;
  for (const auto& [name, values] : integers) {
    const std::string path = fmt::format("{}/PointData/{}", root, name);
    if (series_.steps.empty()) series_.point_fields.push_back({name, "-", 1, true});
    hdf5::append<int>(file_, path, values);
    if (series_.steps.empty()) hdf5::write_attribute(file_, path, "unit", std::string("-"));
  }
  append_fields(root + "/PointData", point_fields, series_.point_fields, to_size(point_data_), to_size(step.points));
  append_fields(root + "/CellData", cell_fields, series_.cell_fields, to_size(cell_data_), to_size(step.cells));
  point_data_ += step.points;
  cell_data_ += step.cells;
  series_.steps.push_back(step);
}

void SeriesWriter::finish() {
  const std::int64_t count = static_cast<std::int64_t>(series_.steps.size());
  hdf5::write_attribute(file_, steps_group, "NSteps", std::span(&count, 1));
  std::vector<double> times;
  for (const SeriesStep& step : series_.steps) times.push_back(step.time);
  hdf5::write<double>(file_, steps_group + "/Values", times);
  hdf5::write_attribute(file_, steps_group + "/Values", "unit", std::string("s"));
  write_column(file_, steps_group + "/PartOffsets", series_, &SeriesStep::part);
  const std::vector<std::int64_t> one(to_size(count), 1);
  hdf5::write<std::int64_t>(file_, steps_group + "/NumberOfParts", one);
  write_column(file_, steps_group + "/PointOffsets", series_, &SeriesStep::first_point);
  write_column(file_, steps_group + "/CellOffsets", series_, &SeriesStep::first_cell);
  write_column(file_, steps_group + "/ConnectivityIdOffsets", series_, &SeriesStep::first_connectivity);
  for (const SeriesField& field : series_.point_fields)
    write_column(file_, fmt::format("{}/PointDataOffsets/{}", steps_group, field.name), series_,
                 &SeriesStep::first_point_data);
  for (const SeriesField& field : series_.cell_fields)
    write_column(file_, fmt::format("{}/CellDataOffsets/{}", steps_group, field.name), series_,
                 &SeriesStep::first_cell_data);
  write_column(file_, "talus/number", series_, &SeriesStep::number);
}

Series read_series(hid_t file) {
  const auto column = [file](const std::string& name) { return hdf5::read<std::int64_t>(file, name); };
  Series series;
  const std::vector<double> times = hdf5::read<double>(file, steps_group + "/Values");
  const auto numbers = column("talus/number"), parts = column(steps_group + "/PartOffsets"),
             first_points = column(steps_group + "/PointOffsets"), first_cells = column(steps_group + "/CellOffsets"),
             first_connectivity = column(steps_group + "/ConnectivityIdOffsets"),
             points = column(root + "/NumberOfPoints"), cells = column(root + "/NumberOfCells");
  std::int64_t point_data = 0, cell_data = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::size_t part = to_size(parts.at(i));
    SeriesStep step{times[i],       numbers.at(i),      parts[i],          points.at(part),
                    cells.at(part), first_points.at(i), first_cells.at(i), first_connectivity.at(i),
                    point_data,     cell_data};
    point_data += step.points;
    cell_data += step.cells;
    series.steps.push_back(step);
  }
  const std::vector<std::uint8_t> types = hdf5::read<std::uint8_t>(
      file, root + "/Types", 0, std::min<std::size_t>(1, hdf5::shape(file, root + "/Types").rows));
  if (!types.empty()) series.type = static_cast<CellType>(types[0]);
  const auto list_fields = [file](const std::string& group) {
    std::vector<SeriesField> fields;
    for (const std::string& name : hdf5::list(file, group)) {
      const std::string path = fmt::format("{}/{}", group, name);
      fields.push_back({name, hdf5::read_text_attribute(file, path, "unit"),
                        static_cast<int>(hdf5::shape(file, path).columns), hdf5::holds_integers(file, path)});
    }
    return fields;
  };
  series.point_fields = list_fields(root + "/PointData");
  series.cell_fields = list_fields(root + "/CellData");
  return series;
}

std::vector<Field> read_series_fields(hid_t file, const std::string& group, const std::vector<SeriesField>& fields,
                                      std::int64_t first, std::int64_t rows) {
  std::vector<Field> result;
  for (const SeriesField& field : fields) {
    if (field.integer) continue;
    const std::string path = fmt::format("{}/{}/{}", root, group, field.name);
    result.push_back(
        {field.name, field.unit, field.components, hdf5::read<double>(file, path, to_size(first), to_size(rows))});
  }
  return result;
}

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

/// Returns the path of the views of a step. Views of a grid belong to its part, which several steps may share.
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
    // Tensors are declared as matrices, because the order of XDMF's Tensor6 (xx xy xz yy yz zz) differs from that of
    // VTK.
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
