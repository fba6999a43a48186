// SPDX-License-Identifier: MIT
#include "run/construction/stage_supports.hpp"

#include <algorithm>
#include <cmath>

#include "run/common/walls_of_case.hpp"
#include "site/supports.hpp"

namespace talus::run {

namespace {

double find_largest(const std::vector<double>& values) {
  double largest = 0;
  for (const double v : values)
    if (std::abs(v) > std::abs(largest)) largest = v;
  return largest;
}

/// Adds the motion of a wall in this stage to that of the stage before, if one is given.
void add_deflection(const fem::BarForces& start, const fem::BarForces& now, const results::ConstructionStage* stage,
                    results::ConstructionSupport& out) {
  constexpr double same_place = 1e-9;
  const fem::BarCurve &before = start.deflection, &after = now.deflection;
  const results::ConstructionSupport* last = nullptr;
  if (stage)
    for (const results::ConstructionSupport& s : stage->supports)
      if (s.support == out.support && s.row == out.row && s.deflection) last = &s;
  const auto find_last = [&](double place) {
    for (std::size_t i = 0; last && i < last->deflection->size(); ++i)
      if (std::abs((*last->deflection_place)[i] - place) < same_place) return (*last->deflection)[i];
    return 0.0;
  };
  out.deflection_place = after.place;
  out.deflection.emplace();
  for (std::size_t i = 0; i < after.place.size(); ++i)
    out.deflection->push_back(find_last(after.place[i]) + after.value[i] - before.value[i]);
  out.largest_deflection = find_largest(*out.deflection);
}

}  // namespace

std::vector<fem::BarForces> list_bar_forces(const StageModel& stage, const fem::SolidState<2>& solid) {
  const fem::SolidModel<2>& model = stage.solid.model;
  if (model.bars.empty() && model.walls.empty()) return {};
  return fem::compute_bar_forces(model, solid);
}

std::vector<results::ConstructionSupport> make_stage_supports(const StageModel& stage, const fem::SolidState<2>& solid,
                                                              const std::vector<fem::BarForces>& start,
                                                              const results::ConstructionStage* before) {
  std::vector<results::ConstructionSupport> supports;
  const fem::SolidModel<2>& model = stage.solid.model;
  if (model.bars.empty() && model.walls.empty()) return supports;
  const std::vector<fem::BarForces> forces = list_bar_forces(stage, solid);
  const site::Site site(stage.data);
  std::vector<site::Bar> bars = site::list_bars(site);
  std::erase_if(bars, [](const site::Bar& bar) { return bar.kind == input::SupportKind::wall; });
  const std::vector<WallLine> walls = list_walls(site);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    results::ConstructionSupport& out = supports.emplace_back();
    out.support = i < model.bars.size() ? model.bars[i].name : model.walls[i - model.bars.size()].name;
    out.place = forces[i].axial.place;
    out.force = forces[i].axial.value;
    out.moment = forces[i].moment.value;
    out.shear = forces[i].shear.value;
    out.largest_force = find_largest(out.force);
    out.largest_moment = std::abs(find_largest(out.moment));
    out.largest_shear = std::abs(find_largest(out.shear));
    out.head_force = forces[i].plate;
    out.row = i < bars.size() ? bars[i].row : walls[i - bars.size()].row;
    if (!forces[i].strut.value.empty()) out.struts = forces[i].strut.value;
    if (i >= bars.size()) add_deflection(start[i], forces[i], before, out);
  }
  return supports;
}

}  // namespace talus::run
