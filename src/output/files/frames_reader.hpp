// SPDX-License-Identifier: MIT
#pragma once
// The results of a run in its folder: `frames/000012.h5` while it goes on, `results.vtkhdf` and `results.xdmf`
// (and `mesh.vtkhdf`, `mesh.xdmf` when the background mesh is stored) once it is finished.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "output/files/frame.hpp"

namespace talus::output {

// Files that may be damaged, looked at before the HDF5 library of this process reads them.

/// What is looked at: the structure of a file, which says where its values stand, or all its values too.
enum class Depth { structure, values };

/// Goes through HDF5 files in a child process, because the library crashes on some damaged ones. Every data set has a
/// checksum, which is verified wherever its values are read. Throws Error (wrong_input) with the name of the first file
/// that is damaged; files that are not there are left out.
void examine(const std::vector<std::filesystem::path>& files, Depth depth = Depth::structure);

/// Keeps the frames of a run. Every frame is on the disk, whole, when write() returns, and stays there until the
/// assembled file that holds it is: a killed run loses nothing that was written.
class ResultsWriter {
 public:
  /// A new run. Throws Error (folder_exists) when `folder` already holds frames or results.
  static ResultsWriter start(const std::filesystem::path& folder);
  /// A run that goes on from a checkpoint at `time` [s]: frames after it are dropped, numbering goes on.
  static ResultsWriter resume(const std::filesystem::path& folder, double time);

  /// Throws Error (cannot_write) naming the file, the reason, and what is safe.
  void write(const Frame& frame);
  /// Assembles the results and removes the single frames. When it throws (cannot_write), the frames are still there.
  void finish();
  int frame_count() const { return count_; }

 private:
  ResultsWriter(std::filesystem::path folder, int next, int count);
  std::filesystem::path folder_;
  int next_;   ///< number of the next frame
  int count_;  ///< frames kept so far
};

/// Assembles what a run left behind, also one that was killed; the same as ResultsWriter::finish. Returns the number
/// of frames in the results. Throws Error (wrong_input) when there are none or one is damaged, Error (cannot_write).
int collect(const std::filesystem::path& folder);

/// Returns true where a folder has a whole frame. A killed run may have made the folder of frames and no frame yet.
bool holds_frames(const std::filesystem::path& folder);

/// Removes frames and results from `folder`, for a run that overwrites them.
void remove_results(const std::filesystem::path& folder);

/// Reads the frames of a run, from the assembled file, from single frames, or from both.
class ResultsReader {
 public:
  /// Throws Error (wrong_input) when there are no frames or a file cannot be read.
  explicit ResultsReader(const std::filesystem::path& folder);
  ResultsReader(ResultsReader&&) noexcept;
  ~ResultsReader();

  int size() const;
  const std::vector<double>& times() const;  ///< [s]
  const std::vector<long>& steps() const;
  const std::vector<std::string>& stages() const;       ///< name of each frame's stage
  const std::vector<std::string>& field_names() const;  ///< of the points, in the order of their first appearance
  /// The frame with this index, counted from 0. Fields that a frame lacked are NaN once assembled.
  Frame read(int index) const;
  /// Index of the frame nearest to `time` [s]; the later of two frames at the same time.
  int find_nearest(double time) const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace talus::output
