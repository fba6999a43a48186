// SPDX-License-Identifier: MIT
#include "run/mpm/start/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "ground/ground_line.hpp"
#include "ground/initial_water.hpp"
#include "ground/known_stress.hpp"
#include "ground/pore_water.hpp"
#include "ground/root_sink.hpp"
#include "mesh/column.hpp"
#include "mesh/points.hpp"
#include "mpm/body/observe.hpp"
#include "mpm/coupled/pore_state.hpp"
#include "mpm/step/softening.hpp"
#include "run/mpm/start/conditions.hpp"
#include "run/mpm/start/end_state.hpp"
#include "run/mpm/start/ground_loads.hpp"
#include "run/mpm/start/initial_state.hpp"
#include "run/mpm/start/water_conditions.hpp"

namespace talus::run {
namespace {

int find_material(const std::vector<std::string>& names, const std::string& name) {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw Error(ExitCode::wrong_input, fmt::format("there is no material '{}'", name));
  return static_cast<int>(at - names.begin());
}

/// The law of a material; where its cohesion varies from place to place, the one that has it as a state variable.
material::Law make_point_law(const input::Material& soil, std::optional<double> cohesion, double factor) {
  const auto local = material::find_local_model(soil.model, soil);
  if (!local || *local == soil.model) return input::make_law(soil, cohesion, factor);
  input::Material varied = soil;
  varied.model = *local;
  return input::make_law(varied, cohesion, factor);
}

/// Material number of each region of the mesh.
template <int D>
std::vector<int> assign_materials(const input::Case& data, const mesh::Mesh<D>& mesh,
                                  const std::vector<std::string>& names) {
  std::vector<int> material;
  for (const std::string& region : mesh.region_names) {
    const auto given = data.regions.find(region);
    if (given == data.regions.end()) {
      throw Error(ExitCode::wrong_input,
                  fmt::format("region '{}' of the mesh has no material; add it to [regions]", region));
    }
    material.push_back(find_material(names, given->second));
  }
  return material;
}

/// Vertical effective stress of the column of soil and water above, and K0 of it sideways.
template <int D>
void set_k0_stress(const input::Case& data, const mesh::Mesh<D>& mesh, const std::vector<std::string>& names,
                   const std::vector<mpm::WaterLaw>& laws, const ground::InitialWater<D>& water,
                   const ground::HeldWater<D>& held, std::vector<mpm::InitialPoint<D>>& points) {
  std::vector<double> unit_weight(mesh.elements.size(), 0.0), bishop(mesh.elements.size(), 0.0);
  for (const mpm::InitialPoint<D>& p : points) {
    const input::Material& m = data.materials.at(names[p.material]);
    double density = m.density();
    if (m.water.is_wet()) {
      const mpm::WaterLaw& law = laws[p.material];
      const double pressure = water.pressure[p.element];
      density += m.porosity * mpm::find_content(law, pressure) * law.density;
      bishop[p.element] = mpm::find_state_at_pressure(law, pressure).bishop;
    }
    unit_weight[p.element] =
        held.unit_weight.empty() ? density * data.gravity.acceleration : held.unit_weight[p.element];
    if (!held.acts) continue;
    double pore = 0;
    for (const double corner : held.pore[p.element]) pore += corner / (D + 1);
    if (pore != 0) bishop[p.element] = pore;
  }
  Vec<D> up = find_gravity<D>(data.gravity);
  const double g = norm(up);
  for (double& u : up) u /= -g;
  std::vector<mesh::LocalPoint<D>> places;
  for (const auto& p : points) places.push_back({p.element, p.xi});
  std::vector<double> overburden = mesh::overburden_integral<D>(mesh, unit_weight, places, up);
  if (!laws.empty()) {
    const std::vector<double> ponded = ground::find_ponded_load<D>(data, mesh, points);
    for (std::size_t i = 0; i < points.size(); ++i) overburden[i] += ponded[i];
  }
  std::vector<Vec<D>> at;
  for (const auto& p : points) at.push_back(mesh::to_global(mesh, p.element, p.xi));
  const std::vector<double> above = find_ground_load<D>(data, at);
  for (std::size_t i = 0; i < points.size(); ++i) {
    overburden[i] += above[i];
    const input::Material& m = data.materials.at(names[points[i].material]);
    const double k0 = data.initial.k0.value_or(m.poisson_ratio / (1 - m.poisson_ratio));
    const double vertical = -overburden[i] - bishop[points[i].element], sideways = k0 * vertical;  // σ = σ' + χp
    // σ = sideways·I + (vertical - sideways) up⊗up
    auto& s = points[i].stress;
    for (std::size_t d = 0; d < 3; ++d) s[d] = sideways;
    const double extra = vertical - sideways;
    for (std::size_t d = 0; d < D; ++d) s[d] += extra * up[d] * up[d];
    s[3] = extra * up[0] * up[1];
    if constexpr (D == 3) {
      s[4] = extra * up[1] * up[2];
      s[5] = extra * up[2] * up[0];
    }
  }
}

/// Stress and plastic strain of finite elements at the points; empty where none were calculated.
template <int D>
std::vector<ground::StressAt> find_known_stress(const input::Initial& initial, const mesh::Mesh<D>& mesh,
                                                const std::vector<mpm::InitialPoint<D>>& points) {
  std::vector<ground::StressAt> known;
  if constexpr (D == 2) {
    if (!initial.known_stress) return known;
    ground::StressReader reader(*initial.known_stress, mesh);
    for (const mpm::InitialPoint<D>& p : points) known.push_back(reader.read(p.element, p.xi));
  }
  return known;
}

/// A body whose soil is where the mesh says.
template <int D>
mpm::Body<D> fill_mesh(const input::Case& data, mesh::Mesh<D> mesh, int points_per_element, int chunks,
                       std::optional<fem::SeepageResult<D>>* seepage, std::optional<ground::SeasonRecord>* season) {
  const std::vector<std::string> names = list_materials(data);
  if (names.size() > 32)
    throw Error(ExitCode::wrong_input, fmt::format("{} materials are too many; at most 32 are possible", names.size()));
  const std::vector<int> material_of_region = assign_materials(data, mesh, names);
  const std::vector<mpm::WaterLaw> water_laws = ground::make_water_laws(data);
  ground::InitialWater<D> water = ground::find_initial_water<D>(data, mesh);
  const ground::HeldWater<D> held = find_carried_water<D>(data, mesh);
  const auto positions = mesh::point_positions<D>(points_per_element);
  std::vector<mpm::InitialPoint<D>> points;
  std::vector<int> in_element(mesh.elements.size(), 0);
  for (int e = 0; e < mesh.element_count(); ++e) {
    const int region = mesh.element_region[e];
    if (region < 0) continue;
    const std::string& region_name = mesh.region_names[region];
    mpm::InitialPoint<D> point;
    point.element = e;
    point.material = material_of_region[region];
    point.volume = mesh.volumes[e] / points_per_element;
    point.mass = point.volume * (held.unit_weight.empty() ? data.materials.at(names[point.material]).density()
                                                          : held.unit_weight[e] / data.gravity.acceleration);
    if (const auto v = data.initial.velocity.find(region_name); v != data.initial.velocity.end()) {
      for (std::size_t d = 0; d < D; ++d) point.velocity[d] = v->second[d];
    }
    point.pressure = water.pressure[e];
    for (std::size_t d = 0; d < D; ++d) point.water_velocity[d] = point.velocity[d] + water.velocity[e][d];
    for (const auto& xi : positions) {
      point.xi = xi;
      points.push_back(point);
    }
    in_element[e] = points_per_element;
  }
  if (points.empty())
    throw Error(ExitCode::wrong_input, "no element of the mesh holds soil; check the polygons and the mesh size");
  if (data.initial.stress != input::InitialStress::none)
    set_k0_stress<D>(data, mesh, names, water_laws, water, held, points);
  const std::vector<ground::StressAt> known = find_known_stress<D>(data.initial, mesh, points);
  for (std::size_t i = 0; i < known.size(); ++i)
    std::copy_n(known[i].stress.begin(), points[i].stress.size(), points[i].stress.begin());

  std::vector<material::Law> laws;
  for (const std::string& name : names) laws.push_back(make_point_law(data.materials.at(name), {}, 1));
  set_initial_state<D>(data, mesh, laws, names, water_laws, points);
  for (std::size_t i = 0; i < known.size(); ++i) points[i].state[0] = known[i].plastic_strain;
  auto layout = mpm::make_layout<D>(std::move(mesh), in_element, chunks);
  mpm::Body<D> body = mpm::make_body<D>(std::move(layout), std::move(laws), names, points, water_laws);
  resolve_conditions(body, data);
  add_ground_loads(body, data, held);
  resolve_water_conditions(body, data);
  ground::resolve_root_uptakes(body, data);
  if (data.softening_length) mpm::set_softening_length(body, *data.softening_length);
  body.water.darcy.pressure = ground::find_nodal_pressures<D>(data, body.mesh(), water);
  if (seepage != nullptr) *seepage = std::move(water.seepage);
  if (season != nullptr) *season = std::move(water.season);
  return body;
}

}  // namespace

std::vector<std::string> list_materials(const input::Case& data) {
  std::vector<std::string> names;
  for (const auto& [name, material] : data.materials) names.push_back(name);
  return names;
}

template <int D>
void set_strength(mpm::Body<D>& body, const input::Case& data, std::optional<double> cohesion, double factor) {
  body.laws.clear();
  for (const std::string& name : body.material_names)
    body.laws.push_back(make_point_law(data.materials.at(name), cohesion, factor));
}

template <int D>
Vec<D> find_gravity(const input::Gravity& gravity) {
  Vec<D> g;
  for (std::size_t d = 0; d < D; ++d) g[d] = gravity.acceleration * gravity.direction[d];
  return g;
}

template <int D>
Vec<D> find_acceleration(const input::Case& data) {
  Vec<D> g = find_gravity<D>(data.gravity);
  if (data.earthquake.horizontal == 0 && data.earthquake.vertical == 0) return g;
  ground::Polyline ground;
  if (data.mesh.dimension == 2 && !data.mesh.polygons.empty()) ground = ground::find_ground(data.mesh);
  const Vec<D> added = ground::find_earthquake<D>(data, ground);
  for (std::size_t d = 0; d < D; ++d) g[d] += data.gravity.acceleration * added[d];
  return g;
}

template <int D>
mpm::Body<D> prepare(const input::Case& data, mesh::Mesh<D> mesh, int chunks,
                     std::optional<fem::SeepageResult<D>>* seepage, std::optional<ground::SeasonRecord>* season) {
  if (data.initial.result.empty())
    return fill_mesh(data, std::move(mesh), data.points_per_element, chunks, seepage, season);
  // Conditions belong to nodes and points as they were when the mesh was filled, and follow the soil from there.
  const EndState end(data.initial);
  mpm::Body<D> body = fill_mesh(data, end.get_mesh<D>(), end.points_per_element(), chunks, seepage, season);
  const bool has_state = std::any_of(body.laws.begin(), body.laws.end(), [](const material::Law& law) {
    return material::state_size(law) > material::common_state_size;
  });
  const mpm::Body<D> fresh = has_state ? body : mpm::Body<D>();
  end.take_over(body);
  if (has_state) adopt_state(body, data, fresh, end.list_models(), end.has_roots_of(data));
  return body;
}

template <int D>
double find_soil_height(const mpm::Body<D>& body, const input::Gravity& gravity) {
  // Corners of the elements that hold points, so that the height is the polygon's and not the points'.
  double lowest = std::numeric_limits<double>::max(), highest = std::numeric_limits<double>::lowest();
  for (int e = 0; e < body.mesh().element_count(); ++e) {
    if (body.points.count[e] == 0) continue;
    for (int i : body.mesh().elements[e]) {
      double height = 0;
      for (std::size_t d = 0; d < D; ++d) height -= gravity.direction[d] * body.mesh().nodes[i][d];
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
  }
  return highest - lowest;
}

#define TALUS_INSTANTIATE(D)                                                                                      \
  template void set_strength<D>(mpm::Body<D>&, const input::Case&, std::optional<double>, double);                \
  template Vec<D> find_gravity<D>(const input::Gravity&);                                                         \
  template Vec<D> find_acceleration<D>(const input::Case&);                                                       \
  template mpm::Body<D> prepare<D>(const input::Case&, mesh::Mesh<D>, int, std::optional<fem::SeepageResult<D>>*, \
                                   std::optional<ground::SeasonRecord>*);                                         \
  template double find_soil_height<D>(const mpm::Body<D>&, const input::Gravity&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
