// SPDX-License-Identifier: MIT
#pragma once
// A GPU that takes a body through its steps, as the engine sees it. It is a module of its own that shares no packs with
// the rest: what goes there and comes back are the plain arrays below, in the order that its threads want.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "mpm/body/observe.hpp"
#include "mpm/device/device_laws.hpp"
#include "mpm/device/thread_body.hpp"

namespace talus::mpm {

/// Slots beyond those in use that a block has.
inline constexpr int spare_slots = 1;
/// The slots that blocks have, and more behind them for those that will have to grow.
constexpr std::size_t find_room(std::size_t slots) {
  return slots + slots / 8 + 32;
}
/// Room for points on their way at the start: one in so many of all.
inline constexpr std::size_t mover_share = 32;

/// A force of a load, before the load's factor.
template <int D>
struct DeviceLoad {
  int load, index;  ///< node, or point
  Vec<D> force;     ///< [N]
};

/// What a device needs of a body, and what changes there. Arrays [block][…][lane] have blocks of device_width elements.
template <int D>
struct DeviceImage {
  static constexpr int stress_size = PointFields<D>::stress_size;

  DeviceMesh<D> mesh;  ///< in the host's memory
  std::vector<int> connectivity, row_start, node_rows;
  std::vector<double> gradients, volumes;
  std::vector<StoredLaw> laws;
  std::vector<int> constraint_of_node;
  std::vector<Constraint<D>> constraints;
  View<const std::int64_t> reach_start;  ///< empty: soil softens element by element
  View<const int> reach_element;
  View<const double> reach_weight;
  View<const std::uint8_t> material;  ///< by point number
  View<const Vec<D>> reference;       ///< by point number
  std::vector<double> held_saturation;
  std::vector<int> load_start;  ///< of a node among node_loads; empty: there are no loads
  std::vector<DeviceLoad<D>> node_loads, point_loads;
  double smallest_mass = 0;
  WaterImage<D> water;

  // What changes.
  int fields = 0, point_count = 0;  ///< of a slot; point numbers
  std::vector<std::int64_t> block_start;
  std::vector<int> block_capacity;
  std::vector<double> data, count;  ///< [slot][field][lane]; [block][lane]
  std::vector<int> id;              ///< [slot][lane]
  std::vector<std::array<double, stress_size>> strain_offset;
  std::vector<double> strain, fill_limit, apart, rough, plastic_dilation, softened, softening_volume, lent;
  std::vector<double> motion;         ///< [node][motion_stride]
  std::vector<double> sums, moments;  ///< these only come back: [node][sums_stride], [block][moment_size][lane]
  std::vector<Vec<D>> displacement;
  double motion_step = 0;

  int blocks() const { return static_cast<int>(block_start.size()); }
};

/// What a step is given beside its options.
template <int D>
struct DeviceInput {
  double time = 0;                   ///< at its start [s]
  std::vector<double> load_factors;  ///< then
  std::vector<GivenFactor> factors;  ///< of what moves nodes
  // Of water that seeps.
  std::vector<DeviceSurface> surfaces;
  std::vector<double> uptake_rates;  ///< of the plants [m/s]
};

/// A point that left the grid in a step.
template <int D>
struct Departed {
  int id, element;  ///< the last one
  double mass;      ///< of the grains [kg]
  double water;     ///< [kg]
  Vec<D> xi, velocity;
};

/// What a step did.
template <int D>
struct DeviceOutput {
  Work work;
  Monitor monitor;  ///< of steps that are monitored
  std::vector<Departed<D>> departed;
  // Of water that seeps.
  bool finds_pressures = true;
  int rounds = 0, iterations = 0;  ///< see DarcyWater
  std::vector<SurfaceBudget> budgets;
  double transpired = 0, pressed_in = 0;  ///< see Water [kg]
};

/// Memory of a device [bytes].
struct DeviceMemory {
  std::size_t free = 0, total = 0;
};

/// What a kernel has taken.
struct KernelTime {
  std::string name;
  int launches = 0;
  double seconds = 0;
};

template <int D>
class Device {
 public:
  virtual ~Device() = default;
  /// Takes the body over, and takes the nodes' sums anew from its points. Throws std::bad_alloc when the device has no
  /// room for it.
  virtual void take(const DeviceImage<D>& image, const StepOptions<D>& options) = 0;
  virtual DeviceOutput<D> step(const DeviceInput<D>& input, const StepOptions<D>& options) = 0;
  /// fade_unseen(); returns what is lost [J].
  virtual double fade_unseen() = 0;
  /// What has changed.
  virtual void give_back(DeviceImage<D>& image) = 0;
  /// find_critical_step() of points as heavy as soil and water, without mass scaling.
  virtual StepSquare find_step_square() = 0;
  virtual double find_largest_displacement() = 0;
  virtual DeviceMemory find_memory() = 0;
  virtual Observation<D> observe(const Vec<D>& gravity, const std::vector<int>& points) = 0;
  /// From now on kernels are timed.
  virtual void time_kernels() = 0;
  virtual std::vector<KernelTime> list_times() = 0;
};

/// A device that does not answer any more ends the run as an interruption does.
[[noreturn]] inline void throw_lost(const std::string& why) {
  throw Error(ExitCode::interrupted, "the device failed (" + why +
                                         "); --resume goes on from the last checkpoint, without --device on the "
                                         "processor");
}

/// Where devices come from: what the module of a GPU makes.
class DeviceMaker {
 public:
  virtual ~DeviceMaker() = default;
  /// Of the device; empty where there is none, and `why` says what was the matter.
  virtual std::string find_name(std::string& why) = 0;
  virtual std::unique_ptr<Device<2>> make_2d() = 0;
  virtual std::unique_ptr<Device<3>> make_3d() = 0;
};

/// To be raised with the functions of Device and DeviceMaker.
inline constexpr std::size_t device_interface = 4;
/// Sizes of what goes between the program and a module: they differ between builds that must not meet.
inline constexpr std::size_t device_layout =
    device_interface + 31 * (sizeof(DeviceInput<3>) + 31 * sizeof(PointView<3>)) + 31 * sizeof(Observation<3>) +
    sizeof(DeviceImage<2>) +
    31 * (sizeof(StepOptions<3>) + 31 * (sizeof(DeviceOutput<3>) + 31 * (sizeof(StoredLaw) + 31 * sizeof(WaterLaw))));

}  // namespace talus::mpm
