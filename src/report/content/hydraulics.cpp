// SPDX-License-Identifier: MIT
#include "report/content/hydraulics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "input/case/hydraulic.hpp"
#include "report/content/boundary_lines.hpp"
#include "report/words/numbers.hpp"

namespace talus::report {

using input::WaterCondition;
using nlohmann::json;

namespace {

/// The number of a condition over time as it acts, in the unit that the report shows it in.
struct Shown {
  const char* title;
  ShownUnit unit;
  std::vector<double> time, values;  ///< [s], in `unit`

  bool is_negative() const {
    return std::any_of(values.begin(), values.end(), [](double v) { return v < 0; });
  }
};

json to_json(const Shown& shown) {
  return {{"title", shown.title}, {"unit", to_json(shown.unit)}, {"time", shown.time}, {"values", shown.values}};
}

/// Nothing for a condition without a number.
std::optional<Shown> read_series(const input::Hydraulic& h, const ShownUnits& units) {
  const ShownUnit rain = units.rain();
  const auto show = [&](const char* title, const ShownUnit& unit) -> std::optional<Shown> {
    const input::TimeTable series = h.values();
    if (series.time.empty()) return std::nullopt;
    Shown shown{title, unit, series.time, {}};
    for (const double v : series.value) shown.values.push_back(round_to_digits(v / unit.si, 12));
    return shown;
  };
  switch (h.condition) {
    case WaterCondition::total_head:
      return show("level", units.length);
    case WaterCondition::pressure:
      return show("pore pressure", units.stress);
    case WaterCondition::rain:
      return show("rain", rain);
    case WaterCondition::flux:
      return show("inflow", rain);
    default:
      return std::nullopt;
  }
}

/// "10 m", "0 to 20 mm/h".
std::string show_range(const Shown& series) {
  const auto [low, high] = std::minmax_element(series.values.begin(), series.values.end());
  return *low == *high ? show_number(*low, 4) + " " + series.unit.name
                       : fmt::format("{} to {} {}, as the series says", show_number(*low, 4), show_number(*high, 4),
                                     series.unit.name);
}

std::string describe(const input::Hydraulic& h, const std::optional<Shown>& series, const ShownUnits& units) {
  const std::string value = series ? show_range(*series) : "";
  const bool is_negative = series && series->is_negative();
  switch (h.condition) {
    case WaterCondition::total_head:
      return "standing water up to y = " + value + "; above it, a seepage face";
    case WaterCondition::pressure:
      return "pore pressure " + value + " (suction is negative)";
    case WaterCondition::seepage_face:
      return "water may leave at zero pressure, none enters";
    case WaterCondition::flux:
      return value + " enters" + (is_negative ? " (what is negative is pumped out)" : "") + ", whatever the pressure";
    case WaterCondition::no_flow:
      return "no water passes";
    case WaterCondition::rain:
      break;
  }
  std::string text = value +
                     (h.rain == input::RainDirection::normal ? " on the inclined surface itself" : ", vertical") +
                     "; what does not enter runs off";
  if (is_negative) {
    text += "; negative rain evaporates";
    if (std::isfinite(h.suction_limit)) text += ", up to a suction of " + show(h.suction_limit, units.stress);
  }
  return text;
}

}  // namespace

std::string name_condition(std::string word) {
  std::replace(word.begin(), word.end(), '_', ' ');
  return word;
}

json list_hydraulics(const ResultFolder& folder, const std::optional<mesh::Mesh<2>>& mesh) {
  json list = json::array();
  const ShownUnits units = read_units(folder.run);
  for (const input::Hydraulic& h : folder.data.hydraulics) {
    const std::string condition = input::get_word(h.condition);
    const std::optional<Shown> series = read_series(h, units);
    json lines = json::array();
    if (get_dimension(folder.run) == 2) lines = find_boundary_lines(h.on, folder.data.mesh, mesh);
    json entry{{"on", h.on},
               {"condition", condition},
               {"title", name_condition(condition)},
               {"text", describe(h, series, units)},
               {"lines", lines}};
    if (series) entry["series"] = to_json(*series);
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace talus::report
