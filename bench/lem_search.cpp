// SPDX-License-Identifier: MIT
// Circles per second of the search for the critical slip surface, and the growth of its cost with circles and slices.
//
// Usage: lem_search [THREADS]
//
// It prints wall time, circles per second and microseconds per circle and method: for the trial circles only, and with
// the optimisation of the circle and of the surface; and the growth of the cost of the optimisation.

#include <fmt/format.h>

#include <cstdlib>
#include <numbers>

#include "base/parallel.hpp"
#include "lem/search/search.hpp"

namespace {

using talus::lem::Method;

/// Returns a slope of two soils with a water table, 10 m high.
talus::lem::Slope make_slope() {
  talus::lem::Section s;
  s.ground = {{0, 10}, {30, 10}, {50, 20}, {90, 20}};
  talus::lem::Soil upper, lower;
  upper.name = "upper", upper.unit_weight = upper.saturated_unit_weight = 19e3;
  upper.cohesion = 5e3, upper.friction_angle = 28 * std::numbers::pi / 180;
  lower = upper;
  lower.name = "lower", lower.cohesion = 12e3, lower.friction_angle = 22 * std::numbers::pi / 180;
  s.soils = {upper, lower};
  s.regions = {{0, {{0, 0}, {90, 0}, {90, 20}, {50, 20}, {30, 10}, {0, 10}}}, {1, {{0, 0}, {90, 0}, {90, 11}, {0, 8}}}};
  s.water_table = {{0, 9}, {30, 9}, {90, 15}};
  return talus::lem::Slope(s);
}

double run(const talus::lem::Slope& slope, int points, int depths, int slices, std::vector<Method> methods, int threads,
           bool circle, bool surface, long& tried) {
  talus::lem::SearchOptions options;
  options.entry_exit.emplace();
  options.entry_exit->entries = options.entry_exit->exits = points;
  options.entry_exit->depths = depths;
  options.slices = slices;
  options.methods = std::move(methods);
  options.optimise_circle = circle;
  options.optimise_surface = surface;
  options.threads = threads;
  const auto result = talus::lem::search(slope, options);
  tried = result.tried;
  return result.seconds;
}

}  // namespace

int main(int argc, char** argv) {
  const int threads = argc > 1 ? std::atoi(argv[1]) : talus::default_threads();
  const auto slope = make_slope();
  const std::vector<Method> both{Method::bishop, Method::spencer};
  long tried = 0;
  run(slope, 10, 5, 50, both, threads, false, false, tried);  // warm-up
  fmt::print("threads {}\n{:>8} {:>7} {:>10} {:>12} {:>10}  what\n", threads, "circles", "slices", "seconds",
             "circles/s", "us/circle");
  auto show = [&](double seconds, int slices, const char* what) {
    fmt::print("{:8d} {:7d} {:10.3f} {:12.0f} {:10.2f}  {}\n", tried, slices, seconds,
               static_cast<double>(tried) / seconds, 1e6 * seconds / static_cast<double>(tried), what);
  };
  for (const int points : {12, 25, 50})
    show(run(slope, points, 15, 50, both, threads, false, false, tried), 50, "Bishop and Spencer, circles");
  for (const int slices : {25, 50, 100, 200})
    show(run(slope, 25, 15, slices, both, threads, false, false, tried), slices, "Bishop and Spencer, slices");
  show(run(slope, 25, 15, 50, {Method::bishop}, threads, false, false, tried), 50, "Bishop");
  show(run(slope, 25, 15, 50, {Method::spencer}, threads, false, false, tried), 50, "Spencer");
  show(run(slope, 25, 15, 50, {Method::morgenstern_price}, threads, false, false, tried), 50, "Morgenstern-Price");
  show(run(slope, 25, 15, 50, both, threads, true, false, tried), 50, "Bishop and Spencer, circle optimised");
  show(run(slope, 25, 15, 50, both, threads, true, true, tried), 50,
       "Bishop and Spencer, circle and surface optimised");
  return 0;
}
