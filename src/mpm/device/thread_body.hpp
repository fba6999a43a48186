// SPDX-License-Identifier: MIT
#pragma once
// The body on a GPU as its threads see it: pointers into the memory of the device, under the names that Body gives its
// arrays, so that the lines of the step are the same source for both. A thread takes one element: with the arrays
// [block][…][lane] shifted to its lane it reads and writes single doubles where the CPU has packs. Blocks have 32
// lanes, so that neighbouring threads reach neighbouring numbers. Each element has a row of its own for the sums of
// each of its nodes, and a node adds the rows of its elements up in their order: no two threads ever write to one
// place.

#include <cstddef>

#include "base/portable.hpp"
#include "mpm/body/body.hpp"
#include "mpm/device/device_laws.hpp"
#include "mpm/step/element_kernels.hpp"
#include "mpm/step/kernels.hpp"
#include "mpm/two_velocity/water.hpp"
#include "mpm/two_velocity/water_lanes.hpp"

namespace talus::mpm {

// How the threads of a GPU see arrays.

/// Elements of a block on a device, and rows of a slice of a matrix: the threads of a warp.
inline constexpr int device_width = 32;

/// Where something is stored, and for how many; the memory is someone else's.
template <class T>
struct View {
  T* start = nullptr;
  std::size_t count = 0;

  TALUS_PORTABLE T* data() const { return start; }
  TALUS_PORTABLE std::size_t size() const { return count; }
  TALUS_PORTABLE bool empty() const { return count == 0; }
  TALUS_PORTABLE T& operator[](std::size_t i) const { return start[i]; }
  /// From the lane on that is a thread's.
  TALUS_PORTABLE void shift(int lane) { start += lane; }
};

/// A pointer that is its own target.
template <class T>
struct Inside : T {
  TALUS_PORTABLE const T* operator->() const { return this; }
  TALUS_PORTABLE const T& operator*() const { return *this; }
};

// Pore water of the mixture on a GPU as its threads see it, under the names that Water and DarcyWater give it.

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

/// What mesh::Mesh has, as far as a step needs it.
template <int D>
struct DeviceMesh {
  View<const Vec<D>> nodes;
  View<const std::array<int, D + 1>> elements, neighbours;
  View<const double> volumes, altitudes;
  View<const std::array<double, D * D>> gradients;
};

template <int D>
struct DeviceLayout {
  View<const int> connectivity;           ///< [block][D+1][lane] node
  View<const double> gradients, volumes;  ///< as in Layout
  View<const int> row_start, node_rows;   ///< rows of the sums of node i: node_rows[row_start[i] … row_start[i+1])

  /// Motion and averages have one row per node.
  TALUS_PORTABLE int count_motion_rows(int /*node*/) const { return 1; }
  TALUS_PORTABLE int motion_row(int node, int /*k*/) const { return node; }
};

/// Of an element without points; of one with points of more materials than one.
inline constexpr int no_soil = 254, many_soils = 255;
static_assert(most_laws <= no_soil);

template <int D>
struct DevicePoints : PointFields<D> {
  int fields = 0;
  View<double> data;
  View<int> id;
  View<const std::int64_t> block_start;
  View<const int> block_capacity;
  View<double> count;
  // By point number.
  View<int> element;
  View<std::int64_t> place;
  View<const std::uint8_t> material;
  View<const Vec<D>> reference;
  View<std::uint8_t> soil;  ///< by element: the material of all its points, or no_soil, or many_soils
  View<std::array<double, PointFields<D>::stress_size>> strain_offset;

  TALUS_PORTABLE double* slot(std::int64_t s) const { return data.start + s * fields * device_width; }
};

/// A thread has no slots but those with points of its element.
template <int D>
TALUS_KERNEL int count_slots(const DevicePoints<D>& points, int b) {
  return static_cast<int>(points.count[static_cast<std::size_t>(b) * device_width]);
}

struct DeviceElements {
  View<double> moments, strain, fill_limit, apart, rough, plastic_dilation, softened, softening_volume, lent,
      held_saturation;
};

template <int D>
struct DeviceNodes {
  View<double> sums;          ///< [element][D+1][sums_stride]
  View<double> motion;        ///< [node][motion_stride]
  View<double> smoothed;      ///< [node]
  View<const Vec<D>> load;    ///< [node]
  View<Vec<D>> displacement;  ///< [node]
  double motion_step = 0;
};

/// SofteningReach.
struct SofteningList {
  View<const std::int64_t> start;
  View<const int> element;
  View<const double> weight;
};

/// The value at the end of the step of what moves nodes.
struct GivenFactor {
  double value;
  TALUS_PORTABLE double at(double /*time*/) const { return value; }
};

template <int D>
struct DeviceConditions {
  View<const int> constraint_of_node;
  View<const Constraint<D>> constraints;
  View<std::uint8_t> pressed;
  View<const GivenFactor> factors;
};

template <int D>
struct ThreadBody {
  static constexpr int dimension = D, width = device_width;
  static constexpr bool adds_to_sums = false;
  using Lanes = double;

  Inside<DeviceLayout<D>> layout;
  DeviceMesh<D> grid;
  DeviceLaws laws;
  DeviceConditions<D> conditions;
  DevicePoints<D> points;
  DeviceElements elements;
  DeviceNodes<D> nodes;
  DeviceWater<D> water;
  double time = 0, smallest_mass = 0;
  int element_count = 0, node_count = 0;
  int lane = 0;  ///< that the arrays [block][…][lane] are shifted to

  TALUS_PORTABLE const DeviceMesh<D>& mesh() const { return grid; }

  /// The body for the thread of element `e`, which is in lane 0 of its block there.
  TALUS_PORTABLE ThreadBody for_element(int e) const {
    ThreadBody mine = *this;
    mine.lane = e % width;
    mine.layout.connectivity.shift(mine.lane);
    mine.layout.gradients.shift(mine.lane);
    mine.layout.volumes.shift(mine.lane);
    mine.points.data.shift(mine.lane);
    mine.points.id.shift(mine.lane);
    mine.points.count.shift(mine.lane);
    DeviceElements& of = mine.elements;
    for (View<double>* field : {&of.moments, &of.strain, &of.fill_limit, &of.apart, &of.rough, &of.plastic_dilation,
                                &of.softened, &of.softening_volume, &of.lent, &of.held_saturation})
      field->shift(mine.lane);
    mine.water.shift(mine.lane);
    return mine;
  }
};

/// The row of the sums of the k-th node of element `e`.
template <int D>
TALUS_PORTABLE double* sums_row(ThreadBody<D>& body, int e, int k) {
  return &body.nodes.sums[(static_cast<std::size_t>(e) * (D + 1) + static_cast<std::size_t>(k)) * sums_stride];
}

/// The row of the sums of node `i` that carries the forces of the pressures: the first one of an element with points,
/// which the pass writes anew. nullptr: none.
template <int D>
TALUS_PORTABLE double* find_row_to_press(const ThreadBody<D>& body, int i) {
  for (int r = body.layout->row_start[i]; r < body.layout->row_start[i + 1]; ++r) {
    const int row = body.layout->node_rows[r];
    if (body.points.count[row / (D + 1)] > 0) return &body.nodes.sums[static_cast<std::size_t>(row) * sums_stride];
  }
  return nullptr;
}

/// The water laws of a thread's element.
template <class Law, int D>
TALUS_KERNEL auto get_block_water(const ThreadBody<D>& body, int b, double conductivity_factor) {
  if constexpr (Law::is_single)
    return OneWater{
        &body.water
             .laws[body.points.soil[static_cast<std::size_t>(b) * device_width + static_cast<std::size_t>(body.lane)]],
        conductivity_factor};
  else
    return ManyWaters<View<const WaterLaw>>{&body.water.laws, ~std::uint32_t{0}, conductivity_factor};
}

/// Adds N values from column First on to the sums of the k-th node of the thread's element in block `b`.
template <int N, int First, int D>
TALUS_KERNEL void add_to_sums(ThreadBody<D>& body, int b, int k, const double* values) {
  double* row = sums_row(body, b * device_width + body.lane, k) + First;
  TALUS_UNROLL
  for (int c = 0; c < N; ++c) row[c] += values[c];
}

}  // namespace talus::mpm
