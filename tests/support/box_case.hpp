// SPDX-License-Identifier: MIT
#pragma once
// Cases on a box, without a mesh generator: named sides, regions by height or by any other rule, rollers.

#include <cmath>
#include <functional>

#include "run/mpm/stage.hpp"
#include "run/mpm/start/prepare.hpp"
#include "support/soil_body.hpp"

namespace talus::support {

/// Names the sides of a mesh of the box [0, size]: left right bottom top (front back).
template <int D>
void name_sides(mesh::Mesh<D>& mesh, const std::type_identity_t<Vec<D>>& size) {
  static constexpr const char* low[] = {"left", "bottom", "front"};
  static constexpr const char* high[] = {"right", "top", "back"};
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (std::size_t k = 0; k <= D; ++k) {
      if (mesh.neighbours[e][k] >= 0) continue;
      typename mesh::Mesh<D>::Side side;
      std::size_t n = 0;
      for (std::size_t j = 0; j <= D; ++j) {
        if (j != k) side[n++] = mesh.elements[e][j];
      }
      for (std::size_t d = 0; d < D; ++d) {
        bool is_low = true, is_high = true;
        for (int i : side) {
          is_low = is_low && std::abs(mesh.nodes[static_cast<std::size_t>(i)][d]) < 1e-9;
          is_high = is_high && std::abs(mesh.nodes[static_cast<std::size_t>(i)][d] - size[d]) < 1e-9;
        }
        if (is_low) mesh.sides[low[d]].push_back(side);
        if (is_high) mesh.sides[high[d]].push_back(side);
      }
    }
  }
}

/// A jittered mesh of the box with its sides named; `region` gives each centroid's region (-1: empty).
template <int D>
mesh::Mesh<D> make_box_mesh(const std::array<int, D>& cells, const std::type_identity_t<Vec<D>>& size,
                            std::vector<std::string> names, const Filling<D>& region, double jitter = 0.15) {
  mesh::Mesh<D> mesh = make_mesh<D>(cells, size, jitter);
  name_sides(mesh, size);
  mesh.region_names = std::move(names);
  Vec<D> middle;
  middle.fill(1.0 / (D + 1));
  for (int e = 0; e < mesh.element_count(); ++e)
    mesh.element_region[static_cast<std::size_t>(e)] = region(mesh::to_global(mesh, e, middle));
  return mesh;
}

inline input::Material make_elastic(double young_modulus = 10e6, double poisson_ratio = 0.3, double density = 1800) {
  input::Material m;
  m.grain_density = density;
  m.young_modulus = young_modulus;
  m.poisson_ratio = poisson_ratio;
  return m;
}

inline input::Boundary make_boundary(const std::string& on, input::Fix fix) {
  input::Boundary b;
  b.on = on;
  b.fix = fix;
  return b;
}

/// One material "soil" in the region "soil"; rollers on every face but the top.
template <int D>
input::Case make_box_case(const input::Material& soil) {
  input::Case data;
  data.points_per_element = D == 2 ? 3 : 4;
  data.materials["soil"] = soil;
  data.regions["soil"] = "soil";
  for (const char* name : {"left", "right", "bottom", "front", "back"}) {
    if (D == 2 && std::string(name).ends_with("k")) continue;
    if (D == 2 && std::string(name) == "front") continue;
    data.boundaries.push_back(make_boundary(name, input::Fix::normal));
  }
  return data;
}

/// A plan that runs `duration` seconds under the case's gravity.
template <int D>
run::StagePlan<D> make_stage(const input::Case& data, const mpm::Body<D>& body, double duration,
                             input::StepSettings step) {
  run::StagePlan<D> plan;
  plan.name = "test";
  plan.duration = duration;
  plan.step = step;
  plan.gravity = run::find_gravity<D>(data.gravity);
  plan.soil_height = run::find_soil_height(body, data.gravity);
  return plan;
}

/// The same until rest, with a strict criterion.
template <int D>
run::StagePlan<D> make_rest_stage(const input::Case& data, const mpm::Body<D>& body, double longest,
                                  input::StepSettings step, double force_ratio = 1e-6) {
  run::StagePlan<D> plan = make_stage(data, body, longest, step);
  plan.until_rest = true;
  plan.rest = {.force_ratio = force_ratio, .speed_ratio = force_ratio, .energy_ratio = 1, .hold = 0.01};
  return plan;
}

/// Runs a stage from its start.
template <int D>
results::StageEnd run_plan(mpm::Body<D>& body, const run::StagePlan<D>& plan) {
  run::StageState state;
  return run::run_stage(body, plan, state);
}

}  // namespace talus::support
