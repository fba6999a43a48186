// SPDX-License-Identifier: MIT
#pragma once
// Frames of a run in its folder: `frames/000012.h5` while it is in progress, `results.vtkhdf` and `results.xdmf` (and
// `mesh.vtkhdf`, `mesh.xdmf` if the background mesh is stored) after it has finished. Files that may be damaged are
// examined before the HDF5 library of this process reads them.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "output/files/frame.hpp"

namespace talus::output {

/// Depth of an examination: the structure of a file, which includes the positions of its values, or its values as well.
enum class Depth { structure, values };

/// Reads HDF5 files in a child process, since the library crashes on some damaged files. Each dataset has a checksum,
/// which is verified when its values are read. Throws Error (wrong_input) with the name of the first damaged file;
/// absent files are skipped.
void examine(const std::vector<std::filesystem::path>& files, Depth depth = Depth::structure);

/// Stores the frames of a run. A frame is completely on disk when write() returns, and is removed only after the
/// assembled file that contains it is on disk. A killed run therefore loses no frame.
class ResultsWriter {
 public:
  /// Starts a new run. Throws Error (folder_exists) if `folder` already contains frames or results.
  static ResultsWriter start(const std::filesystem::path& folder);
  /// Resumes a run from a checkpoint at `time` [s]: later frames are removed, and the numbering continues.
  static ResultsWriter resume(const std::filesystem::path& folder, double time);

  /// Throws Error (cannot_write) with the file, the reason, and what is intact.
  void write(const Frame& frame);
  /// Assembles the results and removes the single frames. If it throws Error (cannot_write), the frames are intact.
  void finish();
  int frame_count() const { return count_; }

 private:
  ResultsWriter(std::filesystem::path folder, int next, int count);
  std::filesystem::path folder_;
  int next_;   ///< number of the next frame
  int count_;  ///< number of stored frames
};

/// Assembles the frames of an unfinished or killed run, as ResultsWriter::finish, and returns the number of frames in
/// the results. Throws Error (wrong_input) if there are none or one is damaged, and Error (cannot_write).
int collect(const std::filesystem::path& folder);

/// Returns true if a folder contains a complete frame. The folder of frames of a killed run may be empty.
bool holds_frames(const std::filesystem::path& folder);

/// Removes frames and results from `folder`, before a run overwrites them.
void remove_results(const std::filesystem::path& folder);

/// Reads the frames of a run, from the assembled file, from single frames, or from both.
class ResultsReader {
 public:
  /// Throws Error (wrong_input) if there are no frames or a file cannot be read.
  explicit ResultsReader(const std::filesystem::path& folder);
  ResultsReader(ResultsReader&&) noexcept;
  ~ResultsReader();

  int size() const;
  const std::vector<double>& times() const;  ///< [s]
  const std::vector<long>& steps() const;
  const std::vector<std::string>& stages() const;       ///< stage of each frame
  const std::vector<std::string>& field_names() const;  ///< fields of the points, in order of their first occurrence
  /// Returns the frame with the zero-based `index`. In assembled results, fields that a frame lacked are NaN.
  Frame read(int index) const;
  /// Returns the index of the frame nearest to `time` [s]; the later of two frames at the same time.
  int find_nearest(double time) const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace talus::output
