// SPDX-License-Identifier: MIT
#include "run/timeline/water_in_time.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "run/common/section_of_case.hpp"
#include "run/common/walls_of_case.hpp"
#include "run/timeline/times.hpp"
#include "site/initial_water.hpp"
#include "site/pore_water.hpp"
#include "site/site.hpp"

namespace talus::run {

WaterInTime::WaterInTime(const input::Case& data)
    : given_(data), data_(site::close_sides(data)), mesh_(generate_for_seepage<2>(data_)) {
  model_ = site::make_seepage_model<2>(data_, mesh_, wet_mesh_);
  fem::check_storage(model_);
}

void WaterInTime::calculate(const PreparedSlope& prepared, results::Timeline& summary) {
  const auto start = std::chrono::steady_clock::now();
  section_ = prepared.slope->section();
  water_ = prepared.water;
  std::vector<double> heads;
  for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) {
    first_pressure_.push_back(-section_.pressure_grid->pressure[i]);
    heads.push_back(mesh_.nodes[i][1] - first_pressure_[i] / model_.unit_weight);
  }
  fem::SeepageSchedule schedule;
  schedule.outputs = list_times(data_);
  schedule.head_tolerance = site::head_tolerance;
  flow_ = site::follow_flow<2>(data_, model_, heads, schedule, "[timeline]");
  times_ = {0};
  times_.insert(times_.end(), schedule.outputs.begin(), schedule.outputs.end());
  summary.weather = site::make_season_result(flow_.record);
  summary.step_error = flow_.history.largest_error;
  summary.seepage_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

const std::vector<double>& WaterInTime::find_pressure(std::size_t number) const {
  return number == 0 ? first_pressure_ : flow_.history.states[number - 1].pressure;
}

Moment WaterInTime::make_moment(std::size_t number) const {
  Moment moment;
  moment.time = times_[number];
  lem::Section now = section_;
  set_pressures(data_, mesh_, find_pressure(number), moment.time + site::find_first_time(data_), now);
  moment.slope = std::make_unique<lem::Slope>(std::move(now));
  return moment;
}

std::size_t WaterInTime::find_nearest(double time) const {
  const auto nearer = [&](double a, double b) { return std::abs(a - time) < std::abs(b - time); };
  return static_cast<std::size_t>(std::min_element(times_.begin(), times_.end(), nearer) - times_.begin());
}

input::Case WaterInTime::begin_at(std::size_t number) const {
  if (number == 0) return begin_later(given_, times_[number], nullptr);
  const fem::SeepageResult<2>& state = flow_.history.states[number - 1];
  return begin_later(
      given_, times_[number],
      std::make_shared<const input::KnownWater>(input::KnownWater{mesh_, state.pressure, state.velocity}));
}

bool WaterInTime::stands_on_ground(const input::Hydraulic& condition, double level) const {
  input::Case alone = data_;
  alone.hydraulics = {condition};
  alone.hydraulics.front().head = {{0}, {level}};
  return !site::Site(alone).find_ponds(0).empty();
}

/// Returns the field of time 0: that of the methods, if it is on this mesh.
results::WaterField WaterInTime::make_first_field() const {
  if (water_.fields && water_.fields->nodes.size() == mesh_.nodes.size() && !water_.fields->states.empty())
    return water_.fields->states.back();
  results::WaterField first;
  first.flow = water_.states->back().flow;
  for (const double p : first_pressure_) first.pressure.push_back(-p);
  return first;
}

void WaterInTime::keep_states(const std::vector<double>& times, results::Timeline& summary) {
  if (!water_.states || water_.states->empty()) return;
  fields_ = site::begin_fields(data_, wet_mesh_);
  for (const double time : times) {
    if (time == 0) {
      summary.states.push_back(water_.states->back());
      if (fields_) fields_->states.push_back(make_first_field());
      continue;
    }
    const auto at = std::find(times_.begin(), times_.end(), time);
    const auto& state = flow_.history.states[static_cast<std::size_t>(at - times_.begin()) - 1];
    summary.states.push_back(site::make_state_result<2>(data_, state, results::WaterFlow::transient, time));
    if (fields_)
      fields_->states.push_back(site::make_field_result<2>(wet_mesh_, state, results::WaterFlow::transient, time));
  }
}

}  // namespace talus::run
