// SPDX-License-Identifier: MIT
#include "laboratory/calibration_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.hpp"
#include "base/units.hpp"
#include "input/case/checks.hpp"
#include "input/case/uncertain_number.hpp"
#include "laboratory/point_test.hpp"
#include "laboratory/stage_history.hpp"
#include "run/construction/stage_record.hpp"

namespace talus::laboratory {

namespace {

/// Signs of the legs: +1 if the controlled quantity increases.
std::vector<int> list_directions(const input::PointTest& test) {
  const std::vector<double> turns = list_turns(test);
  std::vector<int> directions;
  for (std::size_t i = 1; i < turns.size(); ++i) directions.push_back(turns[i] >= turns[i - 1] ? 1 : -1);
  return directions;
}

/// Returns the division of the points among the legs with the least cost, and that cost.
std::pair<std::vector<std::size_t>, double> divide(const std::vector<std::array<double, 2>>& points,
                                                   const std::vector<int>& directions, int sense) {
  const std::size_t n = points.size(), legs = directions.size();
  // least[i][k]: least distance in the wrong direction up to point i, if it lies on leg k.
  std::vector<std::vector<double>> least(n, std::vector<double>(legs, 0));
  std::vector<std::vector<std::size_t>> from(n, std::vector<std::size_t>(legs, 0));
  for (std::size_t i = 1; i < n; ++i)
    for (std::size_t k = 0; k < legs; ++k) {
      least[i][k] = std::numeric_limits<double>::infinity();
      const double wrong = std::max(0.0, -sense * directions[k] * (points[i][0] - points[i - 1][0]));
      // The step to a point belongs to the leg of that point.
      for (std::size_t before = 0; before <= k; ++before)
        if (least[i - 1][before] + wrong < least[i][k]) {
          least[i][k] = least[i - 1][before] + wrong;
          from[i][k] = before;
        }
    }
  const auto best = std::min_element(least[n - 1].begin(), least[n - 1].end());
  std::vector<std::size_t> leg(n);
  leg[n - 1] = static_cast<std::size_t>(best - least[n - 1].begin());
  for (std::size_t i = n - 1; i > 0; --i) leg[i - 1] = from[i][leg[i]];
  return {leg, *best};
}

}  // namespace

std::vector<std::size_t> find_legs(const input::PointTest& test, const std::vector<std::array<double, 2>>& points) {
  const std::vector<int> directions = list_directions(test);
  if (directions.size() < 2 || points.empty()) return std::vector<std::size_t>(points.size(), 0);
  // Most abscissae increase with the controlled quantity; a void ratio or a saturation decreases.
  const auto with = divide(points, directions, 1), against = divide(points, directions, -1);
  return against.second < with.second ? against.first : with.first;
}

Reading read_curve(const PointCurve& curve, std::size_t leg, const std::string& x_name, const std::string& y_name,
                   double x) {
  const std::vector<PointRow>& rows = curve.rows;
  const auto turn = [&](std::size_t k) { return k < curve.turns.size() ? curve.turns[k] : rows.size() - 1; };
  const std::size_t first = leg == 0 ? 0 : turn(leg - 1), last = turn(leg);
  double before = get_quantity(rows[first], x_name);
  Reading nearest{get_quantity(rows[first], y_name), std::abs(x - before)};
  for (std::size_t i = first + 1; i <= last; ++i) {
    const double here = get_quantity(rows[i], x_name);
    if (std::min(before, here) <= x && x <= std::max(before, here)) {
      const double share = here == before ? 1 : (x - before) / (here - before);
      return {(1 - share) * get_quantity(rows[i - 1], y_name) + share * get_quantity(rows[i], y_name), 0};
    }
    if (std::abs(x - here) < nearest.missing) nearest = {get_quantity(rows[i], y_name), std::abs(x - here)};
    before = here;
  }
  return nearest;
}

namespace {

/// Residual, in standard errors, of a point that the test does not reach; it grows with the distance. The end of a
/// curve at failure has no information on the parameters, and any soil that reaches the point fits better.
constexpr double missed = 100;
constexpr double slack = 1e-6;  ///< of the measured abscissae: a smaller distance beyond the end counts as at the end
constexpr std::size_t most_drawn = 200;

/// Returns the first fault that the checks of a case find in the soil; empty if there is none.
std::string find_fault(const std::string& name, const input::Material& soil) {
  input::Case alone;
  alone.materials[name] = soil;
  alone.regions["soil"] = name;  // a soil without a region would be a fault of its own
  alone.mesh.file = "soil";
  input::Places places;
  input::Findings findings(places);
  input::check_materials(alone, findings);
  return findings.empty() ? "" : findings.sort().front().sentence;
}

}  // namespace

CalibrationModel::CalibrationModel(const input::Case& data, EvaluationStore* store)
    : data_(data), calibration_(*data.calibration), store_(store) {
  for (const input::MeasuredCurve& curve : calibration_.curves) {
    if (std::find(tests_.begin(), tests_.end(), curve.test_number) == tests_.end()) tests_.push_back(curve.test_number);
    legs_.push_back(find_legs(data.tests[curve.test_number], curve.points));
    const auto by_x = [](const auto& a, const auto& b) { return a[0] < b[0]; };
    const auto [low, high] = std::minmax_element(curve.points.begin(), curve.points.end(), by_x);
    const double span = (*high)[0] - (*low)[0];
    spans_.push_back(span > 0 ? span : std::max(std::abs((*high)[0]), 1e-300));
    if (curve.weight > 0) value_count_ += curve.points.size();
  }
  for (const input::MonitoredCurve& curve : calibration_.monitors)
    if (curve.weight > 0) value_count_ += curve.points.size();
}

// The time steps of stages follow their errors: results scatter by a small part of the tolerance. Element tests are
// solved to ten digits, which smaller steps than these would resolve.
double CalibrationModel::difference_step() const {
  return calibration_.monitors.empty() ? 5e-4 : 1e-2;
}
double CalibrationModel::search_tolerance() const {
  return calibration_.monitors.empty() ? 1e-10 : 1e-4;
}

double CalibrationModel::find_value(std::size_t i, double u) const {
  const input::CalibrationParameter& p = calibration_.parameters[i];
  // The ends are exact, so that a number at its limit equals the limit.
  if (u <= 0) return p.low;
  if (u >= 1) return p.high;
  return p.scale == input::CalibrationScale::log ? p.low * std::pow(p.high / p.low, u) : p.low + u * (p.high - p.low);
}

std::vector<double> CalibrationModel::find_values(const std::vector<double>& places) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < places.size(); ++i) values.push_back(find_value(i, places[i]));
  return values;
}

double CalibrationModel::find_place(std::size_t i, double value) const {
  const input::CalibrationParameter& p = calibration_.parameters[i];
  const double u = p.scale == input::CalibrationScale::log ? std::log(value / p.low) / std::log(p.high / p.low)
                                                           : (value - p.low) / (p.high - p.low);
  return std::clamp(u, 0.0, 1.0);
}

double CalibrationModel::find_slope(std::size_t i, double u) const {
  const input::CalibrationParameter& p = calibration_.parameters[i];
  return p.scale == input::CalibrationScale::log ? find_value(i, u) * std::log(p.high / p.low) : p.high - p.low;
}

input::Material CalibrationModel::make_soil(std::size_t test, const std::vector<double>& places) const {
  input::Material soil = data_.test_soils[test];
  for (std::size_t i = 0; i < places.size(); ++i) {
    const input::CalibrationParameter& p = calibration_.parameters[i];
    const auto& own = data_.tests[test].set;
    if (p.material != data_.tests[test].material) continue;
    if (std::any_of(own.begin(), own.end(), [&](const auto& s) { return s.key == p.path; })) continue;
    input::set_number(soil, p.path, find_value(i, places[i]));
  }
  return soil;
}

std::string CalibrationModel::compare_tests(const std::vector<double>& places, bool with_lines,
                                            Comparison& result) const {
  std::map<std::size_t, PointCurve> curves;
  for (const std::size_t test : tests_) {
    const input::Material soil = make_soil(test, places);
    if (std::string fault = find_fault(data_.tests[test].material, soil); !fault.empty()) return fault;
    try {
      curves[test] = run_point_test(soil, data_.tests[test], data_.units().stress);
      ++runs_;
    } catch (const Error& error) {
      return error.what();
    }
  }
  for (std::size_t k = 0; k < calibration_.curves.size(); ++k) {
    const input::MeasuredCurve& c = calibration_.curves[k];
    std::vector<double>& values = result.values.emplace_back();
    double missing = 0;
    for (std::size_t i = 0; i < c.points.size(); ++i) {
      const Reading reading = read_curve(curves.at(c.test_number), legs_[k][i], c.x, c.y, c.points[i][0]);
      values.push_back(reading.y);
      const double beyond = reading.missing / spans_[k];
      if (beyond > slack) missing += beyond / static_cast<double>(c.points.size());
      if (c.weight <= 0) continue;
      const double error = beyond > slack ? missed * (1 + beyond) : (reading.y - c.points[i][1]) / c.deviation;
      result.residuals.push_back(c.weight * error);
    }
    result.missing.push_back(missing);
    if (!with_lines) continue;
    const PointCurve& curve = curves.at(c.test_number);
    std::vector<results::Point>& line = result.lines.emplace_back();
    for (const std::size_t i : choose_drawn(curve, most_drawn))
      line.push_back({get_quantity(curve.rows[i], c.x), get_quantity(curve.rows[i], c.y)});
  }
  return "";
}

std::string CalibrationModel::compare_stages(const std::vector<double>& places, bool with_lines,
                                             Comparison& result) const {
  if (calibration_.monitors.empty()) return "";
  input::Case changed = data_;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const input::CalibrationParameter& p = calibration_.parameters[i];
    input::set_number(changed.materials.at(p.material), p.path, find_value(i, places[i]));
  }
  for (const auto& [name, soil] : changed.materials)
    if (std::string fault = find_fault(name, soil); !fault.empty()) return fault;
  std::optional<StageHistory> history;
  try {
    history.emplace(changed);
    ++runs_;
  } catch (const Error& error) {
    if (error.code() != ExitCode::wrong_input) throw;
    return error.what();
  }
  const double end = history->times().back();
  for (const input::MonitoredCurve& c : calibration_.monitors) {
    const std::vector<double> computed = history->list_values(c.number, c.quantity);
    std::vector<double>& values = result.values.emplace_back();
    double missing = 0;
    for (const auto& [time, measured] : c.points) {
      const double value = run::read_in_time(history->times(), computed, std::min(time, end));
      if (!std::isfinite(value))
        return fmt::format("monitor '{}' is not in soil at {}, when it was measured", c.monitor,
                           units::format_time(time));
      values.push_back(value);
      const double beyond = time > end ? (time - end) / time : 0;
      if (beyond > slack) missing += beyond / static_cast<double>(c.points.size());
      if (c.weight <= 0) continue;
      const double error = beyond > slack ? missed * (1 + beyond) : (value - measured) / c.deviation;
      result.residuals.push_back(c.weight * error);
    }
    result.missing.push_back(missing);
    if (!with_lines) continue;
    std::vector<results::Point>& line = result.lines.emplace_back();
    for (std::size_t i = 0; i < computed.size(); ++i)
      if (std::isfinite(computed[i])) line.push_back({history->times()[i], computed[i]});
  }
  return "";
}

std::optional<Comparison> CalibrationModel::evaluate(const std::vector<double>& places, std::string& fault,
                                                     bool with_lines) const {
  Comparison result;
  result.residuals.reserve(value_count_);
  fault = compare_tests(places, with_lines, result);
  if (fault.empty()) fault = compare_stages(places, with_lines, result);
  for (const double r : result.residuals)
    if (fault.empty() && !std::isfinite(r)) fault = "a test gives a value that is not finite";
  if (fault.empty()) return result;
  return std::nullopt;
}

std::optional<Comparison> CalibrationModel::compare(const std::vector<double>& places, std::string* why,
                                                    bool with_lines) const {
  std::optional<Comparison> result;
  std::string fault;
  if (store_ != nullptr && !with_lines) {
    if (std::optional<Evaluation> known = store_->find(places)) {
      fault = std::move(known->fault);
      if (fault.empty()) result.emplace().residuals = std::move(known->residuals);
      runs_ += static_cast<long>(tests_.size()) + (calibration_.monitors.empty() ? 0 : 1);
    } else {
      result = evaluate(places, fault, false);
      store_->add(places, {result ? result->residuals : std::vector<double>{}, fault});
    }
  } else {
    result = evaluate(places, fault, with_lines);
  }
  if (!result && why != nullptr) *why = fault;
  return result;
}

}  // namespace talus::laboratory
