// SPDX-License-Identifier: MIT
#include "run/mpm/start/prepare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include "base/error.hpp"
#include "input/case/soil_water_law.hpp"
#include "material/every_law.hpp"
#include "mesh/locate.hpp"
#include "mesh/points.hpp"
#include "mpm/kernels/pore_state.hpp"
#include "mpm/kernels/softening.hpp"
#include "mpm/solver/observe.hpp"
#include "run/common/soil_column.hpp"
#include "run/mpm/start/bars.hpp"
#include "run/mpm/start/conditions.hpp"
#include "run/mpm/start/end_state.hpp"
#include "site/initial_water.hpp"
#include "site/known_state.hpp"
#include "site/pore_water.hpp"
#include "site/roots.hpp"

namespace talus::run {

namespace {

using State = std::array<double, material::max_state_size>;

State make_state(const material::Law& law, const input::Material& soil, const material::StateStart& start) {
  State state{};
  material::set_initial_state(law, soil, start, state.data());
  return state;
}

/// Saturation for the laws; 1 in soil without pore water.
template <int D>
double find_saturation(const mpm::PointView<D>& point) {
  return point.wet ? point.saturation : 1;
}

/// Void ratio of a point, from its grains and its volume.
template <int D>
double find_void_ratio(const mpm::PointView<D>& point, const input::Material& soil) {
  return std::max(0.0, point.volume * soil.grain_density / point.mass - 1);
}

/// Returns true if the preconsolidation of a point is not set yet.
bool lacks_preconsolidation(const material::Law& law, const double* state) {
  return std::visit(
      [&]<class L>([[maybe_unused]] const L& l) {
        if constexpr (material::IsPreconsolidated<L>) return !L::is_set(l.find_preconsolidation(state, 1));
        return false;
      },
      law);
}

/// Returns the state of a point after a change of its material.
template <int D>
State adopt(const mpm::PointView<D>& point, const State& fresh, const material::Law& law, const input::Material& soil,
            input::MaterialModel before, bool same_roots) {
  const material::Traits &now = soil.traits(), &then = material::get_traits(before);
  const bool stays_in_family = *now.family && std::string_view(now.family) == then.family;
  // If the previous run ended before its preconsolidation was set, the next case that gives one sets it.
  const bool lacks_one =
      stays_in_family && lacks_preconsolidation(law, point.state.data()) && soil.preconsolidation.has_value();
  // The fresh state has the water content, and the cohesion or strength of the place, of the new law.
  material::StateStart start{point.stress.data(), find_void_ratio(point, soil), find_saturation(point)};
  start.level = point.position[1];
  material::read_start(law, fresh.data(), start);
  const bool is_same = material::find_local_model(soil.model, soil).value_or(soil.model) == before;
  if (is_same && !lacks_one && (same_roots || start.strength_growth || now.roots == material::RootEffect::none)) {
    State state = point.state;
    if (start.strength_growth) state[1] = *start.strength_growth;
    return state;
  }
  const auto kept = static_cast<std::size_t>(stays_in_family ? now.family_states : material::common_state_size);
  State renewed = make_state(law, soil, start);
  const double preconsolidation = renewed[1];
  std::copy_n(point.state.begin(), kept, renewed.begin());
  if (lacks_one) renewed[1] = preconsolidation;
  return renewed;
}

/// Sets the preconsolidation of a point, unless it has one, and counts it.
template <class L, int D>
bool set_point(const L& law, double ratio, const mpm::PointView<D>& point, State& state,
               results::Preconsolidation& done) {
  const double saturation = find_saturation(point);
  if (L::is_set(law.find_preconsolidation(state.data(), saturation))) return false;
  law.set_preconsolidation(ratio, point.stress.data(), state.data());
  const double pressure = law.find_preconsolidation(state.data(), saturation);
  ++done.points;
  done.smallest = std::min(done.smallest, pressure);
  done.largest = std::max(done.largest, pressure);
  // An update without strain returns a stress beyond the yield surface to it.
  constexpr int NS = material::stress_size<D>;
  std::array<double, NS> stress = point.stress, none{};
  State after = state;
  material::Surroundings<double> around;
  around.saturation = saturation;
  law.template update<NS>(stress.data(), none.data(), after.data(), true, around);
  if (after[0] > state[0]) ++done.beyond;
  return true;
}

}  // namespace

template <int D>
void set_initial_state(const input::Case& data, const mesh::Mesh<D>& mesh, const std::vector<material::Law>& laws,
                       const std::vector<std::string>& names, const std::vector<mpm::WaterLaw>& water,
                       std::vector<mpm::InitialPoint<D>>& points) {
  std::vector<const input::Material*> by_number, soils;
  for (const std::string& name : names) by_number.push_back(&data.materials.at(name));
  std::vector<Vec<D>> places;
  for (const auto& p : points) {
    soils.push_back(by_number[static_cast<std::size_t>(p.material)]);
    places.push_back(mesh::to_global(mesh, p.element, p.xi));
  }
  const std::vector<site::RootsAt> roots = site::find_roots<D>(data, mesh, places, soils);
  const SoilColumns columns(data);
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto& p = points[i];
    const auto number = static_cast<std::size_t>(p.material);
    const double saturation =
        soils[i]->water.is_wet() && !water.empty() ? material::saturation(water[number].retention, p.pressure) : 1.0;
    material::StateStart start{p.stress.data(),  soils[i]->void_ratio(), saturation,
                               roots[i].content, roots[i].cohesion,      places[i][1]};
    add_column<D>(columns, places[i], start);
    p.state = make_state(laws[number], *soils[i], start);
  }
}

template <int D>
void adopt_state(mpm::Body<D>& body, const input::Case& data, const mpm::Body<D>& fresh,
                 const std::vector<input::MaterialModel>& before, bool same_roots) {
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto at = static_cast<std::size_t>(id);
    const std::size_t number = body.points.material[at];
    const State state = adopt(mpm::view_point(body, id), mpm::view_point(fresh, id).state, body.laws[number],
                              data.materials.at(body.material_names[number]), before[at], same_roots);
    mpm::write_state(body, id, state.data());
  }
}

bool is_equilibrium_stage(const input::Case& data, int stage) {
  if (data.initial.equilibrium.empty()) return stage == 0;
  return data.stages[static_cast<std::size_t>(stage)].name == data.initial.equilibrium;
}

template <int D>
results::Preconsolidation set_preconsolidation(mpm::Body<D>& body, const input::Case& data) {
  results::Preconsolidation done{.smallest = std::numeric_limits<double>::infinity()};
  for (int id = 0; id < body.points.size(); ++id) {
    const std::size_t number = body.points.material[static_cast<std::size_t>(id)];
    const input::Material& soil = data.materials.at(body.material_names[number]);
    if (!mpm::is_present(body, id) || !soil.preconsolidation_ratio) continue;
    const mpm::PointView<D> point = mpm::view_point(body, id);
    State state = point.state;
    const bool is_changed = std::visit(
        [&]<class L>([[maybe_unused]] const L& law) {
          if constexpr (material::IsPreconsolidated<L>)
            return set_point(law, *soil.preconsolidation_ratio, point, state, done);
          return false;
        },
        body.laws[number]);
    if (is_changed) mpm::write_state(body, id, state.data());
  }
  if (done.points == 0) done.smallest = 0;
  return done;
}

template <int D>
using Points = std::vector<mpm::InitialPoint<D>>;
#define TALUS_INSTANTIATE(D)                                                                                          \
  template void set_initial_state<D>(const input::Case&, const mesh::Mesh<D>&, const std::vector<material::Law>&,     \
                                     const std::vector<std::string>&, const std::vector<mpm::WaterLaw>&, Points<D>&); \
  template void adopt_state<D>(mpm::Body<D>&, const input::Case&, const mpm::Body<D>&,                                \
                               const std::vector<input::MaterialModel>&, bool);                                       \
  template results::Preconsolidation set_preconsolidation<D>(mpm::Body<D>&, const input::Case&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

namespace {

int find_material(const std::vector<std::string>& names, const std::string& name) {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw Error(ExitCode::wrong_input, fmt::format("there is no material '{}'", name));
  return static_cast<int>(at - names.begin());
}

/// Returns the law of a material; if its cohesion varies in space, the one with cohesion as a state variable.
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

/// Sets the vertical effective stress of the overburden of soil and water, and K0 times it horizontally.
template <int D>
void set_k0_stress(const input::Case& data, const mesh::Mesh<D>& mesh, const std::vector<std::string>& names,
                   const std::vector<mpm::WaterLaw>& laws, const site::InitialWater<D>& water,
                   const site::HeldWater<D>& held, std::vector<mpm::InitialPoint<D>>& points) {
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
    const double given = held.unit_weight.empty() ? 0 : held.unit_weight[p.element];
    unit_weight[p.element] = given > 0 ? given : density * data.gravity.acceleration;
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
  std::vector<Vec<D>> at;
  for (const auto& p : points) at.push_back(mesh::to_global(mesh, p.element, p.xi));
  if (!laws.empty()) {
    const std::vector<double> ponded = site::find_ponded_load<D>(data, mesh, at);
    for (std::size_t i = 0; i < points.size(); ++i) overburden[i] += ponded[i];
  }
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

/// Returns stress and plastic strain of FEM at the points; empty if none was computed.
template <int D>
std::vector<site::StressAt> find_known_stress(const input::Initial& initial, const mesh::Mesh<D>& mesh,
                                              const std::vector<mpm::InitialPoint<D>>& points) {
  std::vector<site::StressAt> known;
  if constexpr (D == 2) {
    if (!initial.known_stress) return known;
    site::StressReader reader(*initial.known_stress, mesh);
    for (const mpm::InitialPoint<D>& p : points) known.push_back(reader.read(p.element, p.xi));
  }
  return known;
}

/// Returns the water laws by material number (list_materials); empty if no soil has pore water.
std::vector<mpm::WaterLaw> make_water_laws(const input::Case& data) {
  std::vector<mpm::WaterLaw> laws;
  if (!site::has_water(data)) return laws;
  for (const auto& [name, m] : data.materials) {
    mpm::WaterLaw law;
    law.grain_density = m.grain_density;
    law.density = data.water.density;
    law.bulk_modulus = data.water.bulk_modulus;
    law.drag_gravity = data.water.drag_gravity;
    law.wet = m.water.is_wet();
    if (law.wet) {
      law.conductivity = input::find_saturated_conductivity(m.water, data.water, data.water.drag_gravity);
      law.retention = input::make_retention(m.water);
      law.relative = input::make_relative_conductivity(m.water);
      if (m.water.chi == input::BishopChi::khalili_khabbaz) law.chi_air_entry = m.water.chi_air_entry;
    }
    laws.push_back(law);
  }
  return laws;
}

/// Fills the mesh of a case with material points.
template <int D>
mpm::Body<D> fill_mesh(const input::Case& data, mesh::Mesh<D> mesh, int points_per_element, int chunks,
                       std::optional<fem::SeepageResult<D>>* seepage, std::optional<site::SeasonRecord>* season) {
  const std::vector<std::string> names = list_materials(data);
  if (names.size() > 32)
    throw Error(ExitCode::wrong_input, fmt::format("{} materials are too many; at most 32 are possible", names.size()));
  const std::vector<int> material_of_region = assign_materials(data, mesh, names);
  const std::vector<mpm::WaterLaw> water_laws = make_water_laws(data);
  site::InitialWater<D> water = site::find_initial_water<D>(data, mesh);
  const site::HeldWater<D> held = find_carried_water<D>(data, mesh);
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
    const double given = held.unit_weight.empty() ? 0 : held.unit_weight[e];
    point.mass = point.volume *
                 (given > 0 ? given / data.gravity.acceleration : data.materials.at(names[point.material]).density());
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
  const std::vector<site::StressAt> known = find_known_stress<D>(data.initial, mesh, points);
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
  resolve_root_uptakes(body, data);
  add_bars(body, data);
  if (data.softening_length) mpm::set_softening_length(body, *data.softening_length);
  body.water.darcy.pressure = site::find_nodal_pressures<D>(data, body.mesh(), water);
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
  for (mpm::Bar& bar : body.bars) bar.divisor = bar.reduces_bond ? factor : 1;
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
  const Vec<D> added = site::Site(data).find_earthquake<D>();
  for (std::size_t d = 0; d < D; ++d) g[d] += data.gravity.acceleration * added[d];
  return g;
}

template <int D>
mpm::Body<D> prepare(const input::Case& data, mesh::Mesh<D> mesh, int chunks,
                     std::optional<fem::SeepageResult<D>>* seepage, std::optional<site::SeasonRecord>* season) {
  if (data.initial.result.empty())
    return fill_mesh(data, std::move(mesh), data.points_per_element, chunks, seepage, season);
  // Conditions belong to the nodes and points of the filled mesh, and move with the soil from there.
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
  // The height is that of the corners of elements with points, which is the height of the polygon, not of the points.
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
                                   std::optional<site::SeasonRecord>*);                                           \
  template double find_soil_height<D>(const mpm::Body<D>&, const input::Gravity&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
