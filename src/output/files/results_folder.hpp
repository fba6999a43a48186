// SPDX-License-Identifier: MIT
#pragma once
// Index of the frames in a results folder, used by the writer, the reader and the assembly.

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
/// Returns the number of a frame from its file name; nullopt if the file is not a frame.
std::optional<int> find_frame_number(const std::filesystem::path& file);

/// Properties of one frame and its place.
struct FrameEntry {
  double time = 0;  ///< [s]
  long step = 0;
  std::string stage;
  std::optional<std::size_t> assembled;  ///< index in results.vtkhdf; nullopt for a single frame
};

struct Index {
  std::map<int, FrameEntry> frames;  ///< by frame number
  std::vector<std::string> field_names;
  Series points;               ///< in results.vtkhdf
  std::optional<Series> mesh;  ///< in mesh.vtkhdf
};

/// Reads the index of a folder. If a frame exists twice, its single file is used, which is newer.
Index read_index(const std::filesystem::path& folder);
Frame read_entry(const std::filesystem::path& folder, const Index& index, int number);

/// Writes results.vtkhdf (and mesh.vtkhdf) with their XDMF files from the frames of `index`, assembled or single.
/// Throws Error (cannot_write); the previous files are then intact.
void assemble(const std::filesystem::path& folder, const Index& index);

}  // namespace talus::output
