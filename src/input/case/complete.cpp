// SPDX-License-Identifier: MIT
#include "input/case/complete.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <vector>

#include "input/case/checks.hpp"

namespace talus::input {
namespace {

/// Without material points the box is the bounding box of the soil.
void fit_box(mesh::Plan& plan) {
  if (plan.polygons.empty()) return;
  constexpr double far = std::numeric_limits<double>::infinity();
  plan.box_min = {far, far};
  plan.box_max = {-far, -far};
  for (const mesh::Polygon& polygon : plan.polygons) {
    for (const auto& p : polygon.points) {
      for (std::size_t d = 0; d < 2; ++d) {
        plan.box_min[d] = std::min(plan.box_min[d], p[d]);
        plan.box_max[d] = std::max(plan.box_max[d], p[d]);
      }
    }
  }
}

/// Supports of the finite elements where the case names none.
void hold_section(Case& data) {
  std::vector<const char*> rollers{"left", "right"};
  if (data.mesh.dimension == 3) rollers.insert(rollers.end(), {"front", "back"});
  data.boundaries.resize(1 + rollers.size());
  data.boundaries[0].on = "bottom";
  for (std::size_t i = 0; i < rollers.size(); ++i) {
    data.boundaries[i + 1].on = rollers[i];
    data.boundaries[i + 1].fix = Fix::normal;
  }
}

/// What a case without material points leaves out.
void complete_without_points(Case& data, const Places& places) {
  if (data.mesh.file.empty() && !places.is_given("geometry.box")) fit_box(data.mesh);
  if (uses(data, Method::mpm)) return;
  if (data.mesh.size == 0 && data.fem.size) data.mesh.size = *data.fem.size;
  if ((uses(data, Method::fem) || uses(data, Method::bounds)) && data.boundaries.empty()) hold_section(data);
}

/// The density that belongs to a unit weight, unless grains and pores are given as well.
void complete_density(Material& material, const Gravity& gravity, const std::string& path, const Places& places) {
  if (!material.slices.unit_weight || places.is_given(path + ".grain_density") || gravity.acceleration <= 0) return;
  material.grain_density = *material.slices.unit_weight / (gravity.acceleration * (1 - material.porosity));
}

/// Water that may move carries the weight first, and soil at rest under it is not in its effective stresses.
void drain_weight(Case& data, const Places& places) {
  if (data.stages.empty() || !is_wet(data)) return;
  Stage& first = data.stages.front();
  const bool brings_weight = first.until == Until::rest && data.initial.stress == InitialStress::none &&
                             data.initial.result.empty() && data.initial.water.pressure != InitialPressure::zero &&
                             data.gravity.acceleration > 0;
  if (!brings_weight || places.is_given("stage.0.water") || places.is_given("stage.0.geometry") ||
      places.is_given("stage.0.conductivity_factor"))
    return;
  first.step.water = WaterMotion::held;
  first.step.geometry = Geometry::frozen;
}

}  // namespace

void complete_porosities(Case& data) {
  for (auto& [name, material] : data.materials)
    if (const auto e = material.given_void_ratio) material.porosity = *e / (1 + *e);
}

void complete(Case& data, const std::string& file, const Places& places) {
  if (data.mesh.dimension == 3 && !places.is_given("mesh.points_per_element")) data.points_per_element = 4;
  const auto find_file = [&](const std::string& path) {
    return (std::filesystem::path(file).parent_path() / path).lexically_normal().string();
  };
  if (!data.mesh.file.empty()) data.mesh.file = find_file(data.mesh.file);
  complete_porosities(data);
  for (auto& [name, material] : data.materials) {
    complete_density(material, data.gravity, "materials." + name, places);
    material::complete_soil(material, name, find_file);
  }
  complete_without_points(data, places);
  drain_weight(data, places);
  // A ready mesh cannot be coarsened, and a second mesh of tetrahedra costs memory and time.
  if (!places.is_given("fem.meshes") && (data.mesh.dimension == 3 || !data.mesh.file.empty())) data.fem.meshes = 1;
  if (data.initial.result.empty()) return;
  data.initial.result_folder = find_file(data.initial.result);
  // The mesh of a result cannot be halved.
  if (!places.is_given("strength_reduction.frozen.meshes")) data.strength_reduction.frozen.meshes = 1;
}

}  // namespace talus::input
