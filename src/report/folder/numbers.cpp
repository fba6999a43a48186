// SPDX-License-Identifier: MIT
#include "report/folder/numbers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"

namespace talus::report {

nlohmann::json to_json(const ShownUnit& unit) {
  return {{"name", unit.name}, {"si", unit.si}};
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
