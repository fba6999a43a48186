// SPDX-License-Identifier: MIT
#pragma once
// Ground of a section in columns, and the deposit of a slide: the soil that lies over the old ground.

#include <optional>
#include <vector>

#include "mesh/mesh.hpp"
#include "results/runout.hpp"

namespace talus::run {

/// Columns of a box along x, and lanes along z in 3D. They divide the box evenly, so that a mirrored section has the
/// mirrored columns, and one that is shifted has the shifted ones.
struct ColumnGrid {
  double left = 0, width = 1;  ///< of the columns [m]
  int columns = 1;
  double side = 0, breadth = 1;  ///< of the lanes [m]; plane strain: one lane of 1 m
  int lanes = 1;

  int find_column(double x) const;
  int find_lane(double z) const;
  double centre(int column) const { return left + (column + 0.5) * width; }
  /// Index of a column of a lane, lane by lane.
  std::size_t find_index(int column, int lane) const {
    return static_cast<std::size_t>(lane) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
};

/// Divides the box of `mesh` into columns and lanes as wide as `size` [m], rounded to a whole number of them.
template <int D>
ColumnGrid make_column_grid(const mesh::Mesh<D>& mesh, double size);

/// The soil of a material point as a square or a cube about it.
struct SoilCube {
  double x = 0, y = 0;  ///< centre [m]
  int lane = 0;
  double size = 0;    ///< of a side [m]
  double volume = 0;  ///< [m³ or m³/m]
};

/// Level of the ground by column and lane: the top of the highest cube whose centre lies there.
class Ground {
 public:
  Ground(const ColumnGrid& grid, const std::vector<SoilCube>& soil);
  const ColumnGrid& grid() const { return grid_; }
  /// -infinity where there is no soil [m].
  double level(int column, int lane) const { return levels_[grid_.find_index(column, lane)]; }
  /// Returns the highest level of each column that has soil.
  results::Profile make_profile() const;

 private:
  ColumnGrid grid_;
  std::vector<double> levels_;
};

/// Soil above a ground.
struct Deposit {
  double volume = 0;            ///< [m³ or m³/m]
  std::optional<double> front;  ///< x of the farthest place where it is thick enough [m]; nullopt if it is nowhere
};

/// Measures the part of `soil` above `ground`, or all of it if `ground` is null. The thickness at x is the mean over
/// one column's width about x (T10.1); the front is the farthest x along `direction` (±1) at which it reaches `least`
/// [m].
Deposit measure_deposit(const std::vector<SoilCube>& soil, const Ground* ground, const ColumnGrid& grid, int direction,
                        double least);

/// Part of a section that a search is limited to.
struct Stretch {
  double from = 0, to = 0;  ///< [m]
};

/// Returns the distance from `crest`, against `direction` (±1), to the rearmost place of `stretch` where the ground
/// sank by `least` [m] or more in two adjacent columns [m]; 0 if there is none. Between columns the drop is linear.
double measure_retreat(const Ground& before, const Ground& now, double crest, int direction, double least,
                       const Stretch& stretch);

}  // namespace talus::run
