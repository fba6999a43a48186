// SPDX-License-Identifier: MIT
// Runout by the plain step of tests/reference with the rules of another material point code in the place of those of
// Talus, one at a time and together: the dry slope at a strength reduction factor of 1.75 on that code's mesh, and a
// column of dry sand (Lube et al. 2005).
//
// Usage: plain_runout [slope|column] [seconds of the slope]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "mesh/generate.hpp"
#include "reference/bodies.hpp"
#include "reference/plain_mpm.hpp"

using namespace talus;

namespace {

constexpr double gravity = 9.81, degree = std::numbers::pi / 180;

struct Rules {
  const char* name;
  std::function<void(reference::Settings&)> change = [](reference::Settings&) {};
  bool filters = true;  ///< null modes every 64 steps
};

std::vector<Rules> list_rules() {
  using S = reference::Settings;
  const auto brake = [](S& s) { s.fixed_nodes_brake = false; };
  const auto tags = [](S& s) { s.surface_points = true; };
  const auto gaps = [](S& s) { s.separates = false; };
  const auto turn = [](S& s) { s.objective = false; };
  return {{"Talus"},
          {"points beside fixed nodes keep their speed", brake},
          {"surface by points marked at the start", tags},
          {"no separation", gaps},
          {"no filter of null modes", [](S&) {}, false},
          {"stress does not rotate", turn},
          {"integration on points", [](S& s) { s.mixed = false; }},
          {"strain smoothing", [](S& s) { s.smoothing = reference::Smoothing::strain; }},
          {"strain smoothing of three components",
           [](S& s) { s.smoothing = reference::Smoothing::strain, s.smooths_three = true; }},
          {"all of the other code", [=](S& s) { brake(s), tags(s), gaps(s), turn(s); }, false}};
}

double find_step(const reference::Body<2>& body) {
  const reference::Material& m = body.materials[0];
  const double nu = m.poisson_ratio, modulus = m.young_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  double altitude = INFINITY;
  for (const auto& point : body.points) altitude = std::min(altitude, body.mesh.altitudes[point.element]);
  return 0.98 * altitude / std::sqrt(modulus / (body.points[0].mass / body.points[0].volume));
}

void mark_surface_points(reference::Body<2>& body) {
  reference::classify_elements(body, {});
  for (auto& point : body.points)
    for (const int n : body.mesh.neighbours[point.element])
      if (n >= 0 && !body.cells[n].is_active()) point.at_surface = true;
}

void run(reference::Body<2>& body, const Rules& rules, double damping, double duration,
         reference::Smoothing smoothing) {
  reference::Settings settings;
  settings.damping = damping;
  settings.smoothing = smoothing;
  rules.change(settings);
  const int steps = static_cast<int>(std::ceil(duration / find_step(body)));
  settings.time_step = duration / steps;
  for (int s = 1; s <= steps; ++s) {
    reference::step(body, settings);
    if (rules.filters && s % 64 == 0) reference::filter_null_modes(body);
  }
}

/// Results against the start: largest displacement [m], x that 99 % of the mass that has moved by `noticeable` has not
/// passed [m], and the largest speed [m/s].
void print(const char* name, const char* when, const reference::Body<2>& start, const reference::Body<2>& body) {
  constexpr double noticeable = 0.1;
  double largest = 0, speed = 0, mass = 0;
  std::vector<std::pair<double, double>> moved;  // x and mass
  for (const auto& point : body.points) {
    const double u = (point.x - start.points[point.id].x).norm();
    largest = std::max(largest, u);
    speed = std::max(speed, point.v.norm());
    if (u > noticeable) moved.push_back({point.x[0], point.mass}), mass += point.mass;
  }
  std::sort(moved.rbegin(), moved.rend());
  double beyond = 0, front = NAN;
  for (const auto& [x, m] : moved)
    if ((beyond += m) >= 0.01 * mass) {
      front = x;
      break;
    }
  std::printf("%-44s %-7s %10.4f %10.3f %10.3f\n", name, when, largest, front, speed);
  std::fflush(stdout);
}

void print_heading(const char* what) {
  std::printf("%s\n%-44s %-7s %10s %10s %10s\n", what, "rules", "time", "u [m]", "front [m]", "v [m/s]");
}

/// The slope at rest by the rules of Talus.
reference::Body<2> settle_slope() {
  mesh::Plan plan;
  plan.file = TALUS_SOURCE_DIR "/examples/data/dry_slope_h075.msh";
  const auto mesh = mesh::generate<2>(plan);
  reference::Body<2> body = reference::make_body(mesh, {45e6, 0.3, true, 200e3, 30 * degree, 0, 0});
  body.gravity[1] = -gravity;
  const reference::Slope outline{32, 5, 12, 15};
  reference::fill(body, 2650 * 0.6, 0, [&](const reference::Vector<2>& x) { return x[1] < outline.surface(x[0]); });
  for (const auto& [side, components] : {std::pair{"bottom", 2}, std::pair{"left", 1}, std::pair{"right", 1}})
    for (const auto& ends : mesh.sides.at(side))
      for (const int node : ends)
        for (int c = 0; c < components; ++c) body.constraints[node].fixed[c] = true;
  mark_surface_points(body);
  run(body, {"Talus"}, 0.75, 6, reference::Smoothing::none);
  body.materials[0].cohesion = 2e3;
  run(body, {"Talus"}, 0.75, 18, reference::Smoothing::none);
  return body;
}

void slide_slope(double duration) {
  print_heading("Dry slope at 1.75, toe at x = 32 m");
  reference::Body<2> start = settle_slope();
  start.materials[0].cohesion = 2e3 / 1.75;
  start.materials[0].friction_angle = std::atan(std::tan(30 * degree) / 1.75);
  for (const Rules& rules : list_rules()) {
    reference::Body<2> body = start;
    run(body, rules, 0.05, 5, reference::Smoothing::none);
    print(rules.name, "5 s", start, body);
    run(body, rules, 0.05, duration - 5, reference::Smoothing::none);
    print(rules.name, "end", start, body);
  }
}

void collapse_column() {
  print_heading("Column of sand, 1 m wide and 2 m high, edge at x = 1 m");
  const reference::Material sand{5e6, 0.3, true, 0, 31 * degree, 0, 0};
  for (const Rules& rules : list_rules()) {
    reference::Body<2> body = reference::make_body(reference::make_box<2>({60, 25}, {6, 2.5}), sand);
    body.gravity[1] = -gravity;
    reference::fill(body, 2650 * 0.6, 0, [&](const reference::Vector<2>& x) { return x[0] < 1 && x[1] < 2; });
    for (auto& point : body.points) {
      const double weight = -2650 * 0.6 * gravity * (2 - point.x[1]);
      point.sigma.diagonal() = Eigen::Vector3d(0.3 / 0.7, 1, 0.3 / 0.7) * weight;
    }
    reference::fix_face(body, 1, 0, 0);
    reference::fix_face(body, 1, 0, 1);
    reference::fix_face(body, 0, 0, 0);
    mark_surface_points(body);
    const reference::Body<2> start = body;
    run(body, rules, 0, 2.5, reference::Smoothing::stable);
    run(body, rules, 0.5, 1, reference::Smoothing::stable);
    print(rules.name, "3.5 s", start, body);
  }
}

}  // namespace

int main(int count, char** words) {
  const std::string which = count > 1 ? words[1] : "";
  if (which != "slope") collapse_column();
  if (which != "column") slide_slope(count > 2 ? std::atof(words[2]) : 20);
}
