// SPDX-License-Identifier: MIT
// From the single frames of a run to its results files.

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <numeric>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "output/files/results_folder.hpp"
#include "output/files/xdmf.hpp"

namespace talus::output {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t format_version = 1;

/// A results file under its temporary name, and the series in it.
class Heavy {
 public:
  Heavy(fs::path path, CellType type)
      : path_(std::move(path)), file_(hdf5::create(begin_file(path_))), writer_(file_, type) {
    hdf5::make_group(file_, "talus");
    hdf5::write_attribute(file_, "talus", "version", std::span(&format_version, 1));
  }
  SeriesWriter& writer() { return writer_; }
  hid_t file() const { return file_; }
  const fs::path& path() const { return path_; }

  /// Closes the file; nothing of it may be held in memory after.
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

/// Frees the space of an unfinished file. The library may still hold it open, so it is emptied before it goes.
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

/// Steps and stages of the frames, which VTKHDF has no place for.
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
    // The mesh goes first: results.vtkhdf is the sign that all is there.
    if (mesh) finish(*mesh, "background mesh");
    finish(points, "material points");
  } catch (const hdf5::Failure& failure) {
    discard(results_file(folder));
    discard(mesh_file(folder));
    if (failure.reason != 0) throw_cannot_write(current, failure.reason, safe);
    throw Error(ExitCode::cannot_write,
                fmt::format("cannot write '{}': HDF5 refused {}; {}", current.string(), failure.what(), safe));
  } catch (const Error&) {
    discard(results_file(folder));
    discard(mesh_file(folder));
    throw;
  }
}

}  // namespace talus::output
