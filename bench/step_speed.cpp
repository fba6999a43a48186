// SPDX-License-Identifier: MIT
// Million point-steps per second of the MPM step on the slope of the yardstick.
//
// Usage: step_speed D CASE THREADS [WARM STEPS REPEATS] [FLAG...]
//
// CASE is small, mid, large, or huge (five million points, for GPUs). Flags for dry cases: mixed, smooth, stable,
// objective; rooted (the rooted-soil model). Flags for pore water: wet (unsaturated above the water level) or saturated
// (S = 1 everywhere), and with them net (damping), explicit (drag), pressure (smoothing), seepage (surfaces without
// inflow), seeps (Darcy formulation with the time step of drained soil; prints rounds and iterations of its solver).
// Output and device: parts (wall time by phase of the step), state (extreme values of the points before timing), gpu or
// emulated (the device of --device, in wall time), kernels (fraction of each kernel, over as many further steps).
// Single-threaded runs are timed in CPU time, threaded ones in wall time.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "mpm/backend/device_image.hpp"
#include "mpm/solver/device_stepper.hpp"
#include "mpm/solver/observe.hpp"
#include "mpm/solver/step.hpp"
#include "wet_yardstick.hpp"

namespace {

double read_clock(bool wall) {
  timespec t;
  clock_gettime(wall ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Returns the total bytes of the arrays.
template <class... Vectors>
std::size_t count_bytes(const Vectors&... vectors) {
  return ((vectors.capacity() * sizeof(vectors[0])) + ... + 0);
}

template <int D>
std::size_t memory_per_point(const talus::mpm::Body<D>& body) {
  const auto& p = body.points;
  const auto& e = body.elements;
  const auto& n = body.nodes;
  const auto& w = body.water;
  const auto& l = *body.layout;
  const auto& m = l.mesh;
  std::size_t total = count_bytes(p.data, p.id, p.count, p.element, p.place, p.material, p.reference, p.strain_offset) +
                      count_bytes(e.moments, e.strain, e.fill_limit, e.apart, e.plastic_dilation, e.rough) +
                      count_bytes(n.sums, n.motion, n.average, n.smoothed, n.load, n.displacement) +
                      count_bytes(l.connectivity, l.gradients, l.volumes, l.node_rows, l.row_start) +
                      count_bytes(m.nodes, m.elements, m.neighbours, m.volumes, m.gradients, m.altitudes);
  total += count_bytes(w.constraint_of_node, w.constraints, w.surface_of_node, w.moments, w.volume, w.stretch,
                       w.mean_saturation, w.mean_pressure, w.surplus, w.sums, w.motion, w.average, w.smoothed,
                       w.open_sides, w.facing, w.load, w.darcy_load);
  return total / static_cast<std::size_t>(p.size());
}

template <int D>
talus::bench::Yardstick<D> make_case(const std::string& name, int threads, const std::set<std::string>& flags) {
  const bool saturated = flags.contains("saturated"), wet = saturated || flags.contains("wet"),
             rooted = flags.contains("rooted");
  const int chunks = threads > 1 || name == "large" || name == "huge" ? 0 : 1;
  auto y = wet ? talus::bench::make_wet_yardstick<D>(name, chunks, saturated, rooted)
               : talus::bench::make_yardstick<D>(name, chunks, rooted);
  y.options.threads = threads;
  y.options.mixed = flags.contains("mixed");
  if (flags.contains("smooth")) y.options.smoothing = talus::input::Smoothing::strain;
  if (flags.contains("stable")) y.options.smoothing = talus::input::Smoothing::stable;
  y.options.objective = flags.contains("objective");
  y.options.net_damping = flags.contains("net");
  y.options.implicit_drag = !flags.contains("explicit");
  y.options.smooth_pressure = flags.contains("pressure");
  if (flags.contains("seepage"))
    for (auto& surface : y.body.water.surfaces) surface.kind = talus::mpm::SurfaceKind::seepage;
  if (flags.contains("seeps")) {
    y.options.darcy = true;
    y.options.dt = 0.9 * talus::mpm::find_critical_step(y.body, y.options).dt;
    talus::mpm::gather_nodal_sums(y.body, y.options);
  }
  return y;
}

/// Prints the largest speeds, pressure and stress, for comparison with `check` of the yardstick.
template <int D>
void print_state(const talus::mpm::Body<D>& body) {
  double grains = 0, water = 0, pressure = 0, stress = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!talus::mpm::is_present(body, id)) continue;
    const auto view = talus::mpm::view_point(body, id);
    for (const double v : view.velocity) grains = std::max(grains, std::abs(v));
    for (const double v : view.water_velocity) water = std::max(water, std::abs(v));
    for (const double v : view.stress) stress = std::max(stress, std::abs(v));
    pressure = std::max(pressure, std::abs(view.pressure));
  }
  fmt::print("state: |v| {:.4g} m/s, |w| {:.4g} m/s, |p| {:.5g} Pa, |stress| {:.5g} Pa, lost {}\n", grains, water,
             pressure, stress, body.lost.size());
}

void print_parts(const talus::mpm::Timing& t, int steps) {
  const double scale = 1e6 / steps;
  fmt::print(
      "parts [us/step]: momentum {:.2f}, remap {:.2f}, smoothing {:.2f}, points {:.2f}, relocate "
      "{:.2f}\n",
      t.solve_momentum * scale, t.remap_momentum * scale, t.smooth_strain * scale, t.advance_points * scale,
      t.relocate * scale);
}

/// Runs the steps on the processor, or on the device that the flags select.
template <int D>
class Steps {
 public:
  Steps(talus::bench::Yardstick<D>& y, const std::set<std::string>& flags) : y_(y) {
    if (flags.contains("gpu")) talus::mpm::use_gpu();
    if (flags.contains("emulated")) talus::mpm::use_emulated_device({.threads = y.options.threads});
    if (auto device = talus::mpm::make_device<D>()) device_.emplace(std::move(device));
  }
  bool on_device() const { return device_.has_value(); }
  void run(int count) {
    for (int s = 0; s < count; ++s)
      device_ ? device_->step(y_.body, y_.options) : talus::mpm::step(y_.body, y_.options);
  }
  /// Prints the kernels of further steps, the longest first.
  void print_kernels(int steps) {
    if (!device_) return;
    device_->time_kernels();
    run(steps);
    std::vector<talus::mpm::KernelTime> times = device_->list_times();
    std::sort(times.begin(), times.end(), [](const auto& a, const auto& b) { return a.seconds > b.seconds; });
    double all = 0;
    for (const auto& time : times) all += time.seconds;
    fmt::print("kernels, each waited for: {:.1f} us/step\n", all / steps * 1e6);
    for (const auto& time : times)
      fmt::print("  {:<24} {:5.1f} % {:10.1f} us/step {:7.1f} launches/step\n", time.name, 100 * time.seconds / all,
                 time.seconds / steps * 1e6, static_cast<double>(time.launches) / steps);
  }
  void end() {
    if (device_) device_->copy_back(y_.body);
  }

 private:
  talus::bench::Yardstick<D>& y_;
  std::optional<talus::mpm::DeviceStepper<D>> device_;
};

/// Prints the statistics of the pressure solver over ten further steps.
template <int D>
void print_solver(talus::bench::Yardstick<D>& y, Steps<D>& stepper) {
  constexpr int steps = 10;
  double rounds = 0, iterations = 0;
  for (int s = 0; s < steps; ++s) {
    stepper.run(1);
    rounds += y.body.water.darcy.rounds;
    iterations += y.body.water.darcy.iterations;
  }
  fmt::print("step {:.3g} s; rounds {:.1f}, iterations {:.1f} a step\n", y.options.dt, rounds / steps,
             iterations / steps);
}

template <int D>
void run(const std::string& name, int threads, int warm, int steps, int repeats, const std::set<std::string>& flags) {
  auto y = make_case<D>(name, threads, flags);
  Steps<D> stepper(y, flags);
  const bool wall = threads > 1 || stepper.on_device();
  stepper.run(warm);
  stepper.end();
  if (flags.contains("state")) print_state(y.body);
  y.body.timing = {};
  double best = 1e30;
  for (int r = 0; r < repeats; ++r) {
    const double start = read_clock(wall);
    stepper.run(steps);
    best = std::min(best, (read_clock(wall) - start) / steps);
  }
  const double points = y.body.points.size();
  fmt::print("talus D={} {} points={} threads={} chunks={} : best {:.2f} Mpps, {:.1f} us/step, {} bytes/point\n", D,
             name, y.body.points.size(), threads, y.body.layout->chunks, points / best * 1e-6, best * 1e6,
             memory_per_point(y.body));
  if (stepper.on_device())
    fmt::print("on the device: {}, {:.0f} bytes/point\n", talus::mpm::get_device_name(),
               static_cast<double>(count_bytes(talus::mpm::make_device_image(y.body, threads))) / points);
  if (y.options.darcy) print_solver(y, stepper);
  if (flags.contains("kernels")) stepper.print_kernels(steps);
  if (flags.contains("parts")) print_parts(y.body.timing, steps * repeats);
}

}  // namespace

int main(int count, char** arguments) {
  const auto number = [&](int i, int fallback) {
    return count > i && std::isdigit(arguments[i][0]) ? std::atoi(arguments[i]) : fallback;
  };
  const int dimension = number(1, 2);
  const std::string name = count > 2 ? arguments[2] : "small";
  const bool large = name == "large" || name == "huge";
  const int threads = number(3, 1), warm = number(4, large ? 10 : 200), steps = number(5, large ? 10 : 1000),
            repeats = number(6, 5);
  const std::set<std::string> flags(arguments + 1, arguments + count);
  if (dimension == 2)
    run<2>(name, threads, warm, steps, repeats, flags);
  else
    run<3>(name, threads, warm, steps, repeats, flags);
  return 0;
}
