// SPDX-License-Identifier: MIT
#include "output/files/frame.hpp"

#include <fmt/format.h>

#include <set>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "output/files/hdf5.hpp"

namespace talus::output {

namespace {

[[noreturn]] void fail(const std::string& sentence) {
  throw Error(ExitCode::internal_error, sentence);
}

void check_length(const std::string& what, std::size_t have, std::size_t want) {
  if (have != want) fail(fmt::format("a frame's {} has {} values where {} were expected", what, have, want));
}

void check_fields(const std::vector<Field>& fields, std::size_t items, std::set<std::string> taken) {
  for (const Field& field : fields) {
    if (field.name.empty() || field.name.find('/') != std::string::npos)
      fail(fmt::format("'{}' cannot be the name of a field: it is empty or holds '/'", field.name));
    if (!taken.insert(field.name).second) fail(fmt::format("a frame has two fields called '{}'", field.name));
    if (field.components < 1) fail(fmt::format("the field '{}' has no components", field.name));
    check_length("field '" + field.name + "'", field.values.size(), items * static_cast<std::size_t>(field.components));
  }
}

}  // namespace

void check(const Frame& frame) {
  if (frame.positions.size() % 3 != 0) fail("a frame's positions are not three coordinates a point");
  const std::size_t points = frame.positions.size() / 3;
  check_length("ids", frame.ids.size(), points);
  check_length("materials", frame.materials.size(), points);
  check_fields(frame.point_fields, points, {"id", "material"});
  if (!frame.mesh) return;
  const MeshFrame& mesh = *frame.mesh;
  if (mesh.nodes_per_element != 3 && mesh.nodes_per_element != 4)
    fail(fmt::format("elements with {} nodes cannot be stored: only 3 and 4 are known", mesh.nodes_per_element));
  if (mesh.nodes.size() % 3 != 0) fail("a mesh's nodes are not three coordinates a node");
  const std::size_t per_element = static_cast<std::size_t>(mesh.nodes_per_element);
  if (mesh.elements.size() % per_element != 0) fail("a mesh's elements are not complete");
  check_fields(mesh.element_fields, mesh.elements.size() / per_element, {});
  check_fields(mesh.node_fields, mesh.nodes.size() / 3, {});
}

const Field* find(const std::vector<Field>& fields, const std::string& name) {
  for (const Field& field : fields)
    if (field.name == name) return &field;
  return nullptr;
}

namespace {

namespace fs = std::filesystem;

const std::string frame_format = "talus frame";
constexpr std::int64_t frame_version = 1;

void write_fields(hid_t file, const std::string& group, const std::vector<Field>& fields) {
  hdf5::make_group(file, group);
  for (const Field& field : fields) {
    const std::string name = group + "/" + field.name;
    hdf5::write<double>(file, name, field.values, static_cast<std::size_t>(field.components));
    hdf5::write_attribute(file, name, "unit", field.unit);
  }
}

std::vector<Field> read_fields(hid_t file, const std::string& group, bool with_values) {
  std::vector<Field> fields;
  for (const std::string& name : hdf5::list(file, group)) {
    std::string path = group;
    path.append("/").append(name);
    Field field{
        name, hdf5::read_text_attribute(file, path, "unit"), static_cast<int>(hdf5::shape(file, path).columns), {}};
    if (with_values) field.values = hdf5::read<double>(file, path);
    fields.push_back(std::move(field));
  }
  return fields;
}

/// Opens a frame file and calls `take` with it; failures of HDF5 become an Error with one sentence.
auto read_from(const fs::path& path, auto&& take) {
  const hdf5::Guard guard;
  if (!fs::exists(path)) fail_input("cannot read '{}': there is no such file", path.string());
  try {
    const hdf5::Handle file = hdf5::open(path);
    const std::string format = hdf5::read_text_attribute(file, ".", "format");
    const std::int64_t version = hdf5::read_integer_attribute(file, ".", "version");
    if (format != frame_format || version != frame_version)
      fail_input("cannot read '{}': it is '{}' version {}, not '{}' version {}", path.string(), format, version,
                 frame_format, frame_version);
    return take(static_cast<hid_t>(file));
  } catch (const hdf5::Failure& failure) {
    fail_input("cannot read '{}': the file is damaged or no frame of a run ({})", path.string(), failure.what());
  }
}

FrameHeader take_header(hid_t file) {
  return {hdf5::read_real_attribute(file, ".", "time"),
          static_cast<long>(hdf5::read_integer_attribute(file, ".", "step")),
          hdf5::read_text_attribute(file, ".", "stage"), read_fields(file, "points", false)};
}

void fill(hid_t file, const Frame& frame) {
  hdf5::write_attribute(file, ".", "format", frame_format);
  hdf5::write_attribute(file, ".", "version", std::span(&frame_version, 1));
  hdf5::write_attribute(file, ".", "time", frame.time);
  const std::int64_t step = frame.step;
  hdf5::write_attribute(file, ".", "step", std::span(&step, 1));
  hdf5::write_attribute(file, ".", "stage", frame.stage);
  hdf5::write<double>(file, "positions", frame.positions, 3);
  hdf5::write<int>(file, "ids", frame.ids);
  hdf5::write<int>(file, "materials", frame.materials);
  write_fields(file, "points", frame.point_fields);
  if (!frame.mesh) return;
  hdf5::write<double>(file, "nodes", frame.mesh->nodes, 3);
  hdf5::write<int>(file, "elements", frame.mesh->elements, static_cast<std::size_t>(frame.mesh->nodes_per_element));
  write_fields(file, "element_fields", frame.mesh->element_fields);
  write_fields(file, "node_fields", frame.mesh->node_fields);
}

}  // namespace

void write_frame(const fs::path& path, const Frame& frame, const std::string& safe) {
  check(frame);
  hdf5::FileImage image;
  try {
    // The file is made in memory first: HDF5 cannot close a file on a full disk, whereas a plain write returns the
    // error.
    const hdf5::Guard guard;
    hdf5::MemoryFile file;
    fill(file, frame);
    image = file.take();
  } catch (const hdf5::Failure& failure) {
    throw Error(ExitCode::no_memory, "cannot store a frame: HDF5 refused {}, as it does where memory ends",
                failure.what());
  }
  write_atomically(path, image.bytes(), safe);
}

Frame read_frame(const fs::path& path) {
  return read_from(path, [](hid_t file) {
    const FrameHeader header = take_header(file);
    Frame frame{header.time,
                header.step,
                header.stage,
                hdf5::read<double>(file, "positions"),
                hdf5::read<int>(file, "ids"),
                hdf5::read<int>(file, "materials"),
                read_fields(file, "points", true),
                {}};
    if (hdf5::has(file, "nodes"))
      frame.mesh = MeshFrame{static_cast<int>(hdf5::shape(file, "elements").columns), hdf5::read<double>(file, "nodes"),
                             hdf5::read<int>(file, "elements"), read_fields(file, "element_fields", true),
                             read_fields(file, "node_fields", true)};
    return frame;
  });
}

FrameHeader read_frame_header(const fs::path& path) {
  return read_from(path, take_header);
}

}  // namespace talus::output
