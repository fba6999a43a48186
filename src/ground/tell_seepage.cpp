// SPDX-License-Identifier: MIT
#include "ground/tell_seepage.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "ground/initial_water.hpp"
#include "ground/plane_water.hpp"
#include "ground/pore_water.hpp"
#include "results/run.hpp"

namespace talus::ground {
namespace {

/// A mesh with more elements would be the largest part of the folder, and too fine to be seen.
constexpr std::size_t most_elements = 60000;
/// Columns and rows of the triangles on which water at rest is told.
constexpr int columns = 120, rows = 30;

template <std::size_t D>
std::vector<double> to_list(const std::array<double, D>& x) {
  return {x.begin(), x.end()};
}

/// Six digits: as many as a picture or a comparison needs.
double shorten(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5);
  return std::round(value / unit) * unit;
}

/// To a hundredth of a millimetre, whatever the origin: six digits of a map's coordinate would be metres.
results::Point shorten_place(double x, double y) {
  constexpr double per_metre = 1e5;
  return {std::round(x * per_metre) / per_metre, std::round(y * per_metre) / per_metre};
}

template <int D>
void tell_sides(const fem::SeepageResult<D>& r, std::vector<results::Discharge>& discharges,
                std::vector<results::SeepageExit>& exits) {
  for (const fem::Discharge& d : r.discharges) discharges.push_back({d.name, d.inflow, d.outflow, d.runoff});
  for (const fem::FaceExtent<D>& e : r.exits) exits.push_back({e.name, to_list(e.highest), to_list(e.lowest)});
}

/// Nothing where slices would find no ground: only pictures want it here.
Polyline look_for_ground(const input::Case& data) {
  if (data.mesh.dimension != 2 || data.mesh.polygons.empty()) return {};
  try {
    return find_ground(data.mesh);
  } catch (const Error&) {
    return {};
  }
}

std::vector<results::StandingWater> tell_ponds(const std::vector<Pond>& ponds) {
  std::vector<results::StandingWater> told;
  for (const Pond& p : ponds) told.push_back({p.from, p.to, p.level_from, p.level_to});
  return told;
}

/// The elements of soil with pore water; `mesh` is that of the flow calculation.
template <int D>
std::vector<std::vector<int>> list_elements(const mesh::Mesh<D>& mesh) {
  std::vector<std::vector<int>> list;
  for (int e = 0; e < mesh.element_count(); ++e)
    if (mesh.element_region[e] != mesh::empty_region)
      list.emplace_back(mesh.elements[e].begin(), mesh.elements[e].end());
  return list;
}

/// The places at which table and ground may cross or bend, from left to right.
std::vector<double> list_breaks(const Polyline& table, const Polyline& ground) {
  const double left = ground.front()[0], right = ground.back()[0], step = 1e-7 * (right - left);
  std::vector<double> breaks{left, right};
  for (const Polyline* line : {&table, &ground})
    for (const Point& x : *line)
      if (x[0] > left && x[0] < right) breaks.push_back(x[0]);
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> all;
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    all.push_back(breaks[i]);
    if (i + 1 == breaks.size() || breaks[i + 1] - breaks[i] <= 2 * step) continue;
    const auto over = [&](double x) { return find_water_table(table, x) - find_level(ground, x); };
    const double a = breaks[i] + step, b = breaks[i + 1] - step, before = over(a), after = over(b);
    if (before * after < 0) all.push_back(a + (b - a) * before / (before - after));
  }
  return all;
}

/// A point straight on from the last piece takes the place of its end.
void extend(std::vector<results::Point>& line, const Point& x) {
  const auto n = line.size();
  if (n > 1) {
    const Point &a = line[n - 2], &b = line[n - 1];
    const double cross = (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]);
    if (std::abs(cross) <= 1e-9 * (x[0] - a[0]) * (x[0] - a[0])) line.pop_back();
  }
  line.push_back(x);
}

/// A table that lies above the ground in places: the part in the soil, and the ponds over it.
void split_table(const Polyline& table, const std::vector<Pond>& ponds, const Polyline& ground,
                 results::WaterState& state) {
  const std::vector<double> breaks = list_breaks(table, ground);
  const double step = 1e-7 * (ground.back()[0] - ground.front()[0]), no_depth = 10 * step;
  bool goes_on = false;
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const double a = breaks[i - 1], b = breaks[i], middle = (a + b) / 2;
    if (b - a <= 2 * step) continue;
    const double y = find_water_table(table, middle);
    if (find_standing_level(ponds, {}, ground, middle)) {
      goes_on = false;
    } else if (y > find_level(ground, middle) + no_depth) {
      state.ponds.push_back({{a, find_level(ground, a + step)},
                             {b, find_level(ground, b - step)},
                             find_water_table(table, a),
                             find_water_table(table, b)});
      goes_on = false;
    } else {
      if (!goes_on) state.water_table.push_back({{a, find_water_table(table, a)}});
      extend(state.water_table.back(), {b, find_water_table(table, b)});
      goes_on = true;
    }
  }
}

/// The water table of the case; nothing in a case without.
std::optional<results::WaterState> tell_table_state(const input::Case& data, double time) {
  const input::InitialWater& initial = data.initial.water;
  if (initial.pressure != input::InitialPressure::water_table || initial.water_table.empty()) return std::nullopt;
  const Polyline ground = look_for_ground(data);
  if (ground.empty()) return std::nullopt;
  results::WaterState state;
  state.time = time;
  const std::vector<Pond> ponds = find_ponds(data, ground, time);
  state.ponds = tell_ponds(ponds);
  split_table(initial.water_table, ponds, ground, state);
  return state;
}

/// Water at rest under the table of the case, on triangles between the ground and the lower end of the soil.
results::WaterFields lay_fields(const input::Case& data, const Polyline& ground) {
  const double base = find_base(data.mesh), left = ground.front()[0], right = ground.back()[0];
  std::vector<double> places;
  for (int c = 0; c <= columns; ++c) places.push_back(left + (right - left) * c / columns);
  for (const Point& x : ground)
    for (const double side : {-1e-6, 1e-6}) places.push_back(x[0] + side * (right - left));
  std::sort(places.begin(), places.end());
  std::erase_if(places, [&](double x) { return x < left || x > right; });
  results::WaterFields told;
  told.unit_weight = find_water_weight(data);
  results::WaterField& field = told.states.emplace_back();
  for (const double x : places)
    for (int r = 0; r <= rows; ++r) {
      const double y = base + (find_level(ground, x) - base) * r / rows;
      const double p = told.unit_weight * (find_water_table(data.initial.water.water_table, x) - y);
      told.nodes.push_back(shorten_place(x, y));
      field.pressure.push_back(shorten(std::max(p, -data.initial.water.largest_suction)));
    }
  for (int c = 0; c + 1 < static_cast<int>(places.size()); ++c)
    for (int r = 0; r < rows; ++r) {
      const int a = c * (rows + 1) + r, b = a + rows + 1;
      told.elements.push_back({a, b, b + 1});
      told.elements.push_back({a, b + 1, a + 1});
    }
  return told;
}

}  // namespace

template <int D>
results::Seepage tell_seepage(const mesh::Mesh<D>& mesh, const fem::SeepageResult<D>& r) {
  results::Seepage told;
  told.inflow = r.inflow;
  told.outflow = r.outflow;
  told.balance_error = r.balance_error;
  told.iterations = r.iterations;
  told.undecided = r.undecided;
  const auto driest =
      static_cast<std::size_t>(std::max_element(r.pressure.begin(), r.pressure.end()) - r.pressure.begin());
  told.largest_suction = r.pressure[driest];
  told.largest_suction_at = to_list(mesh.nodes[driest]);
  tell_sides<D>(r, told.discharges, told.exits);
  for (const auto& line : r.water_table) {
    auto& points = told.water_table.emplace_back();
    for (const auto& x : line) points.push_back(to_list(x));
  }
  return told;
}

template <int D>
results::WaterState tell_state(const input::Case& data, const fem::SeepageResult<D>& r, results::WaterFlow flow,
                               double time) {
  results::WaterState told;
  told.flow = flow;
  told.time = time;
  told.inflow = r.inflow;
  told.outflow = r.outflow;
  told.storage_rate = r.storage_rate;
  tell_sides<D>(r, told.discharges, told.exits);
  if constexpr (D == 2)
    for (const auto& line : r.water_table) told.water_table.emplace_back(line.begin(), line.end());
  if (const Polyline ground = look_for_ground(data); !ground.empty())
    told.ponds = tell_ponds(find_ponds(data, ground, time));
  return told;
}

template <int D>
results::WaterField tell_field(const mesh::Mesh<D>& wet_mesh, const fem::SeepageResult<D>& r, results::WaterFlow flow,
                               double time) {
  results::WaterField told;
  told.flow = flow;
  told.time = time;
  for (const double p : r.pressure) told.pressure.push_back(-shorten(p));
  for (int e = 0; e < wet_mesh.element_count(); ++e) {
    if (wet_mesh.element_region[e] == mesh::empty_region) continue;
    told.saturation.push_back(shorten(r.saturation[e]));
    auto& velocity = told.velocity.emplace_back();
    for (const double v : r.velocity[e]) velocity.push_back(shorten(v));
  }
  return told;
}

std::optional<results::WaterFields> begin_fields(const input::Case& data, const mesh::Mesh<2>& wet_mesh) {
  results::WaterFields fields;
  fields.elements = list_elements<2>(wet_mesh);
  if (fields.elements.size() > most_elements) return std::nullopt;
  fields.unit_weight = find_water_weight(data);
  for (const auto& x : wet_mesh.nodes) fields.nodes.push_back(shorten_place(x[0], x[1]));
  return fields;
}

template <int D>
ToldWater tell_water(const input::Case& data, const mesh::Mesh<D>& mesh,
                     const std::optional<fem::SeepageResult<D>>& steady, const std::optional<SeasonRecord>& season) {
  ToldWater told;
  if (data.initial.water.known) return told;  // who found it has told of it
  if (!steady && !season) return tell_water_table(data);
  const double start = season ? season->rows.front().time : 0;
  std::vector<results::WaterState>& states = told.states.emplace();
  if (steady) {
    told.seepage = tell_seepage<D>(mesh, *steady);
    states.push_back(tell_state<D>(data, *steady, results::WaterFlow::steady, start));
  } else if (auto first = tell_table_state(data, start)) {
    states.push_back(std::move(*first));
  }
  if (season) {
    told.season = tell_season(*season);
    states.insert(states.end(), season->states.begin(), season->states.end());
  }
  if constexpr (D == 2) {
    mesh::Mesh<2> wet = mesh;
    for (int e = 0; e < mesh.element_count(); ++e)
      if (const input::Material* soil = find_soil(data, mesh, e); soil == nullptr || !soil->water.is_wet())
        wet.element_region[e] = mesh::empty_region;
    told.fields = begin_fields(data, wet);
    if (!told.fields) return told;
    auto& fields = told.fields->states;
    if (steady) fields.push_back(tell_field<2>(wet, *steady, results::WaterFlow::steady, start));
    if (season) fields.insert(fields.end(), season->fields.begin(), season->fields.end());
  }
  return told;
}

ToldWater tell_water_table(const input::Case& data) {
  ToldWater told;
  if (auto state = tell_table_state(data, 0)) {
    told.states = std::vector{std::move(*state)};
    told.fields = lay_fields(data, look_for_ground(data));
  }
  return told;
}

void add_lowered_state(const input::Case& data, const Polyline& table, ToldWater& told) {
  const Polyline ground = look_for_ground(data);
  if (ground.empty()) return;
  if (!told.states) told.states.emplace();
  results::WaterState& state = told.states->emplace_back();
  state.flow = results::WaterFlow::lowered;
  split_table(table, {}, ground, state);
  if (!told.fields) return;
  results::WaterField& field = told.fields->states.emplace_back();
  field.flow = state.flow;
  for (const results::Point& x : told.fields->nodes)
    field.pressure.push_back(shorten(std::max(told.fields->unit_weight * (find_water_table(table, x[0]) - x[1]),
                                              -data.initial.water.largest_suction)));
}

void give(const ToldWater& water, results::RunResult& run) {
  if (!run.seepage) run.seepage = water.seepage;
  if (!run.season) run.season = water.season;
  if (!run.water_states) run.water_states = water.states;
}

#define TALUS_INSTANTIATE(D)                                                                                         \
  template results::Seepage tell_seepage<D>(const mesh::Mesh<D>&, const fem::SeepageResult<D>&);                     \
  template results::WaterState tell_state<D>(const input::Case&, const fem::SeepageResult<D>&, results::WaterFlow,   \
                                             double);                                                                \
  template results::WaterField tell_field<D>(const mesh::Mesh<D>&, const fem::SeepageResult<D>&, results::WaterFlow, \
                                             double);                                                                \
  template ToldWater tell_water<D>(const input::Case&, const mesh::Mesh<D>&,                                         \
                                   const std::optional<fem::SeepageResult<D>>&, const std::optional<SeasonRecord>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::ground
