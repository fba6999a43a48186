// SPDX-License-Identifier: MIT
// The sides of the wet soil with their hydraulic conditions, and the model of seepage of a case.
#include "site/seepage_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "base/error.hpp"
#include "input/case/soil_water_law.hpp"
#include "results/water.hpp"
#include "site/initial_water.hpp"
#include "site/mesh_sides.hpp"
#include "site/pore_water.hpp"
#include "site/weights.hpp"

namespace talus::site {

namespace {

using input::WaterCondition;

/// A plane condition applies to sides whose normal is within 20° of its own.
constexpr double parallel_cosine = 0.9397;

template <int D>
using Side = std::array<int, D>;

template <int D>
Side<D> sort_nodes(Side<D> side) {
  std::sort(side.begin(), side.end());
  return side;
}

/// The walls and conditions that the case assigns to named sides.
template <int D>
class NamedSides {
 public:
  NamedSides(const mesh::Mesh<D>& mesh, const input::Case& data) {
    for (std::size_t h = 0; h < data.hydraulics.size(); ++h) {
      for (const auto& side : find_sides(mesh, data.hydraulics[h].on)) {
        const int number = static_cast<int>(h) + 1;
        const auto [at, is_new] = conditions_.try_emplace(sort_nodes<D>(side), number);
        if (!is_new) at->second = choose(data, at->second, number);
      }
    }
    if (const auto covered = mesh.sides.find(impermeable_sides); covered != mesh.sides.end())
      for (const auto& side : covered->second) covered_.insert(sort_nodes<D>(side));
    int moved = static_cast<int>(data.hydraulics.size());
    for (const input::Boundary& b : data.boundaries) {
      if (b.fix == input::Fix::velocity) ++moved;
      for (const auto& [side, elements] : map_sides<D>(mesh, find_sides(mesh, b.on))) {
        if (b.fix == input::Fix::plane && !is_parallel(mesh, b, elements)) continue;
        walls_.insert(side);
        if (b.fix == input::Fix::velocity) conditions_.try_emplace(side, moved);
      }
    }
  }
  bool is_wall(const Side<D>& sorted) const { return walls_.contains(sorted); }
  /// Returns true beside an impermeable wall, whatever the condition of the side.
  bool is_covered(const Side<D>& sorted) const { return covered_.contains(sorted); }
  /// Returns the number of the condition, or 0.
  int get_condition(const Side<D>& sorted) const {
    const auto found = conditions_.find(sorted);
    return found == conditions_.end() ? 0 : found->second;
  }

 private:
  static int choose(const input::Case& data, int a, int b) {
    const auto rank = [&](int number) {
      constexpr double lowest = -1e300;  // below its level, where a head is not a seepage face
      return find_rank(make_surface_condition(data.hydraulics[static_cast<std::size_t>(number) - 1]), lowest, true);
    };
    return rank(b) < rank(a) ? b : a;
  }
  static bool is_parallel(const mesh::Mesh<D>& mesh, const input::Boundary& b,
                          const std::vector<SideElement>& elements) {
    if (elements.empty()) return false;
    const Vec<D> n = find_outward_normal(mesh, elements.front().element, elements.front().opposite).first;
    double cosine = 0;
    for (std::size_t d = 0; d < D; ++d) cosine += n[d] * b.normal[d];
    return std::abs(cosine) > parallel_cosine;
  }

  std::map<Side<D>, int> conditions_;
  std::set<Side<D>> walls_, covered_;
};

input::TimeTable make_constant(double value) {
  return {{0.0}, {value}};
}

template <int D>
std::vector<bool> find_wet_elements(const mesh::Mesh<D>& mesh, const input::Case& data) {
  std::vector<bool> wet(mesh.elements.size(), false);
  for (int e = 0; e < mesh.element_count(); ++e) {
    const input::Material* soil = find_soil(data, mesh, e);
    wet[static_cast<std::size_t>(e)] = soil != nullptr && soil->water.is_wet();
  }
  return wet;
}

template <int D>
Side<D> get_side(const mesh::Mesh<D>& mesh, int e, int opposite) {
  Side<D> side;
  std::size_t n = 0;
  for (int j = 0; j <= D; ++j) {
    if (j != opposite) side[n++] = mesh.elements[e][j];
  }
  return side;
}

/// Adds the sides of fixed boundaries, except those that a [[hydraulic]] opens.
template <int D>
void add_held_walls(const mesh::Mesh<D>& mesh, const input::Case& data, const NamedSides<D>& named,
                    WaterSides<D>& result) {
  for (const input::Boundary& b : data.boundaries) {
    if (b.fix == input::Fix::velocity) continue;
    std::vector<Side<D>> held;
    for (const auto& side : find_sides(mesh, b.on)) {
      const Side<D> sorted = sort_nodes<D>(side);
      const int number = named.get_condition(sorted);
      const bool opened =
          number > static_cast<int>(data.hydraulics.size()) ||
          (number > 0 && data.hydraulics[static_cast<std::size_t>(number) - 1].condition != WaterCondition::no_flow);
      if (named.is_wall(sorted) && !opened) held.push_back(side);
    }
    if (!held.empty()) result.held.push_back(std::move(held));
  }
}

}  // namespace

mpm::SurfaceCondition make_surface_condition(const input::Hydraulic& h) {
  mpm::SurfaceCondition s;
  s.name = h.on;
  s.value = h.values();
  s.vertical = h.rain == input::RainDirection::vertical;
  s.suction_limit = h.suction_limit;
  switch (h.condition) {
    case WaterCondition::total_head:
      s.kind = mpm::SurfaceKind::head;
      break;
    case WaterCondition::pressure:
      s.kind = mpm::SurfaceKind::pressure;
      for (double& p : s.value.value) p = -p;
      break;
    case WaterCondition::seepage_face:
    case WaterCondition::free_drainage:  // MPM does not have it
      s.kind = mpm::SurfaceKind::seepage;
      break;
    case WaterCondition::rain:
      s.kind = mpm::SurfaceKind::rain;
      break;
    case WaterCondition::flux:
      s.kind = mpm::SurfaceKind::flux;
      break;
    case WaterCondition::no_flow:
      s.kind = mpm::SurfaceKind::flux;
      s.value = make_constant(0);
      break;
  }
  return s;
}

int find_rank(const mpm::SurfaceCondition& s, double y, bool is_named) {
  constexpr int seepage = 4, unnamed = 5, closed = 6;
  switch (s.kind) {
    case mpm::SurfaceKind::head: {
      const auto highest = std::max_element(s.value.value.begin(), s.value.value.end());
      return highest != s.value.value.end() && *highest > y ? 0 : seepage;
    }
    case mpm::SurfaceKind::pressure:
    case mpm::SurfaceKind::open:
      return 1;
    case mpm::SurfaceKind::flux:
      return mpm::lets_nothing_through(s) ? closed : 2;
    case mpm::SurfaceKind::rain:
      return 3;
    case mpm::SurfaceKind::seepage:
      break;
  }
  return is_named ? seepage : unnamed;
}

template <int D>
WaterSides<D> find_water_sides(const mesh::Mesh<D>& mesh, const input::Case& data) {
  WaterSides<D> result;
  result.surfaces.push_back({results::other_surfaces, mpm::SurfaceKind::seepage, {}});
  for (const input::Hydraulic& h : data.hydraulics) result.surfaces.push_back(make_surface_condition(h));
  for (const input::Boundary& b : data.boundaries) {
    if (b.fix == input::Fix::velocity) result.surfaces.push_back({b.on, mpm::SurfaceKind::flux, make_constant(0)});
  }
  const NamedSides<D> named(mesh, data);
  const std::vector<bool> wet = find_wet_elements(mesh, data);
  const auto has_wet = [&](int e) { return e >= 0 && wet[static_cast<std::size_t>(e)]; };
  const auto is_no_flow = [&](int number) {
    return number > 0 && number <= static_cast<int>(data.hydraulics.size()) &&
           data.hydraulics[static_cast<std::size_t>(number) - 1].condition == WaterCondition::no_flow;
  };
  std::vector<std::vector<Side<D>>> lines(result.surfaces.size());
  std::vector<bool> is_met(result.surfaces.size(), false);
  for (int e = 0; e < mesh.element_count(); ++e) {
    for (int k = 0; k <= D; ++k) {
      const int behind = mesh.neighbours[e][k];
      const Side<D> side = get_side(mesh, e, k), sorted = sort_nodes<D>(side);
      const int number = named.get_condition(sorted);
      const bool wall = named.is_wall(sorted);
      if (!has_wet(e)) {
        if (behind < 0 && number > 0 && wall && !is_no_flow(number))
          for (int node : side) result.reserved.emplace_back(node, number);
        continue;
      }
      if (named.is_covered(sorted)) continue;
      if (has_wet(behind)) {
        if (is_no_flow(number) && e < behind) lines[static_cast<std::size_t>(number)].push_back(side);
        continue;
      }
      if (wall && (number == 0 || is_no_flow(number))) continue;  // impermeable
      is_met[static_cast<std::size_t>(number)] = true;
      result.open.push_back({side, mesh.elements[e][k], find_outward_normal(mesh, e, k).first, wall, number});
    }
  }
  add_held_walls(mesh, data, named, result);
  for (auto& line : lines) {
    if (!line.empty()) result.held.push_back(std::move(line));
  }
  for (std::size_t h = 0; h < data.hydraulics.size(); ++h) {
    const WaterCondition c = data.hydraulics[h].condition;
    if (is_met[h + 1] || c == WaterCondition::no_flow || c == WaterCondition::seepage_face) continue;
    throw Error(ExitCode::wrong_input,
                fmt::format("the hydraulic condition on '{}' has no effect: no side of '{}' is a surface of soil with "
                            "pore water at the start",
                            data.hydraulics[h].on, data.hydraulics[h].on));
  }
  return result;
}

template WaterSides<2> find_water_sides<2>(const mesh::Mesh<2>&, const input::Case&);
template WaterSides<3> find_water_sides<3>(const mesh::Mesh<3>&, const input::Case&);

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
  // Darcy's k depends on gravity: the pressure gradient per unit of head is proportional to it.
  const double along = input::find_saturated_conductivity(m.water, data.water, data.gravity.acceleration);
  const double across = m.water.conductivity_ratio * along;
  const double c = std::cos(m.water.conductivity_inclination), s = std::sin(m.water.conductivity_inclination);
  soil.conductivity.fill(along);  // along z too: bedding strikes along it
  soil.conductivity[0] = along * c * c + across * s * s;
  soil.conductivity[1] = along * s * s + across * c * c;
  soil.cross_conductivity = (along - across) * s * c;
  soil.retention = input::make_retention(m.water);
  const bool in_time = data.timeline || data.initial.water.season > 0 || !data.seepage.times.empty();
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
    case WaterCondition::free_drainage:
      return fem::HydraulicKind::free_drainage;
    case WaterCondition::no_flow:
      break;
  }
  return fem::HydraulicKind::no_flow;
}

/// Selects the unnamed sides that are the ground: not the base, whose normal points down, and not the outer sides of
/// the model, at which it is cut off from the surrounding soil.
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

/// Level that stands for 'none' [m].
constexpr double no_level = -std::numeric_limits<double>::infinity();

/// Returns per node the level of the given water behind unnamed sides of the soil with pore water: that of soil without
/// pore water of its own, and of a water table above the ground.
template <int D>
std::vector<double> find_levels_behind(const input::Case& data, const mesh::Mesh<D>& mesh,
                                       const std::vector<std::array<int, D>>& sides) {
  std::vector<double> levels(mesh.nodes.size(), no_level);
  for (int e = 0; e < mesh.element_count(); ++e) {
    const input::Material* soil = find_soil(data, mesh, e);
    if (soil == nullptr || soil->water.is_wet() || find_pressure_source(data, *soil) != PressureSource::given) continue;
    for (const int node : mesh.elements[e])
      levels[node] = std::max(levels[node], find_given_level<D>(data, *soil, mesh.nodes[node]));
  }
  const input::InitialWater& water = data.initial.water;
  if (water.pressure != input::InitialPressure::water_table || water.water_table.empty() || gives_levels(data))
    return levels;
  for (const std::array<int, D>& side : sides)
    for (const int node : side)
      if (levels[node] == no_level) levels[node] = find_water_table(water.water_table, mesh.nodes[node][0]);
  return levels;
}

/// Gives the unnamed surfaces the levels of given water behind them. They come last: named conditions take precedence.
template <int D>
void add_given_levels(const input::Case& data, const mesh::Mesh<D>& mesh, fem::SeepageModel<D>& model) {
  if (model.boundaries.empty() || model.boundaries.front().name != results::other_surfaces) return;
  std::vector<double> levels = find_levels_behind<D>(data, mesh, model.boundaries.front().sides);
  const auto is_below = [&](int node) { return levels[node] > mesh.nodes[node][1]; };
  const auto& sides = model.boundaries.front().sides;
  if (std::none_of(sides.begin(), sides.end(),
                   [&](const auto& side) { return std::any_of(side.begin(), side.end(), is_below); }))
    return;
  model.boundaries.front().levels = std::move(levels);
  std::rotate(model.boundaries.begin(), model.boundaries.begin() + 1, model.boundaries.end());
}

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
  model.units = data.units();
  for (const std::string& region : mesh.region_names) model.soils.push_back(make_soil<D>(data, region));
  model.unit_weight = find_water_weight(data);
  // The same sides and the same precedence as in MPM. Unnamed sides are seepage faces on the ground and impermeable
  // elsewhere.
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
  add_given_levels<D>(data, mesh, model);
  if constexpr (D == 2)
    if (data.timeline && data.timeline->pool_loading) model.pool_weight = make_pool_weight(data, mesh);
  return model;
}

template fem::SeepageModel<2> make_seepage_model<2>(const input::Case&, const mesh::Mesh<2>&, mesh::Mesh<2>&);
template fem::SeepageModel<3> make_seepage_model<3>(const input::Case&, const mesh::Mesh<3>&, mesh::Mesh<3>&);

}  // namespace talus::site
