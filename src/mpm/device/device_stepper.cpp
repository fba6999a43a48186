// SPDX-License-Identifier: MIT
#include "mpm/device/device_stepper.hpp"

#include <cmath>
#include <type_traits>

#include "mpm/device/device_image.hpp"
#include "mpm/step/loads.hpp"

namespace talus::mpm {

template <int D>
std::string find_hindrance(const Body<D>& body, const StepOptions<D>& /*options*/) {
  if (body.water.is_wet()) return "its pore water moves";
  for (std::size_t m = 0; m < body.laws.size(); ++m)
    if (std::holds_alternative<material::External>(body.laws[m]))
      return "material '" + body.material_names[m] + "' is calculated by a library of its own";
  return "";
}

template <int D>
void DeviceStepper<D>::take(const Body<D>& body, const StepOptions<D>& options) {
  image_ = make_device_image(body);
  device_->take(image_, options);
  device_has_body_ = true;
  load_is_known_ = false;
}

template <int D>
DeviceInput<D> DeviceStepper<D>::make_input(const Body<D>& body, const StepOptions<D>& options) {
  DeviceInput<D> input;
  input.time = body.time;
  for (const input::TimeTable& factor : body.conditions.factors)
    input.factors.push_back({factor.at(body.time + options.dt)});
  if (body.conditions.loads.empty()) return input;
  const std::vector<Vec<D>> load =
      find_loads<D>(body, body.time, [this](const std::vector<int>& points) { return device_->locate(points); });
  input.load_is_new = !load_is_known_ || load != load_;
  load_ = load;
  load_is_known_ = true;
  input.load = {load_.data(), load_.size()};
  return input;
}

template <int D>
void DeviceStepper<D>::step(Body<D>& body, const StepOptions<D>& options) {
  if (!device_has_body_) take(body, options);
  host_is_up_to_date_ = false;
  const DeviceOutput<D> output = device_->step(make_input(body, options), options);
  body.time += options.dt;
  ++body.step_count;
  body.work.external += output.work.external;
  body.work.damped += output.work.damped;
  body.work.walls += output.work.walls;
  body.work.mapping += output.work.mapping;
  body.work.dissipated += output.work.dissipated;
  if (options.monitor) body.monitor = output.monitor;
  for (const Departed<D>& point : output.departed) {
    Lost<D> lost{point.id, body.time, point.mass, mesh::to_global(body.mesh(), point.element, point.xi), {}};
    for (std::size_t d = 0; d < D; ++d) lost.momentum[d] = point.mass * point.velocity[d];
    body.lost.push_back(lost);
  }
}

template <int D>
void DeviceStepper<D>::fade_unseen(Body<D>& body) {
  body.work.mapping += device_->fade_unseen();
  host_is_up_to_date_ = false;
}

template <int D>
void DeviceStepper<D>::bring_back(Body<D>& body) {
  if (host_is_up_to_date_) return;
  device_->give_back(image_);
  read_device_image(image_, body);
  host_is_up_to_date_ = true;
}

template <int D>
CriticalStep DeviceStepper<D>::find_critical_step(const Body<D>& body, const StepOptions<D>& options) {
  if (!device_has_body_) take(body, options);
  const StepSquare least = device_->find_step_square();
  return {std::sqrt(least.dt2 * options.mass_scaling), least.element};
}

#define TALUS_INSTANTIATE(D)                                                     \
  template std::string find_hindrance<D>(const Body<D>&, const StepOptions<D>&); \
  template class DeviceStepper<D>;
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::mpm
