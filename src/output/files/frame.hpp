// SPDX-License-Identifier: MIT
#pragma once
// One moment of a run as plain data: what the engine hands over and what a reader gets back.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus::output {

/// One quantity on all points, elements or nodes.
struct Field {
  std::string name;            ///< as stored, e.g. `deviatoric_strain`
  std::string unit;            ///< SI unit, e.g. `Pa`; "-" for a number without one
  int components = 1;          ///< 1 scalar, 3 vector, 6 symmetric tensor (xx yy zz xy yz xz)
  std::vector<double> values;  ///< row-major, [item * components + component]
};

/// The background mesh with its fields, stored on request.
struct MeshFrame {
  int nodes_per_element = 3;  ///< 3 triangle, 4 tetrahedron
  std::vector<double> nodes;  ///< three coordinates a node [m]
  std::vector<int> elements;  ///< node numbers, [element * nodes_per_element + k]
  std::vector<Field> element_fields;
  std::vector<Field> node_fields;
};

/// All material points at one time. The number of points may differ from frame to frame.
struct Frame {
  double time = 0;                  ///< simulated time [s]
  long step = 0;                    ///< number of the time step
  std::string stage;                ///< name of the stage
  std::vector<double> positions;    ///< three coordinates a point [m]; z = 0 in 2D
  std::vector<int> ids;             ///< number of each point, kept for its whole life
  std::vector<int> materials;       ///< index of each point's material
  std::vector<Field> point_fields;  ///< names are unique; `id` and `material` are taken
  std::optional<MeshFrame> mesh;

  int point_count() const { return static_cast<int>(positions.size() / 3); }
};

/// Throws Error (internal_error) naming the first array whose length does not fit the number of points, elements or
/// nodes, or the first name that is empty, holds '/', or is used twice.
void check(const Frame& frame);

/// The field called `name`, or nullptr.
const Field* find(const std::vector<Field>& fields, const std::string& name);

// One frame in one HDF5 file, the form in which frames are kept while a run is going on.

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
