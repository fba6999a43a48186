// SPDX-License-Identifier: MIT
#include "input/case/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/error.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "input/case/checks.hpp"
#include "input/case/compare.hpp"
#include "input/case/result_names.hpp"
#include "input/case/series_file.hpp"
#include "input/case/uncertain_number.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, CalibrationParameter& p) {
  v.key("key", p.key, plain().required().example(R"("materials.sand.young_modulus")"),
        "The number of a material that is fitted, written as for --set. A test that sets it keeps its own value.");
  v.key("min", p.min, plain().required().example("5000"),
        "Its smallest value: a number in the unit of the key, or a text with a unit.");
  v.key("max", p.max, plain().required().example(R"("80 MPa")"), "Its largest value.");
  v.key("start", p.start, plain().example("20000"),
        "Where the search begins; if not given, at the value that the material has.");
  v.key("scale", p.scale, plain(), "How the search moves between the smallest and the largest value.");
}

void describe(Visitor& v, MeasuredCurve& c) {
  v.key("test", c.test, plain().required().example(R"("cell 100 kPa")"), "Name of the [[test]] that was measured.");
  v.key("x", c.x, plain().required().example(R"("axial_strain")"),
        "Abscissa, a column of the tables of `talus point`: axial_strain, axial_stress, p, suction …");
  v.key("y", c.y, plain().required().example(R"("q")"),
        "Ordinate, whose differences are made small: q, volumetric_strain, void_ratio …");
  v.key("file", c.file, plain().example(R"("measured/cell_100.csv")"),
        "Table with a column for x and one for y, headed with their names and units, such as `axial_strain [%],q "
        "[kPa]`; relative to the case file. Rows are in the order of the measurement.");
  v.key("data", c.data, plain().needed_without("file", !c.file.empty()).example("[[0.05, 165.1], [0.1, 226.2]]"),
        "The rows themselves, [[x, y], ...].");
  v.key("x_unit", c.x_unit, plain().allowed_without("file", !c.file.empty()).example(R"("%")"),
        "Unit of x in `data`; if not given, kPa for stresses and none for the rest.");
  v.key("y_unit", c.y_unit, plain().allowed_without("file", !c.file.empty()).example(R"("MPa")"),
        "Unit of y in `data`, in the same way.");
  v.key("error", c.error, plain().above(0).example(R"("3 kPa")"),
        "Standard error of the measured y: in per cent of the largest measured value, or an amount. If not given, 1 %. "
        "Differences are divided by it.");
  v.key("weight", c.weight, plain().at_least(0),
        "Factor of the differences of this curve; 0: the curve is shown and not fitted.");
}

void describe(Visitor& v, MonitoredCurve& c) {
  v.key("name", c.monitor, plain().required().example(R"("plate")"),
        "Name of an [[output.monitor]] with measured values, in a case with stages of construction.");
  v.key("quantity", c.quantity, plain(), "Which of its measured values count.");
  v.key("error", c.error, plain().above(0).example(R"("5 mm")"),
        "Standard error of a measured value: in per cent of the largest one, or an amount with its unit. If not given, "
        "1 %.");
  v.key("weight", c.weight, plain().at_least(0),
        "Factor of the differences of these values; 0: they are shown and not fitted.");
}

void describe(Visitor& v, Calibration& c) {
  v.key(
      "starts", c.starts, plain().at_least(1).at_most(1000),
      "Number of searches: one from `start`, the others from random values between `min` and `max`. The best counts.");
  v.key("seed", c.seed, plain().at_least(0), "Seed of the random values; equal seeds give equal results.");
  v.key("iterations", c.iterations, plain().at_least(1), "Largest number of iterations of each search.");
  v.tables("parameter", c.parameters, 0, "A number that is fitted.");
  v.tables("curve", c.curves, 0, "A measured curve of an element test.");
  v.tables("monitor", c.monitors, 0,
           "Measured values of a monitor in stages of construction, in the place of a curve.");
}

namespace {

struct Column {
  std::size_t number = 0;
  double factor = 1;
};

Column find_column(const TextTable& table, const PointQuantity& quantity) {
  const std::size_t number = table.find_column(quantity.name);
  const std::string& unit = table.header()[number].unit;
  if (unit.empty() && std::string(quantity.unit) == "Pa")
    fail_input("the column '{0}' of '{1}' has no unit; head it '{0} [kPa]' or with another stress", quantity.name,
               table.file());
  try {
    return {number, find_measured_factor(quantity, unit)};
  } catch (const Error& error) {
    fail_input("the column '{}' of '{}': {}", quantity.name, table.file(), error.what());
  }
}

}  // namespace

const PointQuantity* find_point_quantity(const std::string& name) {
  const auto& list = list_point_quantities();
  const auto found = std::find_if(list.begin(), list.end(), [&](const PointQuantity& q) { return name == q.name; });
  return found == list.end() ? nullptr : &*found;
}

double find_measured_factor(const PointQuantity& quantity, const std::string& unit) {
  if (unit.empty() || unit == "-") {
    if (std::string(quantity.unit) == "Pa" && unit == "-")
      fail_input("'{}' is a stress and needs a unit such as kPa", quantity.name);
    return 1;
  }
  const std::string wanted = std::string(quantity.unit) == "Pa" ? "Pa" : "1";
  return units::parse_as_si("1 " + unit, wanted, quantity.name);
}

std::vector<std::array<double, 2>> read_measured_table(const std::filesystem::path& path, const PointQuantity& x,
                                                       const PointQuantity& y) {
  const TextTable table(path);
  std::vector<std::array<double, 2>> rows;
  if (table.rows() == 0) fail_input("the table '{}' has no row with '{}' and '{}'", table.file(), x.name, y.name);
  const Column columns[2]{find_column(table, x), find_column(table, y)};
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table.cell(i, columns[0].number).empty() || table.cell(i, columns[1].number).empty()) continue;
    std::array<double, 2>& row = rows.emplace_back();
    for (std::size_t k = 0; k < 2; ++k) row[k] = columns[k].factor * table.number(i, columns[k].number);
  }
  if (rows.empty()) fail_input("the table '{}' has no row with '{}' and '{}'", table.file(), x.name, y.name);
  return rows;
}

namespace {

constexpr double usual_error = 0.01;  ///< fraction of the largest measured value [-]

/// Converts an amount to the unit in which a material stores the key.
double convert(const Amount& amount, const NumberKey& key) {
  if (amount.unit.empty()) return amount.number * key.factor;
  const std::string wanted = key.spec.unit.empty() ? "1" : key.spec.unit;
  const double si = units::parse_as_si(amount.text, wanted, key.path);
  return si / (key.spec.unit.empty() ? 1 : units::get_si_factor(key.spec.unit)) * key.factor;
}

/// Check of one parameter.
class ParameterCheck : BlockFindings {
 public:
  ParameterCheck(const Case& data, CalibrationParameter& parameter, const std::string& block, Findings& all)
      : BlockFindings(all, block), data_(data), p_(parameter) {}

  void run() {
    if (!is_sound("key") || !findings.is_sound("materials")) return;
    const std::optional<NumberKey> key = find_key();
    if (!key) return;
    p_.unit = key->spec.unit;
    p_.factor = key->factor;
    const bool has_low = read("min", p_.min, *key, p_.low), has_high = read("max", p_.max, *key, p_.high);
    if (!has_low || !has_high) return;
    if (!(p_.low < p_.high))
      return report("max", "'max' is {}; it must be above 'min', {}", show(p_.high), show(p_.low));
    if (p_.scale == CalibrationScale::log && p_.low <= 0)
      return report("scale", "scale = \"log\" needs a 'min' above 0; it is {}", show(p_.low));
    if (p_.start) {
      if (!read("start", *p_.start, *key, p_.first)) return;
    } else if (key->value && std::isfinite(*key->value)) {
      p_.first = *key->value;
    } else {
      return report("start", "missing key 'start' in [[calibration.parameter]]: the material has no '{}' to begin with",
                    p_.path);
    }
    const double slack = 1e-9 * (p_.high - p_.low);  // tolerates rounding of a limit that was written as text
    if (p_.first < p_.low - slack || p_.first > p_.high + slack)
      report(p_.start ? "start" : "key", "'{}' begins at {}, outside 'min' and 'max', {} to {}", p_.key, show(p_.first),
             show(p_.low), show(p_.high));
  }

 private:
  std::string show(double value) const {
    return fmt::format("{:.6g}{}{}", value / p_.factor, p_.unit.empty() ? "" : " ", p_.unit);
  }

  std::optional<NumberKey> find_key() {
    const std::string start = "materials.";
    const auto dot = p_.key.find('.', start.size());
    if (p_.key.rfind(start, 0) != 0 || dot == std::string::npos) {
      report("key", "'{}' is not a number of a material, such as materials.{}.poisson_ratio", p_.key,
             data_.materials.empty() ? "sand" : data_.materials.begin()->first);
      return std::nullopt;
    }
    p_.material = p_.key.substr(start.size(), dot - start.size());
    p_.path = p_.key.substr(dot + 1);
    std::vector<std::string> names;
    for (const auto& entry : data_.materials) names.push_back(entry.first);
    const auto material = data_.materials.find(p_.material);
    if (material == data_.materials.end()) {
      report("key", "there is no material '{}'; {}", p_.material, talus::suggest(p_.material, names));
      return std::nullopt;
    }
    names.clear();
    for (const NumberKey& key : list_number_keys(material->second)) {
      if (key.path == p_.path && key.applies) return key;
      if (key.applies) names.push_back(key.path);
    }
    report("key", "material '{}' has no number '{}'; {}", p_.material, p_.path, talus::suggest(p_.path, names));
    return std::nullopt;
  }

  bool read(const char* name, const Amount& amount, const NumberKey& key, double& out) {
    if (!is_sound(name)) return false;
    try {
      out = convert(amount, key);
    } catch (const Error& error) {
      return report(name, error.what()), false;
    }
    if (key.spec.allows(out / key.factor)) return true;
    report(name, "'{}' is {}; '{}' must be {}", name, show(out), p_.path, key.spec.write_range());
    return false;
  }

  const Case& data_;
  CalibrationParameter& p_;
};

/// Check of one curve.
class CurveCheck : BlockFindings {
 public:
  CurveCheck(const Case& data, MeasuredCurve& curve, const std::string& block, std::string folder, Findings& all)
      : BlockFindings(all, block), data_(data), c_(curve), folder_(std::move(folder)) {}

  void run() {
    find_test();
    const PointQuantity *x = find_quantity("x", c_.x), *y = find_quantity("y", c_.y);
    if (x == nullptr || y == nullptr) return;
    if (x == y) return report("y", "'x' and 'y' are both '{}'", c_.x);
    if (c_.file.empty() ? !read_rows(*x, *y) : !read_file(*x, *y)) return;
    set_deviation(*y);
  }

 private:
  void find_test() {
    if (!is_sound("test") || !findings.is_sound("test")) return;
    std::vector<std::string> names;
    for (const PointTest& test : data_.tests) {
      if (test.name == c_.test) c_.test_number = names.size();
      names.push_back(test.name);
    }
    if (std::find(names.begin(), names.end(), c_.test) == names.end())
      report("test", "there is no test '{}'; {}", c_.test, talus::suggest(c_.test, names));
  }

  const PointQuantity* find_quantity(const char* key, const std::string& name) {
    if (!is_sound(key)) return nullptr;
    if (const PointQuantity* quantity = find_point_quantity(name)) return quantity;
    std::vector<std::string> names;
    for (const PointQuantity& quantity : list_point_quantities()) names.emplace_back(quantity.name);
    report(key, "an element test has no '{}'; {}", name, talus::suggest(name, names));
    return nullptr;
  }

  bool read_rows(const PointQuantity& x, const PointQuantity& y) {
    if (!is_sound("data")) return false;
    if (c_.data.empty()) return report("data", "'data' needs at least one row [x, y]"), false;
    double factor[2];
    const auto read = [&](const char* key, const PointQuantity& quantity, const std::string& unit, double& out) {
      const bool is_stress = std::string(quantity.unit) == "Pa";
      try {
        out = find_measured_factor(quantity, unit.empty() && is_stress ? "kPa" : unit);
      } catch (const Error& error) {
        return report(key, error.what()), false;
      }
      return true;
    };
    const bool has_x = read("x_unit", x, c_.x_unit, factor[0]), has_y = read("y_unit", y, c_.y_unit, factor[1]);
    if (!has_x || !has_y) return false;
    c_.points.clear();
    for (const auto& row : c_.data) c_.points.push_back({row[0] * factor[0], row[1] * factor[1]});
    return true;
  }

  bool read_file(const PointQuantity& x, const PointQuantity& y) {
    if (!is_sound("file")) return false;
    try {
      c_.points = read_measured_table((std::filesystem::path(folder_) / c_.file).lexically_normal(), x, y);
    } catch (const Error& error) {
      return report("file", error.what()), false;
    }
    return true;
  }

  void set_deviation(const PointQuantity& y) {
    double largest = 0;
    for (const auto& point : c_.points) largest = std::max(largest, std::abs(point[1]));
    if (!is_sound("error")) return;
    const bool is_share = !c_.error || is_relative(*c_.error);
    if (is_share && largest == 0) return report("error", "all measured values are 0; give 'error' as an amount");
    if (is_share) {
      c_.deviation = (c_.error ? c_.error->number / 100 : usual_error) * largest;
      return;
    }
    const bool is_stress = std::string(y.unit) == "Pa";
    try {
      if (c_.error->unit.empty())
        c_.deviation = c_.error->number * (is_stress ? 1e3 : 1);
      else
        c_.deviation = units::parse_as_si(c_.error->text, is_stress ? "Pa" : "1", "error");
    } catch (const Error& error) {
      report("error", error.what());
    }
  }

  const Case& data_;
  MeasuredCurve& c_;
  std::string folder_;
};

/// Check of the measurements of one monitor.
class MonitorCheck : BlockFindings {
 public:
  MonitorCheck(const Case& data, MonitoredCurve& curve, const std::string& block, Findings& all)
      : BlockFindings(all, block), data_(data), c_(curve) {}

  void run() {
    if (!is_sound("name") || !findings.is_sound("output")) return;
    if (data_.construction.empty())
      return report("name", "monitors are fitted in stages of construction: the case has no [[construction]]");
    std::vector<std::string> names;
    for (const Monitor& monitor : data_.output.monitors) {
      if (monitor.name == c_.monitor) c_.number = names.size();
      names.push_back(monitor.name);
    }
    if (std::find(names.begin(), names.end(), c_.monitor) == names.end())
      return report("name", "there is no monitor '{}'; {}", c_.monitor, talus::suggest(c_.monitor, names));
    const Monitor& monitor = data_.output.monitors[c_.number];
    const TimeTable& table = c_.quantity == MonitoredQuantity::settlement ? monitor.settlement
                             : c_.quantity == MonitoredQuantity::lateral  ? monitor.lateral
                                                                          : monitor.pressure;
    const std::string word = get_word(c_.quantity);
    if (table.time.empty()) return report("quantity", "monitor '{}' has no measured_{}", c_.monitor, word);
    double largest = 0;
    for (std::size_t i = 0; i < table.time.size(); ++i) {
      if (table.time[i] < 0) continue;  // before the first stage
      c_.points.push_back({table.time[i], table.value[i]});
      largest = std::max(largest, std::abs(table.value[i]));
    }
    if (c_.points.empty())
      return report("quantity", "monitor '{}' has no measured_{} from the first stage on", c_.monitor, word);
    if (!is_sound("error")) return;
    if (c_.error && !is_relative(*c_.error)) return set_amount(word);
    if (largest == 0) return report("error", "all measured values are 0; give 'error' as an amount");
    c_.deviation = (c_.error ? c_.error->number / 100 : usual_error) * largest;
  }

 private:
  void set_amount(const std::string& word) {
    const bool is_pressure = c_.quantity == MonitoredQuantity::pressure;
    if (c_.error->unit.empty())
      return report("error", "'{}' has no unit: write \"{} {}\", or per cent", c_.error->text, c_.error->text,
                    is_pressure ? "kPa" : "mm");
    try {
      c_.deviation = units::parse_as_si(c_.error->text, is_pressure ? "Pa" : "m", word);
    } catch (const Error& error) {
      report("error", error.what());
    }
  }

  const Case& data_;
  MonitoredCurve& c_;
};

/// Returns true if the test depends on the parameter: it uses the material and does not set the key itself.
bool feels(const PointTest& test, const CalibrationParameter& parameter) {
  return test.material == parameter.material &&
         std::none_of(test.set.begin(), test.set.end(), [&](const PointSetting& s) { return s.key == parameter.path; });
}

/// Checks conditions between parameters and curves.
void check_together(const Case& data, const Calibration& calibration, Findings& findings) {
  if (calibration.parameters.empty() && findings.is_sound("calibration"))
    findings.add("calibration", "[calibration] has nothing to fit: add a [[calibration.parameter]]");
  if (calibration.curves.empty() && calibration.monitors.empty() && findings.is_sound("calibration"))
    findings.add("calibration",
                 "[calibration] has nothing to fit to: add a [[calibration.curve]] or a [[calibration.monitor]]");
  std::set<std::string> keys;
  for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
    const CalibrationParameter& p = calibration.parameters[i];
    const std::string path = fmt::format("calibration.parameter.{}.key", i);
    if (!findings.is_sound(path)) continue;
    if (!keys.insert(p.key).second) findings.add(path, "'{}' is fitted twice", p.key);
    if (p.material.empty() || !findings.is_sound("test") || !findings.is_sound("calibration.curve")) continue;
    if (calibration.curves.empty()) continue;
    if (std::any_of(calibration.monitors.begin(), calibration.monitors.end(),
                    [](const MonitoredCurve& c) { return c.weight > 0; }))
      continue;
    if (std::none_of(calibration.curves.begin(), calibration.curves.end(),
                     [&](const MeasuredCurve& c) { return c.weight > 0 && feels(data.tests[c.test_number], p); }))
      findings.add(path, "no curve feels '{}': none is of a test of material '{}' that does not set it itself", p.key,
                   p.material);
  }
  if (!findings.is_sound("calibration")) return;
  std::size_t values = 0;
  for (const MeasuredCurve& c : calibration.curves) values += c.weight > 0 ? c.points.size() : 0;
  for (const MonitoredCurve& c : calibration.monitors) values += c.weight > 0 ? c.points.size() : 0;
  if (values < calibration.parameters.size())
    findings.add("calibration", "{} measured {} cannot fix {} parameters", values, values == 1 ? "value" : "values",
                 calibration.parameters.size());
}

}  // namespace

void complete_calibration(Case& data, const std::string& file, Findings& findings) {
  if (!data.calibration) return;
  Calibration& calibration = *data.calibration;
  const std::string folder = std::filesystem::path(file).parent_path().string();
  for (std::size_t i = 0; i < calibration.parameters.size(); ++i)
    ParameterCheck(data, calibration.parameters[i], fmt::format("calibration.parameter.{}", i), findings).run();
  for (std::size_t i = 0; i < calibration.curves.size(); ++i)
    CurveCheck(data, calibration.curves[i], fmt::format("calibration.curve.{}", i), folder, findings).run();
  for (std::size_t i = 0; i < calibration.monitors.size(); ++i)
    MonitorCheck(data, calibration.monitors[i], fmt::format("calibration.monitor.{}", i), findings).run();
  check_together(data, calibration, findings);
}

}  // namespace talus::input
