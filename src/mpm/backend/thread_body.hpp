// SPDX-License-Identifier: MIT
#pragma once
// The body in the form that GPU threads use: pointers to device memory under the names of Body's arrays, so that the
// kernels of the step are the same source for both. One thread takes one element: the arrays [block][…][lane] are
// shifted to its lane, and it reads and writes single doubles where the CPU has packs. Blocks have 32 lanes, so
// neighbouring threads access neighbouring addresses (coalescing). Each element has its own row for the sums of each of
// its nodes, and a node sums the rows of its elements in their order (gather), so no two threads write to one address.

#include <cstddef>

#include "base/portable.hpp"
#include "mpm/backend/device_laws.hpp"
#include "mpm/kernels/element_kernels.hpp"
#include "mpm/kernels/point_kernels.hpp"
#include "mpm/kernels/water_lanes.hpp"
#include "mpm/state/body.hpp"
#include "mpm/state/water.hpp"

namespace talus::mpm {

// Array types of GPU threads.

/// Elements in a block on a device, and rows in a slice of a matrix: the threads of a warp.
inline constexpr int device_width = 32;

/// Pointer and size of an array; non-owning.
template <class T>
struct View {
  T* start = nullptr;
  std::size_t count = 0;

  TALUS_PORTABLE T* data() const { return start; }
  TALUS_PORTABLE std::size_t size() const { return count; }
  TALUS_PORTABLE bool empty() const { return count == 0; }
  TALUS_PORTABLE T& operator[](std::size_t i) const { return start[i]; }
  /// Moves the start to the lane of a thread.
  TALUS_PORTABLE void shift(int lane) { start += lane; }
};

/// A pointer-like object that contains its target.
template <class T>
struct Inside : T {
  TALUS_PORTABLE const T* operator->() const { return this; }
  TALUS_PORTABLE const T& operator*() const { return *this; }
};

// Pore water of the Darcy formulation on a GPU, under the names of Water and DarcyWater.

/// Numbers [row][column]; columns are elements or nodes.
struct TableView {
  double* start = nullptr;
  std::size_t rows = 0, columns = 0;

  TALUS_PORTABLE std::size_t size() const { return rows; }
  TALUS_PORTABLE View<double> operator[](std::size_t k) const { return {start + k * columns, columns}; }
  TALUS_PORTABLE void shift(int lane) { start += lane; }
};

/// A hydraulic condition, evaluated at the start of a step.
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

/// NodeGraph on a device. The touches of a node are the rows of its sums. The entries of a row are a stride apart,
/// interleaved with those of the other rows of their slice (sliced ELL), so that accesses coalesce.
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

  static constexpr int row_stride = device_width, touch_stride = 1;
  TALUS_PORTABLE int row_end(int i) const { return row_ends[i]; }
  TALUS_PORTABLE int touch_end(int i) const { return touch_start[static_cast<std::size_t>(i) + 1]; }
  /// Corners are the rows of sums.
  TALUS_PORTABLE std::size_t find_corner(int e, int k) const {
    return static_cast<std::size_t>(e) * (D + 1) + static_cast<std::size_t>(k);
  }
  template <class T>
  TALUS_PORTABLE int find_touch_end(int i) const {
    return touch_end(i);
  }
  template <class T>
  TALUS_PORTABLE bool are_touches(int /*i*/, int /*t*/) const {
    return true;
  }
  template <class T>
  TALUS_PORTABLE T gather_element(const auto& field, int t) const {
    return field[static_cast<std::size_t>(element[static_cast<std::size_t>(t)])];
  }
  template <class T>
  TALUS_PORTABLE T gather_corner(const auto& field, int t) const {
    return field[static_cast<std::size_t>(element.rows[static_cast<std::size_t>(t)])];
  }
  template <class T>
  TALUS_PORTABLE void load_gradient(const auto& mesh, int t, T* b) const {
    const auto gradient =
        mesh::find_shape_gradient(mesh, element[static_cast<std::size_t>(t)], local[static_cast<std::size_t>(t)]);
    for (int d = 0; d < D; ++d) b[d] = gradient[static_cast<std::size_t>(d)];
  }
};

template <int D>
struct DeviceDarcy {
  static constexpr bool is_used = true;  ///< a device supports the Darcy formulation only
  Inside<DeviceGraph<D>> graph;
  // By node, kept from step to step.
  View<double> pressure, own, change;
  View<std::uint8_t> ponded;
  // By element.
  TableView pores, volume;
  View<double> water, share, flux[D], drawn, saturated, effective, coupling, conductive, soft, pressing, own_mass;
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
  /// Shifts the arrays that the pass over the points reads to the lane of an element.
  TALUS_PORTABLE void shift(int lane) {
    for (View<double>* field : {&volume, &stretch, &mean_saturation, &mean_pressure, &darcy.water, &darcy.share})
      field->shift(lane);
    for (View<double>& component : darcy.flux) component.shift(lane);
    darcy.pores.shift(lane);
  }
};

/// Root uptake by one plant condition.
struct DeviceUptake {
  material::Feddes reduction;
  View<const double> weight;  ///< by point number
};

/// Water of a body in the layout of a device, and the arrays that are copied back.
template <int D>
struct WaterImage {
  std::vector<WaterLaw> laws;  ///< by material number; empty: no water
  double density = 0;
  int first_field = 0, surfaces = 0;
  View<const int> surface_of_node, constraint_of_node;
  View<const WaterConstraint<D>> constraints;
  bool loads = false;            ///< outside water or a given pressure loads the soil
  View<const double> node_size;  ///< NodeGraph::size
  std::vector<int> row_start, row_ends, column, place;
  std::vector<DeviceUptake> uptakes;
  // Arrays that change.
  std::vector<double> volume, stretch, mean_saturation, mean_pressure;  ///< [lane]
  std::vector<double> pressure, own, change;                            ///< [node]; may be empty at the start
  std::vector<std::uint8_t> ponded;
};

/// The part of mesh::Mesh that a step needs.
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

  /// Motion and averages have one row per node on a device.
  TALUS_PORTABLE int count_motion_rows(int /*node*/) const { return 1; }
  TALUS_PORTABLE int motion_row(int node, int /*k*/) const { return node; }
};

/// Values of DevicePoints::soil for an element without points and for one with points of several materials.
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
  View<std::uint8_t> soil;  ///< by element: material of all its points, no_soil or many_soils
  View<std::array<double, PointFields<D>::stress_size>> strain_offset;

  TALUS_PORTABLE double* slot(std::int64_t s) const { return data.start + s * fields * device_width; }
};

/// A thread covers only the slots with points of its element.
template <int D>
TALUS_KERNEL int count_slots(const DevicePoints<D>& points, int b) {
  return static_cast<int>(points.count[static_cast<std::size_t>(b) * device_width]);
}

struct DeviceElements {
  View<double> moments, strain, fill_limit, apart, rough, plastic_dilation, softened, softening_volume,
      nonlocal_correction, held_saturation;
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

/// SofteningReach on a device.
struct SofteningList {
  View<const std::int64_t> start;
  View<const int> element;
  View<const double> weight;
};

/// Factor of a moving support at the end of the step.
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
  int lane = 0;  ///< lane that the arrays [block][…][lane] are shifted to

  TALUS_PORTABLE const DeviceMesh<D>& mesh() const { return grid; }

  /// The body for the thread of element `e`, shifted so that the element is in lane 0 of its block.
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
                                &of.softened, &of.softening_volume, &of.nonlocal_correction, &of.held_saturation})
      field->shift(mine.lane);
    mine.water.shift(mine.lane);
    return mine;
  }
};

/// Row in the sums for the k-th node of element `e`.
template <int D>
TALUS_PORTABLE double* sums_row(ThreadBody<D>& body, int e, int k) {
  return &body.nodes.sums[(static_cast<std::size_t>(e) * (D + 1) + static_cast<std::size_t>(k)) * sums_stride];
}

/// Row of the sums of node `i` that receives the pressure forces: the first one of an element with points, which the
/// pass overwrites; nullptr: none.
template <int D>
TALUS_PORTABLE double* find_row_to_press(const ThreadBody<D>& body, int i) {
  for (int r = body.layout->row_start[i]; r < body.layout->row_start[i + 1]; ++r) {
    const int row = body.layout->node_rows[r];
    if (body.points.count[row / (D + 1)] > 0) return &body.nodes.sums[static_cast<std::size_t>(row) * sums_stride];
  }
  return nullptr;
}

/// Water laws of a thread's element.
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

/// Adds N values from column First on to the row of the k-th node of the thread's element in block `b`.
template <int N, int First, int D>
TALUS_KERNEL void add_to_sums(ThreadBody<D>& body, int b, int k, const double* values) {
  double* row = sums_row(body, b * device_width + body.lane, k) + First;
  TALUS_UNROLL
  for (int c = 0; c < N; ++c) row[c] += values[c];
}

}  // namespace talus::mpm
