// SPDX-License-Identifier: MIT
#include "base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <regex>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/unit_definition.hpp"

namespace talus::units {

namespace {

/// A physical dimension with a common name, its SI unit and an example value.
struct Dimension {
  const char* unit;
  const char* name;
  const char* example;
};
constexpr std::array dimensions{
    Dimension{"m", "a length", "2 m"},
    Dimension{"s", "a time", "2 s"},
    Dimension{"kg", "a mass", "2 kg"},
    Dimension{"Pa", "a stress", "2 kPa"},
    Dimension{"kg/m3", "a density", "2650 kg/m3"},
    Dimension{"m/s", "a speed", "1e-5 m/s"},
    Dimension{"m/s2", "an acceleration", "9.81 m/s2"},
    Dimension{"N", "a force", "2 kN"},
    Dimension{"J", "an energy", "2 J"},
    Dimension{"W", "a power", "2 W"},
    Dimension{"N/m", "a force per length", "2 kN/m"},
    Dimension{"N/m3", "a unit weight", "18 kN/m3"},
    Dimension{"m2", "an area", "2 m2"},
    Dimension{"m3", "a volume", "2 m3"},
    Dimension{"Hz", "a rate", "2 Hz"},
    Dimension{"Pa s", "a viscosity", "1e-3 Pa.s"},
    Dimension{"m2/s", "a diffusivity", "1e-6 m2/s"},
    Dimension{"K", "a temperature", "293 K"},
};
constexpr Dimension angle{"rad", "an angle", "30 deg"};
constexpr Dimension number{"1", "a number", "0.3"};

/// Units for suggestions on mistyped names ("kpa", "Kg").
const std::vector<std::string> common_units{
    "m",    "mm",    "cm",   "km",    "s",     "min", "h",     "day",  "kg",     "t",      "N",
    "kN",   "MN",    "Pa",   "kPa",   "MPa",   "GPa", "bar",   "deg",  "rad",    "degree", "m/s",
    "m/s2", "kg/m3", "t/m3", "kN/m3", "kN/m2", "%",   "g/cm3", "mm/h", "mm/day", "J",      "kJ",
    "psf",  "ksf",   "tsf",  "pcf",   "psi",   "ft",  "in",    "ft/s", "ft/day"};

/// Serialises the calls of define_unit().
std::mutex& get_lock() {
  static std::mutex mutex;
  return mutex;
}

/// Throws Error if the text is not a unit.
UnitDefinition parse(const std::string& text) {
  const bool is_scaled = !text.empty() && (std::isdigit(static_cast<unsigned char>(text[0])) || text[0] == '.' ||
                                           text[0] == '-' || text[0] == '+');
  // UDUNITS accepts "3 kPa" as a unit, but "2 3 kPa" is a typing error, not six kilopascals.
  static std::map<std::string, UnitDefinition> known;  // asked for at every number of a case file
  constexpr std::size_t most_known = 1000;
  if (const auto found = known.find(text); found != known.end()) return found->second;
  std::optional<UnitDefinition> unit;
  if (!is_scaled || text == "1") unit = define_unit(text);
  if (!unit) {
    const std::string near = find_nearest(text, common_units);
    fail_input(near.empty() ? fmt::format("'{}' is no known unit", text)
                            : fmt::format("'{}' is no known unit; did you mean '{}'?", text, near));
  }
  if (known.size() < most_known) known[text] = *unit;
  return *unit;
}

/// Returns true if one converts to the other. Angles are not plain numbers: "30 deg" is not a porosity.
bool are_alike(const UnitDefinition& a, const UnitDefinition& b) {
  return a.powers == b.powers;
}

/// Returns the named dimension of a unit, if there is one.
std::optional<Dimension> find_dimension(const UnitDefinition& unit) {
  if (are_alike(unit, {})) return number;
  if (are_alike(unit, parse("rad"))) return angle;
  for (const Dimension& d : dimensions)
    if (are_alike(unit, parse(d.unit))) return d;
  return std::nullopt;
}

/// Returns true if a comma and a digit follow the integer part of a number.
bool has_decimal_comma(const char* rest, const char* end) {
  return end - rest > 1 && *rest == ',' && std::isdigit(static_cast<unsigned char>(rest[1])) != 0;
}

bool is_blank(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

}  // namespace

std::string explain_decimal_comma(const std::string& text) {
  std::string point = text;
  std::replace(point.begin(), point.end(), ',', '.');
  return fmt::format("'{}' has a decimal comma; write it with a point: {}", text, point);
}

Quantity parse_quantity(const std::string& text) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  while (begin != end && is_blank(*begin)) ++begin;
  while (end != begin && is_blank(end[-1])) --end;
  const char* digits = begin != end && *begin == '+' ? begin + 1 : begin;
  Quantity quantity;
  const char* parsed = parse_number(digits, end, quantity.value);
  const char* rest = parsed != nullptr ? parsed : digits;
  if (has_decimal_comma(rest, end)) fail_input(explain_decimal_comma(text));
  if (parsed == nullptr || !std::isfinite(quantity.value)) fail_input("'{}' does not begin with a finite number", text);
  const char* unit = rest;
  while (unit != end && is_blank(*unit)) ++unit;
  if (unit == end) fail_input("'{}' is a text without a unit", text);
  quantity.unit.assign(unit, end);
  return quantity;
}

double get_si_factor(const std::string& unit) {
  const std::lock_guard held(get_lock());
  const UnitDefinition definition = parse(unit);
  return definition.factor + definition.offset;
}

double parse_as_si(const std::string& text, const std::string& wanted, std::string_view subject) {
  const std::string needs =
      fmt::format("{} needs {} such as \"{}\"", subject, get_dimension_name(wanted), get_dimension_example(wanted));
  Quantity quantity;
  try {
    quantity = parse_quantity(text);
  } catch (const Error& error) {
    throw Error(error.code(), "{}; {}", error.what(), needs);
  }
  const std::lock_guard held(get_lock());
  const UnitDefinition given = parse(quantity.unit);
  if (!are_alike(given, parse(wanted))) {
    const auto is = find_dimension(given);
    fail_input("'{}' is {}; {}", text, is ? is->name : "of another dimension", needs);
  }
  return given.factor * quantity.value + given.offset;
}

std::string get_dimension_name(const std::string& unit) {
  const std::lock_guard held(get_lock());
  const auto dimension = find_dimension(parse(unit));
  return dimension ? dimension->name : fmt::format("a quantity in {}", unit);
}

std::string get_dimension_example(const std::string& unit) {
  const std::lock_guard held(get_lock());
  const auto dimension = find_dimension(parse(unit));
  return dimension ? dimension->example : fmt::format("2 {}", unit);
}

std::string format_time(double seconds) {
  constexpr double minute = 60, hour = 3600, day = 86400;
  const double size = std::abs(seconds);
  if (size < 2 * minute) return fmt::format("{:.4g} s", seconds);
  if (size < 2 * hour) return fmt::format("{:.4g} min", seconds / minute);
  if (size < 2 * day) return fmt::format("{:.4g} h", seconds / hour);
  return fmt::format("{:.4g} days", seconds / day);
}

}  // namespace talus::units

namespace talus {

std::optional<double> parse_date(const std::string& text) {
  static const std::regex form(R"((\d{4})-(\d{2})-(\d{2})(?:[T ](\d{2}):(\d{2})(?::(\d{2})(?:\.0*)?)?Z?)?)");
  std::smatch parts;
  if (!std::regex_match(text, parts, form)) return std::nullopt;
  const auto get = [&](int i) {
    return parts[static_cast<std::size_t>(i)].matched ? std::stoi(parts[static_cast<std::size_t>(i)]) : 0;
  };
  const std::chrono::year_month_day day{std::chrono::year(get(1)), std::chrono::month(static_cast<unsigned>(get(2))),
                                        std::chrono::day(static_cast<unsigned>(get(3)))};
  const int hour = get(4), minute = get(5), second = get(6);
  if (!day.ok() || hour > 24 || minute > 59 || second > 59) return std::nullopt;
  const auto days = std::chrono::sys_days(day).time_since_epoch().count();
  return 86400.0 * static_cast<double>(days) + 3600.0 * hour + 60.0 * minute + second;
}

std::string format_date(double seconds) {
  const auto minutes = static_cast<long long>(std::llround(seconds / 60));
  const long long days = minutes >= 0 ? minutes / 1440 : -((1439 - minutes) / 1440);
  const int rest = static_cast<int>(minutes - 1440 * days);
  const std::chrono::year_month_day day{std::chrono::sys_days(std::chrono::days(days))};
  std::string text = fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()), static_cast<unsigned>(day.month()),
                                 static_cast<unsigned>(day.day()));
  if (rest != 0) text += fmt::format(" {:02}:{:02}", rest / 60, rest % 60);
  return text;
}

}  // namespace talus
