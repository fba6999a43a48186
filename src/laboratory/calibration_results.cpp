#include "laboratory/calibration_results.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/units.hpp"
#include "input/case/measured_table.hpp"
#include "output/files/history.hpp"

namespace talus::laboratory {
namespace {

using nlohmann::json;

/// A quantity as people read it.
struct Shown {
  std::string name, title, symbol, unit;
  double factor = 1;  ///< one `unit` in SI
};

Shown show_quantity(const std::string& name, const std::string& stress_unit) {
  const input::PointQuantity& q = *input::find_point_quantity(name);
  if (std::string(q.unit) == "Pa") return {name, q.title, q.symbol, stress_unit, units::get_si_factor(stress_unit)};
  if (name.ends_with("strain")) return {name, q.title, q.symbol, "%", 0.01};
  return {name, q.title, q.symbol, q.unit, 1};
}

json to_json(const Shown& q) {
  return {{"name", q.name}, {"title", q.title + (q.symbol.empty() ? "" : " ") + q.symbol}, {"unit", q.unit}};
}

/// Nine digits, which are more than any measurement has.
double round_off(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double power = std::pow(10, 8 - std::floor(std::log10(std::abs(value))));
  return std::isfinite(power) ? std::round(value * power) / power : value;
}

json scale(const std::vector<double>& values, double factor) {
  json list = json::array();
  for (const double v : values) list.push_back(round_off(v / factor));
  return list;
}

json scale(const std::vector<std::array<double, 2>>& line, const Shown& x, const Shown& y) {
  json list = json::array();
  for (const auto& [a, b] : line) list.push_back({round_off(a / x.factor), round_off(b / y.factor)});
  return list;
}

json show_value(std::optional<double> value, double factor) {
  return value ? json(*value / factor) : json();
}

const char* name_limit(AtLimit limit) {
  return limit == AtLimit::low ? "low" : limit == AtLimit::high ? "high" : "no";
}

json describe_curve(const FittedCurve& c, const std::string& stress_unit) {
  const Shown x = show_quantity(c.x, stress_unit), y = show_quantity(c.y, stress_unit);
  return {{"test", c.test},
          {"x", to_json(x)},
          {"y", to_json(y)},
          {"at", scale(c.at, x.factor)},
          {"measured", scale(c.measured, y.factor)},
          {"before", scale(c.before, y.factor)},
          {"fitted", scale(c.fitted, y.factor)},
          {"line", scale(c.line, x, y)},
          {"line_before", scale(c.line_before, x, y)},
          {"deviation", c.deviation / y.factor},
          {"weight", c.weight},
          {"rms", c.rms / y.factor},
          {"rms_before", c.rms_before / y.factor},
          {"mean", c.mean / y.factor},
          {"largest", c.largest / y.factor},
          {"largest_at", c.largest_at / x.factor},
          {"missing", c.missing}};
}

/// A cell of text, with quotation marks where a comma would end it.
std::string write_cell(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + "\"";
}

}  // namespace

std::string write_value(const FittedParameter& p) {
  // Six digits are more than any calibration knows; a value at its limit must not be rounded past it.
  const std::string text = fmt::format("{:.6g}", p.value / p.factor);
  return p.limit == AtLimit::no ? text : output::to_shortest(p.value / p.factor);
}

std::string write_parameter_table(const CalibrationResult& result) {
  std::string text = "parameter,unit,start,fitted,standard_error,min,max,limit\n";
  for (const FittedParameter& p : result.parameters)
    text += fmt::format("{},{},{:.10g},{:.10g},{},{:.10g},{:.10g},{}\n", p.key, p.unit.empty() ? "-" : p.unit,
                        p.start / p.factor, p.value / p.factor,
                        p.error ? fmt::format("{:.6g}", *p.error / p.factor) : "", p.low / p.factor, p.high / p.factor,
                        p.limit == AtLimit::no    ? ""
                        : p.limit == AtLimit::low ? "min"
                                                  : "max");
  return text;
}

std::string write_correlation_table(const CalibrationResult& result) {
  std::string text = "parameter";
  for (const FittedParameter& p : result.parameters) text += "," + p.key;
  text += '\n';
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    text += result.parameters[i].key;
    for (const auto& c : result.correlation[i]) text += c ? fmt::format(",{:.6f}", *c) : ",";
    text += '\n';
  }
  return text;
}

std::string write_curve_table(const CalibrationResult& result, const std::string& stress_unit) {
  std::string text = "test,x,x_unit,y,y_unit,x_value,measured,with_start,fitted,difference,standard_error\n";
  for (const FittedCurve& c : result.curves) {
    const Shown x = show_quantity(c.x, stress_unit), y = show_quantity(c.y, stress_unit);
    for (std::size_t i = 0; i < c.at.size(); ++i)
      text += fmt::format("{},{},{},{},{},{:.10g},{:.10g},{:.10g},{:.10g},{:.6g},{:.6g}\n", write_cell(c.test), c.x,
                          x.unit, c.y, y.unit, c.at[i] / x.factor, c.measured[i] / y.factor, c.before[i] / y.factor,
                          c.fitted[i] / y.factor, (c.fitted[i] - c.measured[i]) / y.factor, c.deviation / y.factor);
  }
  return text;
}

json to_json(const CalibrationResult& result, const std::string& stress_unit) {
  json parameters = json::array(), curves = json::array(), starts = json::array(), correlation = json::array();
  for (const FittedParameter& p : result.parameters)
    parameters.push_back({{"key", p.key},
                          {"unit", p.unit},
                          {"start", p.start / p.factor},
                          {"value", p.value / p.factor},
                          {"text", write_value(p)},
                          {"low", p.low / p.factor},
                          {"high", p.high / p.factor},
                          {"error", show_value(p.error, p.factor)},
                          {"limit", name_limit(p.limit)}});
  for (const FittedCurve& c : result.curves) curves.push_back(describe_curve(c, stress_unit));
  for (const auto& row : result.correlation) {
    json& list = correlation.emplace_back(json::array());
    for (const auto& c : row) list.push_back(show_value(c, 1));
  }
  const auto show_all = [&](const std::vector<double>& values) {
    json list = json::array();
    for (std::size_t i = 0; i < values.size(); ++i) list.push_back(values[i] / result.parameters[i].factor);
    return list;
  };
  for (const CalibrationStart& s : result.starts)
    starts.push_back({{"from", show_all(s.from)},
                      {"to", show_all(s.to)},
                      {"misfit", s.misfit},
                      {"misfit_before", s.misfit_before},
                      {"converged", s.converged},
                      {"iterations", s.iterations},
                      {"message", s.message}});
  return {{"parameters", parameters},   {"curves", curves},
          {"correlation", correlation}, {"starts", starts},
          {"best", result.best},        {"values", result.values},
          {"scatter", result.scatter},  {"evaluations", result.evaluations},
          {"tests", result.tests},      {"findings", result.findings}};
}

}  // namespace talus::laboratory
