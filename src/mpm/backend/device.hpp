// SPDX-License-Identifier: MIT
#pragma once
// Interface between the MPM engine and a GPU module. The module shares no packs with the engine: data are exchanged as
// the plain arrays below, in the layout of the device's threads.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "mpm/backend/device_laws.hpp"
#include "mpm/backend/thread_body.hpp"
#include "mpm/kernels/observation.hpp"

namespace talus::mpm {

/// Free slots that a block starts with.
inline constexpr int spare_slots = 1;
/// Number of slots to allocate: those of the blocks, and a reserve behind them for blocks that grow.
constexpr std::size_t find_room(std::size_t slots) {
  return slots + slots / 8 + 32;
}
/// Initial capacity for movers: one per this many points.
inline constexpr std::size_t mover_share = 32;

/// A force of a load, before the load's factor.
template <int D>
struct DeviceLoad {
  int load, index;  ///< node, or point
  Vec<D> force;     ///< [N]
};

/// State of a body that is copied to a device, and back. Arrays [block][…][lane] have blocks of device_width elements.
template <int D>
struct DeviceImage {
  static constexpr int stress_size = PointFields<D>::stress_size;

  DeviceMesh<D> mesh;  ///< in host memory
  std::vector<int> connectivity, row_start, node_rows;
  std::vector<double> gradients, volumes;
  std::vector<StoredLaw> laws;
  std::vector<int> constraint_of_node;
  std::vector<Constraint<D>> constraints;
  View<const std::int64_t> reach_start;  ///< empty: softening is local
  View<const int> reach_element;
  View<const double> reach_weight;
  View<const std::uint8_t> material;  ///< by point number
  View<const Vec<D>> reference;       ///< by point number
  std::vector<double> held_saturation;
  std::vector<int> load_start;  ///< of a node, index into node_loads; empty: no loads
  std::vector<DeviceLoad<D>> node_loads, point_loads;
  double smallest_mass = 0;
  WaterImage<D> water;

  // Data that change on the device.
  int fields = 0, point_count = 0;  ///< fields of a slot; number of points
  std::vector<std::int64_t> block_start;
  std::vector<int> block_capacity;
  std::vector<double> data, count;  ///< [slot][field][lane]; [block][lane]
  std::vector<int> id;              ///< [slot][lane]
  std::vector<std::array<double, stress_size>> strain_offset;
  std::vector<double> strain, fill_limit, apart, rough, plastic_dilation, softened, softening_volume,
      nonlocal_correction;
  std::vector<double> motion;         ///< [node][motion_stride]
  std::vector<double> sums, moments;  ///< copied back only: [node][sums_stride], [block][moment_size][lane]
  std::vector<Vec<D>> displacement;
  double motion_step = 0;

  int blocks() const { return static_cast<int>(block_start.size()); }
};

/// Input of a step beside its options.
template <int D>
struct DeviceInput {
  double time = 0;                   ///< at the start of the step [s]
  std::vector<double> load_factors;  ///< at the start of the step
  std::vector<GivenFactor> factors;  ///< of moving supports
  // Pore water (Darcy formulation).
  std::vector<DeviceSurface> surfaces;
  std::vector<double> uptake_rates;  ///< by plant condition [m/s]
};

/// A point that left the grid in a step.
template <int D>
struct Departed {
  int id, element;  ///< number, and the element where it left
  double mass;      ///< of the grains [kg]
  double water;     ///< [kg]
  Vec<D> xi, velocity;
};

/// Results of a step.
template <int D>
struct DeviceOutput {
  Work work;
  Monitor monitor;  ///< of monitored steps
  std::vector<Departed<D>> departed;
  // Pore water (Darcy formulation).
  bool finds_pressures = true;
  int rounds = 0, iterations = 0;  ///< see DarcyWater
  std::vector<SurfaceBudget> budgets;
  double transpired = 0, pressed_in = 0;  ///< added to the members of Water [kg]
};

/// Memory of a device [bytes].
struct DeviceMemory {
  std::size_t free = 0, total = 0;
};

/// Launches and time of a kernel.
struct KernelTime {
  std::string name;
  int launches = 0;
  double seconds = 0;
};

template <int D>
class Device {
 public:
  virtual ~Device() = default;
  /// Copies the body to the device and computes its nodal sums from the points. Throws std::bad_alloc when device
  /// memory is too small.
  virtual void take(const DeviceImage<D>& image, const StepOptions<D>& options) = 0;
  virtual DeviceOutput<D> step(const DeviceInput<D>& input, const StepOptions<D>& options) = 0;
  /// filter_null_modes(), the filter of null modes; returns the kinetic energy removed [J].
  virtual double filter_null_modes() = 0;
  /// Copies the changed data back.
  virtual void copy_back(DeviceImage<D>& image) = 0;
  /// find_critical_step() without mass scaling, for points with the mass of soil and water.
  virtual StepSquare find_step_square() = 0;
  virtual double find_largest_displacement() = 0;
  virtual DeviceMemory find_memory() = 0;
  virtual Observation<D> observe(const Vec<D>& gravity, const std::vector<int>& points) = 0;
  /// Starts to time kernels.
  virtual void time_kernels() = 0;
  virtual std::vector<KernelTime> list_times() = 0;
};

/// Ends the run as an interruption does, after a failure of the device.
[[noreturn]] inline void throw_lost(const std::string& why) {
  throw Error(ExitCode::interrupted,
              "the device failed (" + why +
                  "); --resume continues from the last checkpoint, without --device on the processor");
}

/// Factory of devices, implemented by a GPU module.
class DeviceMaker {
 public:
  virtual ~DeviceMaker() = default;
  /// Name of the device; empty without one, and `why` is the reason.
  virtual std::string find_name(std::string& why) = 0;
  virtual std::unique_ptr<Device<2>> make_2d() = 0;
  virtual std::unique_ptr<Device<3>> make_3d() = 0;
};

/// Version; increase it with every change of Device or DeviceMaker.
inline constexpr std::size_t device_interface = 4;
/// Hash of the sizes of exchanged structures; differs between builds that are incompatible.
inline constexpr std::size_t device_layout =
    device_interface + 31 * (sizeof(DeviceInput<3>) + 31 * sizeof(PointView<3>)) + 31 * sizeof(Observation<3>) +
    sizeof(DeviceImage<2>) +
    31 * (sizeof(StepOptions<3>) + 31 * (sizeof(DeviceOutput<3>) + 31 * (sizeof(StoredLaw) + 31 * sizeof(WaterLaw))));

}  // namespace talus::mpm
