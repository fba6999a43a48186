// SPDX-License-Identifier: MIT
#include "run/common/section_of_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "mesh/planar.hpp"
#include "run/common/walls_of_case.hpp"
#include "site/design_values.hpp"
#include "site/initial_water.hpp"
#include "site/pore_water.hpp"
#include "site/roots.hpp"
#include "site/supports.hpp"
#include "site/weights.hpp"

namespace talus::run {
namespace {

/// Number of samples of the saturation above the water table across a polygon.
constexpr int weight_samples = 40;
/// Numbers of parts, in depth and along the ground, into which a distribution of roots is divided.
constexpr int root_depths = 20, root_parts = 24;

lem::Soil make_soil(const input::Case& data, const std::string& name, std::vector<std::string>& notes) {
  const input::Material& m = data.materials.at(name);
  lem::Soil soil;
  soil.name = name;
  soil.saturated_unit_weight = site::find_saturated_weight(data, m);
  soil.unit_weight = soil.saturated_unit_weight;  // until the water is known
  soil.pore_pressure_ratio = m.slices.pore_pressure_ratio;
  const site::PlaneStrength strength = site::find_plane_strength(m);
  soil.cohesion = strength.cohesion;
  soil.friction_angle = strength.friction_angle;
  soil.cohesion_gradient = strength.cohesion_gradient;
  soil.cohesion_level = strength.cohesion_level;
  soil.law = strength.law;
  soil.reduced = m.reduced;
  if (!strength.yields)
    notes.push_back(fmt::format("material '{}' is elastic: no slip surface passes through it", name));
  soil.undrained = m.known_strength || material::is_total_stress(m.model, m) || (!soil.law && soil.friction_angle == 0);
  switch (m.slices.suction_strength) {
    case input::SuctionStrength::from_water:
    case input::SuctionStrength::saturation:
      if (m.water.is_wet()) soil.suction = lem::Suction::saturation;
      break;
    case input::SuctionStrength::phi_b:
      soil.suction = lem::Suction::phi_b;
      break;
    case input::SuctionStrength::none:
      break;
  }
  if (soil.suction == lem::Suction::saturation) {
    // χ of the soil, by either law.
    soil.saturation = [m](double suction) {
      return suction > 0 ? site::find_suction_stress(m, suction) / suction : 1.0;
    };
    if (m.slices.suction_strength == input::SuctionStrength::saturation && !site::uses_saturation(m))
      notes.push_back(fmt::format("material '{}' has no retention curve: its suction adds no strength", name));
  }
  soil.takes_roots = m.traits().roots == material::RootEffect::cohesion;
  soil.phi_b = m.slices.phi_b;
  if (const auto& e = m.slices.undrained_envelope)
    soil.envelope = lem::UndrainedEnvelope{e->cohesion, e->friction_angle};
  soil.b_bar = m.slices.b_bar;
  const bool is_computed = data.initial.water.known && m.water.is_wet();
  if (!is_computed &&
      (data.initial.water.pressure == input::InitialPressure::water_table || site::has_pressure_field(data)))
    soil.largest_suction = data.initial.water.largest_suction;
  return soil;
}

/// Sorts polygons from the largest to the smallest: a lens replaces the soil around it.
std::vector<const mesh::Polygon*> sort_polygons(const mesh::Plan& plan) {
  std::vector<const mesh::Polygon*> sorted;
  for (const mesh::Polygon& p : plan.polygons) sorted.push_back(&p);
  std::stable_sort(sorted.begin(), sorted.end(), [](const mesh::Polygon* a, const mesh::Polygon* b) {
    return std::abs(mesh::compute_area(a->points)) > std::abs(mesh::compute_area(b->points));
  });
  return sorted;
}

void add_regions(const site::Site& site, lem::Section& section, std::vector<std::string>& notes) {
  const input::Case& data = site.data();
  std::map<std::string, int> numbers;
  const double rounding = 1e-9 * (section.ground.back()[0] - section.ground.front()[0]);
  for (const mesh::Polygon* polygon : sort_polygons(data.mesh)) {
    site.get_soil(polygon->name);  // throws for a region without material
    const std::string& name = data.regions.at(polygon->name);
    const auto [at, is_new] = numbers.try_emplace(name, static_cast<int>(section.soils.size()));
    if (is_new) section.soils.push_back(make_soil(data, name, notes));
    // Points on straight edges are dropped, as a slip surface cannot touch the soil there.
    section.regions.push_back({at->second, mesh::drop_straight_points(polygon->points, true, rounding)});
  }
}

/// Bounding box of a polygon.
struct Box {
  site::Point low{}, high{};

  explicit Box(const std::vector<lem::Point>& polygon) : low(polygon.front()), high(polygon.front()) {
    for (const site::Point& x : polygon)
      for (std::size_t d = 0; d < 2; ++d) low[d] = std::min(low[d], x[d]), high[d] = std::max(high[d], x[d]);
  }
  bool holds(const site::Point& x) const {
    return x[0] >= low[0] && x[0] <= high[0] && x[1] >= low[1] && x[1] <= high[1];
  }
};

/// Sets the unit weight above the water table, if it follows from the water content: the mean over the unsaturated
/// soil of the polygons.
void weigh_moist_soil(const input::Case& data, const lem::PressureGrid* grid, lem::Section& section) {
  const double weight = site::find_water_weight(data);
  const bool has_table = !section.water_table.empty();
  std::vector<double> sum(section.soils.size(), 0.0), area(section.soils.size(), 0.0);
  std::vector<Box> boxes;  // with many regions most are far from a place
  for (const lem::Region& region : section.regions) boxes.emplace_back(region.polygon);
  const auto find_soil = [&](const site::Point& x) {
    for (std::size_t r = section.regions.size(); r-- > 0;)
      if (boxes[r].holds(x) && mesh::is_inside(x, section.regions[r].polygon)) return section.regions[r].soil;
    return -1;
  };
  const auto add = [&](const site::Point& x, double pressure, double share) {
    const int soil = pressure > 0 ? find_soil(x) : -1;
    if (soil < 0) return;
    const auto s = static_cast<std::size_t>(soil);
    sum[s] += share * site::find_unit_weight(data, data.materials.at(section.soils[s].name), pressure);
    area[s] += share;
  };
  if (grid != nullptr) {
    for (const auto& t : grid->triangles) {
      const site::Point &a = grid->nodes[t[0]], &b = grid->nodes[t[1]], &c = grid->nodes[t[2]];
      add({(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3},
          -(grid->pressure[t[0]] + grid->pressure[t[1]] + grid->pressure[t[2]]) / 3,
          std::abs(mesh::compute_area({a, b, c})));
    }
  } else if (has_table) {
    for (std::size_t r = 0; r < section.regions.size(); ++r) {
      const lem::Region& region = section.regions[r];
      const auto& [low, high] = boxes[r];
      for (int i = 0; i < weight_samples * weight_samples; ++i) {
        const int row = i / weight_samples, column = i % weight_samples;
        const site::Point x{low[0] + (high[0] - low[0]) * (column + 0.5) / weight_samples,
                            low[1] + (high[1] - low[1]) * (row + 0.5) / weight_samples};
        const int line = section.soils[static_cast<std::size_t>(region.soil)].piezometric_line;
        const auto& table = line < 0 ? section.water_table : section.piezometric_lines[static_cast<std::size_t>(line)];
        const double suction = weight * (x[1] - site::find_water_table(table, x[0]));
        if (mesh::is_inside(x, region.polygon))
          add(x, std::min(suction, data.initial.water.largest_suction), (high[0] - low[0]) * (high[1] - low[1]));
      }
    }
  }
  for (std::size_t s = 0; s < section.soils.size(); ++s) {
    const input::Material& m = data.materials.at(section.soils[s].name);
    // Without a water table, or beside computed water, dry soil is dry; wet soil at zero pressure is saturated.
    const bool has_none = site::find_pressure_source(data, m) == site::PressureSource::none;
    const bool is_dry = !m.water.is_wet() && (grid == nullptr ? !has_table : has_none);
    if (area[s] > 0)
      section.soils[s].unit_weight = sum[s] / area[s];
    else if (is_dry || has_table)
      section.soils[s].unit_weight = site::find_unit_weight(data, m, 1e-3);
    if (is_dry) section.soils[s].saturated_unit_weight = section.soils[s].unit_weight;
  }
}

/// Sets the unit weights that do not depend on the water until it is known.
void set_saturated(const input::Case& data, lem::Section& section) {
  for (lem::Soil& soil : section.soils)
    soil.unit_weight = soil.saturated_unit_weight = site::find_saturated_weight(data, data.materials.at(soil.name));
}

/// `wet`: the grid of the soils that have a water table.
void set_grid(const site::Site& site, lem::PressureGrid grid, const lem::PressureGrid& wet,
              const std::vector<site::Pond>& ponds, lem::Section& section) {
  set_saturated(site.data(), section);
  section.water_table = site::trace_water_table(wet, ponds, section.ground, section.base);
  section.pressure_grid = std::move(grid);
  weigh_moist_soil(site.data(), &*section.pressure_grid, section);
}

/// Adds the water of the water table that stands on the ground, unless [[hydraulic]] gives levels in its place.
void add_standing_water(const site::Site& site, std::vector<site::Pond>& ponds) {
  const site::Polyline &table = site.water_table(), &ground = site.ground();
  if (table.empty() || site::gives_levels(site.data())) return;
  const double rounding = 1e-9 * (ground.back()[0] - ground.front()[0]);
  std::vector<double> breaks;
  for (const site::Polyline* line : {&table, &ground})
    for (const site::Point& x : *line)
      if (x[0] >= ground.front()[0] && x[0] <= ground.back()[0]) breaks.push_back(x[0]);
  std::sort(breaks.begin(), breaks.end());
  const auto find_depth = [&](double x) { return site::find_water_table(table, x) - site::find_level(ground, x); };
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    // Both lines are straight between two breaks; at a step of the ground its level jumps.
    const double a = breaks[i - 1], b = breaks[i], third = (b - a) / 3, p = find_depth(a + third),
                 q = find_depth(b - third), first = 2 * p - q, last = 2 * q - p;
    if (first <= 0 && last <= 0) continue;
    const double shore = a + (b - a) * first / (first - last), from = first < 0 ? shore : a, to = last < 0 ? shore : b;
    if (!(to - from > rounding)) continue;
    const double level_from = site::find_water_table(table, from), level_to = site::find_water_table(table, to);
    ponds.push_back(
        {{from, level_from - std::max(0.0, first)}, {to, level_to - std::max(0.0, last)}, level_from, level_to});
  }
}

void add_water(const site::Site& site, lem::Section& section, site::WaterResult& out) {
  const input::Case& data = site.data();
  section.water_unit_weight = site.water_weight();
  if (site::needs_seepage(data)) {
    const mesh::Mesh<2> mesh = generate_for_seepage<2>(site);
    set_pressures(site, mesh, site::find_nodal_pressure<2>(site::close_sides(data), mesh, &out),
                  site::find_first_time(data), section);
    return;
  }
  if (data.initial.water.pressure == input::InitialPressure::water_table) {
    site::check_upright(data, "a water table");
    section.water_table = site.water_table();
    for (const input::PiezometricLine& line : data.initial.water.lines) {
      for (lem::Soil& soil : section.soils)
        if (std::find(line.materials.begin(), line.materials.end(), soil.name) != line.materials.end())
          soil.piezometric_line = static_cast<int>(section.piezometric_lines.size());
      section.piezometric_lines.push_back(line.points);
    }
    out = site::make_water_table_result(site);
    if (!site.ponds().empty()) section.water_table = site::add_ponds(section.water_table, site.ponds(), section.ground);
  }
  if (data.initial.water.pressure == input::InitialPressure::grid) {
    site::check_upright(data, "a grid of pressures");
    if (site::has_pressure_field(data)) {
      out = site::make_water_table_result(site);
      const lem::PressureGrid grid = site::make_given_grid(site);
      return set_grid(site, grid, grid, site.find_ponds(site::find_first_time(data)), section);
    }
    section.pressure_ratio = [field = data.initial.water.field](const lem::Point& x) {
      return std::clamp(field->find(x), 0.0, 1.0);
    };
  }
  weigh_moist_soil(data, nullptr, section);
}

/// Returns true if a vertical step of the ground at x contains the stretch from `low` to `high`.
bool lies_on_step(const site::Polyline& ground, double x, double low, double high, double near) {
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const site::Point &a = ground[i - 1], &b = ground[i];
    if (std::abs(a[0] - x) > near || std::abs(b[0] - x) > near) continue;
    if (low >= std::min(a[1], b[1]) - near && high <= std::max(a[1], b[1]) + near) return true;
  }
  return false;
}

/// Adds tractions on named lines of the ground and of its vertical steps.
void add_tractions(const input::Case& data, lem::Section& section, std::vector<std::string>& notes) {
  const double near = 1e-6 * (section.ground.back()[0] - section.ground.front()[0]);
  for (const input::Traction& t : data.tractions) {
    const auto line = std::find_if(data.mesh.lines.begin(), data.mesh.lines.end(),
                                   [&](const mesh::Line& l) { return l.name == t.on; });
    bool lies_on_ground = false;
    const double share = t.factor.at(0);
    if (line != data.mesh.lines.end()) {
      for (std::size_t i = 1; i < line->points.size(); ++i) {
        site::Point a = line->points[i - 1], b = line->points[i];
        if (a[0] > b[0]) std::swap(a, b);
        if (b[0] - a[0] <= near) {
          const auto [low, high] = std::minmax(a[1], b[1]);
          if (!lies_on_step(section.ground, a[0], low, high, near)) continue;
          section.face_loads.push_back({a[0], low, high, {share * t.traction[0], share * t.traction[1]}});
        } else {
          if (std::abs(site::find_level(section.ground, (a[0] + b[0]) / 2) - (a[1] + b[1]) / 2) > near) continue;
          // Tractions become loads per horizontal metre.
          const double along = share * std::hypot(b[0] - a[0], b[1] - a[1]) / (b[0] - a[0]);
          const double down = -along * t.traction[1], right = along * t.traction[0];
          section.surcharges.push_back({{{a[0], down, right}, {b[0], down, right}}});
        }
        lies_on_ground = true;
      }
    }
    if (!lies_on_ground)
      notes.push_back(fmt::format("the traction on '{}' is not on the ground: LEM neglects it", t.on));
  }
}

void add_surcharges(const input::Case& data, lem::Section& section) {
  for (const input::Surcharge& s : data.surcharges) {
    lem::Surcharge load;
    for (std::size_t i = 0; i < s.x.size(); ++i) load.load.push_back({s.x[i], s.load.at(i), 0});
    load.is_variable = s.variable;
    section.surcharges.push_back(std::move(load));
  }
}

/// Adds the pressure of slurries, normal to the ground, as loads per horizontal metre.
void add_slurries(const input::Case& data, lem::Section& section) {
  const double rounding = 1e-9 * (section.ground.back()[0] - section.ground.front()[0]);
  for (const input::Slurry& s : data.slurries) {
    section.slurries.push_back({s.x[0], s.x[1], s.level, s.unit_weight});
    for (std::size_t i = 1; i < section.ground.size(); ++i) {
      const lem::Point &a = section.ground[i - 1], &b = section.ground[i];
      double from = std::max(a[0], s.x[0]), to = std::min(b[0], s.x[1]);
      if (!(to - from > rounding)) continue;
      const double slope = (b[1] - a[1]) / (b[0] - a[0]);
      const auto depth = [&](double x) { return s.level - a[1] - slope * (x - a[0]); };
      if (depth(from) <= 0 && depth(to) <= 0) continue;
      const double shore = slope != 0 ? a[0] + (s.level - a[1]) / slope : from;
      if (depth(from) < 0) from = shore;
      if (depth(to) < 0) to = shore;
      const double first = s.unit_weight * std::max(0.0, depth(from)), last = s.unit_weight * std::max(0.0, depth(to));
      section.surcharges.push_back({{{from, first, slope * first}, {to, last, slope * last}}});
    }
  }
}

void add_roots(const input::Case& data, lem::Section& section, std::vector<std::string>& notes) {
  bool has_blocks = false;
  for (const input::Roots& block : data.roots) {
    const auto cohesion = site::find_ground_cohesion(block);
    if (!cohesion) continue;
    has_blocks = true;
    double from = section.ground.front()[0], to = section.ground.back()[0];
    for (const mesh::Line& line : data.mesh.lines) {
      if (line.name != block.ground) continue;
      from = to = line.points.front()[0];
      for (const site::Point& x : line.points) from = std::min(from, x[0]), to = std::max(to, x[0]);
    }
    const double full = *cohesion * site::find_age_share(block);
    const int parts = block.along.empty() ? 1 : root_parts;
    for (int p = 0; p < parts; ++p) {
      lem::RootCohesion roots;
      roots.from = from + (to - from) * p / parts;
      roots.to = from + (to - from) * (p + 1) / parts;
      const double x = (roots.from + roots.to) / 2;
      for (int i = 0; i <= root_depths; ++i) {
        const double depth = block.depth * i / root_depths;
        roots.profile.push_back({depth, full * site::find_root_share(block, depth, x)});
      }
      section.roots.push_back(std::move(roots));
    }
  }
  for (lem::Soil& soil : section.soils) {
    const input::Material& m = data.materials.at(soil.name);
    if (m.traits().roots != material::RootEffect::cohesion || m.root_cohesion == 0) continue;
    if (!has_blocks)
      soil.cohesion += m.root_cohesion;
    else
      notes.push_back(fmt::format("LEM takes the root cohesion of material '{}' from [[roots]] alone", soil.name));
  }
}

lem::BarDirection convert(input::SupportDirection direction) {
  switch (direction) {
    case input::SupportDirection::tangent:
      return lem::BarDirection::tangent;
    case input::SupportDirection::bisector:
      return lem::BarDirection::bisector;
    case input::SupportDirection::normal:
      return lem::BarDirection::normal;
    case input::SupportDirection::usual:
    case input::SupportDirection::axial:
      break;
  }
  return lem::BarDirection::axial;
}

/// Returns the weight of a wall as a load on the ground above it, over 1e-3 of the width of the section at least.
lem::Surcharge make_weight(const site::Bar& wall, const lem::Section& section) {
  const double middle = 0.5 * (wall.head[0] + wall.end[0]),
               width = std::max(std::abs(wall.head[0] - wall.end[0]),
                                1e-3 * (section.ground.back()[0] - section.ground.front()[0])),
               pressure = wall.weight * wall.length() / width;
  return {{{middle - width / 2, pressure, 0}, {middle + width / 2, pressure, 0}}};
}

void add_bars(const site::Site& site, lem::Section& section) {
  for (const site::Bar& bar : site::list_bars(site)) {
    lem::Bar made;
    made.name = bar.support;
    made.kind = input::get_word(bar.kind);
    made.row = bar.row;
    made.head = bar.head;
    made.end = bar.end;
    if (bar.kind == input::SupportKind::bolt) made.hold = lem::BarHold::end_anchor;
    made.is_pile = bar.kind == input::SupportKind::pile;
    // A wall that surfaces do not cross has no force; its toe is a seed of the search.
    if (made.is_pile || bar.kind == input::SupportKind::wall)
      made.hold = bar.has_soil_pressure ? lem::BarHold::soil_pressure : lem::BarHold::across;
    made.free_length = bar.free_length;
    made.tensile = bar.tensile;
    made.plate = bar.plate;
    made.bond = bar.bond;
    made.bond_factor = bar.bond_factor;
    made.prestress = bar.prestress;
    made.lateral = bar.is_barrier ? 0 : bar.lateral > 0 ? bar.lateral : bar.shear;
    made.shear = bar.shear;
    if (bar.weight > 0) section.surcharges.push_back(make_weight(bar, section));
    made.diameter = bar.diameter;
    made.spacing = bar.spacing;
    if (bar.moment > 0) made.moment = bar.moment;
    made.is_active = bar.is_active;
    made.direction = convert(bar.direction);
    section.bars.push_back(std::move(made));
  }
}

/// Throws if standing water after drawdown is above that before: pools of [[hydraulic]] and seepage give levels that
/// are not in the case file.
void check_standing_water(const lem::Section& before, const lem::Section& after) {
  constexpr double noticeable = 1e-6;  // of the width of the ground, which is the accuracy of a traced water table
  const double near = noticeable * (after.ground.back()[0] - after.ground.front()[0]);
  const ShownUnit& length = after.units.length;
  const auto level = [](const lem::Section& s, double x) {
    return s.water_table.empty() ? s.base : site::find_water_table(s.water_table, x);
  };
  for (std::size_t i = 1; i < after.ground.size(); ++i) {
    // Banks of pools are steps at corners of the ground.
    const lem::Point &a = after.ground[i - 1], &b = after.ground[i];
    const double x = 0.5 * (a[0] + b[0]), ground = 0.5 * (a[1] + b[1]);
    const double from = std::max(ground, level(before, x)), to = std::max(ground, level(after, x));
    if (to > from + near)
      throw Error(
          ExitCode::wrong_input,
          fmt::format("At x = {} the water after drawdown ({}) is above the water before it ({}): "
                      "lower [lem.drawdown] water_table there",
                      format_coordinate(x, length), format_coordinate(to, length), format_coordinate(from, length)));
  }
}

/// Returns the section after a rapid drawdown, with the lowered water table in drained soils.
lem::Section draw_down(const input::Case& data, const input::Drawdown& drawdown, lem::Section before) {
  lem::Section after = before;
  set_saturated(data, after);
  after.pressure_grid.reset();
  after.water_table = drawdown.water_table;
  weigh_moist_soil(data, nullptr, after);
  check_standing_water(before, after);
  after.drawdown = lem::Drawdown{drawdown.method, std::make_shared<const lem::Section>(std::move(before))};
  return after;
}

}  // namespace

void set_pressures(const site::Site& site, const mesh::Mesh<2>& mesh, const std::vector<double>& pressure, double time,
                   lem::Section& section) {
  lem::PressureGrid grid = site::make_pressure_grid(site.data(), mesh, pressure), wet = grid;
  // Soil without water has nodes of its own, all with zero pressure.
  std::erase_if(wet.triangles, [&](const std::array<int, 3>& t) {
    return std::all_of(t.begin(), t.end(), [&](int i) {
      const auto n = static_cast<std::size_t>(i);
      return n >= mesh.nodes.size() && grid.pressure[n] == 0;
    });
  });
  std::vector<site::Pond> ponds = site.find_ponds(time);
  add_standing_water(site, ponds);
  set_grid(site, std::move(grid), wet, ponds, section);
}

SectionOfCase make_section(const site::Site& site) {
  const input::Case& data = site.data();
  SectionOfCase result;
  lem::Section& section = result.section;
  section.units = data.units();
  section.ground = site.ground();
  section.base = site::find_base(data.mesh);
  add_regions(site, section, result.notes);
  for (std::size_t i = 0; i < section.soils.size(); ++i)
    if (std::count(data.lem.impenetrable.begin(), data.lem.impenetrable.end(), section.soils[i].name) > 0)
      section.impenetrable.push_back(static_cast<int>(i));
  add_water(site, section, result.water);
  for (std::string& note : site.list_open_ends()) result.notes.push_back(std::move(note));
  add_surcharges(data, section);
  add_slurries(data, section);
  add_tractions(data, section, result.notes);
  add_roots(data, section, result.notes);
  add_bars(site, section);
  const input::EarthquakeDirection direction = data.earthquake.direction;
  const bool is_both = direction == input::EarthquakeDirection::both;
  section.horizontal_acceleration = is_both ? std::abs(data.earthquake.horizontal) : data.earthquake.horizontal;
  section.push = is_both ? 0 : direction == input::EarthquakeDirection::left ? -1 : 1;
  section.vertical_acceleration = data.earthquake.vertical;
  if (data.lem.crack.depth > 0)
    section.crack = lem::TensionCrack{data.lem.crack.depth, data.lem.crack.water, data.lem.crack.limit};
  if (data.lem.drawdown) {
    section = draw_down(data, *data.lem.drawdown, std::move(section));
    site::add_lowered_state(site, data.lem.drawdown->water_table, result.water);
  }
  return result;
}

std::vector<std::string> list_ground_warnings(const input::Case& data) {
  const site::Site site(data);
  std::vector<std::string> sentences = site::find_odd_water(site);
  for (const site::SteepFace& face : site::find_steep_faces(site))
    sentences.push_back(site::describe(face, data.units().length));
  if (std::string quake = site::describe_factored_quake(data); !quake.empty()) sentences.push_back(std::move(quake));
  return sentences;
}

}  // namespace talus::run
