#include "report/content/slices.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "base/error.hpp"
#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

constexpr std::array number_columns{"left",          "right",    "top_left",      "top_right",        "alpha",
                                    "length",        "weight",   "surface_load",  "surface_thrust",   "earthquake",
                                    "pore_pressure", "cohesion", "root_cohesion", "suction_strength", "tan_friction",
                                    "normal",        "shear",    "m_alpha",       "normal_right",     "shear_right",
                                    "thrust_right"};

json take_number(const json& node, std::initializer_list<const char*> path) {
  const auto value = find_number(node, path);
  return value ? json(*value) : json();
}

/// null for 0, which stands for a surface that was refused.
json take_factor(const json& node) {
  const double factor = get_number(node, {"factor"});
  return factor > 0 ? json(factor) : json();
}

json take_circle(const json& circle) {
  return {{"centre", find_list(circle, {"centre"})}, {"radius", get_number(circle, {"radius"})}};
}

bool has_lambda(const std::string& method) {
  return method == "spencer" || method.starts_with("morgenstern_price");
}

/// The columns of the slice table; null where the surface could not be cut.
json take_columns(const json& slices) {
  const std::size_t count = find_list(slices, {"left"}).size();
  if (count == 0) return {};
  json columns{{"soil", find_list(slices, {"soil"})},
               {"base_left", find_list(slices, {"base_left"})},
               {"base_right", find_list(slices, {"base_right"})}};
  for (const char* key : number_columns) {
    json values = find_list(slices, {key});
    if (values.size() != count) values = json(std::vector<double>(count));
    columns[key] = std::move(values);
  }
  return columns;
}

json take_surface(const json& surface, const char* kind) {
  const std::string method = get_text(surface, {"method"});
  json taken{{"kind", kind},
             {"name", get_text(surface, {"name"})},
             {"method", method},
             {"title", get_text(surface, {"title"}, method)},
             {"factor", take_factor(surface)},
             {"lambda", has_lambda(method) ? take_number(surface, {"lambda"}) : json()},
             {"correction", get_number(surface, {"correction"}, 1)},
             {"points", find_list(surface, {"points"})},
             {"area", get_number(surface, {"area"})},
             {"depth", get_number(surface, {"depth"})},
             {"yield_acceleration", take_number(surface, {"yield_acceleration"})},
             {"checks",
              {{"smallest_m_alpha", take_number(surface, {"checks", "smallest_m_alpha"})},
               {"tensile_share", get_number(surface, {"checks", "tensile_share"})},
               {"thrust_outside", get_number(surface, {"checks", "thrust_outside"})},
               {"refusal", get_text(surface, {"checks", "refusal"})}}},
             {"warnings", find_list(surface, {"warnings"})}};
  if (const json* circle = find(surface, {"circle"})) taken["circle"] = take_circle(*circle);
  if (const json* slices = find(surface, {"slices"}))
    if (json columns = take_columns(*slices); !columns.is_null()) taken["slices"] = std::move(columns);
  return taken;
}

json list_minima(const json& lem) {
  json list = json::array();
  const json* minima = find(lem, {"minima"});
  if (minima == nullptr || !minima->is_object()) return list;
  for (const auto& [method, surfaces] : minima->items())
    for (const json& m : surfaces) {
      json taken{{"method", method}, {"factor", get_number(m, {"factor"})}, {"points", find_list(m, {"points"})}};
      if (const json* circle = find(m, {"circle"})) taken["circle"] = take_circle(*circle);
      list.push_back(std::move(taken));
    }
  return list;
}

json take_search(const json& search) {
  json refused = json::array();
  if (const json* counts = find(search, {"refused"}); counts != nullptr && counts->is_object())
    for (const auto& [method, reasons] : counts->items()) {
      json list = json::array();
      for (const auto& [reason, count] : reasons.items()) list.push_back({{"reason", reason}, {"count", count}});
      refused.push_back({{"method", method}, {"reasons", list}});
    }
  json taken{{"kind", get_text(search, {"kind"})},
             {"tried", get_number(search, {"tried"})},
             {"refused", refused},
             {"limit_hits", find_list(search, {"limit_hits"})},
             {"circles_per_second", take_number(search, {"circles_per_second"})}};
  for (const char* range : {"exit", "entry"})
    if (const json& ends = find_list(search, {"ranges", range}); ends.size() == 2) taken[range] = ends;
  if (const json* grid = find(search, {"ranges", "grid"})) {
    // Either two corners, or a table with them.
    if (grid->is_array() && grid->size() == 2) taken["grid"] = *grid;
    if (grid->is_object()) taken["grid"] = {find_list(*grid, {"from"}), find_list(*grid, {"to"})};
  }
  return taken;
}

json pack_trials(const json& file, Packer& packer) {
  const json& trials = find_list(file, {"trials"});
  const json& methods = find_list(file, {"methods"});
  if (trials.empty() || methods.empty()) return {};
  std::vector<double> circles, factors;
  for (const json& trial : trials) {
    for (std::size_t k = 0; k < 5; ++k) circles.push_back(trial.at(k).get<double>());
    for (std::size_t k = 0; k < methods.size(); ++k) {
      const json& factor = trial.at(5 + k);
      factors.push_back(factor.is_number() ? factor.get<double>() : 0);
    }
  }
  return {{"count", trials.size()},
          {"methods", methods},
          {"circles", packer.add_reals("lem.circles", circles, {trials.size(), 5})},
          {"factors", packer.add_reals("lem.factors", factors, {trials.size(), methods.size()})}};
}

json pack_maps(const json& file, Packer& packer) {
  json list = json::array();
  const json* maps = find(file, {"maps"});
  if (maps == nullptr || !maps->is_object()) return list;
  for (const auto& [method, map] : maps->items()) {
    const auto columns = static_cast<std::size_t>(get_number(map, {"columns"})),
               rows = static_cast<std::size_t>(get_number(map, {"rows"}));
    const json& values = find_list(map, {"factor"});
    if (columns * rows == 0 || values.size() != columns * rows) continue;
    std::vector<double> factors;
    for (const json& v : values) factors.push_back(v.is_number() ? v.get<double>() : 0);
    list.push_back({{"method", method},
                    {"from", find_list(map, {"from"})},
                    {"to", find_list(map, {"to"})},
                    {"columns", columns},
                    {"rows", rows},
                    {"factor", packer.add_reals("lem.map." + method, factors, {rows, columns})}});
  }
  return list;
}

}  // namespace

json make_slices(const ResultFolder& folder, Packer& packer, json& warnings) {
  const json* lem = find(folder.summary, {"lem"});
  if (lem == nullptr || !lem->is_object()) return {};
  json surfaces = json::array(), titles = json::object(), methods = json::array();
  static constexpr std::array kinds{std::pair{"critical", "circle"}, std::pair{"noncircular", "polyline"},
                                    std::pair{"given", "given"}};
  for (const auto& [key, kind] : kinds)
    for (const json& surface : find_list(*lem, {key})) {
      surfaces.push_back(take_surface(surface, kind));
      titles[surfaces.back()["method"].get<std::string>()] = surfaces.back()["title"];
    }
  for (const json& name : find_list(*lem, {"methods"}))
    methods.push_back({{"name", name}, {"title", titles.value(name.get<std::string>(), name)}});
  json slices{{"methods", methods},
              {"slice_count", get_number(*lem, {"slices"})},
              {"seconds", get_number(*lem, {"seconds"})},
              {"surfaces", surfaces},
              {"minima", list_minima(*lem)},
              {"maps", json::array()}};
  if (const std::string error = get_text(*lem, {"error"}); !error.empty()) slices["error"] = error;
  if (const json* search = find(*lem, {"search"})) slices["search"] = take_search(*search);
  try {
    const json file = read_json(folder.path / get_text(*lem, {"trials_file"}, "lem.json"));
    if (json trials = pack_trials(file, packer); !trials.is_null()) slices["trials"] = std::move(trials);
    slices["maps"] = pack_maps(file, packer);
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The trial surfaces are not shown: {}", error.what()));
  }
  return slices;
}

}  // namespace talus::report
