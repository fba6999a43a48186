// SPDX-License-Identifier: MIT
#include "laboratory/point_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "input/case/calibration.hpp"
#include "laboratory/point_test.hpp"

namespace talus::laboratory {

namespace {

using input::PointTest;
using input::PointTestKind;
using results::PointGroup;
using results::PointPanel;

PointGroup describe_group(PointTestKind kind) {
  const auto make = [](const char* id, const char* title, std::vector<PointPanel> panels) {
    return PointGroup{id, title, "", std::move(panels), {}, {}, {}};
  };
  const PointPanel compression{"p", "void_ratio", true};
  switch (kind) {
    case PointTestKind::drained_triaxial:
      return make("drained_triaxial", "Drained triaxial tests",
                  {{"axial_strain", "q"}, {"axial_strain", "volumetric_strain"}, {"p", "q"}, compression});
    case PointTestKind::undrained_triaxial:
      return make("undrained_triaxial", "Undrained triaxial tests",
                  {{"axial_strain", "q"}, {"axial_strain", "pore_pressure"}, {"p", "q"}, compression});
    case PointTestKind::simple_shear:
      return make("simple_shear", "Simple shear tests",
                  {{"shear_strain", "shear_stress"},
                   {"shear_strain", "volumetric_strain"},
                   {"axial_stress", "shear_stress"},
                   compression});
    case PointTestKind::wetting:
      return make("wetting", "Wetting tests",
                  {{"suction", "volumetric_strain"},
                   {"suction", "preconsolidation"},
                   {"saturation", "volumetric_strain"},
                   compression});
    default:
      return make("compression", "Compression tests",
                  {compression, {"axial_stress", "axial_strain", true}, {"p", "q"}, {"axial_strain", "q"}});
  }
}

/// Returns the index of `key` in the list, to which a new one is appended.
template <class Key>
int find_number(std::vector<Key>& keys, const Key& key) {
  const auto at = std::find(keys.begin(), keys.end(), key);
  if (at != keys.end()) return static_cast<int>(at - keys.begin());
  keys.push_back(key);
  return static_cast<int>(keys.size()) - 1;
}

std::string write_settings(const PointTest& test) {
  std::string text = test.material;
  for (const input::PointSetting& s : test.set) text += ";" + s.key + "=" + s.value;
  return text;
}

/// Returns a key of all settings of a test except its soil.
std::string write_path(const PointTest& test) {
  std::string text = std::to_string(static_cast<int>(test.kind)) + std::to_string(static_cast<int>(test.control)) +
                     std::to_string(static_cast<int>(test.drainage));
  for (const auto& value : {test.confining_pressure, test.vertical_stress, test.k0})
    text += ";" + std::to_string(value.value_or(-1));
  for (const auto* list : {&test.goals(), &test.suction})
    for (const double value : *list) text += ";" + std::to_string(value);
  return text;
}

/// Selects the lines of a group: colour by soil and dashes by apparatus if there are several of both, otherwise a
/// colour for each test.
void choose_lines(PointGroup& group, const std::vector<PointTest>& tests) {
  std::vector<std::string> soils, paths;
  for (const std::size_t i : group.tests) {
    group.colour.push_back(find_number(soils, write_settings(tests[i])));
    group.dash.push_back(find_number(paths, write_path(tests[i])));
  }
  if (soils.size() > 1 && paths.size() > 1) return;
  for (std::size_t i = 0; i < group.tests.size(); ++i) {
    group.colour[i] = static_cast<int>(i);
    group.dash[i] = 0;
  }
}

}  // namespace

std::vector<PointGroup> group_tests(const std::vector<PointTest>& tests) {
  std::vector<PointGroup> groups;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    const PointGroup mine = describe_group(tests[i].kind);
    auto at = std::find_if(groups.begin(), groups.end(), [&](const PointGroup& g) { return g.id == mine.id; });
    if (at == groups.end()) at = groups.insert(groups.end(), mine);
    at->tests.push_back(i);
  }
  for (PointGroup& group : groups) choose_lines(group, tests);
  return groups;
}

namespace {

using input::PointControl;
using input::PointQuantityKind;

std::string in_per_cent(double strain) {
  return fmt::format("{:.6g} %", strain * 100);
}

std::string join(const std::vector<double>& values, const auto& write) {
  std::string text;
  for (const double v : values) text += (text.empty() ? "" : ", ") + write(v);
  return text;
}

bool extends(const PointTest& test) {
  if (test.control == PointControl::strain) return !test.axial_strain.empty() && test.axial_strain.front() < 0;
  return !test.axial_stress.empty() && test.confining_pressure && test.axial_stress.front() < *test.confining_pressure;
}

std::string describe_goal(const PointTest& test, const ShownUnit& stress) {
  const auto in_stress = [&](double value) { return format_value(value, stress); };
  if (test.kind == PointTestKind::wetting) return "suction " + join(test.suction, in_stress);
  const bool shears = test.kind == PointTestKind::simple_shear;
  if (test.control == PointControl::strain)
    return (shears ? "to a shear strain of " : "to an axial strain of ") + join(test.goals(), in_per_cent);
  return (shears ? "to a shear stress of " : "to an axial stress of ") + join(test.goals(), in_stress);
}

/// "drained triaxial compression", "oedometer".
std::string name_kind(const PointTest& test) {
  const std::string way = extends(test) ? "extension" : "compression";
  switch (test.kind) {
    case PointTestKind::isotropic_compression:
      return "isotropic compression";
    case PointTestKind::k0_compression:
      return "K0 compression";
    case PointTestKind::oedometer:
      return "oedometer";
    case PointTestKind::drained_triaxial:
      return "drained triaxial " + way;
    case PointTestKind::undrained_triaxial:
      return "undrained triaxial " + way;
    case PointTestKind::simple_shear:
      return test.drainage == input::ShearDrainage::drained ? "drained simple shear"
                                                            : "simple shear at constant volume";
    case PointTestKind::wetting:
      break;
  }
  const bool wets = test.suction.size() < 2 || test.suction[1] <= test.suction[0];
  return wets ? "wetting at constant net stress" : "drying at constant net stress";
}

/// "from 100 kPa radial and 100 kPa axial stress to an axial strain of 25 %".
std::string describe_path(const PointTest& test, const ShownUnit& stress) {
  const auto [axial, radial] = find_start(test);
  std::string text = radial == axial ? fmt::format("from {} all round", format_value(axial, stress))
                                     : fmt::format("from {} axial and {} radial stress", format_value(axial, stress),
                                                   format_value(radial, stress));
  text += test.kind == PointTestKind::wetting ? "; " : " ";
  text += describe_goal(test, stress);
  if (test.kind != PointTestKind::wetting) {
    text += test.control == PointControl::strain ? ", strain-controlled" : ", stress-controlled";
    if (!test.suction.empty() && test.suction.front() > 0)
      text += fmt::format(", at a suction of {}", format_value(test.suction.front(), stress));
  }
  return text;
}

/// "root_content = 0.44"; empty for a test without settings.
std::string describe_settings(const PointTest& test) {
  std::string text;
  for (const input::PointSetting& s : test.set) text += (text.empty() ? "" : ", ") + s.key + " = " + s.value;
  return text;
}

/// Returns the row with the largest |q|.
const PointRow& find_peak(const PointCurve& curve) {
  return *std::max_element(curve.rows.begin(), curve.rows.end(),
                           [](const PointRow& a, const PointRow& b) { return std::abs(a.q) < std::abs(b.q); });
}

/// Returns the strain at which results of the test are evaluated.
double PointRow::*choose_strain(const PointTest& test) {
  return test.kind == PointTestKind::simple_shear ? &PointRow::shear_strain : &PointRow::axial_strain;
}

}  // namespace

Shown show_quantity(const std::string& name, const std::string& stress_unit) {
  const input::PointQuantity& q = *input::find_point_quantity(name);
  Shown shown{{name, std::string(q.title) + (*q.symbol == '\0' ? "" : " ") + q.symbol, q.unit}, 1};
  if (q.kind == PointQuantityKind::stress)
    shown = {{name, shown.summary.title, stress_unit}, units::get_si_factor(stress_unit)};
  if (q.kind == PointQuantityKind::strain) shown = {{name, shown.summary.title, "%"}, 1e-2};
  return shown;
}

std::set<std::size_t> choose_drawn(const PointCurve& curve, std::size_t most) {
  std::set<std::size_t> chosen(curve.turns.begin(), curve.turns.end());
  const std::size_t stride = (curve.rows.size() + most - 1) / most;
  for (std::size_t k = 0; k < curve.rows.size(); k += stride) chosen.insert(k);
  chosen.insert(curve.rows.size() - 1);
  return chosen;
}

std::string write_point_table(const PointCurve& curve, const std::string& stress_unit) {
  const auto& quantities = input::list_point_quantities();
  const double si = units::get_si_factor(stress_unit);
  std::string text;
  const auto is_stress = [](const input::PointQuantity& q) { return q.kind == PointQuantityKind::stress; };
  for (const input::PointQuantity& q : quantities)
    text += fmt::format("{}{} [{}]", text.empty() ? "" : ",", q.name, is_stress(q) ? stress_unit : q.unit);
  text += '\n';
  for (const PointRow& row : curve.rows) {
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      const double value = get_quantity(row, quantities[i].name);
      // Ten digits: further ones are rounding errors of sums of thousands of increments.
      text += (i > 0 ? "," : "") + fmt::format("{:.10g}", is_stress(quantities[i]) ? value / si : value);
    }
    text += '\n';
  }
  return text;
}

std::optional<double> find_point_result(const PointCurve& curve, const input::PointTest& test,
                                        const input::PointResultName& name) {
  if (name.quantity == "peak_q") return find_peak(curve).q;
  if (!name.strain) {
    if (!curve.stopped.empty()) return std::nullopt;  // the end was not reached
    return get_quantity(curve.rows.back(), name.quantity);
  }
  const auto strain = choose_strain(test);
  // After a thousand steps a goal of 0.1 may be missed by a rounding error.
  const double slack = 1e-9;
  for (std::size_t i = 1; i < curve.rows.size(); ++i) {
    const PointRow &a = curve.rows[i - 1], &b = curve.rows[i];
    const double from = a.*strain, to = b.*strain;
    if (std::min(from, to) - slack > *name.strain || std::max(from, to) + slack < *name.strain) continue;
    const double share = to == from ? 1 : std::clamp((*name.strain - from) / (to - from), 0.0, 1.0);
    return (1 - share) * get_quantity(a, name.quantity) + share * get_quantity(b, name.quantity);
  }
  return std::nullopt;
}

results::PointTest describe_point_test(const input::PointTest& test, const PointCurve& curve, const std::string& file,
                                       const ShownUnit& stress) {
  const PointRow& peak = find_peak(curve);
  results::PointTest result;
  result.name = test.name;
  result.material = test.material;
  result.kind = name_kind(test);
  result.path = describe_path(test, stress);
  result.set = describe_settings(test);
  result.file = file;
  result.steps = curve.rows.size() - 1;
  result.turns = curve.turns;
  result.stopped = curve.stopped;
  result.peak_q = peak.q;
  result.peak_q_strain = peak.*choose_strain(test);
  for (const input::PointQuantity& q : input::list_point_quantities())
    result.end[q.name] = get_quantity(curve.rows.back(), q.name);
  return result;
}

}  // namespace talus::laboratory
