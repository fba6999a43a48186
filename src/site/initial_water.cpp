// SPDX-License-Identifier: MIT
// Pore pressures at the start from a water table, seepage, a known state or a season; ponds and water tables for
// LEM.
#include "site/initial_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.hpp"
#include "input/case/soil_water_law.hpp"
#include "site/known_state.hpp"
#include "site/mesh_sides.hpp"
#include "site/pore_water.hpp"
#include "site/seepage_model.hpp"

namespace talus::site {

namespace {

template <int D>
bool is_wet(const input::Case& data, const mesh::Mesh<D>& mesh, int e) {
  const input::Material* soil = find_soil(data, mesh, e);
  return soil != nullptr && soil->water.is_wet();
}

/// Returns the level of zero pressure at `x` [m]: that of the water table, or the head of the grid.
template <int D>
double find_level_of(const input::Case& data, const Polyline& line, const Vec<D>& x) {
  return has_pressure_field(data) ? data.initial.water.field->find({x[0], x[1]}) : find_water_table(line, x[0]);
}

template <int D>
void set_from_table(const input::Case& data, const mesh::Mesh<D>& mesh, InitialWater<D>& water) {
  check_upright(data, "a water table");
  Vec<D> middle;
  middle.fill(1.0 / (D + 1));
  for (int e = 0; e < mesh.element_count(); ++e)
    if (is_wet(data, mesh, e))
      water.pressure[e] = find_given_pressure<D>(data, *find_soil(data, mesh, e), mesh::to_global(mesh, e, middle));
}

template <int D>
void set_from_seepage(const input::Case& data, const mesh::Mesh<D>& mesh, const fem::SeepageResult<D>& seepage,
                      InitialWater<D>& water) {
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (!is_wet(data, mesh, e)) continue;
    for (int node : mesh.elements[e]) water.pressure[e] += seepage.pressure[node] / (D + 1);
    const double content = find_soil(data, mesh, e)->porosity * seepage.saturation[e];
    for (std::size_t d = 0; d < D; ++d) water.velocity[e][d] = seepage.velocity[e][d] / content;
  }
}

/// Sets the pressure at the middle of wet elements, and the velocity, from a known state.
void set_from_known(const input::Case& data, const mesh::Mesh<2>& mesh, InitialWater<2>& water) {
  MappedWater mapped = map_water(*data.initial.water.known, mesh);
  water.nodal = std::move(mapped.pressure);
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (!is_wet(data, mesh, e)) continue;
    const auto i = static_cast<std::size_t>(e);
    for (const int node : mesh.elements[i]) water.pressure[i] += water.nodal[static_cast<std::size_t>(node)] / 3;
    const input::Material& soil = *find_soil(data, mesh, e);
    const double content = soil.porosity * material::saturation(input::make_retention(soil.water), water.pressure[i]);
    for (std::size_t d = 0; d < 2; ++d) water.velocity[i][d] = mapped.seepage[i][d] / content;
  }
}

/// Returns the heads of the nodes at the start of the season [m].
template <int D>
std::vector<double> find_first_heads(const input::Case& data, const mesh::Mesh<D>& mesh, const InitialWater<D>& water) {
  if (water.seepage) return water.seepage->head;
  const input::InitialWater& initial = data.initial.water;
  const double weight = find_water_weight(data);
  std::vector<double> heads;
  for (const Vec<D>& x : mesh.nodes) {
    const double level =
        initial.pressure == input::InitialPressure::zero ? x[1] : find_level_of<D>(data, initial.water_table, x);
    heads.push_back(x[1] - std::min(x[1] - level, initial.largest_suction / weight));
  }
  return heads;
}

template <int D>
void follow_season(const input::Case& data, const mesh::Mesh<D>& mesh, const fem::SeepageModel<D>& model,
                   InitialWater<D>& water) {
  Season<D> season = run_season<D>(data, model, find_first_heads<D>(data, mesh, water));
  water.pressure.assign(mesh.elements.size(), 0.0);
  set_from_seepage<D>(data, mesh, season.end, water);
  water.nodal = season.end.pressure;
  water.season = std::move(season.record);
}

/// Returns the level, above the point x (in 3D also z), of the side that covers it; nothing beside the side.
template <int D>
std::optional<double> find_level(const std::array<Vec<D>, D>& c, const Vec<D>& x) {
  constexpr double edge = 1e-9;
  if constexpr (D == 2) {
    const double width = c[1][0] - c[0][0];
    if (width == 0) return std::nullopt;
    const double share = (x[0] - c[0][0]) / width;
    if (share < -edge || share > 1 + edge) return std::nullopt;
    return c[0][1] + share * (c[1][1] - c[0][1]);
  } else {
    const double ux = c[1][0] - c[0][0], uz = c[1][2] - c[0][2], vx = c[2][0] - c[0][0], vz = c[2][2] - c[0][2],
                 rx = x[0] - c[0][0], rz = x[2] - c[0][2], area = ux * vz - uz * vx;
    if (area == 0) return std::nullopt;
    const double s = (rx * vz - rz * vx) / area, t = (ux * rz - uz * rx) / area;
    if (s < -edge || t < -edge || s + t > 1 + edge) return std::nullopt;
    return c[0][1] + s * (c[1][1] - c[0][1]) + t * (c[2][1] - c[0][1]);
  }
}

}  // namespace

template <int D>
InitialWater<D> find_initial_water(const input::Case& data, const mesh::Mesh<D>& mesh) {
  InitialWater<D> water;
  water.pressure.assign(mesh.elements.size(), 0.0);
  water.velocity.assign(mesh.elements.size(), {});
  if (!has_water(data)) return water;
  if constexpr (D == 2) {
    if (data.initial.water.known) {
      set_from_known(data, mesh, water);
      return water;
    }
  }
  // The state of another result includes its weather.
  const bool has_season = data.initial.water.season > 0 && data.initial.result.empty();
  const bool seeps = data.initial.water.pressure == input::InitialPressure::seepage;
  mesh::Mesh<D> wet_mesh;
  fem::SeepageModel<D> model;
  if (has_season || seeps) model = make_seepage_model<D>(data, mesh, wet_mesh);
  switch (data.initial.water.pressure) {
    case input::InitialPressure::zero:
      break;
    case input::InitialPressure::water_table:
      set_from_table(data, mesh, water);
      break;
    case input::InitialPressure::grid:
      if (has_pressure_field(data)) set_from_table(data, mesh, water);
      break;
    case input::InitialPressure::seepage:
      water.seepage = fem::solve_steady_seepage(model, {}, {}, find_weather_start(data));
      set_from_seepage<D>(data, mesh, *water.seepage, water);
      water.nodal = water.seepage->pressure;
      break;
  }
  if (has_season) follow_season<D>(data, mesh, model, water);
  return water;
}

template <int D>
std::vector<double> find_nodal_pressures(const input::Case& data, const mesh::Mesh<D>& mesh,
                                         const InitialWater<D>& water) {
  if (!has_water(data)) return {};
  std::vector<double> pressure(mesh.nodes.size(), NAN);
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (!is_wet(data, mesh, e)) continue;
    for (const int node : mesh.elements[e]) {
      if (!water.nodal.empty())
        pressure[node] = water.nodal[node];
      else if (data.initial.water.pressure == input::InitialPressure::water_table || has_pressure_field(data))
        pressure[node] = find_given_pressure<D>(data, *find_soil(data, mesh, e), mesh.nodes[node]);
      else
        pressure[node] = 0;
    }
  }
  return pressure;
}

template <int D>
std::vector<double> find_ponded_load(const input::Case& data, const mesh::Mesh<D>& mesh,
                                     const std::vector<Vec<D>>& places) {
  constexpr double steepest = 1e-6;  // smallest vertical component of a normal: a vertical face bears no water above it
  std::vector<double> load(places.size(), 0.0);
  const WaterSides<D> sides = find_water_sides<D>(mesh, data);
  std::vector<WaterSide<D>> ground;
  std::vector<LabelledSide<D>> balls;
  const auto get_corners = [&](const WaterSide<D>& s) {
    std::array<Vec<D>, D> corners;
    for (std::size_t c = 0; c < D; ++c) corners[c] = mesh.nodes[s.nodes[c]];
    return corners;
  };
  for (const WaterSide<D>& s : sides.open) {
    const mpm::SurfaceKind kind = sides.surfaces[s.condition].kind;
    if (!(s.normal[1] > steepest && (kind == mpm::SurfaceKind::head || kind == mpm::SurfaceKind::pressure))) continue;
    balls.push_back(make_labelled_side<D>(get_corners(s), static_cast<int>(ground.size())));
    ground.push_back(s);
  }
  if (ground.empty()) return load;
  check_upright(data, "a total head or a pressure on the ground");
  const SideSet<D> set(std::move(balls));
  const double weight = find_water_weight(data);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec<D>& x = places[i];
    double top = x[1];
    for (const int number : set.find_on_line(x, 1)) {
      const WaterSide<D>& s = ground[number];
      const auto level = find_level<D>(get_corners(s), x);
      if (!level || *level < top) continue;
      top = *level;
      const mpm::SurfaceCondition& surface = sides.surfaces[s.condition];
      const double value = surface.value.at(0);
      load[i] = std::max(0.0, surface.kind == mpm::SurfaceKind::head ? weight * (value - top) : -value);
    }
  }
  return load;
}

#define TALUS_INSTANTIATE(D)                                                                     \
  template InitialWater<D> find_initial_water<D>(const input::Case&, const mesh::Mesh<D>&);      \
  template std::vector<double> find_nodal_pressures<D>(const input::Case&, const mesh::Mesh<D>&, \
                                                       const InitialWater<D>&);                  \
  template std::vector<double> find_ponded_load<D>(const input::Case&, const mesh::Mesh<D>&,     \
                                                   const std::vector<Vec<D>>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

const Polyline& find_piezometric_line(const input::Case& data, const input::Material& soil) {
  for (const input::PiezometricLine& line : data.initial.water.lines)
    for (const std::string& name : line.materials)
      if (&data.materials.at(name) == &soil) return line.points;
  return data.initial.water.water_table;
}

bool has_pressure_field(const input::Case& data) {
  const input::InitialWater& water = data.initial.water;
  return water.pressure == input::InitialPressure::grid && water.field &&
         water.table->quantity != input::GridQuantity::ratio;
}

template <int D>
double find_given_level(const input::Case& data, const input::Material& soil, const Vec<D>& x) {
  return find_level_of<D>(data, find_piezometric_line(data, soil), x);
}

template <int D>
double find_given_pressure(const input::Case& data, const input::Material& soil, const Vec<D>& x) {
  const double level = find_given_level<D>(data, soil, x);
  return std::min(find_water_weight(data) * (x[1] - level), data.initial.water.largest_suction);
}

template <int D>
double find_pressure_ratio(const input::Case& data, const input::Material& soil, const Vec<D>& x) {
  const input::InitialWater& water = data.initial.water;
  if (water.pressure != input::InitialPressure::grid || !water.field || has_pressure_field(data))
    return soil.slices.pore_pressure_ratio;
  return std::clamp(water.field->find({x[0], x[1]}), 0.0, 1.0);
}

bool has_pressure_ratio(const input::Case& data) {
  const input::InitialWater& water = data.initial.water;
  if (water.pressure == input::InitialPressure::grid && water.field && !has_pressure_field(data)) return true;
  return std::any_of(data.materials.begin(), data.materials.end(),
                     [](const auto& entry) { return entry.second.slices.pore_pressure_ratio != 0; });
}

template double find_given_level<2>(const input::Case&, const input::Material&, const Vec<2>&);
template double find_given_level<3>(const input::Case&, const input::Material&, const Vec<3>&);
template double find_given_pressure<2>(const input::Case&, const input::Material&, const Vec<2>&);
template double find_given_pressure<3>(const input::Case&, const input::Material&, const Vec<3>&);
template double find_pressure_ratio<2>(const input::Case&, const input::Material&, const Vec<2>&);
template double find_pressure_ratio<3>(const input::Case&, const input::Material&, const Vec<3>&);

namespace {

/// Cells at whose corners and centres a spline is sampled for LEM, over the section.
constexpr int spline_columns = 140, spline_rows = 56;

lem::PressureGrid sample_spline(const mesh::ScatteredField& field, const Polyline& ground, double base) {
  double high = base;
  for (const Point& p : ground) high = std::max(high, p[1]);
  const double left = ground.front()[0], right = ground.back()[0];
  lem::PressureGrid grid;
  const auto add = [&](double column, double row) {
    grid.nodes.push_back({left + (right - left) * column / spline_columns, base + (high - base) * row / spline_rows});
    grid.pressure.push_back(field.find(grid.nodes.back()));
  };
  for (int c = 0; c <= spline_columns; ++c)
    for (int r = 0; r <= spline_rows; ++r) add(c, r);
  for (int c = 0; c < spline_columns; ++c)
    for (int r = 0; r < spline_rows; ++r) {
      const int a = c * (spline_rows + 1) + r, b = a + spline_rows + 1, centre = static_cast<int>(grid.nodes.size());
      add(c + 0.5, r + 0.5);
      grid.triangles.push_back({a, b, centre});
      grid.triangles.push_back({b, b + 1, centre});
      grid.triangles.push_back({b + 1, a + 1, centre});
      grid.triangles.push_back({a + 1, a, centre});
    }
  return grid;
}

}  // namespace

lem::PressureGrid make_given_grid(const Site& site) {
  const input::InitialWater& water = site.data().initial.water;
  lem::PressureGrid grid;
  if (water.field->kind() == mesh::Scatter::linear) {
    grid.nodes.assign(water.field->triangles().nodes.begin(), water.field->triangles().nodes.end());
    grid.triangles.assign(water.field->triangles().elements.begin(), water.field->triangles().elements.end());
    grid.pressure = water.field->values();
  } else {
    grid = sample_spline(*water.field, site.ground(), find_base(site.data().mesh));
  }
  for (std::size_t i = 0; i < grid.nodes.size(); ++i)  // heads become pressures
    grid.pressure[i] = std::max(site.water_weight() * (grid.pressure[i] - grid.nodes[i][1]), -water.largest_suction);
  return grid;
}

bool needs_seepage(const input::Case& data) {
  return has_water(data) && (data.initial.water.pressure == input::InitialPressure::seepage ||
                             data.initial.water.season > 0 || data.initial.water.known || data.timeline);
}

PressureSource find_pressure_source(const input::Case& data, const input::Material& soil) {
  if (soil.water.is_wet() && needs_seepage(data)) return PressureSource::computed;
  const input::InitialWater& water = data.initial.water;
  const bool has_table = water.pressure == input::InitialPressure::water_table && !water.water_table.empty();
  return has_table || has_pressure_field(data) ? PressureSource::given : PressureSource::none;
}

bool gives_levels(const input::Case& data) {
  return std::any_of(data.hydraulics.begin(), data.hydraulics.end(), [](const input::Hydraulic& h) {
    return h.condition == input::WaterCondition::total_head || h.condition == input::WaterCondition::pressure;
  });
}

input::Case close_sides(input::Case data) {
  if (!data.boundaries.empty()) return data;
  for (const char* side : {"bottom", "left", "right"}) {
    data.boundaries.emplace_back();
    data.boundaries.back().on = side;
    data.boundaries.back().fix = input::Fix::normal;
  }
  return data;
}

template <int D>
std::vector<double> find_nodal_pressure(const input::Case& data, const mesh::Mesh<D>& mesh, WaterResult* out) {
  std::vector<double> pressure(mesh.nodes.size(), 0.0);
  const input::InitialWater& initial = data.initial.water;
  if (needs_seepage(data)) {
    InitialWater<D> water = find_initial_water<D>(data, mesh);
    if (out != nullptr) *out = make_water_result<D>(data, mesh, water.seepage, water.season);
    if (!water.nodal.empty()) return std::move(water.nodal);
  } else if (out != nullptr) {
    *out = make_water_table_result(data);
  }
  const bool has_table = initial.pressure == input::InitialPressure::water_table && !initial.water_table.empty();
  if (!has_table && !has_pressure_field(data)) return pressure;
  check_upright(data, "a water table");
  const double weight = find_water_weight(data);
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    const auto& x = mesh.nodes[i];
    pressure[i] = std::min(weight * (x[1] - find_level_of<D>(data, initial.water_table, x)), initial.largest_suction);
  }
  return pressure;
}

lem::PressureGrid make_pressure_grid(const input::Case& data, const mesh::Mesh<2>& mesh,
                                     const std::vector<double>& pressure) {
  lem::PressureGrid grid;
  grid.nodes.assign(mesh.nodes.begin(), mesh.nodes.end());
  for (const double p : pressure) grid.pressure.push_back(-p);
  for (int e = 0; e < mesh.element_count(); ++e) {
    const input::Material* soil = find_soil(data, mesh, e);
    if (soil == nullptr) continue;
    std::array<int, 3> nodes = mesh.elements[e];
    if (const PressureSource source = find_pressure_source(data, *soil); source != PressureSource::computed) {
      for (int& i : nodes) {
        const Vec<2>& x = mesh.nodes[i];
        grid.nodes.push_back(x);
        grid.pressure.push_back(source == PressureSource::given ? -find_given_pressure<2>(data, *soil, x) : 0.0);
        i = static_cast<int>(grid.nodes.size()) - 1;
      }
    }
    grid.triangles.push_back(nodes);
  }
  return grid;
}

template std::vector<double> find_nodal_pressure<2>(const input::Case&, const mesh::Mesh<2>&, WaterResult*);
template std::vector<double> find_nodal_pressure<3>(const input::Case&, const mesh::Mesh<3>&, WaterResult*);

}  // namespace talus::site
