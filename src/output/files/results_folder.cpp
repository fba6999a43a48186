// SPDX-License-Identifier: MIT
#include "output/files/results_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <numeric>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "output/files/frame.hpp"
#include "output/files/vtkhdf.hpp"

namespace talus::output {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t folder_version = 1;

void add_name(std::vector<std::string>& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

[[noreturn]] void throw_no_result(const fs::path& path, const std::string& what) {
  fail_input("cannot read '{}': the file is damaged or no result of this program ({})", path.string(), what);
}

/// Splits `text` into lines.
std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

void read_assembled(const fs::path& folder, Index& index) {
  const fs::path path = results_file(folder);
  const hdf5::Guard guard;
  try {
    const hdf5::Handle file = hdf5::open(path);
    const std::int64_t version = hdf5::read_integer_attribute(file, "talus", "version");
    if (version != folder_version)
      fail_input("cannot read '{}': its format has version {}, this program knows {}", path.string(), version,
                 folder_version);
    index.points = read_series(file);
    const std::vector<std::int64_t> steps = hdf5::read<std::int64_t>(file, "talus/step");
    const std::vector<std::int64_t> stages = hdf5::read<std::int64_t>(file, "talus/stage");
    const std::vector<std::string> names = split_lines(hdf5::read_text(file, "talus/stage_names"));
    for (std::size_t i = 0; i < index.points.steps.size(); ++i) {
      const SeriesStep& step = index.points.steps[i];
      index.frames[static_cast<int>(step.number)] = {step.time, static_cast<long>(steps.at(i)),
                                                     names.at(static_cast<std::size_t>(stages.at(i))), i};
    }
    for (const SeriesField& field : index.points.point_fields)
      if (!field.integer) add_name(index.field_names, field.name);
  } catch (const hdf5::Failure& failure) {
    throw_no_result(path, failure.what());
  } catch (const std::out_of_range&) {
    throw_no_result(path, "its tables do not fit each other");
  }
}

void read_assembled_mesh(const fs::path& folder, Index& index) {
  const hdf5::Guard guard;
  try {
    index.mesh = read_series(hdf5::open(mesh_file(folder)));
  } catch (const hdf5::Failure& failure) {
    throw_no_result(mesh_file(folder), failure.what());
  } catch (const std::out_of_range&) {
    throw_no_result(mesh_file(folder), "its tables do not fit each other");
  }
}

std::vector<int> to_int(const std::vector<std::int64_t>& values) {
  std::vector<int> result(values.size());
  std::ranges::transform(values, result.begin(), [](std::int64_t v) { return static_cast<int>(v); });
  return result;
}

MeshFrame read_mesh(hid_t file, const Series& series, const SeriesStep& step) {
  const auto size = [](std::int64_t n) { return static_cast<std::size_t>(n); };
  const int per_cell = count_nodes(series.type);
  return {per_cell, hdf5::read<double>(file, "VTKHDF/Points", size(step.first_point), size(step.points)),
          to_int(hdf5::read<std::int64_t>(file, "VTKHDF/Connectivity", size(step.first_connectivity),
                                          size(step.cells * per_cell))),
          read_series_fields(file, "CellData", series.cell_fields, step.first_cell_data, step.cells),
          read_series_fields(file, "PointData", series.point_fields, step.first_point_data, step.points)};
}

}  // namespace

fs::path frame_file(const fs::path& folder, int number) {
  return frames_folder(folder) / fmt::format("{:06d}.h5", number);
}

std::optional<int> find_frame_number(const fs::path& path) {
  const std::string stem = path.stem().string();
  int number = -1;
  const auto [end, failure] = std::from_chars(stem.data(), stem.data() + stem.size(), number);
  if (path.extension() != ".h5" || failure != std::errc() || end != stem.data() + stem.size()) return std::nullopt;
  return number;
}

Index read_index(const fs::path& folder) {
  Index index;
  if (fs::exists(results_file(folder))) read_assembled(folder, index);
  if (fs::exists(mesh_file(folder))) read_assembled_mesh(folder, index);
  std::error_code none;
  std::map<int, fs::path> single;
  for (const fs::directory_entry& entry : fs::directory_iterator(frames_folder(folder), none))
    if (const std::optional<int> number = find_frame_number(entry.path())) single[*number] = entry.path();
  for (const auto& [number, path] : single) {
    const FrameHeader header = read_frame_header(path);
    index.frames[number] = {header.time, header.step, header.stage, std::nullopt};
    for (const Field& field : header.point_fields) add_name(index.field_names, field.name);
  }
  return index;
}

Frame read_entry(const fs::path& folder, const Index& index, int number) {
  const FrameEntry& entry = index.frames.at(number);
  if (!entry.assembled) return read_frame(frame_file(folder, number));
  const auto size = [](std::int64_t n) { return static_cast<std::size_t>(n); };
  const SeriesStep& step = index.points.steps[*entry.assembled];
  const hdf5::Guard guard;
  fs::path path = results_file(folder);
  try {
    const hdf5::Handle file = hdf5::open(path);
    Frame frame{entry.time,
                entry.step,
                entry.stage,
                hdf5::read<double>(file, "VTKHDF/Points", size(step.first_point), size(step.points)),
                hdf5::read<int>(file, "VTKHDF/PointData/id", size(step.first_point_data), size(step.points)),
                hdf5::read<int>(file, "VTKHDF/PointData/material", size(step.first_point_data), size(step.points)),
                read_series_fields(file, "PointData", index.points.point_fields, step.first_point_data, step.points),
                {}};
    if (!index.mesh) return frame;
    path = mesh_file(folder);
    for (const SeriesStep& mesh_step : index.mesh->steps)
      if (mesh_step.number == number) frame.mesh = read_mesh(hdf5::open(path), *index.mesh, mesh_step);
    return frame;
  } catch (const hdf5::Failure& failure) {
    throw_no_result(path, failure.what());
  }
}

namespace {

/// A results file under its temporary name, with its series.
class Heavy {
 public:
  Heavy(fs::path path, CellType type)
      : path_(std::move(path)), file_(hdf5::create(begin_file(path_))), writer_(file_, type) {
    hdf5::make_group(file_, "talus");
    hdf5::write_attribute(file_, "talus", "version", std::span(&folder_version, 1));
  }
  SeriesWriter& writer() { return writer_; }
  hid_t file() const { return file_; }
  const fs::path& path() const { return path_; }

  /// Closes the file, so that the library holds none of its data in memory.
  void close() {
    writer_.finish();
    write_views(file_, writer_.series());
    if (!file_.close()) throw hdf5::Failure("the end of the file");
  }

 private:
  fs::path path_;
  hdf5::Handle file_;
  SeriesWriter writer_;
};

/// Frees the disk space of an unfinished file. It is truncated before removal, since the library may still hold it
/// open.
void discard(const fs::path& path) {
  const fs::path temporary = temporary_name(path);
  static_cast<void>(::truncate(temporary.c_str(), 0) == 0);
  std::error_code ignored;
  fs::remove(temporary, ignored);
}

void append_points(SeriesWriter& writer, int number, const Frame& frame) {
  std::vector<int> vertices(frame.positions.size() / 3);
  std::iota(vertices.begin(), vertices.end(), 0);
  writer.append(frame.time, number, frame.positions, vertices, frame.point_fields, {},
                {{"id", frame.ids}, {"material", frame.materials}});
}

void append_mesh(SeriesWriter& writer, int number, const Frame& frame) {
  writer.append(frame.time, number, frame.mesh->nodes, frame.mesh->elements, frame.mesh->node_fields,
                frame.mesh->element_fields);
}

/// Steps and stages of the frames, for which VTKHDF has no dataset.
class Log {
 public:
  void add(const Frame& frame) {
    steps_.push_back(frame.step);
    if (stages_.empty() || frame.stage != last_) {
      names_ += frame.stage + "\n";
      last_ = frame.stage;
      ++count_;
    }
    stages_.push_back(count_ - 1);
  }
  void write(hid_t file) const {
    hdf5::write<std::int64_t>(file, "talus/step", steps_);
    hdf5::write<std::int64_t>(file, "talus/stage", stages_);
    hdf5::write_text(file, "talus/stage_names", names_);
  }

 private:
  std::vector<std::int64_t> steps_, stages_;
  std::string names_, last_;
  std::int64_t count_ = 0;
};

}  // namespace

void assemble(const fs::path& folder, const Index& index) {
  const hdf5::Guard guard;
  const std::string safe = fmt::format("the {} frames written before are whole", index.frames.size());
  fs::path current = results_file(folder);
  try {
    Heavy points(results_file(folder), CellType::vertex);
    std::optional<Heavy> mesh;
    Log log;
    for (const auto& [number, entry] : index.frames) {
      const Frame frame = read_entry(folder, index, number);
      errno = 0;
      current = points.path();
      append_points(points.writer(), number, frame);
      log.add(frame);
      if (!frame.mesh) continue;
      current = mesh_file(folder);
      if (!mesh) mesh.emplace(current, frame.mesh->nodes_per_element == 3 ? CellType::triangle : CellType::tetrahedron);
      append_mesh(mesh->writer(), number, frame);
    }
    const auto finish = [&current, &safe](Heavy& heavy, const std::string& name) {
      current = heavy.path();
      heavy.close();
      const Series& series = heavy.writer().series();
      const fs::path side_car = fs::path(heavy.path()).replace_extension(".xdmf");
      const std::string text = describe_series(series, heavy.path().filename().string(), name);
      publish(heavy.path(), safe);
      write_atomically(side_car, text, safe);
    };
    current = points.path();
    log.write(points.file());
    // The mesh is published first: the presence of results.vtkhdf implies that all files are complete.
    if (mesh) finish(*mesh, "background mesh");
    finish(points, "material points");
  } catch (const hdf5::Failure& failure) {
    discard(results_file(folder));
    discard(mesh_file(folder));
    if (failure.reason != 0) throw_cannot_write(current, failure.reason, safe);
    throw Error(ExitCode::cannot_write, "cannot write '{}': HDF5 refused {}; {}", current.string(), failure.what(),
                safe);
  } catch (const Error&) {
    discard(results_file(folder));
    discard(mesh_file(folder));
    throw;
  }
}

}  // namespace talus::output
