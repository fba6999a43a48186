// SPDX-License-Identifier: MIT
#include "input/case/compare.hpp"

#include <fmt/format.h>

#include <optional>

#include "base/text.hpp"
#include "base/units.hpp"
#include "input/case/checks.hpp"
#include "input/case/result_names.hpp"

namespace talus::input {
namespace {

constexpr const char* per_cent = "%";

std::string suggest(const Case& data, const std::string& name) {
  std::vector<std::string> names;
  for (const results::NamedValue& known : list_result_names(data)) names.push_back(known.name);
  for (const PointTest& test : data.tests)
    for (const PointQuantity& q : list_point_quantities())
      names.push_back(fmt::format("test[{}].{}", test.name, q.name));
  const std::string near = find_nearest(name, names);
  if (!near.empty()) return fmt::format("did you mean '{}'?", near);
  std::string list;
  for (const std::string& known : names) list += (list.empty() ? "" : ", ") + known;
  if (uses(data, Method::mpm) && data.analysis == AnalysisKind::strength_reduction &&
      data.strength_reduction.curve.enabled)
    list += ", curve.displacement[SRF]";
  return "it yields " + list;
}

/// A plain number is in SI units; a unit must be of the result's dimension.
bool fits(const Amount& amount, const std::string& unit) {
  if (amount.unit.empty()) return true;
  if (unit.empty()) return units::get_dimension_name(amount.unit) == units::get_dimension_name("");
  try {
    units::parse_as_si("1 " + amount.unit, unit, "value");
    return true;
  } catch (const Error&) {
    return false;
  }
}

void check_amount(const Amount& amount, const results::NamedValue& result, const std::string& path, const char* key,
                  Findings& findings) {
  if (!findings.is_sound(path) || fits(amount, result.unit)) return;
  findings.add(path, fmt::format("'{}' is \"{}\"; '{}' is {}{}", key, amount.text, result.name,
                                 units::get_dimension_name(result.unit),
                                 result.unit.empty() ? "" : " such as \"1 " + result.unit + "\""));
}

}  // namespace

double to_si(const Amount& amount) {
  return amount.number * units::get_si_factor(amount.unit);
}

bool is_relative(const Amount& tolerance) {
  return tolerance.unit == per_cent;
}

double find_tolerance(const Compare& compare) {
  Amount tolerance = compare.tolerance;
  if (is_relative(tolerance)) return tolerance.number / 100 * std::abs(to_si(compare.value));
  if (tolerance.unit.empty()) tolerance.unit = compare.value.unit;
  return to_si(tolerance);
}

void check_compare(const Case& data, Findings& findings) {
  if (!findings.is_sound("analysis") || !findings.is_sound("stage") || !findings.is_sound("test")) return;
  for (std::size_t i = 0; i < data.compare.size(); ++i) {
    const Compare& compare = data.compare[i];
    const std::string path = fmt::format("compare.{}", i);
    if (!findings.is_sound(path + ".name")) continue;
    const std::optional<results::NamedValue> result = find_possible_name(data, compare.name);
    if (!result) {
      findings.add(path + ".name",
                   fmt::format("the case yields no result '{}'; {}", compare.name, suggest(data, compare.name)));
      continue;
    }
    check_amount(compare.value, *result, path + ".value", "value", findings);
    if (!is_relative(compare.tolerance))
      check_amount(compare.tolerance, *result, path + ".tolerance", "tolerance", findings);
  }
}

}  // namespace talus::input
