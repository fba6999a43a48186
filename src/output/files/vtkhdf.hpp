// SPDX-License-Identifier: MIT
#pragma once
// A time series of an unstructured grid in the VTKHDF layout, version 2.0, as ParaView 5.12 and later open it.
// https://docs.vtk.org/en/latest/vtk_file_formats/vtkhdf_file_format/vtkhdf_specifications.html
// All steps of a quantity stand one after the other in one dataset; `Steps` says where each begins.

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

/// Where the parts of one step stand. All are rows of the datasets, counted from 0.
struct SeriesStep {
  double time = 0;          ///< [s]
  std::int64_t number = 0;  ///< number of the frame in its run
  std::int64_t part = 0;    ///< entry of NumberOfPoints, NumberOfCells and NumberOfConnectivityIds
  std::int64_t points = 0, cells = 0;
  std::int64_t first_point = 0, first_cell = 0, first_connectivity = 0;
  std::int64_t first_point_data = 0, first_cell_data = 0;
};

/// A quantity of a series: its name, unit, and number of components, without values.
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

/// Writes a series into an open file. All functions throw hdf5::Failure; the caller holds the Guard.
class SeriesWriter {
 public:
  SeriesWriter(hid_t file, CellType type);
  /// Appends a step. The grid is not stored again when it is the one of the step before. A field that a step lacks is
  /// filled with NaN there, for VTKHDF wants every field on every step.
  void append(double time, std::int64_t number, std::span<const double> points, std::span<const int> connectivity,
              const std::vector<Field>& point_fields, const std::vector<Field>& cell_fields,
              const std::vector<std::pair<std::string, std::span<const int>>>& integers = {});
  /// Writes what is known only at the end. Nothing may be appended after.
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

/// Reads where everything stands.
Series read_series(hid_t file);
/// Reads the fields of one step; integer fields are left out.
std::vector<Field> read_series_fields(hid_t file, const std::string& group, const std::vector<SeriesField>& fields,
                                      std::int64_t first, std::int64_t rows);

// The XDMF 3 side-car of a series: ParaView before 5.12 cannot read a VTKHDF series, and reads this instead.
//
// ParaView has two XDMF readers, and they share no way to name a part of a dataset: one knows hyperslabs, the other a
// suffix of the path. So every part of a step gets a name of its own in the HDF5 file, as a virtual dataset under
// /xdmf: both readers open that, and no value is stored twice.

/// Writes the virtual datasets into the finished file of the series. Throws hdf5::Failure.
void write_views(hid_t file, const Series& series);

/// The XML text of a temporal collection over `series`, whose arrays stand in the HDF5 file `heavy_file` (a name
/// without folder, since the two files lie side by side). Steps without points are left out: XDMF cannot say "none".
std::string describe_series(const Series& series, const std::string& heavy_file, const std::string& name);

}  // namespace talus::output
