// SPDX-License-Identifier: MIT
#pragma once
// Pore water of the mixture on a GPU as its threads see it, under the names that Water and DarcyWater give it.

#include "mpm/coupled/water.hpp"
#include "mpm/device/view.hpp"

namespace talus::mpm {

/// Numbers [row][column], the columns by element or node.
struct TableView {
  double* start = nullptr;
  std::size_t rows = 0, columns = 0;

  TALUS_PORTABLE std::size_t size() const { return rows; }
  TALUS_PORTABLE View<double> operator[](std::size_t k) const { return {start + k * columns, columns}; }
  TALUS_PORTABLE void shift(int lane) { start += lane; }
};

/// A hydraulic condition at the start of a step.
struct DeviceSurface {
  SurfaceKind kind = SurfaceKind::seepage;
  bool vertical = true, is_skin = false;
  double suction_limit = 0, value = 0;
};
TALUS_PORTABLE inline double find_value(const DeviceSurface& s, double /*time*/) {
  return s.value;
}
TALUS_PORTABLE inline bool lets_nothing_through(const DeviceSurface& s) {
  return s.is_skin;
}

/// NodeGraph. The touches of a node are the rows of its sums. The entries of a row stand a stride apart, beside those
/// of the other rows of their slice, so that neighbouring threads read neighbours.
template <int D>
struct DeviceGraph {
  struct Element {
    View<const int> rows;
    TALUS_PORTABLE int operator[](std::size_t touch) const { return rows[touch] / (D + 1); }
  };
  struct Local {
    View<const int> rows;
    TALUS_PORTABLE int operator[](std::size_t touch) const { return rows[touch] % (D + 1); }
  };
  View<const int> touch_start;
  Element element;
  Local local;
  View<const double> size;
  View<const int> row_start, row_ends, column, place;

  static constexpr int row_stride = device_width;
  TALUS_PORTABLE int row_end(int i) const { return row_ends[i]; }
};

template <int D>
struct DeviceDarcy {
  static constexpr bool is_used = true;  ///< water that seeps is all that a device knows
  Inside<DeviceGraph<D>> graph;
  // By node, from step to step.
  View<double> pressure, own, change;
  View<std::uint8_t> ponded;
  // By element.
  TableView pores, volume;
  View<double> water, share, flux[D], drawn, saturated, effective, coupling, conductive, soft;
  // By node.
  TableView node_pores;
  View<double> node_water, out, passed, mobility;
  View<Vec<D>> velocity, acceleration, pore_force, area;
};

template <int D>
struct DeviceWater {
  View<const WaterLaw> laws;
  double density = 0;
  int first_field = 0;
  View<const int> surface_of_node, constraint_of_node;
  View<const WaterConstraint<D>> constraints;
  View<const DeviceSurface> surfaces;
  View<double> volume, stretch, mean_saturation, mean_pressure;
  DeviceDarcy<D> darcy;

  TALUS_PORTABLE bool is_wet() const { return !laws.empty(); }
  /// To the lane of an element, what the pass over the points reads.
  TALUS_PORTABLE void shift(int lane) {
    for (View<double>* field : {&volume, &stretch, &mean_saturation, &mean_pressure, &darcy.water, &darcy.share})
      field->shift(lane);
    for (View<double>& component : darcy.flux) component.shift(lane);
    darcy.pores.shift(lane);
  }
};

/// What roots draw from the pores.
struct DeviceUptake {
  material::Feddes reduction;
  View<const double> weight;  ///< by point number
};

/// Water of a body for a device, and what comes back of it.
template <int D>
struct WaterImage {
  std::vector<WaterLaw> laws;  ///< by material number; empty: there is none
  double density = 0;
  int first_field = 0, surfaces = 0;
  View<const int> surface_of_node, constraint_of_node;
  View<const WaterConstraint<D>> constraints;
  bool loads = false;            ///< water stands outside, or presses
  View<const double> node_size;  ///< NodeGraph
  std::vector<int> row_start, row_ends, column, place;
  std::vector<DeviceUptake> uptakes;
  // What changes.
  std::vector<double> volume, stretch, mean_saturation, mean_pressure;  ///< [lane]
  std::vector<double> pressure, own, change;                            ///< [node]; may be empty at the start
  std::vector<std::uint8_t> ponded;
};

}  // namespace talus::mpm
