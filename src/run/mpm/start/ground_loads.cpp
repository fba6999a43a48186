// SPDX-License-Identifier: MIT
#include "run/mpm/start/conditions.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "input/case/pressure_table.hpp"
#include "mesh/mesh.hpp"
#include "mpm/solver/observe.hpp"
#include "site/ground_load.hpp"
#include "site/initial_water.hpp"
#include "site/mesh_sides.hpp"
#include "site/pore_water.hpp"

namespace talus::run {
namespace {

/// Returns true if a [[hydraulic]] prescribes the pressure on the top of the box; the engine applies it to the soil
/// there.
bool has_pressure_on_top(const input::Case& data) {
  return std::any_of(data.hydraulics.begin(), data.hydraulics.end(), [](const input::Hydraulic& h) {
    using enum input::WaterCondition;
    return h.on == "top" && (h.condition == total_head || h.condition == pressure);
  });
}

/// Returns true if water of the water table may stand on the ground. Ponds are conditions of the engine.
bool has_standing_water(const site::Site& site) {
  return !site.water_table().empty() && site.ponds().empty() && !has_pressure_on_top(site.data());
}

bool moves(const input::Case& data) {
  return std::any_of(data.stages.begin(), data.stages.end(),
                     [](const input::Stage& stage) { return stage.step.geometry == input::Geometry::moving; });
}

/// Returns the growth of the weight in the first stage.
input::TimeTable make_growth(const input::Case& data) {
  const double ramp = data.stages.empty() || !data.initial.result.empty() ? 0 : data.stages.front().gravity_ramp;
  if (ramp <= 0) return {};
  return {{0.0, ramp}, {0.0, 1.0}};
}

/// Integrates a traction that is linear on a side to forces at its corners: ∫ N_i N_j = (1 + δ_ij)/(D(D+1)) of the
/// area.
template <int D>
std::array<Vec<D>, D> integrate(const std::array<Vec<D>, D>& traction, double area) {
  Vec<D> sum{};
  for (const Vec<D>& t : traction)
    for (std::size_t d = 0; d < D; ++d) sum[d] += t[d];
  std::array<Vec<D>, D> force;
  for (std::size_t c = 0; c < D; ++c)
    for (std::size_t d = 0; d < D; ++d) force[c][d] = area * (sum[d] + traction[c][d]) / (D * (D + 1));
  return force;
}

template <int D>
mpm::Load<D> make_side_load(const mpm::Body<D>& body, const fem::SurfaceLoad<D>& surface, bool on_points) {
  mpm::Load<D> load;
  load.on_points = on_points;
  const auto elements_of = site::map_sides<D>(body.mesh(), surface.sides);
  for (std::size_t s = 0; s < surface.sides.size(); ++s) {
    std::array<int, D> key = surface.sides[s];
    std::sort(key.begin(), key.end());
    const auto& elements = elements_of.at(key);
    const auto soil = std::find_if(elements.begin(), elements.end(),
                                   [&](const site::SideElement& e) { return body.points.count[e.element] > 0; });
    if (soil == elements.end()) continue;
    const double area = site::find_outward_normal(body.mesh(), soil->element, soil->opposite).second;
    const std::array<Vec<D>, D> force = integrate<D>(surface.traction[s], area);
    if (!on_points) {
      for (std::size_t c = 0; c < D; ++c) load.entries.push_back({surface.sides[s][c], force[c]});
      continue;
    }
    Vec<D> sum{};
    for (const Vec<D>& f : force)
      for (std::size_t d = 0; d < D; ++d) sum[d] += f[d];
    load_nearest_points(body, *soil, sum, load);
  }
  return load;
}

/// Nodal forces -V p ∇N of pressures that are positive in tension.
template <int D>
mpm::Load<D> make_pore_load(const mpm::Body<D>& body, const std::vector<std::array<double, D + 1>>& pore) {
  mpm::Load<D> load;
  for (int e = 0; e < body.mesh().element_count(); ++e) {
    if (body.points.count[e] == 0) continue;
    double mean = 0;
    for (const double p : pore[e]) mean += p / (D + 1);
    if (mean == 0) continue;
    for (int k = 0; k <= D; ++k) {
      const std::array<double, D> gradient = mesh::find_shape_gradient(body.mesh(), e, k);
      Vec<D> force;
      for (std::size_t d = 0; d < D; ++d) force[d] = -body.mesh().volumes[e] * mean * gradient[d];
      load.entries.push_back({body.mesh().elements[e][k], force});
    }
  }
  return load;
}

/// Throws if a given pressure acts in soil without pore water of its own: that of the other soils moves, and would
/// drain there.
template <int D>
void check_given_pressures(const input::Case& data, const mesh::Mesh<D>& mesh, const site::HeldWater<D>& given) {
  constexpr double noticeable = 1e-6;  // of the pressure of water as deep as the section
  const auto [low, high] = std::minmax_element(mesh.nodes.begin(), mesh.nodes.end(),
                                               [](const Vec<D>& a, const Vec<D>& b) { return a[1] < b[1]; });
  const double least = noticeable * site::find_water_weight(data) * ((*high)[1] - (*low)[1]);
  for (int e = 0; e < mesh.element_count(); ++e) {
    const std::array<double, D + 1>& pore = given.pore[static_cast<std::size_t>(e)];
    if (*std::min_element(pore.begin(), pore.end()) >= -least) continue;
    const std::string& region = mesh.region_names[static_cast<std::size_t>(mesh.element_region[e])];
    if (const std::string& soil = data.regions.at(region); input::has_effective_strength(data.materials.at(soil)))
      throw Error(ExitCode::wrong_input, input::describe_missing_water(soil));
  }
}

}  // namespace

template <int D>
site::HeldWater<D> find_carried_water(const input::Case& data, const mesh::Mesh<D>& mesh) {
  if (data.gravity.acceleration == 0) return {};
  if (!site::has_water(data)) {
    const bool has_table = data.initial.water.pressure == input::InitialPressure::water_table;
    if (!has_table && !site::has_pressure_field(data) && !site::has_pressure_ratio(data)) return {};
    return site::find_held_water<D>(data, mesh);
  }
  site::HeldWater<D> held = site::find_given_water<D>(data, mesh);
  check_given_pressures<D>(data, mesh, held);
  held.pore.assign(mesh.elements.size(), {});
  held.acts = site::has_pressure_ratio(data) &&
              site::add_pressure_ratio<D>(data, mesh, site::find_held_water<D>(data, mesh).unit_weight, held.pore);
  return held;
}

template <int D>
std::vector<double> find_ground_load(const site::Site& site, const std::vector<Vec<D>>& places) {
  std::vector<double> load;
  const bool has_water = has_standing_water(site);
  for (const Vec<D>& x : places)
    load.push_back(site.find_surcharge(x[0]) + (has_water ? site.find_standing_load(x[0]) : 0) +
                   (site.has_ground() ? site.find_slurry_pressure(x[0], site::find_level(site.ground(), x[0])) : 0));
  return load;
}

template <int D>
void add_ground_loads(mpm::Body<D>& body, const site::Site& site, const site::HeldWater<D>& held) {
  const input::Case& data = site.data();
  const auto add = [&](mpm::Load<D> load) {
    if (load.entries.empty()) return;
    load.factor = make_growth(data);
    body.conditions.loads.push_back(std::move(load));
  };
  const site::ActingLoads acting{.standing_water = has_standing_water(site), .hydraulics = false, .tractions = false};
  for (const fem::SurfaceLoad<D>& surface : site::make_surface_loads<D>(site, body.mesh(), acting))
    add(make_side_load<D>(body, surface, moves(data)));
  if (held.acts) add(make_pore_load<D>(body, held.pore));
}

#define TALUS_INSTANTIATE(D)                                                                       \
  template site::HeldWater<D> find_carried_water<D>(const input::Case&, const mesh::Mesh<D>&);     \
  template std::vector<double> find_ground_load<D>(const site::Site&, const std::vector<Vec<D>>&); \
  template void add_ground_loads<D>(mpm::Body<D>&, const site::Site&, const site::HeldWater<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
