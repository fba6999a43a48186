// SPDX-License-Identifier: MIT
#include "report/words/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "base/units.hpp"

namespace talus::report {
namespace {

/// Customary units that accompany a unit of stress.
struct Companions {
  const char *stress, *stiffness, *unit_weight, *unit_weight_title, *line_force;
};

const Companions& find_companions(const std::string& stress) {
  static constexpr std::array all{
      Companions{"kPa", "MPa", "kN/m3", "kN/m³", "kN/m"}, Companions{"Pa", "MPa", "kN/m3", "kN/m³", "N/m"},
      Companions{"MPa", "MPa", "kN/m3", "kN/m³", "MN/m"}, Companions{"psf", "ksf", "pcf", "pcf", "plf"},
      Companions{"psi", "ksf", "pcf", "pcf", "plf"},      Companions{"ksf", "ksf", "pcf", "pcf", "klf"},
      Companions{"tsf", "tsf", "pcf", "pcf", "klf"}};
  const auto found = std::find_if(all.begin(), all.end(), [&](const Companions& c) { return stress == c.stress; });
  return found == all.end() ? all.front() : *found;
}

}  // namespace

nlohmann::json to_json(const ShownUnit& unit) {
  return {{"name", unit.name}, {"si", unit.si}};
}

ShownUnits read_units(const results::RunResult& run) {
  const auto read = [](const std::string& name) { return ShownUnit{name, units::get_si_factor(name)}; };
  const Companions& others = find_companions(run.units.stress);
  const ShownUnit weight{others.unit_weight_title, units::get_si_factor(others.unit_weight)};
  const bool in_feet = run.units.length == "ft" || run.units.length == "in";
  return {read(run.units.length),  read(run.units.displacement), read(run.units.stress), read(others.stiffness), weight,
          read(others.line_force), read(in_feet ? "ft" : "m")};
}

ShownUnit ShownUnits::volume(std::size_t dimension) const {
  const double cube = span.si * span.si * span.si;
  if (dimension == 3) return {span.name + "³", cube};
  return {span.name + "³/" + span.name, cube / span.si};
}

ShownUnit ShownUnits::flow(std::size_t dimension) const {
  const ShownUnit whole = volume(dimension);
  return {span.name + "³/s" + whole.name.substr(span.name.size() + std::string("³").size()), whole.si};
}

ShownUnit ShownUnits::rain() const {
  constexpr double hour = 3600;
  return span.name == "ft" ? ShownUnit{"in/h", units::get_si_factor("in") / hour} : ShownUnit{"mm/h", 1e-3 / hour};
}

std::string show_number(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value == 0 ? "0" : "–";
  const double size = std::abs(value);
  std::string text = fmt::format("{:.{}g}", size, digits);
  if (const std::size_t e = text.find('e'); e != std::string::npos && size >= 1 && size < 1e7) {
    text = fmt::format("{:.0f}", size);
  } else if (e != std::string::npos) {
    static const char* const raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string power;
    for (const char c : std::to_string(std::stoi(text.substr(e + 1)))) power += c == '-' ? "⁻" : raised[c - '0'];
    text = text.substr(0, e) + " × 10" + power;
  }
  return (value < 0 ? "−" : "") + text;
}

std::string show_per_thickness(double si, const ShownUnit& unit, int digits) {
  return show(si, name_thickness(unit), digits);
}

ShownUnit name_thickness(ShownUnit unit) {
  for (const auto& [sign, word] : {std::pair{"/m", " per metre"}, std::pair{"/ft", " per foot"}})
    if (unit.name.ends_with(sign)) {
      unit.name = unit.name.substr(0, unit.name.rfind('/')) + word;
      break;
    }
  return unit;
}

std::string show_uncertain(double si, std::optional<double> uncertainty, const ShownUnit& unit) {
  if (uncertainty) *uncertainty /= unit.si;
  return format_uncertain(si / unit.si, uncertainty) + (unit.name.empty() ? "" : " " + unit.name);
}

std::string show_coordinate(double si, const ShownUnit& unit) {
  return (si < 0 ? "−" : "") + format_coordinate(std::abs(si) / unit.si) + " " + unit.name;
}

std::string show(double si, const ShownUnit& unit, int digits) {
  return show_number(si / unit.si, digits) + " " + unit.name;
}

ShownUnit choose_time_unit(double duration) {
  constexpr double minute = 60, hour = 3600, day = 86400;
  if (duration >= 2 * day) return {"days", day};
  if (duration >= 2 * hour) return {"h", hour};
  return duration >= 2 * minute ? ShownUnit{"min", minute} : ShownUnit{"s", 1};
}

double keep_finite(double value) {
  return std::isfinite(value) ? value : 0;
}

std::string join_words(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
  return text;
}

}  // namespace talus::report
