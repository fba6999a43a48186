#include "laboratory/calibration_results.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/units.hpp"
#include "input/case/measured_table.hpp"
#include "output/files/history.hpp"

namespace talus::laboratory {
namespace {

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

results::ShownQuantity describe_quantity(const Shown& q) {
  return {q.name, q.title + (q.symbol.empty() ? "" : " ") + q.symbol, q.unit};
}

/// Nine digits, which are more than any measurement has.
double round_off(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double power = std::pow(10, 8 - std::floor(std::log10(std::abs(value))));
  return std::isfinite(power) ? std::round(value * power) / power : value;
}

std::vector<double> scale(std::vector<double> values, double factor) {
  for (double& v : values) v = round_off(v / factor);
  return values;
}

std::vector<results::Point> scale(std::vector<results::Point> line, const Shown& x, const Shown& y) {
  for (auto& [a, b] : line) a = round_off(a / x.factor), b = round_off(b / y.factor);
  return line;
}

results::CalibratedCurve describe_curve(const FittedCurve& c, const std::string& stress_unit) {
  const Shown x = show_quantity(c.x, stress_unit), y = show_quantity(c.y, stress_unit);
  results::CalibratedCurve curve;
  curve.test = c.test;
  curve.x = describe_quantity(x);
  curve.y = describe_quantity(y);
  curve.at = scale(c.at, x.factor);
  curve.measured = scale(c.measured, y.factor);
  curve.before = scale(c.before, y.factor);
  curve.fitted = scale(c.fitted, y.factor);
  curve.line = scale(c.line, x, y);
  curve.line_before = scale(c.line_before, x, y);
  curve.deviation = c.deviation / y.factor;
  curve.weight = c.weight;
  curve.rms = c.rms / y.factor;
  curve.rms_before = c.rms_before / y.factor;
  curve.mean = c.mean / y.factor;
  curve.largest = c.largest / y.factor;
  curve.largest_at = c.largest_at / x.factor;
  curve.missing = c.missing;
  return curve;
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

results::Calibration describe_calibration(const CalibrationResult& result, const std::string& stress_unit) {
  results::Calibration told;
  for (const FittedParameter& p : result.parameters)
    told.parameters.push_back({p.key, p.unit, p.start / p.factor, p.value / p.factor, write_value(p), p.low / p.factor,
                               p.high / p.factor, p.error ? std::optional(*p.error / p.factor) : std::nullopt,
                               p.limit});
  for (const FittedCurve& c : result.curves) told.curves.push_back(describe_curve(c, stress_unit));
  const auto show_all = [&](std::vector<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] /= result.parameters[i].factor;
    return values;
  };
  for (const CalibrationStart& s : result.starts)
    told.starts.push_back(
        {show_all(s.from), show_all(s.to), s.misfit, s.misfit_before, s.converged, s.iterations, s.message});
  told.correlation = result.correlation;
  told.best = result.best;
  told.values = result.values;
  told.scatter = result.scatter;
  told.evaluations = result.evaluations;
  told.tests = result.tests;
  told.findings = result.findings;
  return told;
}

}  // namespace talus::laboratory
