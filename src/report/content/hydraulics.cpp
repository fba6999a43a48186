#include "report/content/hydraulics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/units.hpp"
#include "report/content/boundary_lines.hpp"
#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// The number of a condition, in the unit that the report shows it in.
struct Shown {
  const char* key;
  const char* title;
  ShownUnit unit;
};

std::optional<Shown> find_value(const std::string& condition, const ShownUnits& units) {
  const ShownUnit rain{"mm/h", 1e-3 / 3600};
  if (condition == "total_head") return Shown{"head", "level", units.length};
  if (condition == "pressure") return Shown{"pressure", "pore pressure", units.stress};
  if (condition == "rain") return Shown{"rate", "rain", rain};
  if (condition == "flux") return Shown{"rate", "inflow", rain};
  return std::nullopt;
}

/// The series as it acts: rows that hold until the next one are written out as jumps.
json read_series(const json& h, const Shown& shown) {
  const json* value = find(h, {shown.key, "value"});
  if (value == nullptr) return {};
  const std::string unit = get_text(h, {shown.key, "unit"});
  const double factor = (unit.empty() ? 1 : units::get_si_factor(unit)) / shown.unit.si;
  json time = json::array(), values = json::array();
  const auto add = [&](double t, double v) {
    time.push_back(t);
    values.push_back(std::stod(fmt::format("{:.12g}", v * factor)));
  };
  if (value->is_number()) add(0, value->get<double>());
  if (value->is_array()) {
    const bool steps = get_word(h, "series") == "steps";
    double last = 0;
    for (const json& row : *value) {
      const double t = row.at(0).get<double>(), v = row.at(1).get<double>();
      if (steps && !time.empty()) add(t, last);
      add(t, last = v);
    }
  }
  if (time.empty()) return {};
  return {{"title", shown.title}, {"unit", to_json(shown.unit)}, {"time", time}, {"values", values}};
}

/// "10 m", "0 to 20 mm/h".
std::string show_range(const json& series) {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const json& v : series.at("values")) {
    low = std::min(low, v.get<double>());
    high = std::max(high, v.get<double>());
  }
  const std::string unit = series["unit"]["name"].get<std::string>();
  return low == high ? show_number(low, 4) + " " + unit
                     : fmt::format("{} to {} {}, as the series says", show_number(low, 4), show_number(high, 4), unit);
}

std::string describe(const json& h, const std::string& condition, const json& series, const ShownUnits& units) {
  const std::string value = series.is_null() ? "" : show_range(series);
  if (condition == "total_head") return "standing water up to y = " + value + "; above it, a seepage face";
  if (condition == "pressure") return "pore pressure " + value + " (suction is negative)";
  if (condition == "seepage_face") return "water may leave at zero pressure, none enters";
  if (condition == "flux")
    return value + " enters" + (value.find("−") != std::string::npos ? " (what is negative is pumped out)" : "") +
           ", whatever the pressure";
  if (condition == "no_flow") return "no water passes";
  if (condition != "rain") return "";
  std::string text = value + (get_word(h, "rain") == "normal" ? " on the inclined surface itself" : ", vertical") +
                     "; what does not enter runs off";
  if (value.find("−") != std::string::npos) {
    text += "; negative rain evaporates";
    if (const auto limit = find_si(h, "suction_limit")) text += ", up to a suction of " + show(*limit, units.stress);
  }
  return text;
}

}  // namespace

std::string name_condition(const std::string& condition) {
  static const std::map<std::string, std::string> names{
      {"total_head", "total head"},
      {"pressure", "pressure"},
      {"seepage_face", "seepage face"},
      {"rain", "rain"},
      {"flux", "flux"},
      {"no_flow", "no flow"},
      {"open", "open"},
  };
  const auto found = names.find(condition);
  return found != names.end() ? found->second : condition;
}

json list_hydraulics(const json& summary, const std::optional<mesh::Mesh<2>>& mesh) {
  json list = json::array();
  const ShownUnits units = read_units(summary);
  const json* geometry = find(summary, {"input", "geometry"});
  for (const json& h : find_list(summary, {"input", "hydraulic"})) {
    const std::string condition = get_word(h, "condition");
    json lines = json::array(), series;
    if (get_dimension(summary) == 2)
      lines = find_boundary_lines(get_word(h, "on"), geometry != nullptr ? *geometry : json::object(), mesh);
    if (const auto shown = find_value(condition, units)) series = read_series(h, *shown);
    json entry{{"on", get_word(h, "on")},
               {"condition", condition},
               {"title", name_condition(condition)},
               {"text", describe(h, condition, series, units)},
               {"lines", lines}};
    if (!series.is_null()) entry["series"] = std::move(series);
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace talus::report
