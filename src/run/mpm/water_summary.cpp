// SPDX-License-Identifier: MIT
#include "run/mpm/water_summary.hpp"

#include <algorithm>
#include <cmath>

#include "run/mpm/record/water_record.hpp"

namespace talus::run {
namespace {

results::SurfaceCondition find_condition(mpm::SurfaceKind kind) {
  switch (kind) {
    case mpm::SurfaceKind::open:
      return results::SurfaceCondition::open;
    case mpm::SurfaceKind::seepage:
      return results::SurfaceCondition::seepage_face;
    case mpm::SurfaceKind::rain:
      return results::SurfaceCondition::rain;
    case mpm::SurfaceKind::flux:
      return results::SurfaceCondition::flux;
    case mpm::SurfaceKind::head:
      return results::SurfaceCondition::total_head;
    case mpm::SurfaceKind::pressure:
      break;
  }
  return results::SurfaceCondition::pressure;
}

}  // namespace

template <int D>
results::WaterBudget make_water_result(const input::Case& data, const mpm::Body<D>& body, double initial) {
  const mpm::Water<D>& water = body.water;
  const std::vector<std::string> names = name_surfaces(water.surfaces);
  results::WaterBudget result;
  result.density = data.water.density;
  result.initial = initial;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const mpm::SurfaceBudget& b = water.budgets[i];
    result.entered += b.entered;
    result.left += b.left;
    result.runoff += b.runoff;
    result.surfaces.push_back(
        {names[i], find_condition(water.surfaces[i].kind), b.entered, b.left, b.supplied, b.runoff});
  }
  const mpm::WaterState<D> state = mpm::find_water_state(body);
  result.stored = state.mass;
  result.lost_between = water.lost_between;
  result.left_grid = water.left_grid;
  result.pressed_in = water.pressed_in;
  const double unexplained = result.stored - (initial + result.entered + water.pressed_in - result.left - water.transpired -
                                            water.lost_between - water.left_grid);
  result.error = unexplained / std::max({initial, result.stored, 1e-300});
  result.largest_pressure = state.largest_pressure;
  result.largest_suction = state.largest_suction;
  result.largest_suction_at.assign(state.place.begin(), state.place.end());
  if (!water.uptakes.empty()) result.transpired = water.transpired;
  return result;
}

template results::WaterBudget make_water_result<2>(const input::Case&, const mpm::Body<2>&, double);
template results::WaterBudget make_water_result<3>(const input::Case&, const mpm::Body<3>&, double);

}  // namespace talus::run
