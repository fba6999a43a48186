// SPDX-License-Identifier: MIT
#include "run/mpm/record/water_record.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/units.hpp"

namespace talus::run {

std::vector<std::string> name_surfaces(const std::vector<mpm::SurfaceCondition>& surfaces) {
  std::vector<std::string> names;
  for (const mpm::SurfaceCondition& s : surfaces) {
    std::string name = s.name;
    for (int number = 2; std::find(names.begin(), names.end(), name) != names.end(); ++number)
      name = fmt::format("{} ({})", s.name, number);
    names.push_back(name);
  }
  return names;
}

template <int D>
WaterRecord<D>::WaterRecord(const input::Case& data, const mpm::Body<D>& body)
    : names_(name_surfaces(body.water.surfaces)),
      density_(data.water.density),
      stress_(units::get_si_factor(data.output.stress_unit)),
      stress_unit_(data.output.stress_unit) {
  for (const mpm::SurfaceCondition& s : body.water.surfaces) is_rain_.push_back(s.kind == mpm::SurfaceKind::rain);
  has_roots_ = !body.water.uptakes.empty();
  begin_interval(body);
}

template <int D>
void WaterRecord<D>::begin_interval(const mpm::Body<D>& body) {
  time_ = body.time;
  budgets_ = body.water.budgets;
  transpired_ = body.water.transpired;
}

template <int D>
std::vector<output::Column> WaterRecord<D>::list_columns() const {
  std::vector<output::Column> columns{
      {"water_mass", "kg"}, {"largest_pore_pressure", stress_unit_}, {"largest_suction", stress_unit_}};
  for (std::size_t i = 0; i < names_.size(); ++i) {
    columns.push_back({names_[i] + ".inflow", "m3/s"});
    columns.push_back({names_[i] + ".outflow", "m3/s"});
    if (is_rain_[i]) columns.push_back({names_[i] + ".runoff", "m3/s"});
  }
  if (has_roots_) columns.push_back({"transpiration", "m3/s"});
  return columns;
}

template <int D>
void WaterRecord<D>::append(const mpm::Body<D>& body, const mpm::WaterState<D>& state, std::vector<double>& row) {
  row.insert(row.end(), {state.mass, state.largest_pressure / stress_, state.largest_suction / stress_});
  const double share = body.time > time_ ? 1 / (density_ * (body.time - time_)) : 0;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const mpm::SurfaceBudget &now = body.water.budgets[i], &before = budgets_[i];
    row.push_back((now.entered - before.entered) * share);
    row.push_back((now.left - before.left) * share);
    if (is_rain_[i]) row.push_back((now.runoff - before.runoff) * share);
  }
  if (has_roots_) row.push_back((body.water.transpired - transpired_) * share);
  begin_interval(body);
}

template <int D>
std::vector<double> WaterRecord<D>::save() const {
  std::vector<double> saved{time_};
  for (const mpm::SurfaceBudget& b : budgets_) saved.insert(saved.end(), {b.entered, b.left, b.supplied, b.runoff});
  saved.push_back(transpired_);
  return saved;
}

template <int D>
void WaterRecord<D>::restore(const std::vector<double>& saved) {
  time_ = saved[0];
  for (std::size_t i = 0; i < budgets_.size(); ++i)
    budgets_[i] = {saved[4 * i + 1], saved[4 * i + 2], saved[4 * i + 3], saved[4 * i + 4]};
  transpired_ = saved.back();
}

template class WaterRecord<2>;
template class WaterRecord<3>;

}  // namespace talus::run
