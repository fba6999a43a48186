// SPDX-License-Identifier: MIT
#pragma once
// One frame in one HDF5 file, the form in which frames are kept while a run is going on.

#include <filesystem>
#include <string>
#include <vector>

#include "output/files/frame.hpp"

namespace talus::output {

/// Writes the frame whole or not at all (see atomic_file.hpp, also for `safe` and the errors).
void write_frame(const std::filesystem::path& path, const Frame& frame, const std::string& safe);

/// Reads a frame. Throws Error (wrong_input) naming the file when it is absent, damaged or of another kind.
Frame read_frame(const std::filesystem::path& path);

/// What a list of frames shows, read without the fields' values.
struct FrameHeader {
  double time = 0;  ///< [s]
  long step = 0;
  std::string stage;
  std::vector<Field> point_fields;  ///< without values
};
FrameHeader read_frame_header(const std::filesystem::path& path);

}  // namespace talus::output
