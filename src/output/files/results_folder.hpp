// SPDX-License-Identifier: MIT
#pragma once
// What stands where in a results folder: the index that the writer, the reader and the assembly share.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "output/files/frame.hpp"
#include "output/files/vtkhdf.hpp"

namespace talus::output {

inline std::filesystem::path results_file(const std::filesystem::path& folder) {
  return folder / "results.vtkhdf";
}
inline std::filesystem::path mesh_file(const std::filesystem::path& folder) {
  return folder / "mesh.vtkhdf";
}
inline std::filesystem::path frames_folder(const std::filesystem::path& folder) {
  return folder / "frames";
}
std::filesystem::path frame_file(const std::filesystem::path& folder, int number);
/// The number of a frame from the name of its file; nothing where it is no frame.
std::optional<int> find_frame_number(const std::filesystem::path& file);

/// One frame and where to find it.
struct FrameEntry {
  double time = 0;  ///< [s]
  long step = 0;
  std::string stage;
  std::optional<std::size_t> assembled;  ///< index in results.vtkhdf; without it the frame is a file of its own
};

struct Index {
  std::map<int, FrameEntry> frames;  ///< by number
  std::vector<std::string> field_names;
  Series points;               ///< of results.vtkhdf
  std::optional<Series> mesh;  ///< of mesh.vtkhdf
};

/// Reads what the folder holds; a frame that is there twice is taken from its own file, which is the newer.
Index read_index(const std::filesystem::path& folder);
Frame read_entry(const std::filesystem::path& folder, const Index& index, int number);

/// Writes results.vtkhdf (and mesh.vtkhdf) with their side-cars from the frames of `index`, wherever they are.
/// Throws Error (cannot_write); the files that were there before are then still there.
void assemble(const std::filesystem::path& folder, const Index& index);

}  // namespace talus::output
