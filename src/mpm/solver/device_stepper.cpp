// SPDX-License-Identifier: MIT
// Choice of the device for MPM, and the stepper that runs the steps of a body on it and synchronises the host's copy.
#include "mpm/solver/device_stepper.hpp"

#include <fmt/format.h>

#include <cmath>
#include <new>

#include "base/error.hpp"
#include "base/foreign_code.hpp"
#include "mpm/backend/chunk_pass.hpp"
#include "mpm/backend/device_image.hpp"
#include "mpm/darcy/darcy_step.hpp"
#include "mpm/solver/observe.hpp"

namespace talus::mpm {

namespace {

struct Choice {
  std::shared_ptr<DeviceMaker> maker;
  std::string name;
};
Choice& current() {
  static Choice choice;
  return choice;
}

}  // namespace

void use_gpu() {
  std::string why;
  void* function = load_module("libtalus_cuda.so", "talus_make_devices", false, why);
  if (function == nullptr)
    fail_input("--device gpu: this program was built without CUDA: build it with -DTALUS_CUDA=ON (" + why + ")");
  std::shared_ptr<DeviceMaker> maker(reinterpret_cast<DeviceMaker* (*)(std::size_t)>(function)(device_layout));
  if (!maker) fail_input("--device gpu: libtalus_cuda.so is of another build than the program");
  const std::string name = maker->find_name(why);
  if (name.empty())
    fail_input("--device gpu: there is no GPU here that CUDA can use (" + why +
               "); without --device the case is calculated on the processor");
  current() = {std::move(maker), name};
}

void use_emulated_device(const Emulation& how) {
  std::string why;
  void* function = load_module("libtalus_emulated.so", "talus_make_emulated", false, why);
  if (function == nullptr)
    fail_input("--device emulated: this program was built without the emulated device, which `make test` builds (" +
               why + ")");
  using Make = DeviceMaker* (*)(std::size_t, const Emulation*);
  std::shared_ptr<DeviceMaker> maker(reinterpret_cast<Make>(function)(device_layout, &how));
  if (!maker) fail_input("--device emulated: libtalus_emulated.so is of another build than the program");
  current() = {std::move(maker), "emulated"};
}

void use_no_device() {
  current() = {};
}

const std::string& get_device_name() {
  return current().name;
}

template <>
std::unique_ptr<Device<2>> make_device<2>() {
  return current().maker ? current().maker->make_2d() : nullptr;
}
template <>
std::unique_ptr<Device<3>> make_device<3>() {
  return current().maker ? current().maker->make_3d() : nullptr;
}

namespace {

/// Adds the water that a device step counted to the budgets.
template <int D>
void add_water(const DeviceOutput<D>& output, Water<D>& water) {
  water.budgets.resize(water.surfaces.size());
  for (std::size_t i = 0; i < output.budgets.size(); ++i) water.budgets[i].add(output.budgets[i]);
  water.transpired += output.transpired;
  water.pressed_in += output.pressed_in;
  water.darcy.rounds = output.rounds;
  water.darcy.iterations = output.iterations;
}

/// Runs work on the device; if its memory runs out there, because growing blocks need additional memory, throws an
/// error with a message for the user.
auto run_there(const auto& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw Error(
        ExitCode::no_memory,
        "the device ran out of memory in the run; --resume continues from the last checkpoint, without --device "
        "on the processor. Larger elements need less");
  }
}

}  // namespace

template <int D>
void DeviceStepper<D>::take(Body<D>& body, const StepOptions<D>& options) {
  if (body.water.is_wet() && !body.water.darcy.graph)
    body.water.darcy.graph = std::make_shared<const NodeGraph<D>>(make_node_graph(body.mesh()));
  const DeviceMemory memory = device_->find_memory();
  image_ = make_device_image(body, options.threads);
  try {
    device_->take(image_, options);
  } catch (const std::bad_alloc&) {
    const double needed = static_cast<double>(count_bytes(image_)), gigabyte = 1e9;
    const auto free = static_cast<double>(memory.free);
    throw Error(ExitCode::no_memory,
                "the device has {:.3g} GB free, and these {} points need about {:.3g}: about {:.2g} would fit. Larger "
                "elements need less; without --device the processor calculates the case",
                free / gigabyte, body.points.size(), needed / gigabyte, body.points.size() * free / needed);
  }
  device_has_body_ = true;
}

template <int D>
DeviceInput<D> DeviceStepper<D>::make_input(const Body<D>& body, const StepOptions<D>& options) {
  DeviceInput<D> input;
  input.time = body.time;
  for (const input::TimeTable& factor : body.conditions.factors)
    input.factors.push_back({factor.at(body.time + options.dt)});
  input.surfaces = find_device_surfaces(body);
  for (const RootUptake& uptake : body.water.uptakes)
    input.uptake_rates.push_back(uptake.rate.at(body.time + 0.5 * options.dt));
  for (const Load<D>& load : body.conditions.loads) input.load_factors.push_back(load.factor.at(body.time));
  return input;
}

template <int D>
void DeviceStepper<D>::step(Body<D>& body, const StepOptions<D>& options) {
  Stopwatch timed;
  if (!device_has_body_) timed(body.timing.transfer, [&] { take(body, options); });
  host_is_up_to_date_ = false;
  threads_ = options.threads;
  DeviceOutput<D> output;
  timed(body.timing.device,
        [&] { output = run_there([&] { return device_->step(make_input(body, options), options); }); });
  if (!output.finds_pressures) throw_no_pressures(body.step_count);
  body.time += options.dt;
  ++body.step_count;
  body.work.external += output.work.external;
  body.work.damped += output.work.damped;
  body.work.walls += output.work.walls;
  body.work.mapping += output.work.mapping;
  body.work.dissipated += output.work.dissipated;
  body.work.pore_water += output.work.pore_water;
  if (body.water.is_wet()) add_water(output, body.water);
  if (options.monitor) body.monitor = output.monitor;
  for (const Departed<D>& point : output.departed) {
    Lost<D> lost{point.id, body.time, point.mass, mesh::to_global(body.mesh(), point.element, point.xi), {}};
    for (std::size_t d = 0; d < D; ++d) lost.momentum[d] = point.mass * point.velocity[d];
    body.lost.push_back(lost);
    body.water.left_grid += point.water;
  }
}

template <int D>
void DeviceStepper<D>::filter_null_modes(Body<D>& body) {
  Stopwatch()(body.timing.device,
              [&] { body.work.mapping += run_there([&] { return device_->filter_null_modes(); }); });
  host_is_up_to_date_ = false;
}

template <int D>
void DeviceStepper<D>::copy_back(Body<D>& body) {
  if (host_is_up_to_date_) return;
  Stopwatch()(body.timing.transfer, [&] {
    run_there([&] { device_->copy_back(image_); });
    read_device_image(image_, threads_, body);
  });
  host_is_up_to_date_ = true;
}

template <int D>
CriticalStep DeviceStepper<D>::find_critical_step(Body<D>& body, const StepOptions<D>& options) {
  if (!device_has_body_) return mpm::find_critical_step(body, options);
  StepSquare least;
  Stopwatch()(body.timing.device, [&] { least = run_there([&] { return device_->find_step_square(); }); });
  return {std::sqrt(least.dt2 * options.mass_scaling), least.element};
}

template <int D>
double DeviceStepper<D>::find_largest_displacement(const Body<D>& body) {
  if (!device_has_body_) return mpm::find_largest_displacement(body).value;
  return run_there([&] { return device_->find_largest_displacement(); });
}

template <int D>
Observation<D> DeviceStepper<D>::observe(const Body<D>& body, const Vec<D>& gravity, const std::vector<int>& points) {
  if (!device_has_body_) return mpm::observe(body, gravity, points);
  return run_there([&] { return device_->observe(gravity, points); });
}

#define TALUS_INSTANTIATE(D) template class DeviceStepper<D>;
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::mpm
