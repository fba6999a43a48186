// SPDX-License-Identifier: MIT
// Checks of [[construction]] against the rest of the case, and drains.
#include "input/case/construction.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "input/case/checks.hpp"
#include "input/case/support_places.hpp"
#include "input/language/visitor.hpp"
#include "mesh/cover.hpp"
#include "mesh/planar.hpp"

namespace talus::input {

void describe(Visitor& v, ConstructionStage& s) {
  v.key("name", s.name, plain().required().example(R"("lift 1")"), "Name of the stage in the results.");
  v.key("duration", s.duration, quantity("day").at_least(0).required().example("30"),
        "How long it lasts. Its change of weights, loads and soil acts linearly over this time; with 0 at once, before "
        "any water flows.");
  v.key("add", s.add, plain().example(R"(["lift_1"])"),
        "Regions, surcharges, supports and vertical drains that are there from now on; \"sheet.strut_1\" is the first "
        "strut of wall `sheet`. What no stage adds is there at the start. Placed soil is free of stress, and bars with "
        "a prestress keep it until the end of the stage.");
  v.key("remove", s.remove, plain().example(R"(["cut_1"])"),
        "Regions, surcharges, supports and struts that are taken away.");
  v.entries(
      "soils", s.soils, "soil", 0, plain().example(R"("clay_undrained")"),
      "Material of a region from this stage on: another strength or drainage of the same soil, whose stress stays, "
      "or the soil that fills a region which the stage adds.");
  v.key("drainage", s.drainage, plain(), "What the pore water does.");
  v.key("factor", s.factor, plain(),
        "The methods of [analysis] find the factor of safety at its end, with the pore pressures and stresses of the "
        "stage.");
  v.key("reset_displacement", s.reset_displacement, plain(), "Count displacements from the start of this stage.");
  v.key("release", s.release, plain(),
        "MPM starts from its end, with its pore pressures and stresses, or from the place where it fails: the runout.");
}

void describe(Visitor& v, Consolidation& c) {
  v.key("tolerance", c.tolerance, plain().above(0).below(0.5),
        "Error of a time step, over the largest change of pore pressure of the stage so far; it is estimated for every "
        "step and written.");
  v.key("first_step", c.first_step, quantity("day").above(0).example(R"("1 h")"),
        "First time step of a stage; if not given, a thousandth of its duration.");
  v.key("iterations", c.most_iterations, plain().at_least(3), "Linear systems in a step, after which it is halved.");
}

void describe(Visitor& v, VerticalDrains& d) {
  v.key("name", d.name, plain().required().example(R"("wicks")"), "Name of the drains, which a stage may add.");
  v.key("regions", d.regions, plain().required().example(R"(["clay"])"), "Regions that they drain.");
  v.key("spacing", d.spacing, quantity("m").above(0).required().example("1.5"), "Distance of neighbouring drains.");
  v.key("diameter", d.diameter, quantity("m").above(0).required().usual(0.02, 1).example("0.066"),
        "Diameter of a drain; of a band (a + b)/2, or 2 (a + b)/π.");
  v.key("pattern", d.pattern, plain(), "How they are arranged.");
  v.key("conductivity", d.conductivity, quantity("m/s").above(0).example("2e-9"),
        "Horizontal conductivity of the soil; if not given, that of [materials.NAME.water].");
  v.key("smear", d.smear, plain().at_least(1).example("3"), "Diameter of the smeared zone over that of the drain.");
  v.key("smear_conductivity", d.smear_conductivity, plain().at_least(1).example("2"),
        "Horizontal conductivity over that of the smeared zone.");
  v.key("head", d.head, quantity("m").required().example("0"), "Level to which water stands in the drains.");
}

double find_served_diameter(const VerticalDrains& drains) {
  return (drains.pattern == DrainPattern::triangular ? 1.05 : 1.13) * drains.spacing;
}

double find_drain_factor(const VerticalDrains& drains) {
  const double n = find_served_diameter(drains) / drains.diameter, s = drains.smear, ratio = drains.smear_conductivity;
  const double nn = n * n, ss = s * s;
  return (nn * (std::log(n / s) + ratio * std::log(s) - 0.75) + ss * (1 - ss / (4 * nn)) +
          ratio * ((ss * ss - 1) / (4 * nn) - ss + 1)) /
         (nn - 1);
}

bool is_there_at_start(const Case& data, const std::string& name) {
  const auto holds = [&](const std::vector<std::string>& list) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  for (const ConstructionStage& stage : data.construction) {
    if (holds(stage.remove)) return true;
    if (holds(stage.add)) return false;
  }
  return true;
}

bool is_there(const Case& data, const std::string& name, std::size_t number) {
  bool there = is_there_at_start(data, name);
  for (std::size_t k = 0; k <= number && k < data.construction.size(); ++k) {
    const ConstructionStage& stage = data.construction[k];
    if (std::find(stage.remove.begin(), stage.remove.end(), name) != stage.remove.end()) there = false;
    if (std::find(stage.add.begin(), stage.add.end(), name) != stage.add.end()) there = true;
  }
  return there;
}

namespace {

std::set<std::string> list_objects(const Case& data) {
  std::set<std::string> names;
  for (const mesh::Polygon& polygon : data.mesh.polygons) names.insert(polygon.name);
  for (const Surcharge& surcharge : data.surcharges) names.insert(surcharge.name);
  for (const auto& [name, support] : data.supports) {
    names.insert(name);
    for (std::size_t i = 0; i < support.strut_levels.size(); ++i) names.insert(name_strut(name, i));
  }
  for (const VerticalDrains& drains : data.drains) names.insert(drains.name);
  return names;
}

void check_requirements(const Case& data, Findings& findings) {
  const std::string path = "construction.0";
  if (!uses(data, Method::fem))
    findings.add(path, "stages of construction are computed by FEM: add \"fem\" to [analysis] methods");
  if (uses(data, Method::seepage))
    findings.add("analysis.methods",
                 "\"seepage\" cannot follow [[construction]]; \"lem\", \"fem\", \"bounds\" and \"mpm\" can");
  const auto released = std::find_if(data.construction.begin(), data.construction.end(),
                                     [](const ConstructionStage& stage) { return stage.release; });
  if (uses(data, Method::mpm) && released == data.construction.end())
    findings.add("analysis.methods", "\"mpm\" starts from a stage: give one of [[construction]] release = true");
  if (!uses(data, Method::mpm) && released != data.construction.end())
    findings.add(fmt::format("construction.{}.release", released - data.construction.begin()),
                 "MPM starts from this stage: add \"mpm\" to [analysis] methods");
  if (uses(data, Method::mpm) && data.analysis != AnalysisKind::run)
    findings.add("analysis.kind", "MPM computes the motion from a stage of construction: kind = \"run\"");
  if (data.mesh.dimension != 2 || !data.mesh.file.empty())
    findings.add(path, "stages need a plane section of polygons or layers");
  if (data.timeline)
    findings.add("timeline",
                 "not with [[construction]], whose stages are the timeline: [[hydraulic]] series go on in them");
  if (findings.places.is_given("partial_factors"))
    findings.add("partial_factors", "not with [[construction]]: settlements need characteristic values");
  if (findings.places.is_given("lem.drawdown"))
    findings.add("lem.drawdown", "not with [[construction]]: let the level of a [[hydraulic]] fall in a stage");
  if (data.earthquake.horizontal != 0 || data.earthquake.vertical != 0)
    findings.add("earthquake", "not with [[construction]], in whose stages it would act for good");
  if (data.initial.water.season > 0)
    findings.add("initial.season", "not with [[construction]]: let a first stage be the season");
}

/// Checks that stages add what is not there, and remove what is.
void check_changes(const Case& data, Findings& findings) {
  const std::set<std::string> known = list_objects(data);
  std::set<std::string> there;
  for (const std::string& name : known)
    if (is_there_at_start(data, name)) there.insert(name);
  for (std::size_t k = 0; k < data.construction.size(); ++k) {
    const ConstructionStage& stage = data.construction[k];
    const auto check = [&](const std::vector<std::string>& list, const char* key, bool adds) {
      for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string path = fmt::format("construction.{}.{}.{}", k, key, i);
        if (!known.contains(list[i]))
          findings.add(path, "there is no region, surcharge, support or drain '{}'; there are '{}'", list[i],
                       fmt::join(known, "', '"));
        else if (adds && there.contains(list[i]))
          findings.add(path, "'{}' is there already when stage '{}' adds it", list[i], stage.name);
        else if (!adds && !there.contains(list[i]))
          findings.add(path, "'{}' is not there when stage '{}' removes it", list[i], stage.name);
        if (adds)
          there.insert(list[i]);
        else
          there.erase(list[i]);
      }
    };
    check(stage.remove, "remove", false);
    check(stage.add, "add", true);
    if (std::none_of(data.mesh.polygons.begin(), data.mesh.polygons.end(),
                     [&](const mesh::Polygon& p) { return there.contains(p.name); }))
      findings.add(fmt::format("construction.{}.remove", k), "stage '{}' leaves no soil", stage.name);
  }
}

/// The names that a map has, quoted.
template <typename Value>
std::string list_names(const std::map<std::string, Value>& map) {
  std::vector<std::string> names;
  for (const auto& [name, value] : map) names.push_back(fmt::format("'{}'", name));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Checks that soils change in regions that are there, and that no water appears in soil that stays.
void check_stage_soils(const Case& data, Findings& findings) {
  std::map<std::string, std::string> soils = data.regions;
  for (std::size_t k = 0; k < data.construction.size(); ++k) {
    const ConstructionStage& stage = data.construction[k];
    for (const auto& [region, name] : stage.soils) {
      const std::string path = fmt::format("construction.{}.soils.{}", k, region);
      const auto soil = data.materials.find(name), before = data.materials.find(soils[region]);
      if (!data.regions.contains(region)) {
        findings.add(path, "there is no region '{}'; there are {}", region, list_names(data.regions));
      } else if (soil == data.materials.end()) {
        findings.add(path, "there is no material '{}'; there are {}", name, list_names(data.materials));
      } else if (!is_there(data, region, k)) {
        findings.add(path, "region '{}' is not there in stage '{}'", region, stage.name);
      } else if (const bool stays = k == 0 ? is_there_at_start(data, region) : is_there(data, region, k - 1);
                 stays && before != data.materials.end() &&
                 before->second.water.is_wet() != soil->second.water.is_wet()) {
        findings.add(path,
                     "'{}' and '{}' must both have [materials.NAME.water] or neither: region '{}' keeps its stress",
                     before->first, name, region);
      }
      soils[region] = name;
    }
  }
}

/// Checks that no region that comes or goes lies inside another one: LEM would put the outer soil in its place.
void check_nesting(const Case& data, Findings& findings) {
  const double tolerance = mesh::get_section_tolerance(data.mesh);
  for (std::size_t k = 0; k < data.construction.size(); ++k)
    for (const auto& [key, list] :
         {std::pair{"add", &data.construction[k].add}, std::pair{"remove", &data.construction[k].remove}})
      for (std::size_t i = 0; i < list->size(); ++i)
        for (const mesh::Polygon& inner : data.mesh.polygons)
          for (const mesh::Polygon& outer : data.mesh.polygons)
            if (inner.name == (*list)[i] && outer.name != inner.name &&
                mesh::compare(inner.points, outer.points, tolerance) == mesh::Relation::inside)
              findings.add(fmt::format("construction.{}.{}.{}", k, key, i),
                           "region '{}' lies inside '{}', which would fill its place: draw '{}' around it", inner.name,
                           outer.name, outer.name);
}

void check_drains(const Case& data, Findings& findings) {
  check_names(data.drains, "vertical_drains", "drains", findings);
  for (std::size_t i = 0; i < data.drains.size(); ++i) {
    const VerticalDrains& drains = data.drains[i];
    const auto path = [&](const char* key) { return fmt::format("vertical_drains.{}.{}", i, key); };
    if (data.construction.empty()) findings.add(path("name"), "vertical drains act in the stages of [[construction]]");
    if (findings.is_sound(path("diameter")) && findings.is_sound(path("spacing")) &&
        drains.diameter * std::max(1.0, drains.smear) >= find_served_diameter(drains))
      findings.add(path("diameter"),
                   "a drain with its smeared zone, {:g} m wide, does not fit into the {:g} m that it serves",
                   drains.diameter * drains.smear, find_served_diameter(drains));
    for (std::size_t r = 0; r < drains.regions.size(); ++r) {
      const auto region = data.regions.find(drains.regions[r]);
      const std::string at = fmt::format("vertical_drains.{}.regions.{}", i, r);
      if (region == data.regions.end())
        findings.add(at, "there is no region '{}'", drains.regions[r]);
      else if (const auto soil = data.materials.find(region->second);
               soil != data.materials.end() && !soil->second.water.is_wet())
        findings.add(at, "region '{}' has no pore water: its material '{}' needs [materials.{}.water]",
                     drains.regions[r], region->second, region->second);
    }
  }
}

}  // namespace

void check_construction(const Case& data, Findings& findings) {
  check_drains(data, findings);
  if (data.construction.empty()) {
    for (std::size_t i = 0; i < data.output.monitors.size(); ++i)
      for (const auto& [key, table] : {std::pair{"settlement", &data.output.monitors[i].settlement},
                                       std::pair{"lateral", &data.output.monitors[i].lateral},
                                       std::pair{"pressure", &data.output.monitors[i].pressure}})
        if (!table->time.empty())
          findings.add(fmt::format("output.monitor.{}.measured_{}", i, key),
                       "measurements are compared with the stages of [[construction]], which the case does not have");
    return;
  }
  check_requirements(data, findings);
  check_names(data.construction, "construction", "stages", findings);
  check_changes(data, findings);
  check_stage_soils(data, findings);
  if (findings.is_sound("geometry")) check_nesting(data, findings);
}

}  // namespace talus::input
