// SPDX-License-Identifier: MIT
#include "run/mpm/start/initial_state.hpp"

#include <algorithm>
#include <limits>
#include <string_view>

#include "ground/root_content.hpp"
#include "mpm/body/observe.hpp"
#include "mpm/body/point_state.hpp"

namespace talus::run {
namespace {

using State = std::array<double, material::max_state_size>;

State make_state(const material::Law& law, const input::Material& soil, const material::StateStart& start) {
  State state{};
  material::set_initial_state(law, soil, start, state.data());
  return state;
}

/// Saturation that the laws see: 1 in soil without pore water.
template <int D>
double find_saturation(const mpm::PointView<D>& point) {
  return point.wet ? point.saturation : 1;
}

/// Void ratio of a point, from its grains and its volume.
template <int D>
double find_void_ratio(const mpm::PointView<D>& point, const input::Material& soil) {
  return std::max(0.0, point.volume * soil.grain_density / point.mass - 1);
}

/// Whether a point's preconsolidation is open.
bool lacks_preconsolidation(const material::Law& law, const double* state) {
  return std::visit(
      [&]<class L>([[maybe_unused]] const L& l) {
        if constexpr (material::IsPreconsolidated<L>) return !L::is_set(l.find_preconsolidation(state, 1));
        return false;
      },
      law);
}

/// The state of a point after a change of its material.
template <int D>
State adopt(const mpm::PointView<D>& point, const State& fresh, const material::Law& law, const input::Material& soil,
            input::MaterialModel before, bool same_roots) {
  const material::Traits &now = soil.traits(), &then = material::get_traits(before);
  const bool stays_in_family = *now.family && std::string_view(now.family) == then.family;
  // If a run ended before its preconsolidation was set, the next case that gives one sets it.
  const bool lacks_one =
      stays_in_family && lacks_preconsolidation(law, point.state.data()) && soil.preconsolidation.has_value();
  if (soil.model == before && !lacks_one && (same_roots || now.roots == material::RootEffect::none)) return point.state;
  // The law itself puts a content or a cohesion where it keeps them: the fresh state has them.
  const auto kept = static_cast<std::size_t>(stays_in_family ? now.family_states : material::common_state_size);
  material::StateStart start{point.stress.data(), find_void_ratio(point, soil), find_saturation(point)};
  start.level = point.position[1];
  material::read_roots(law, fresh.data(), start);
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
  // A step without strain moves a stress beyond the yield surface back to it.
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
  const std::vector<ground::RootsAt> roots = ground::find_roots<D>(data, mesh, places, soils);
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto& p = points[i];
    const auto number = static_cast<std::size_t>(p.material);
    const double saturation =
        soils[i]->water.is_wet() && !water.empty() ? material::saturation(water[number].retention, p.pressure) : 1.0;
    p.state = make_state(
        laws[number], *soils[i],
        {p.stress.data(), soils[i]->void_ratio(), saturation, roots[i].content, roots[i].cohesion, places[i][1]});
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

}  // namespace talus::run
