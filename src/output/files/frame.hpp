// SPDX-License-Identifier: MIT
#pragma once
// One frame of a run as plain data, which the methods write and the readers return; and its HDF5 file, in which a frame
// is stored while the run is in progress.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace talus::output {

/// One quantity at all points, elements or nodes.
struct Field {
  std::string name;            ///< stored name, such as `deviatoric_strain`
  std::string unit;            ///< SI unit, such as `Pa`; "-" if dimensionless
  int components = 1;          ///< 1 scalar, 3 vector, 6 symmetric tensor (xx yy zz xy yz xz)
  std::vector<double> values;  ///< row-major, [item * components + component]
};

/// Background mesh with its fields, stored on request.
struct MeshFrame {
  int nodes_per_element = 3;  ///< 3 triangle, 4 tetrahedron
  std::vector<double> nodes;  ///< three coordinates per node [m]
  std::vector<int> elements;  ///< node numbers, [element * nodes_per_element + k]
  std::vector<Field> element_fields;
  std::vector<Field> node_fields;
};

/// All material points at one time. Their number may differ between frames.
struct Frame {
  double time = 0;  ///< simulated time [s]
  long step = 0;
  std::string stage;
  std::vector<double> positions;    ///< three coordinates per point [m]; z = 0 in 2D
  std::vector<int> ids;             ///< number of each point, constant during the run
  std::vector<int> materials;       ///< material index of each point
  std::vector<Field> point_fields;  ///< names are unique; `id` and `material` are reserved
  std::optional<MeshFrame> mesh;

  int point_count() const { return static_cast<int>(positions.size() / 3); }
};

/// Throws Error (internal_error) with the name of the first array whose length does not match the number of points,
/// elements or nodes, or the first name that is empty, contains '/', or is not unique.
void check(const Frame& frame);

/// Returns the field `name`, or nullptr.
const Field* find(const std::vector<Field>& fields, const std::string& name);

/// Writes the frame atomically (see atomic_file.hpp, also for `safe` and the errors).
void write_frame(const std::filesystem::path& path, const Frame& frame, const std::string& safe);

/// Reads a frame. Throws Error (wrong_input) with the name of the file if it is absent, damaged or of another kind.
Frame read_frame(const std::filesystem::path& path);

/// Content of a list of frames, read without the values of the fields.
struct FrameHeader {
  double time = 0;  ///< [s]
  long step = 0;
  std::string stage;
  std::vector<Field> point_fields;  ///< without values
};
FrameHeader read_frame_header(const std::filesystem::path& path);

}  // namespace talus::output
