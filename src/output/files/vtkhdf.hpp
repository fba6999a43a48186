// SPDX-License-Identifier: MIT
#pragma once
// Time series of an unstructured grid in the VTKHDF layout, version 2.0, for ParaView 5.12 and later
// (https://docs.vtk.org/en/latest/vtk_file_formats/vtkhdf_file_format/vtkhdf_specifications.html), with an XDMF 3 file
// for older versions. One dataset has all steps of a quantity in sequence; `Steps` has the offset of each.

#include <cstdint>
#include <string>
#include <vector>

#include "output/files/frame.hpp"
#include "output/files/hdf5.hpp"

namespace talus::output {

enum class CellType : std::uint8_t { vertex = 1, triangle = 5, tetrahedron = 10 };
inline int count_nodes(CellType type) {
  return type == CellType::vertex ? 1 : type == CellType::triangle ? 3 : 4;
}

/// Offsets of one step: zero-based rows of the datasets.
struct SeriesStep {
  double time = 0;          ///< [s]
  std::int64_t number = 0;  ///< frame number
  std::int64_t part = 0;    ///< row of NumberOfPoints, NumberOfCells and NumberOfConnectivityIds
  std::int64_t points = 0, cells = 0;
  std::int64_t first_point = 0, first_cell = 0, first_connectivity = 0;
  std::int64_t first_point_data = 0, first_cell_data = 0;
};

/// Name, unit and number of components of a quantity, without values.
struct SeriesField {
  std::string name, unit;
  int components = 1;
  bool integer = false;
};

struct Series {
  CellType type = CellType::vertex;
  std::vector<SeriesStep> steps;
  std::vector<SeriesField> point_fields, cell_fields;
};

/// Writes a series to an open file. All functions throw hdf5::Failure; the caller holds the Guard.
class SeriesWriter {
 public:
  SeriesWriter(hid_t file, CellType type);
  /// Appends a step. The grid is not stored again if it equals that of the previous step. A field that a step lacks is
  /// filled with NaN, since VTKHDF requires every field on every step.
  void append(double time, std::int64_t number, std::span<const double> points, std::span<const int> connectivity,
              const std::vector<Field>& point_fields, const std::vector<Field>& cell_fields,
              const std::vector<std::pair<std::string, std::span<const int>>>& integers = {});
  /// Writes the data that depend on the number of steps. No step may be appended afterwards.
  void finish();
  const Series& series() const { return series_; }

 private:
  void append_grid(SeriesStep& step, std::span<const double> points, std::span<const int> connectivity);
  void append_fields(const std::string& group, const std::vector<Field>& fields, std::vector<SeriesField>& known,
                     std::size_t before, std::size_t rows);

  hid_t file_;
  Series series_;
  std::vector<double> last_points_;
  std::vector<int> last_connectivity_;
  std::int64_t parts_ = 0, points_ = 0, cells_ = 0, connectivity_ = 0, point_data_ = 0, cell_data_ = 0;
};

/// Reads the offsets and fields of all steps, without values.
Series read_series(hid_t file);
/// Reads the fields of one step, except integer fields.
std::vector<Field> read_series_fields(hid_t file, const std::string& group, const std::vector<SeriesField>& fields,
                                      std::int64_t first, std::int64_t rows);

// The XDMF 3 file of a series, for ParaView before 5.12, which cannot read a VTKHDF series. The two XDMF readers of
// ParaView have no common notation for a part of a dataset: one supports hyperslabs, the other a suffix of the path.
// Each part of a step is therefore a virtual dataset under /xdmf in the HDF5 file, which both readers open, and no
// value is stored twice.

/// Adds the virtual datasets to the finished file of the series. Throws hdf5::Failure.
void write_views(hid_t file, const Series& series);

/// Returns the XML text of a temporal collection over `series`. `heavy_file` is the name of the HDF5 file without its
/// folder, since both files are in the same folder. Steps without points are omitted, since XDMF cannot represent them.
std::string describe_series(const Series& series, const std::string& heavy_file, const std::string& name);

}  // namespace talus::output
