#include "report/content/water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/content/hydraulics.hpp"
#include "report/content/soil_water.hpp"
#include "report/look_up.hpp"
#include "run/mpm/record/checkpoint.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// The state before the season, if there was one.
std::string describe_first_state(const json& summary) {
  const json* initial = find(summary, {"input", "initial"});
  const std::string word = initial != nullptr ? get_word(*initial, "pore_pressure", "zero") : "";
  if (word == "seepage") return "steady seepage with the hydraulic conditions of the start";
  if (word == "zero") return "no pore pressure";
  if (word != "water_table") return "";
  std::string text = "hydrostatic under a water table, with suction above it";
  if (const auto limit = find_si(*initial, "largest_suction"))
    text += " up to " + show(*limit, read_units(summary).stress);
  return text;
}

std::string describe_start(const json& summary) {
  std::string text = describe_first_state(summary);
  if (const json* season = find(summary, {"season"}); season != nullptr && !text.empty())
    text += fmt::format(", and {:.4g} days of weather since then", get_number(*season, {"duration"}) / 86400);
  return text;
}

/// "saturated and unsaturated" where some soil drains and suction is known or possible.
std::string describe_state(const json& summary) {
  const json* materials = find(summary, {"input", "materials"});
  bool drains = false, dry = false;
  if (materials != nullptr)
    for (const json& material : *materials) {
      const input::PoreWater soil = read_pore_water(material);
      dry = dry || !soil.is_wet();
      drains = drains || (soil.is_wet() && soil.retention != input::RetentionCurve::saturated);
    }
  std::string text = drains ? "Saturated and unsaturated soil" : "Saturated soil";
  if (dry) text += " beside dry soil";
  const std::string start = describe_start(summary);
  return text + (start.empty() ? "" : "; at the start " + start);
}

json list_properties(const json& summary) {
  const input::Water water = read_water(summary);
  json rows = json::array();
  const auto add = [&](const char* key, const char* title, const char* symbol, const char* unit, double value) {
    if (!std::isfinite(value)) return;
    rows.push_back({{"key", key},
                    {"title", title},
                    {"symbol", symbol},
                    {"unit", unit},
                    {"value", std::stod(fmt::format("{:.12g}", value))}});
  };
  add("density", "density of the water", "ρ_w", "kg/m³", water.density);
  add("bulk_modulus", "bulk modulus of the water", "K_w", "MPa", water.bulk_modulus / 1e6);
  add("viscosity", "dynamic viscosity", "μ_d", "Pa·s", water.viscosity);
  add("drag_gravity", "gravity at which conductivities hold", "g", "m/s²", water.drag_gravity);
  return rows;
}

json make_budget(const json& water) {
  json surfaces = json::array();
  for (const json& s : find_list(water, {"surfaces"}))
    surfaces.push_back({{"name", get_text(s, {"name"})},
                        {"condition", name_condition(get_text(s, {"condition"}))},
                        {"entered", get_number(s, {"entered"})},
                        {"left", get_number(s, {"left"})},
                        {"supplied", get_number(s, {"supplied"})},
                        {"runoff", get_number(s, {"runoff"})}});
  json budget{{"surfaces", surfaces}, {"density", get_number(water, {"density"}, 1000)}};
  for (const char* key : {"initial", "stored", "entered", "left", "runoff", "left_grid", "pressed_in", "lost_between",
                          "error", "largest_pressure", "largest_suction"})
    budget[key] = get_number(water, {key});
  if (water.contains("transpired")) budget["transpired"] = get_number(water, {"transpired"});
  return budget;
}

json make_season(const json& season) {
  json block, layers = json::array();
  for (const char* key : {"duration", "inflow", "outflow", "runoff", "potential", "transpired", "growth", "error"})
    block[key] = get_number(season, {key});
  for (const json& layer : find_list(season, {"layers"})) {
    json row;
    for (const char* key : {"depth", "initial", "mean", "least", "greatest", "driest"})
      row[key] = get_number(layer, {key});
    layers.push_back(row);
  }
  block["layers"] = layers;
  return block;
}

json make_seepage(const json& seepage) {
  json block;
  json discharges = json::array(), exits = json::array();
  for (const json& d : find_list(seepage, {"discharges"}))
    discharges.push_back({{"name", get_text(d, {"name"})},
                          {"inflow", get_number(d, {"inflow"})},
                          {"outflow", get_number(d, {"outflow"})},
                          {"runoff", get_number(d, {"runoff"})}});
  for (const json& e : find_list(seepage, {"exits"}))
    exits.push_back({{"name", get_text(e, {"name"})},
                     {"lowest", find_list(e, {"lowest"})},
                     {"highest", find_list(e, {"highest"})}});
  for (const char* key : {"inflow", "outflow", "balance_error", "iterations", "undecided", "largest_suction"})
    block[key] = get_number(seepage, {key});
  block["largest_suction_at"] = find_list(seepage, {"largest_suction_at"});
  block["discharges"] = discharges;
  block["exits"] = exits;
  return block;
}

}  // namespace

json make_water(const ResultFolder& folder) {
  const json& summary = folder.summary;
  if (!is_wet(summary)) return {};
  std::optional<mesh::Mesh<2>> mesh;
  if (get_dimension(summary) == 2 && std::filesystem::exists(folder.path / "mesh.h5"))
    mesh = run::get_mesh<2>(output::ArchiveReader(folder.path / "mesh.h5"));
  json water{{"state", describe_state(summary)},
             {"initial", describe_start(summary)},
             {"properties", list_properties(summary)},
             {"conditions", list_hydraulics(summary, mesh)}};
  if (const json* budget = find(summary, {"water"})) water["budget"] = make_budget(*budget);
  if (const json* seepage = find(summary, {"seepage"})) water["seepage"] = make_seepage(*seepage);
  if (const json* season = find(summary, {"season"})) water["season"] = make_season(*season);
  return water;
}

json list_water_tables(const json& summary) {
  json list = json::array();
  if (get_dimension(summary) != 2) return list;
  const json& lines = find_list(summary, {"seepage", "water_table"});
  for (std::size_t i = 0; i < lines.size(); ++i)
    list.push_back(
        {{"name", lines.size() == 1 ? std::string("steady seepage") : fmt::format("steady seepage, line {}", i + 1)},
         {"points", lines[i]}});
  const json* initial = find(summary, {"input", "initial"});
  if (list.empty() && initial != nullptr && get_word(*initial, "pore_pressure") == "water_table")
    if (const auto points = get_si_points(*initial, "water_table"); !points.empty())
      list.push_back({{"name", "of the case"}, {"points", points}});
  return list;
}

}  // namespace talus::report
