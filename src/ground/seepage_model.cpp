// SPDX-License-Identifier: MIT
// Steady seepage as the case describes it.

#include <algorithm>
#include <cmath>
#include <limits>

#include "ground/initial_water.hpp"
#include "ground/pool_weight.hpp"
#include "ground/pore_water.hpp"
#include "ground/side_normals.hpp"
#include "ground/water_sides.hpp"
#include "input/case/soil_water_law.hpp"

namespace talus::ground {
namespace {

using input::WaterCondition;

template <int D>
fem::HydraulicSoil<D> make_soil(const input::Case& data, const std::string& region) {
  fem::HydraulicSoil<D> soil;
  soil.name = region;
  soil.porosity = 0.5;
  soil.conductivity.fill(1);  // of a region that takes no part
  const auto given = data.regions.find(region);
  const input::Material& m = data.materials.at(given->second);
  if (!m.water.is_wet()) return soil;
  soil.porosity = m.porosity;
  // Darcy's k under the model's gravity: a head of one metre presses harder there.
  soil.conductivity.fill(input::find_saturated_conductivity(m.water, data.water, data.gravity.acceleration));
  soil.retention = input::make_retention(m.water);
  const bool in_time = data.timeline || data.initial.water.season > 0;
  soil.relative = input::make_relative_conductivity(in_time ? input::add_air_entry(m.water) : m.water);
  soil.water_modulus = data.water.bulk_modulus;
  soil.skeleton_compressibility = m.water.compressibility;
  return soil;
}

fem::HydraulicKind to_kind(WaterCondition c) {
  switch (c) {
    case WaterCondition::total_head:
      return fem::HydraulicKind::reservoir;
    case WaterCondition::pressure:
      return fem::HydraulicKind::pressure;
    case WaterCondition::seepage_face:
      return fem::HydraulicKind::seepage_face;
    case WaterCondition::rain:
      return fem::HydraulicKind::rain;
    case WaterCondition::flux:
      return fem::HydraulicKind::flux;
    case WaterCondition::no_flow:
      break;
  }
  return fem::HydraulicKind::no_flow;
}

/// Which sides without a name are the ground: not the base, whose normal points down, and not the outer sides of the
/// model, which cut through soil that goes on.
template <int D>
class Ground {
 public:
  Ground(const mesh::Mesh<D>& mesh) : mesh_(mesh) {
    low_.fill(std::numeric_limits<double>::infinity());
    high_.fill(-std::numeric_limits<double>::infinity());
    for (int e = 0; e < mesh.element_count(); ++e)
      if (mesh.element_region[e] != mesh::empty_region)
        for (const int node : mesh.elements[e])
          for (std::size_t d = 0; d < D; ++d) {
            low_[d] = std::min(low_[d], mesh.nodes[node][d]);
            high_[d] = std::max(high_[d], mesh.nodes[node][d]);
          }
  }

  bool holds(const WaterSide<D>& side) const {
    constexpr double level = 1e-6;
    constexpr std::size_t up = 1;
    if (side.normal[up] < -level) return false;
    for (std::size_t d = 0; d < D; ++d)
      if (d != up && std::abs(side.normal[d]) > 1 - level && (is_at(side, d, low_[d]) || is_at(side, d, high_[d])))
        return false;
    return true;
  }

 private:
  bool is_at(const WaterSide<D>& side, std::size_t d, double x) const {
    const double near = 1e-9 * (high_[d] - low_[d]);
    return std::all_of(side.nodes.begin(), side.nodes.end(),
                       [&](int node) { return std::abs(mesh_.nodes[node][d] - x) <= near; });
  }

  const mesh::Mesh<D>& mesh_;
  Vec<D> low_{}, high_{};
};

}  // namespace

template <int D>
fem::SeepageModel<D> make_seepage_model(const input::Case& data, const mesh::Mesh<D>& mesh, mesh::Mesh<D>& wet_mesh) {
  check_upright(data, "a total head");
  wet_mesh = mesh;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const input::Material* soil = find_soil(data, mesh, e);
    if (soil != nullptr && !soil->water.is_wet()) wet_mesh.element_region[e] = mesh::empty_region;
  }
  fem::SeepageModel<D> model;
  model.mesh = &wet_mesh;
  for (const std::string& region : mesh.region_names) model.soils.push_back(make_soil<D>(data, region));
  model.unit_weight = find_water_weight(data);
  // The same sides and the same precedence as on the moving soil. Sides without a name are seepage faces on the ground,
  // and closed elsewhere.
  const Ground<D> ground(mesh);
  const WaterSides<D> sides = find_water_sides<D>(mesh, data);
  for (std::size_t number = 0; number < sides.surfaces.size(); ++number) {
    const bool is_named = number > 0 && number <= data.hydraulics.size();
    fem::HydraulicBoundary<D> boundary;
    boundary.name = sides.surfaces[number].name;
    boundary.kind = number == 0 ? fem::HydraulicKind::seepage_face : fem::HydraulicKind::no_flow;
    if (is_named) {
      const input::Hydraulic& h = data.hydraulics[number - 1];
      boundary.kind = to_kind(h.condition);
      boundary.measure = h.condition == WaterCondition::rain && h.rain == input::RainDirection::vertical
                             ? fem::FluxMeasure::vertical
                             : fem::FluxMeasure::normal;
      boundary.suction_limit = h.suction_limit;
      boundary.standing_depth = h.standing_depth;
      boundary.runs_on = h.runs_on;
    }
    if (boundary.kind == fem::HydraulicKind::no_flow) continue;
    for (const WaterSide<D>& s : sides.open) {
      if (s.condition == static_cast<int>(number) && (number > 0 || ground.holds(s))) boundary.sides.push_back(s.nodes);
    }
    if (boundary.sides.empty()) continue;
    const input::TimeTable& values = sides.surfaces[number].value;
    for (std::size_t i = 0; i < values.time.size(); ++i) boundary.history.push_back({values.time[i], values.value[i]});
    model.boundaries.push_back(std::move(boundary));
  }
  if constexpr (D == 2)
    if (data.timeline && data.timeline->pool_loading) model.pool_weight = make_pool_weight(data, mesh);
  return model;
}

template fem::SeepageModel<2> make_seepage_model<2>(const input::Case&, const mesh::Mesh<2>&, mesh::Mesh<2>&);
template fem::SeepageModel<3> make_seepage_model<3>(const input::Case&, const mesh::Mesh<3>&, mesh::Mesh<3>&);

}  // namespace talus::ground
