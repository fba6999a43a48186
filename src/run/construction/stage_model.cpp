// SPDX-License-Identifier: MIT
#include "run/construction/stage_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "input/case/support_places.hpp"
#include "run/common/bedding_lines.hpp"
#include "run/common/walls_of_case.hpp"
#include "run/timeline/moment.hpp"
#include "site/ground_load.hpp"
#include "site/initial_water.hpp"
#include "site/mesh_sides.hpp"
#include "site/weights.hpp"

namespace talus::run {
namespace {

bool is_there(const input::Case& data, const std::string& name, int number) {
  return number == before_stages ? input::is_there_at_start(data, name)
                                 : input::is_there(data, name, static_cast<std::size_t>(number));
}

/// Returns the whole mesh, in which the elements of regions that are not there are empty.
std::shared_ptr<const mesh::Mesh<2>> make_stage_mesh(const input::Case& data, int number, const mesh::Mesh<2>& whole) {
  auto mesh = std::make_shared<mesh::Mesh<2>>(whole);
  std::vector<char> there;
  for (const std::string& region : whole.region_names) there.push_back(is_there(data, region, number));
  for (int& region : mesh->element_region)
    if (region != mesh::empty_region && !there[static_cast<std::size_t>(region)]) region = mesh::empty_region;
  return mesh;
}

/// Returns true if a named line or side of the mesh bounds the soil somewhere.
bool bounds_soil(const mesh::Mesh<2>& mesh, const std::string& name) {
  const auto sides = mesh.sides.find(name);
  if (sides == mesh.sides.end()) return false;
  for (const auto& side : sides->second) {
    int soils = 0;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      const auto& n = mesh.elements[e];
      const auto has = [&](int node) { return std::find(n.begin(), n.end(), node) != n.end(); };
      if (mesh.element_region[e] != mesh::empty_region && has(side[0]) && has(side[1])) ++soils;
    }
    if (soils == 1) return true;
  }
  return false;
}

/// Throws if a part of the soil touches no support.
void check_borne(const input::Case& data, int number, const SolidOfCase<2>& solid) {
  const mesh::Mesh<2>& mesh = *solid.mesh;
  std::vector<int> part(mesh.nodes.size());
  std::iota(part.begin(), part.end(), 0);
  const auto find = [&](int i) {
    while (part[static_cast<std::size_t>(i)] != i)
      i = part[static_cast<std::size_t>(i)] = part[static_cast<std::size_t>(part[static_cast<std::size_t>(i)])];
    return i;
  };
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (mesh.element_region[e] != mesh::empty_region)
      for (const int node : mesh.elements[e]) part[static_cast<std::size_t>(find(node))] = find(mesh.elements[e][0]);
  std::vector<char> borne(mesh.nodes.size(), 0);
  // A smooth vertical side bears no weight.
  const auto bears = [&](const fem::Support<2>& support, const std::array<int, 2>& side) {
    if (!support.along_normal) return support.fixed[1];
    const auto &a = mesh.nodes[static_cast<std::size_t>(side[0])], &b = mesh.nodes[static_cast<std::size_t>(side[1])];
    return std::abs(a[0] - b[0]) > 1e-9 * std::abs(a[1] - b[1]);
  };
  for (const auto& support : solid.model.supports)
    for (const auto& side : support.sides)
      if (bears(support, side))
        for (const int node : side) borne[static_cast<std::size_t>(find(node))] = 1;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const int region = mesh.element_region[e];
    if (region == mesh::empty_region || borne[static_cast<std::size_t>(find(mesh.elements[e][0]))]) continue;
    const std::string where =
        number == before_stages
            ? "at the start"
            : fmt::format("in stage '{}'", data.construction[static_cast<std::size_t>(number)].name);
    throw Error(ExitCode::wrong_input,
                fmt::format("nothing bears region '{}' {}: no soil joins it to a side that is held",
                            mesh.region_names[static_cast<std::size_t>(region)], where));
  }
}

/// The soil without pore water as one whose pressures stay zero.
void make_dry_flow(StageModel& stage) {
  stage.wet_mesh = *stage.solid.mesh;
  for (const std::string& region : stage.wet_mesh.region_names) {
    fem::HydraulicSoil<2> soil;
    soil.name = region, soil.porosity = 0.5, soil.conductivity = {1, 1};
    stage.flow.soils.push_back(soil);
  }
  stage.flow.unit_weight = site::find_water_weight(stage.data);
  stage.model.drainage = fem::StageDrainage::drained;
  stage.model.steady_head = stage.elevation;
}

/// Leaves to the solid the pore pressures that the flow does not have: those given in soil without pore water of its
/// own, and those of r_u.
void keep_given_pressures(StageModel& stage) {
  std::vector<std::array<double, 3>>& pore = stage.solid.model.pore_stress;
  for (std::size_t e = 0; stage.is_wet && e < pore.size(); ++e)
    if (stage.wet_mesh.element_region[e] != mesh::empty_region) pore[e] = {};
}

void add_drains(const input::Case& data, StageModel& stage) {
  if (data.drains.empty() || !stage.is_wet) return;
  stage.model.drains.resize(stage.wet_mesh.elements.size());
  for (const input::VerticalDrains& drains : data.drains)
    for (std::size_t e = 0; e < stage.wet_mesh.elements.size(); ++e) {
      const int region = stage.wet_mesh.element_region[e];
      if (region == mesh::empty_region) continue;
      const auto r = static_cast<std::size_t>(region);
      if (std::find(drains.regions.begin(), drains.regions.end(), stage.wet_mesh.region_names[r]) ==
          drains.regions.end())
        continue;
      const double reach = input::find_served_diameter(drains),
                   k = drains.conductivity.value_or(stage.flow.soils[r].conductivity[0]);
      stage.model.drains[e] = {8 * k / (input::find_drain_factor(drains) * reach * reach), drains.head};
    }
}

/// The pore pressure of wet soil acts in total-stress laws too, whose strength does not depend on it: their initial
/// stress, which the case gives in total stresses, becomes effective.
void make_effective(StageModel& stage, const std::vector<double>& head) {
  const auto acting = fem::find_corner_stress<2>(stage.model, head);
  const mesh::Mesh<2>& mesh = *stage.solid.mesh;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const int region = mesh.element_region[e];
    if (region == mesh::empty_region || stage.solid.model.initial_stress.empty()) continue;
    const input::Material& soil =
        stage.data.materials.at(stage.data.regions.at(mesh.region_names[static_cast<std::size_t>(region)]));
    if (!soil.water.is_wet() || !material::is_total_stress(soil.model, soil)) continue;
    const double pore = (acting[e][0] + acting[e][1] + acting[e][2]) / 3;
    for (std::size_t i = 0; i < 3; ++i) stage.solid.model.initial_stress[e][i] -= pore;
  }
}

/// Throws unless walls in soil with pore water of its own are permeable or not.
void check_permeable(const input::Case& data, const StageModel& stage) {
  for (const fem::Wall& wall : stage.solid.model.walls)
    if (stage.is_wet && !data.supports.at(wall.name).permeable)
      throw Error(ExitCode::wrong_input,
                  fmt::format("support '{}': give 'permeable'; in stages of construction water flows in the soil, "
                              "which a wall with permeable = false stops and one with permeable = true does not",
                              wall.name));
}

/// Lets the bars that were there before carry the force of their state, and those of this stage their prestress.
void lock_off(const input::Case& data, int number, StageModel& stage) {
  stage.model.is_jacking = true;
  for (fem::Bar& bar : stage.solid.model.bars)
    if (is_there(data, bar.name, number - 1)) bar.prestress = 0;
  for (fem::Wall& wall : stage.solid.model.walls) {
    if (!is_there(data, wall.name, number - 1)) continue;
    const std::vector<double>& levels = data.supports.at(wall.name).strut_levels;
    for (std::size_t i = 0; i < levels.size(); ++i)
      for (fem::Strut& strut : wall.struts)
        if (strut.level == levels[i] && is_there(data, input::name_strut(wall.name, i), number - 1))
          strut.prestress = 0;
  }
}

}  // namespace

input::Case make_stage_case(const input::Case& data, int number) {
  input::Case stage = data;
  const auto is_gone = [&](const auto& object) { return !is_there(data, object.name, number); };
  std::erase_if(stage.mesh.polygons, is_gone);
  std::erase_if(stage.surcharges, is_gone);
  std::erase_if(stage.drains, is_gone);
  std::erase_if(stage.supports, [&](const auto& entry) { return !is_there(data, entry.first, number); });
  for (auto& [name, support] : stage.supports) {
    support = input::fix_places(support, input::lay_bars(data, name));
    support.strut_levels.clear();
    const std::vector<double>& levels = data.supports.at(name).strut_levels;
    for (std::size_t i = 0; i < levels.size(); ++i)
      if (is_there(data, input::name_strut(name, i), number)) support.strut_levels.push_back(levels[i]);
  }
  for (int k = 0; k <= number; ++k)
    for (const auto& [region, soil] : data.construction[static_cast<std::size_t>(k)].soils)
      stage.regions[region] = soil;
  stage.construction.clear();
  return stage;
}

double find_stage_end(const input::Case& data, int number) {
  double time = 0;
  for (int k = 0; k <= number; ++k) time += data.construction[static_cast<std::size_t>(k)].duration;
  return time;
}
double find_stage_start(const input::Case& data, int number) {
  return number <= 0 ? 0 : find_stage_end(data, number - 1);
}

std::shared_ptr<const mesh::Mesh<2>> make_whole_mesh(const input::Case& data, std::vector<std::string>& notes) {
  mesh::Plan plan = data.mesh;
  std::vector<WallLine> walls;
  double width = 0;
  for (int k = before_stages; k < static_cast<int>(data.construction.size()); ++k) {
    const site::Site site(begin_later(make_stage_case(data, k), k < 0 ? 0 : find_stage_end(data, k), nullptr));
    if (!site.has_ground()) continue;
    plan = site::conform_to_loads(site, std::move(plan));
    width = std::max(width, input::measure_width(site.ground()));
    for (WallLine& wall : list_walls(site))
      if (std::none_of(walls.begin(), walls.end(), [&](const WallLine& w) { return w.points == wall.points; }))
        walls.push_back(std::move(wall));
  }
  if (!walls.empty()) plan = conform_to_walls(walls, width, std::move(plan));
  plan.algorithm = data.fem.algorithm;
  if (data.fem.size) plan = mesh::resize(std::move(plan), *data.fem.size);
  return std::make_shared<const mesh::Mesh<2>>(generate_along_bedding<2>(data, plan, notes));
}

std::vector<double> map_nodes(const StageModel& from, const std::vector<double>& values, const StageModel& to) {
  std::vector<double> mapped(to.water_mesh->nodes.size());
  for (std::size_t e = 0; e < to.water_mesh->elements.size(); ++e)
    for (std::size_t i = 0; i < 3; ++i)
      mapped[static_cast<std::size_t>(to.water_mesh->elements[e][i])] =
          values[static_cast<std::size_t>(from.water_mesh->elements[e][i])];
  return mapped;
}

std::vector<double> find_heads(const StageModel& stage, const std::vector<double>& pressure) {
  std::vector<double> head = stage.elevation;
  for (std::size_t i = 0; i < head.size(); ++i) head[i] -= pressure[i] / stage.flow.unit_weight;
  return head;
}

std::vector<double> find_pressures(const StageModel& stage, const std::vector<double>& head) {
  std::vector<double> pressure = stage.elevation;
  for (std::size_t i = 0; i < head.size(); ++i) pressure[i] = (pressure[i] - head[i]) * stage.flow.unit_weight;
  return pressure;
}

std::unique_ptr<StageModel> make_stage_model(const input::Case& data, int number,
                                             const std::shared_ptr<const mesh::Mesh<2>>& whole,
                                             std::shared_ptr<const input::KnownWater> water) {
  auto stage = std::make_unique<StageModel>();
  const auto mesh = make_stage_mesh(data, number, *whole);
  input::Case then = make_stage_case(data, number);
  std::erase_if(then.hydraulics, [&](const input::Hydraulic& h) { return !bounds_soil(*mesh, h.on); });
  stage->data = begin_later(then, number == before_stages ? 0 : find_stage_end(data, number), std::move(water));
  const site::Site site(stage->data);
  stage->solid = make_solid_on<2>(site, mesh);
  check_borne(data, number, stage->solid);
  if (number != before_stages) lock_off(data, number, *stage);
  stage->is_wet = std::any_of(then.mesh.polygons.begin(), then.mesh.polygons.end(), [&](const mesh::Polygon& p) {
    return then.materials.at(then.regions.at(p.name)).water.is_wet();
  });
  check_permeable(then, *stage);
  stage->water_mesh = mesh;
  if (stage->is_wet && has_impermeable_walls(then))
    stage->water_mesh = std::make_shared<const mesh::Mesh<2>>(cut_at_walls(site, *mesh));
  for (const auto& x : stage->water_mesh->nodes) stage->elevation.push_back(x[1]);
  if (stage->is_wet) {
    stage->flow = site::make_seepage_model<2>(then, *stage->water_mesh, stage->wet_mesh);
    for (auto& soil : stage->flow.soils) soil.skeleton_compressibility = 0;  // that of the solid
  } else {
    make_dry_flow(*stage);
  }
  keep_given_pressures(*stage);
  stage->flow.mesh = &stage->wet_mesh;
  stage->model.solid = &stage->solid.model;
  stage->model.flow = &stage->flow;
  stage->model.suction_stress = [names = mesh->region_names, materials = stage->data.materials,
                                 regions = stage->data.regions](int region, double s) {
    const input::Material& soil = materials.at(regions.at(names[static_cast<std::size_t>(region)]));
    if (soil.water.retention == input::RetentionCurve::saturated) return material::CurvePoint<double>{s, 1};
    const double step = 1e-4 * s;
    return material::CurvePoint<double>{
        site::find_suction_stress(soil, s),
        (site::find_suction_stress(soil, s + step) - site::find_suction_stress(soil, s - step)) / (2 * step)};
  };
  add_drains(stage->data, *stage);
  if (number == before_stages) {
    const std::vector<double> head =
        stage->is_wet ? find_heads(*stage, site::find_nodal_pressure<2>(stage->data, *stage->water_mesh))
                      : stage->elevation;
    make_effective(*stage, head);
    stage->model.steady_head = head;
  }
  return stage;
}

}  // namespace talus::run
