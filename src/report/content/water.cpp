// SPDX-License-Identifier: MIT
#include "report/content/water.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "report/content/hydraulics.hpp"
#include "report/content/soil_water.hpp"
#include "report/words/numbers.hpp"
#include "run/mpm/record/checkpoint.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// The state before the season, if there was one.
std::string describe_first_state(const ResultFolder& folder) {
  if (folder.run.input.is_empty()) return "";
  const input::InitialWater& water = folder.data.initial.water;
  if (water.pressure == input::InitialPressure::seepage)
    return "steady seepage with the hydraulic conditions of the start";
  if (water.pressure == input::InitialPressure::zero) return "no pore pressure";
  std::string text = "hydrostatic under a water table, with suction above it";
  if (std::isfinite(water.largest_suction))
    text += " up to " + show(water.largest_suction, read_units(folder.run).stress);
  return text;
}

std::string describe_start(const ResultFolder& folder) {
  std::string text = describe_first_state(folder);
  if (folder.run.season && !text.empty())
    text += fmt::format(", and {:.4g} days of weather since then", folder.run.season->duration / 86400);
  return text;
}

/// "saturated and unsaturated" where some soil drains and suction is known or possible.
std::string describe_state(const ResultFolder& folder) {
  bool drains = false, dry = false;
  for (const auto& [name, soil] : folder.data.materials) {
    dry = dry || !soil.water.is_wet();
    drains = drains || (soil.water.is_wet() && soil.water.retention != input::RetentionCurve::saturated);
  }
  std::string text = drains ? "Saturated and unsaturated soil" : "Saturated soil";
  if (dry) text += " beside dry soil";
  const std::string start = describe_start(folder);
  return text + (start.empty() ? "" : "; at the start " + start);
}

json list_properties(const input::Water& water) {
  json rows = json::array();
  const auto add = [&](const char* key, const char* title, const char* symbol, const char* unit, double value) {
    if (!std::isfinite(value)) return;
    rows.push_back(
        {{"key", key}, {"title", title}, {"symbol", symbol}, {"unit", unit}, {"value", round_to_digits(value, 12)}});
  };
  add("density", "density of the water", "ρ_w", "kg/m³", water.density);
  add("bulk_modulus", "bulk modulus of the water", "K_w", "MPa", water.bulk_modulus / 1e6);
  add("viscosity", "dynamic viscosity", "μ_d", "Pa·s", water.viscosity);
  add("drag_gravity", "gravity at which conductivities hold", "g", "m/s²", water.drag_gravity);
  return rows;
}

json make_budget(const results::WaterBudget& water) {
  json surfaces = json::array();
  for (const results::SurfaceWater& s : water.surfaces)
    surfaces.push_back({{"name", s.name},
                        {"condition", name_condition(to_word(s.condition))},
                        {"entered", s.entered},
                        {"left", s.left},
                        {"supplied", s.supplied},
                        {"runoff", s.runoff}});
  json budget{{"surfaces", surfaces},
              {"density", water.density},
              {"initial", water.initial},
              {"stored", water.stored},
              {"entered", water.entered},
              {"left", water.left},
              {"runoff", water.runoff},
              {"left_grid", water.left_grid},
              {"pressed_in", water.pressed_in},
              {"lost_between", water.lost_between},
              {"error", water.error},
              {"largest_pressure", water.largest_pressure},
              {"largest_suction", water.largest_suction}};
  if (water.transpired) budget["transpired"] = *water.transpired;
  return budget;
}

json make_season(const results::Season& season) {
  json layers = json::array();
  for (const results::SuctionLayer& layer : season.layers)
    layers.push_back({{"depth", layer.depth},
                      {"initial", layer.initial},
                      {"mean", layer.mean},
                      {"least", layer.least},
                      {"greatest", layer.greatest},
                      {"driest", layer.driest}});
  return {{"duration", season.duration}, {"inflow", season.inflow},       {"outflow", season.outflow},
          {"runoff", season.runoff},     {"potential", season.potential}, {"transpired", season.transpired},
          {"growth", season.growth},     {"error", season.error},         {"layers", layers}};
}

json make_seepage(const results::Seepage& seepage) {
  json discharges = json::array(), exits = json::array();
  for (const results::Discharge& d : seepage.discharges)
    discharges.push_back({{"name", d.name}, {"inflow", d.inflow}, {"outflow", d.outflow}, {"runoff", d.runoff}});
  for (const results::SeepageExit& e : seepage.exits)
    exits.push_back({{"name", e.name}, {"lowest", e.lowest}, {"highest", e.highest}});
  return {{"inflow", seepage.inflow},
          {"outflow", seepage.outflow},
          {"balance_error", seepage.balance_error},
          {"iterations", seepage.iterations},
          {"undecided", seepage.undecided},
          {"largest_suction", seepage.largest_suction},
          {"largest_suction_at", seepage.largest_suction_at},
          {"discharges", discharges},
          {"exits", exits}};
}

}  // namespace

json make_water(const ResultFolder& folder) {
  if (!is_wet(folder)) return {};
  std::optional<mesh::Mesh<2>> mesh;
  if (get_dimension(folder.run) == 2 && std::filesystem::exists(folder.path / "mesh.h5"))
    mesh = run::get_mesh<2>(output::ArchiveReader(folder.path / "mesh.h5"));
  json water{{"state", describe_state(folder)},
             {"initial", describe_start(folder)},
             {"properties", list_properties(folder.data.water)},
             {"conditions", list_hydraulics(folder, mesh)}};
  if (folder.run.water) water["budget"] = make_budget(*folder.run.water);
  if (folder.run.seepage) water["seepage"] = make_seepage(*folder.run.seepage);
  if (folder.run.season) water["season"] = make_season(*folder.run.season);
  return water;
}

}  // namespace talus::report
