// SPDX-License-Identifier: MIT
#include "support/box_case.hpp"

#include "support/soil_body.hpp"

namespace talus::support {

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

template <int D>
mesh::Mesh<D> make_box_mesh(const std::array<int, D>& cells, const std::type_identity_t<Vec<D>>& size,
                            std::vector<std::string> names, const Filling<D>& region, double jitter) {
  mesh::Mesh<D> mesh = make_mesh<D>(cells, size, jitter);
  name_sides(mesh, size);
  mesh.region_names = std::move(names);
  Vec<D> middle;
  middle.fill(1.0 / (D + 1));
  for (int e = 0; e < mesh.element_count(); ++e)
    mesh.element_region[static_cast<std::size_t>(e)] = region(mesh::to_global(mesh, e, middle));
  return mesh;
}

input::Material make_elastic(double young_modulus, double poisson_ratio, double density) {
  input::Material m;
  m.grain_density = density;
  m.young_modulus = young_modulus;
  m.poisson_ratio = poisson_ratio;
  return m;
}

input::Boundary make_boundary(const std::string& on, input::Fix fix) {
  input::Boundary b;
  b.on = on;
  b.fix = fix;
  return b;
}

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

template <int D>
run::StagePlan<D> make_rest_stage(const input::Case& data, const mpm::Body<D>& body, double longest,
                                  input::StepSettings step, double force_ratio) {
  run::StagePlan<D> plan = make_stage(data, body, longest, step);
  plan.until_rest = true;
  plan.rest = {.force_ratio = force_ratio, .speed_ratio = force_ratio, .energy_ratio = 1, .hold = 0.01};
  return plan;
}

template <int D>
results::StageEnd run_plan(mpm::Body<D>& body, const run::StagePlan<D>& plan) {
  run::StageState state;
  return run::run_stage(body, plan, state);
}

template void name_sides<2>(mesh::Mesh<2>& mesh, const std::type_identity_t<Vec<2>>& size);
template void name_sides<3>(mesh::Mesh<3>& mesh, const std::type_identity_t<Vec<3>>& size);
template mesh::Mesh<2> make_box_mesh<2>(const std::array<int, 2>& cells, const std::type_identity_t<Vec<2>>& size,
                                        std::vector<std::string> names, const Filling<2>& region, double jitter);
template mesh::Mesh<3> make_box_mesh<3>(const std::array<int, 3>& cells, const std::type_identity_t<Vec<3>>& size,
                                        std::vector<std::string> names, const Filling<3>& region, double jitter);
template input::Case make_box_case<2>(const input::Material& soil);
template input::Case make_box_case<3>(const input::Material& soil);
template run::StagePlan<2> make_stage<2>(const input::Case& data, const mpm::Body<2>& body, double duration,
                                         input::StepSettings step);
template run::StagePlan<3> make_stage<3>(const input::Case& data, const mpm::Body<3>& body, double duration,
                                         input::StepSettings step);
template run::StagePlan<2> make_rest_stage<2>(const input::Case& data, const mpm::Body<2>& body, double longest,
                                              input::StepSettings step, double force_ratio);
template run::StagePlan<3> make_rest_stage<3>(const input::Case& data, const mpm::Body<3>& body, double longest,
                                              input::StepSettings step, double force_ratio);
template results::StageEnd run_plan<2>(mpm::Body<2>& body, const run::StagePlan<2>& plan);
template results::StageEnd run_plan<3>(mpm::Body<3>& body, const run::StagePlan<3>& plan);

}  // namespace talus::support
