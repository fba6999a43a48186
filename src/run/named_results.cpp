#include "run/named_results.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/units.hpp"
#include "input/case/result_names.hpp"

namespace talus::run {
namespace {

using nlohmann::json;

/// Two factors are one when they differ by less.
constexpr double same_factor = 1e-9;

std::optional<double> get_number(const json& object, const char* key) {
  if (!object.is_object() || !object.contains(key) || !object.at(key).is_number()) return std::nullopt;
  return object.at(key).get<double>();
}

const json* find_member(const json& list, const char* key, const std::string& value) {
  for (const json& entry : list)
    if (entry.value(key, "") == value) return &entry;
  return nullptr;
}

const json& get(const json& object, const char* key) {
  static const json nothing;
  return object.is_object() && object.contains(key) ? object.at(key) : nothing;
}

std::optional<double> find_factor(const json& summary, const std::string& criterion) {
  const json& factors = get(summary, "factor_of_safety");
  if (criterion.empty()) return get_number(factors, "value");
  if (criterion == "frozen") return get_number(get(factors, "frozen"), "factor");
  const json& list = get(factors, "criteria");
  const json* found = list.is_array() ? find_member(list, "name", criterion) : nullptr;
  return found == nullptr ? std::nullopt : get_number(*found, "factor");
}

/// The displacement at a factor, and between which trials it was interpolated when there is none at that factor.
struct CurveValue {
  std::optional<double> displacement;
  std::string note;
};

CurveValue find_displacement(const json& summary, double factor) {
  const json& points = get(get(summary, "curve"), "points");
  if (!points.is_array()) return {};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double here = points[i].at("srf"), u = points[i].at("displacement");
    if (std::abs(here - factor) < same_factor) return {u, ""};
    if (here < factor || i == 0) continue;
    const double before = points[i - 1].at("srf"), u_before = points[i - 1].at("displacement");
    return {u_before + (u - u_before) * (factor - before) / (here - before),
            fmt::format("no trial at SRF {:g}: interpolated between those at {:g} and {:g}", factor, before, here)};
  }
  return {};
}

/// What a reader must know about how a result was come by; empty for most.
std::string find_note(const json& summary, const std::string& name) {
  const auto factor = input::find_trial_factor(name);
  return factor ? find_displacement(summary, *factor).note : "";
}

std::optional<double> find_in_runout(const json& entry, const std::string& key) {
  if (key == "failure_time") return get_number(entry, "failure_time");
  if (key == "rest_time") return entry.value("end", "") == "rest" ? get_number(entry, "time") : std::nullopt;
  return get_number(get(entry, "runout"), key.c_str());
}

/// "stage[gravity].displacement" split into "stage", "gravity", "displacement".
struct Path {
  std::string block, index, key;
};

Path split(const std::string& name) {
  Path path;
  const auto open = name.find('['), close = name.rfind(']');
  if (open != std::string::npos && close != std::string::npos && close > open) {
    path.block = name.substr(0, open);
    path.index = name.substr(open + 1, close - open - 1);
    if (close + 2 < name.size()) path.key = name.substr(close + 2);
    return path;
  }
  const auto dot = name.find('.');
  path.block = name.substr(0, dot);
  if (dot != std::string::npos) path.key = name.substr(dot + 1);
  return path;
}

/// Volume or flow of one condition: "water.inflow[ground]", "seepage.discharge[toe]".
std::optional<double> find_water_result(const json& summary, const Path& path) {
  const json& water = get(summary, "water");
  const auto find_passed = [&](const char* key) -> std::optional<double> {
    const json& surfaces = get(water, "surfaces");
    const json* surface = surfaces.is_array() ? find_member(surfaces, "name", path.index) : nullptr;
    const auto mass = surface == nullptr ? std::nullopt : get_number(*surface, key),
               density = get_number(water, "density");
    return mass && density ? std::optional(*mass / *density) : std::nullopt;
  };
  if (path.block == "water.inflow") return find_passed("entered");
  if (path.block == "water.outflow") return find_passed("left");
  if (path.block == "water.runoff") return find_passed("runoff");
  if (path.block == "seepage.discharge") {
    const json& discharges = get(get(summary, "seepage"), "discharges");
    const json* one = discharges.is_array() ? find_member(discharges, "name", path.index) : nullptr;
    if (one == nullptr) return std::nullopt;
    return one->at("outflow").get<double>() - one->at("inflow").get<double>();
  }
  if (path.block == "seepage") return get_number(get(summary, "seepage"), path.key.c_str());
  if (path.block != "water") return std::nullopt;
  return get_number(water, path.key == "budget_error" ? "error" : path.key.c_str());
}

/// Member `key` of the entry of a list whose `field` is `value`.
std::optional<double> find_listed(const json& list, const char* field, const std::string& value, const char* key) {
  const json* found = list.is_array() ? find_member(list, field, value) : nullptr;
  return found == nullptr ? std::nullopt : get_number(*found, key);
}

/// "lem.spencer", "lem.noncircular.spencer", "lem.surface[NAME].bishop", "lem.handed[fem.band].spencer".
std::optional<double> find_slice_result(const json& summary, const Path& path) {
  const json& lem = get(summary, "lem");
  if (path.block == "lem.surface" || path.block == "lem.handed") {
    const bool is_handed = path.block == "lem.handed";
    const json& list = is_handed ? get(get(summary, "methods"), "handed") : get(lem, "given");
    if (!list.is_array()) return std::nullopt;
    for (const json& entry : list)
      if (entry.value(is_handed ? "from" : "name", "") == path.index &&
          entry.value(is_handed ? "to" : "method", "") == path.key)
        return get_number(entry, "factor");
    return std::nullopt;
  }
  const auto dot = path.key.find('.');
  if (dot == std::string::npos) return find_listed(get(lem, "critical"), "method", path.key, "factor");
  const std::string kind = path.key.substr(0, dot), method = path.key.substr(dot + 1);
  if (kind == "noncircular") return find_listed(get(lem, "noncircular"), "method", method, "factor");
  if (kind == "yield_acceleration") return find_listed(get(lem, "critical"), "method", method, "yield_acceleration");
  return std::nullopt;
}

/// "fem.factor", "fem.associated.by_displacement".
std::optional<double> find_element_result(const json& summary, const std::string& key) {
  const std::string prefix = "associated.";
  const bool associated = key.starts_with(prefix);
  const std::string name = associated ? key.substr(prefix.size()) : key;
  return find_listed(get(get(summary, "fem"), "runs"), "flow", associated ? "associated" : "as_given", name.c_str());
}

json describe_unit(const std::string& unit, const input::Output& output) {
  const std::string shown = unit == "m" ? output.length_unit : (unit == "Pa" ? output.stress_unit : unit);
  return {{"name", shown}, {"si", units::get_si_factor(shown)}};
}

}  // namespace

std::optional<double> find_result(const json& summary, const std::string& name) {
  if (const auto factor = input::find_trial_factor(name)) return find_displacement(summary, *factor).displacement;
  if (input::find_point_result_name(name)) return get_number(get(summary, "point_results"), name.c_str());
  const Path path = split(name);
  if (path.block == "factor_of_safety") return find_factor(summary, path.key);
  if (path.block == "lem" || path.block.starts_with("lem.")) return find_slice_result(summary, path);
  if (path.block == "fem") return find_element_result(summary, path.key);
  if (path.block == "partial_factors")
    return get_number(get(get(summary, "methods"), "partial_factors"), path.key.c_str());
  if (path.block == "onset" || path.block == "displacement") {
    const json& monitors = get(get(summary, "motion"), "monitors");
    const json* monitor = monitors.is_array() ? find_member(monitors, "name", path.index) : nullptr;
    return monitor == nullptr ? std::nullopt : get_number(*monitor, path.block.c_str());
  }
  if (path.block == "mesh") return get_number(get(summary, "mesh"), path.key.c_str());
  if (path.block == "stage") {
    const json& stages = get(summary, "stages");
    const json* stage = stages.is_array() ? find_member(stages, "name", path.index) : nullptr;
    return stage == nullptr ? std::nullopt : get_number(*stage, path.key.c_str());
  }
  if (path.block != "runout") return find_water_result(summary, path);
  if (path.index.empty()) {
    const json& stages = get(summary, "stages");
    json entry{{"runout", get(summary, "runout")}};
    if (const auto time = get_number(summary, "failure_time")) entry["failure_time"] = *time;
    if (stages.is_array() && !stages.empty())
      entry.update({{"end", stages.back().at("end")}, {"time", stages.back().at("time")}});
    return find_in_runout(entry, path.key);
  }
  const json& runouts = get(summary, "runouts");
  if (!runouts.is_array()) return std::nullopt;
  for (const json& entry : runouts)
    if (fmt::format("{:g}", entry.at("srf").get<double>()) == path.index) return find_in_runout(entry, path.key);
  return std::nullopt;
}

json list_results(const input::Case& data, const json& summary) {
  json list = json::array();
  for (const input::ResultName& result : input::list_result_names(data))
    if (const auto value = find_result(summary, result.name))
      list.push_back({{"name", result.name},
                      {"title", result.title},
                      {"value", *value},
                      {"unit", describe_unit(result.unit, data.output)}});
  return list;
}

json compare_results(const input::Case& data, const json& summary) {
  json list = json::array();
  for (const input::Compare& compare : data.compare) {
    // Element tests are no part of a run, and a run none of theirs.
    if (input::find_point_result_name(compare.name).has_value() != summary.contains("point_results")) continue;
    const auto result = input::find_result_name(data, compare.name);
    const auto known = result ? result : input::find_possible_name(data, compare.name);
    const std::string unit = compare.value.unit.empty() && known ? known->unit : compare.value.unit;
    const double published = input::to_si(compare.value), tolerance = input::find_tolerance(compare);
    const auto computed = result ? find_result(summary, compare.name) : std::nullopt;
    json entry{{"name", compare.name},
               {"title", known ? known->title : compare.name},
               {"unit", {{"name", unit}, {"si", units::get_si_factor(unit)}}},
               {"computed", nullptr},
               {"published", published},
               {"tolerance", tolerance},
               {"tolerance_text", compare.tolerance.text},
               {"source", compare.source},
               {"passes", false},
               {"note", computed ? find_note(summary, compare.name)
                        : result ? "the run did not come to this result"
                                 : "the case leaves this result out"}};
    if (computed) {
      entry["computed"] = *computed;
      // A difference that equals the tolerance passes, whatever the last digit of the subtraction says.
      entry["passes"] = std::abs(*computed - published) <= tolerance * (1 + 1e-12);
    }
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace talus::run
