// SPDX-License-Identifier: MIT
#include "studio/section.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "run/case_picture.hpp"
#include "site/ground_line.hpp"

namespace talus::studio {
namespace {

using nlohmann::json;
using output::CasePicture;

constexpr std::array condition_words{"fixed", "rollers", "plane", "wall", "moving"};
constexpr std::array zone_words{"window", "passage", "excluded", "tangent"};
constexpr std::array water_words{"head", "pressure", "seepage_face", "rain", "flux", "no_flow"};

template <std::size_t N, class E>
const char* get_word(const std::array<const char*, N>& words, E value) {
  return words[static_cast<std::size_t>(value)];
}

json write_unit(const ShownUnit& unit) {
  return {{"name", unit.name}, {"si", unit.si}};
}

/// Returns the path if the case gives it, else null.
json find_path(const input::Sketch& sketch, const std::string& path) {
  return sketch.is_given(path) ? json(path) : json();
}

json write_regions(const input::Sketch& sketch, const CasePicture& picture) {
  json list = json::array();
  for (std::size_t i = 0; i < picture.soils.size(); ++i) {
    const CasePicture::Soil& soil = picture.soils[i];
    list.push_back({{"name", soil.region},
                    {"soil", soil.material.empty() ? json() : json(soil.material)},
                    {"polygon", soil.outline},
                    {"path", find_path(sketch, fmt::format("geometry.polygon.{}.points", i))}});
  }
  return list;
}

/// Returns the boundary lines of a section by layers, with points that are in the text.
json write_boundaries(const input::Sketch& sketch, const std::vector<results::Point>& ground) {
  json list = json::array();
  const input::Layering& layering = sketch.layering;
  const auto add = [&](const std::string& name, const char* kind, const json& points, const std::string& path) {
    list.push_back({{"name", name}, {"kind", kind}, {"points", points}, {"path", path}});
  };
  if (!layering.ground.source && !layering.ground.points.empty())
    add("ground", "ground", layering.ground.points, "geometry.ground");
  for (std::size_t i = 0; i < layering.layers.size(); ++i) {
    const input::LayerInput& layer = layering.layers[i];
    const std::string path = fmt::format("geometry.layer.{}", i);
    if (!layer.bottom.source && !layer.bottom.points.empty())
      add(layer.name, "bottom", layer.bottom.points, path + ".bottom");
    else if (layer.level && ground.size() > 1)
      add(layer.name, "level", json{{ground.front()[0], *layer.level}, {ground.back()[0], *layer.level}},
          path + ".level");
    else if (!layer.depths.source && !layer.depths.points.empty() && ground.size() > 1) {
      json points = json::array();
      for (const results::Point& borehole : layer.depths.points)
        points.push_back({borehole[0], site::find_level(ground, borehole[0]) - borehole[1]});
      add(layer.name, "depths", points, path + ".depths");
    }
  }
  return list;
}

json write_lines(const input::Sketch& sketch) {
  json list = json::array();
  const auto& lines = sketch.data.mesh.lines;
  for (std::size_t i = 0; i < lines.size(); ++i)
    list.push_back({{"name", lines[i].name},
                    {"points", lines[i].points},
                    {"path", find_path(sketch, fmt::format("geometry.line.{}.points", i))}});
  return list;
}

json write_water_tables(const input::Sketch& sketch) {
  json list = json::array();
  const auto add = [&](const std::string& name, const auto& points, const std::string& path, bool is_later) {
    if (!points.empty()) list.push_back({{"name", name}, {"points", points}, {"path", path}, {"is_later", is_later}});
  };
  const input::InitialWater& water = sketch.data.initial.water;
  add("water table", water.water_table, "initial.water_table", false);
  if (sketch.data.lem.drawdown)
    add("water table after drawdown", sketch.data.lem.drawdown->water_table, "lem.drawdown.water_table", true);
  for (std::size_t i = 0; i < water.lines.size(); ++i)
    add("piezometric line", water.lines[i].points, fmt::format("initial.piezometric_line.{}.points", i), false);
  return list;
}

/// Surcharges come first in the picture, then tractions; both in the order of the case, without those that were not
/// read.
json write_loads(const input::Sketch& sketch, const CasePicture& picture) {
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < sketch.data.surcharges.size(); ++i) {
    const input::Surcharge& s = sketch.data.surcharges[i];
    const std::string path = fmt::format("surcharge.{}", i);
    if (sketch.is_sound(path) && s.x.size() > 1 && s.x.size() == s.load.size()) paths.push_back(path);
  }
  json list = json::array();
  for (std::size_t i = 0; i < picture.loads.size(); ++i) {
    const CasePicture::Load& load = picture.loads[i];
    list.push_back({{"text", load.text},
                    {"line", load.line},
                    {"load", load.load},
                    {"path", i < paths.size() ? json(paths[i]) : json()}});
  }
  return list;
}

json write_supports(const CasePicture& picture) {
  json list = json::array();
  std::string name;
  for (const CasePicture::Bar& bar : picture.bars) {
    if (!bar.text.empty()) name = bar.text;
    list.push_back(
        {{"name", name}, {"head", bar.head}, {"end", bar.end}, {"free", bar.free_share}, {"path", "support." + name}});
  }
  return list;
}

void add_conditions(const CasePicture& picture, json& section) {
  json& conditions = section["conditions"] = json::array();
  for (const CasePicture::Support& s : picture.supports)
    conditions.push_back(
        {{"kind", get_word(condition_words, s.kind)}, {"text", s.text}, {"line", s.line}, {"outward", s.outward}});
  json& sides = section["water_sides"] = json::array();
  for (const CasePicture::WaterSide& s : picture.water_sides)
    sides.push_back({{"kind", get_word(water_words, s.kind)}, {"text", s.text}, {"line", s.line}});
}

void add_search(const input::Sketch& sketch, const CasePicture& picture, json& section) {
  json& surfaces = section["surfaces"] = json::array();
  const auto& given = sketch.data.lem.surfaces;
  for (const CasePicture::NamedLine& line : picture.surfaces) {
    json path;
    for (std::size_t i = 0; i < given.size(); ++i)
      if (given[i].name == line.name) path = fmt::format("lem.surface.{}", i);
    surfaces.push_back({{"name", line.name}, {"points", line.points}, {"path", path}});
  }
  json& ranges = section["ranges"] = json::array();
  for (const CasePicture::GroundRange& range : picture.ranges)
    ranges.push_back({{"text", range.text}, {"line", range.ground}, {"is_entry", range.is_entry}});
  json& zones = section["zones"] = json::array();
  for (const CasePicture::SearchZone& zone : picture.zones)
    zones.push_back({{"kind", get_word(zone_words, zone.kind)},
                     {"text", zone.text},
                     {"points", zone.points},
                     {"is_closed", zone.is_closed}});
  if (const auto& grid = picture.centres)
    section["centres"] = {{"from", grid->from}, {"to", grid->to}, {"columns", grid->columns}, {"rows", grid->rows}};
  json& monitors = section["monitors"] = json::array();
  const auto& listed = sketch.data.output.monitors;
  for (std::size_t i = 0; i < listed.size(); ++i)
    monitors.push_back({{"name", listed[i].name},
                        {"at", {listed[i].at[0], listed[i].at[1]}},
                        {"path", fmt::format("output.monitor.{}.at", i)}});
}

}  // namespace

json write_section(const input::Sketch& sketch, bool is_faulty) {
  const std::optional<CasePicture> picture = run::make_section_picture(sketch, is_faulty);
  if (!picture) return {};
  const std::vector<results::Point> ground = run::find_sketched_ground(sketch);
  const ShownUnits& units = sketch.data.units();
  json section;
  section["title"] = sketch.data.title;
  section["units"] = {{"length", write_unit(units.length)},
                      {"stress", write_unit(units.stress)},
                      {"unit_weight", write_unit(units.unit_weight)}};
  section["ground"] = ground;
  section["box"] = picture->box;
  section["regions"] = write_regions(sketch, *picture);
  section["boundaries"] = write_boundaries(sketch, ground);
  section["lines"] = write_lines(sketch);
  section["water_tables"] = write_water_tables(sketch);
  section["ponds"] = picture->ponds;
  section["pond_levels"] = picture->pond_levels;
  section["loads"] = write_loads(sketch, *picture);
  section["supports"] = write_supports(*picture);
  add_conditions(*picture, section);
  add_search(sketch, *picture, section);
  section["notes"] = picture->notes;
  return section;
}

}  // namespace talus::studio
