// SPDX-License-Identifier: MIT
// Discharges, water tables, ponds and fields of seepage, season and water at rest, rounded for the results files.
#include "site/seepage_results.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mesh/planar.hpp"
#include "results/run.hpp"
#include "site/initial_water.hpp"
#include "site/pore_water.hpp"

namespace talus::site {

namespace {

/// Largest mesh whose fields are stored; a larger one would dominate the size of the results and be too fine for a
/// figure.
constexpr std::size_t most_elements = 60000;
/// Columns and rows of the triangles of the field of water at rest.
constexpr int columns = 120, rows = 30;

template <std::size_t D>
std::vector<double> to_list(const std::array<double, D>& x) {
  return {x.begin(), x.end()};
}

/// Rounds to six significant digits, enough for figures and comparisons.
double shorten(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5);
  return std::round(value / unit) * unit;
}

/// Rounds to 0.01 mm, independent of the origin: six significant digits of map coordinates would be metres.
results::Point shorten_place(double x, double y) {
  constexpr double per_metre = 1e5;
  return {std::round(x * per_metre) / per_metre, std::round(y * per_metre) / per_metre};
}

template <int D>
void add_side_discharges(const fem::SeepageResult<D>& r, std::vector<results::Discharge>& discharges,
                         std::vector<results::SeepageExit>& exits) {
  for (const fem::Discharge& d : r.discharges) discharges.push_back({d.name, d.inflow, d.outflow, d.runoff});
  for (const fem::FaceExtent<D>& e : r.exits) exits.push_back({e.name, to_list(e.highest), to_list(e.lowest)});
}

std::vector<results::StandingWater> make_ponds_result(const std::vector<Pond>& ponds) {
  std::vector<results::StandingWater> result;
  for (const Pond& p : ponds) result.push_back({p.from, p.to, p.level_from, p.level_to});
  return result;
}

/// Returns the elements of soil with pore water; `mesh` is that of the flow calculation.
template <int D>
std::vector<std::vector<int>> list_elements(const mesh::Mesh<D>& mesh) {
  std::vector<std::vector<int>> list;
  for (int e = 0; e < mesh.element_count(); ++e)
    if (mesh.element_region[e] != mesh::empty_region)
      list.emplace_back(mesh.elements[e].begin(), mesh.elements[e].end());
  return list;
}

/// Returns the x at which table and ground may intersect or bend, from left to right.
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

/// Appends a point to a line, or replaces its end if the point continues the last segment.
void extend(std::vector<results::Point>& line, const Point& x) {
  const auto n = line.size();
  if (n > 1) {
    const Point &a = line[n - 2], &b = line[n - 1];
    const double cross = (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]);
    if (std::abs(cross) <= 1e-9 * (x[0] - a[0]) * (x[0] - a[0])) line.pop_back();
  }
  line.push_back(x);
}

/// Splits a table that is partly above the ground into the parts in the soil and the ponds over it.
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

/// Returns the state under the water table of a plane case; nothing in a case without one.
std::optional<results::WaterState> make_table_state_result(const Site& site, double time) {
  if (site.data().mesh.dimension != 2) return std::nullopt;
  if (!site.has_ground() || (site.water_table().empty() && !has_pressure_field(site.data()))) return std::nullopt;
  results::WaterState state;
  state.time = time;
  const std::vector<Pond> ponds = site.find_ponds(time);
  state.ponds = make_ponds_result(ponds);
  if (has_pressure_field(site.data())) {
    const Polyline table = trace_water_table(make_given_grid(site), ponds, site.ground(), find_base(site.data().mesh));
    state.water_table.emplace_back(table.begin(), table.end());
    return state;
  }
  split_table(site.water_table(), ponds, site.ground(), state);
  for (const input::PiezometricLine& line : site.data().initial.water.lines)
    state.water_table.emplace_back(line.points.begin(), line.points.end());
  return state;
}

/// Returns the pressure of the water table, of the piezometric line of the soil, or of the grid, positive in tension
/// [Pa].
double find_pressure_at(const Site& site, const Point& x) {
  const input::Case& data = site.data();
  static const input::Material none;
  const input::Material* soil = &none;
  if (!data.initial.water.lines.empty())
    for (const mesh::Polygon& polygon : data.mesh.polygons)
      if (data.regions.contains(polygon.name) && mesh::is_inside(x, polygon.points))
        soil = &site.get_soil(polygon.name);
  return find_given_pressure<2>(data, *soil, x);
}

/// Returns the field of water at rest under the table of the case, on triangles between the ground and the lowest soil.
results::WaterFields lay_fields(const Site& site) {
  const Polyline& ground = site.ground();
  const double base = find_base(site.data().mesh), left = ground.front()[0], right = ground.back()[0];
  std::vector<double> places;
  for (int c = 0; c <= columns; ++c) places.push_back(left + (right - left) * c / columns);
  for (const Point& x : ground)
    for (const double side : {-1e-6, 1e-6}) places.push_back(x[0] + side * (right - left));
  std::sort(places.begin(), places.end());
  std::erase_if(places, [&](double x) { return x < left || x > right; });
  results::WaterFields result;
  result.unit_weight = site.water_weight();
  results::WaterField& field = result.states.emplace_back();
  for (const double x : places)
    for (int r = 0; r <= rows; ++r) {
      const double y = base + (find_level(ground, x) - base) * r / rows;
      result.nodes.push_back(shorten_place(x, y));
      field.pressure.push_back(shorten(-find_pressure_at(site, {x, y})));
    }
  for (int c = 0; c + 1 < static_cast<int>(places.size()); ++c)
    for (int r = 0; r < rows; ++r) {
      const int a = c * (rows + 1) + r, b = a + rows + 1;
      result.elements.push_back({a, b, b + 1});
      result.elements.push_back({a, b + 1, a + 1});
    }
  return result;
}

}  // namespace

template <int D>
results::Seepage make_seepage_result(const mesh::Mesh<D>& mesh, const fem::SeepageResult<D>& r) {
  results::Seepage result;
  result.inflow = r.inflow;
  result.outflow = r.outflow;
  result.balance_error = r.balance_error;
  result.iterations = r.iterations;
  result.undecided = r.undecided;
  const auto driest =
      static_cast<std::size_t>(std::max_element(r.pressure.begin(), r.pressure.end()) - r.pressure.begin());
  result.largest_suction = r.pressure[driest];
  result.largest_suction_at = to_list(mesh.nodes[driest]);
  add_side_discharges<D>(r, result.discharges, result.exits);
  for (const auto& line : r.water_table) {
    auto& points = result.water_table.emplace_back();
    for (const auto& x : line) points.push_back(to_list(x));
  }
  return result;
}

template <int D>
results::WaterState make_state_result(const Site& site, const fem::SeepageResult<D>& r, results::WaterFlow flow,
                                      double time) {
  results::WaterState result;
  result.flow = flow;
  result.time = time;
  result.inflow = r.inflow;
  result.outflow = r.outflow;
  result.storage_rate = r.storage_rate;
  add_side_discharges<D>(r, result.discharges, result.exits);
  if constexpr (D == 2) {
    for (const auto& line : r.water_table) result.water_table.emplace_back(line.begin(), line.end());
    result.ponds = make_ponds_result(site.find_ponds(time));
  }
  return result;
}

template <int D>
results::WaterField make_field_result(const mesh::Mesh<D>& wet_mesh, const fem::SeepageResult<D>& r,
                                      results::WaterFlow flow, double time) {
  results::WaterField result;
  result.flow = flow;
  result.time = time;
  for (const double p : r.pressure) result.pressure.push_back(-shorten(p));
  for (int e = 0; e < wet_mesh.element_count(); ++e) {
    if (wet_mesh.element_region[e] == mesh::empty_region) continue;
    result.saturation.push_back(shorten(r.saturation[e]));
    auto& velocity = result.velocity.emplace_back();
    for (const double v : r.velocity[e]) velocity.push_back(shorten(v));
  }
  return result;
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
WaterResult make_water_result(const Site& site, const mesh::Mesh<D>& mesh,
                              const std::optional<fem::SeepageResult<D>>& steady,
                              const std::optional<SeasonRecord>& season) {
  WaterResult result;
  const input::Case& data = site.data();
  if (data.initial.water.known) return result;  // the earlier result has it
  if (!steady && !season) return make_water_table_result(site);
  const double start = season ? season->rows.front().time : 0;
  std::vector<results::WaterState>& states = result.states.emplace();
  if (steady) {
    result.seepage = make_seepage_result<D>(mesh, *steady);
    states.push_back(make_state_result<D>(site, *steady, results::WaterFlow::steady, start));
  } else if (auto first = make_table_state_result(site, start)) {
    states.push_back(std::move(*first));
  }
  if (season) {
    result.season = make_season_result(*season);
    states.insert(states.end(), season->states.begin(), season->states.end());
  }
  if constexpr (D == 2) {
    mesh::Mesh<2> wet = mesh;
    for (int e = 0; e < mesh.element_count(); ++e)
      if (const input::Material* soil = find_soil(data, mesh, e); soil == nullptr || !soil->water.is_wet())
        wet.element_region[e] = mesh::empty_region;
    result.fields = begin_fields(data, wet);
    if (!result.fields) return result;
    auto& fields = result.fields->states;
    if (steady) fields.push_back(make_field_result<2>(wet, *steady, results::WaterFlow::steady, start));
    if (season) fields.insert(fields.end(), season->fields.begin(), season->fields.end());
  }
  return result;
}

WaterResult make_water_table_result(const Site& site) {
  WaterResult result;
  if (auto state = make_table_state_result(site, 0)) {
    result.states = std::vector{std::move(*state)};
    result.fields = lay_fields(site);
  }
  return result;
}

void add_lowered_state(const Site& site, const Polyline& table, WaterResult& result) {
  if (!site.has_ground()) return;
  if (!result.states) result.states.emplace();
  results::WaterState& state = result.states->emplace_back();
  state.flow = results::WaterFlow::lowered;
  split_table(table, {}, site.ground(), state);
  if (!result.fields) return;
  results::WaterField& field = result.fields->states.emplace_back();
  field.flow = state.flow;
  for (const results::Point& x : result.fields->nodes)
    field.pressure.push_back(shorten(std::max(result.fields->unit_weight * (find_water_table(table, x[0]) - x[1]),
                                              -site.data().initial.water.largest_suction)));
}

void give(const WaterResult& water, results::RunResult& run) {
  if (!run.seepage) run.seepage = water.seepage;
  if (!run.season) run.season = water.season;
  if (!run.water_states) run.water_states = water.states;
}

#define TALUS_INSTANTIATE(D)                                                                                       \
  template results::Seepage make_seepage_result<D>(const mesh::Mesh<D>&, const fem::SeepageResult<D>&);            \
  template results::WaterState make_state_result<D>(const Site&, const fem::SeepageResult<D>&, results::WaterFlow, \
                                                    double);                                                       \
  template results::WaterField make_field_result<D>(const mesh::Mesh<D>&, const fem::SeepageResult<D>&,            \
                                                    results::WaterFlow, double);                                   \
  template WaterResult make_water_result<D>(const Site&, const mesh::Mesh<D>&,                                     \
                                            const std::optional<fem::SeepageResult<D>>&,                           \
                                            const std::optional<SeasonRecord>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::site
