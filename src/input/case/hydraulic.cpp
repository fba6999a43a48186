// SPDX-License-Identifier: MIT
#include "input/case/hydraulic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/numbers.hpp"
#include "input/case/checks.hpp"
#include "input/case/soil_plan.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, Hydraulic& h) {
  using C = WaterCondition;
  v.key("on", h.on, plain().required().example(R"("crest")"),
        "A side of the box or a named line, as in [[boundary]]. One on the surface of the soil goes with it.");
  v.key("condition", h.condition, plain().required().example(R"("rain")"), "What water meets there.");
  Series head{h.head}, pressure{h.pressure}, rate{h.rate};
  v.key("head", head, quantity("m").needed_with("condition", h.condition, C::total_head).example("10"),
        "Level of the water, or rows of time and level.");
  v.key("pressure", pressure, quantity("kPa").needed_with("condition", h.condition, C::pressure).example("-20"),
        "Pore pressure, positive in compression: suction is negative. Or rows of time and pressure.");
  v.key("rate", rate,
        quantity("mm/h")
            .needed_with("condition", h.condition, C::rain)
            .or_with("condition", h.condition, C::flux)
            .example(R"([[0, "20 mm/h"], ["6 h", 5], ["12 h", 0]])"),
        "Water that is offered or enters, per area, or rows of time and rate. A plain number is in mm/h for a flux as "
        "well; write \"1e-6 m/s\" where that is handier.");
  v.key("series", h.series,
        plain()
            .allowed_with("condition", h.condition, C::total_head)
            .or_with("condition", h.condition, C::pressure)
            .or_with("condition", h.condition, C::rain)
            .or_with("condition", h.condition, C::flux)
            .example(R"("steps")"),
        "How rows of time are joined. The value is constant before the first and after the last.");
  v.key("rain", h.rain, plain().allowed_with("condition", h.condition, C::rain), "How the rate is measured.");
  v.key("suction_limit", h.suction_limit,
        quantity("kPa").above(0).or_infinite().allowed_with("condition", h.condition, C::rain),
        "Suction at the surface where evaporation ends.");
  v.key("standing_depth", h.standing_depth,
        quantity("mm").at_least(0).allowed_with("condition", h.condition, C::rain).example("5"),
        "Rain that cannot enter stands on the ground up to this depth, and enters later. In a season and a timeline.");
  v.key(
      "runs_on", h.runs_on, plain().allowed_with("condition", h.condition, C::rain),
      "Rain that cannot enter, and does not stand, runs down the ground to where it can, or to the pool, or off the "
      "section; water that comes out of the ground too. Its way ends where the ground has no condition or `no_flow`. "
      "It holds for all of the ground once one rain has it. Without it such rain is gone. In a season and a timeline.");
}
namespace {

using mesh::Point2;

/// Returns the soil of the case, and that of each of its stages of construction.
std::vector<mesh::Plan> list_plans(const Case& data) {
  std::vector<mesh::Plan> plans{data.mesh};
  const auto add = [&](const auto& is_here) {
    mesh::Plan& plan = plans.emplace_back(data.mesh);
    std::erase_if(plan.polygons, [&](const mesh::Polygon& p) { return !is_here(p.name); });
  };
  if (!data.construction.empty()) add([&](const std::string& name) { return is_there_at_start(data, name); });
  for (std::size_t k = 0; k < data.construction.size(); ++k)
    add([&](const std::string& name) { return is_there(data, name, k); });
  return plans;
}

/// Returns what a line borders on in one of the plans at least.
Border look_along(const Case& data, const std::vector<mesh::Plan>& plans, const mesh::Polyline& line) {
  Border border;
  for (const mesh::Plan& plan : plans) {
    const Border here = SoilPlan(data, plan).look_along(line);
    border.meets_air |= here.meets_air, border.meets_soil |= here.meets_soil, border.is_surface |= here.is_surface;
    border.is_within |= here.is_within;
  }
  return border;
}

/// Returns the line or the side of the box of that name; empty for other names, such as a side in 3D.
mesh::Polyline find_line(const mesh::Plan& plan, const std::string& name) {
  for (const mesh::Line& line : plan.lines)
    if (line.name == name) return line.points;
  const Point2 &low = plan.box_min, &high = plan.box_max;
  if (name == "bottom") return {low, {high[0], low[1]}};
  if (name == "right") return {{high[0], low[1]}, high};
  if (name == "top") return {high, {low[0], high[1]}};
  if (name == "left") return {{low[0], high[1]}, low};
  return {};
}

bool lies_on_top(const mesh::Plan& plan, const mesh::Polyline& line) {
  return std::all_of(line.begin(), line.end(), [&](const Point2& x) {
    return std::abs(x[1] - plan.box_max[1]) <= 1e-9 * (plan.box_max[1] - plan.box_min[1]);
  });
}

const char* name_condition(WaterCondition condition) {
  switch (condition) {
    case WaterCondition::total_head:
      return "a total head";
    case WaterCondition::pressure:
      return "a pressure";
    case WaterCondition::seepage_face:
      return "a seepage face";
    case WaterCondition::rain:
      return "rain";
    case WaterCondition::flux:
      return "a flux";
    case WaterCondition::free_drainage:
      return "free drainage";
    case WaterCondition::no_flow:
      break;
  }
  return "no flow";
}

/// Checks that a condition is on a surface of soil with pore water, rain and seepage faces on a free one. A side of the
/// box may be one: water may leave through any, but rain enters from above only.
void check_surface(const Case& data, const Hydraulic& hydraulic, const std::vector<mesh::Plan>& plans,
                   const std::string& path, Findings& findings) {
  const WaterCondition condition = hydraulic.condition;
  const mesh::Plan& plan = plans.front();
  const mesh::Polyline line = find_line(plan, hydraulic.on);
  if (line.empty()) return;
  const bool knows_water = findings.is_sound("materials") && findings.is_sound("regions");
  if (condition == WaterCondition::no_flow) {
    // MPM stops water at lines within the soil, the equations of seepage do not.
    const Border border = look_along(data, plans, line);
    if (knows_water && !uses(data, Method::mpm) && border.is_within && !border.is_surface)
      findings.add(
          path + ".on",
          "no_flow on '{}', which lies inside the soil: give a wall with permeable = false, see [support.NAME]",
          hydraulic.on);
    return;
  }
  const bool is_named =
      std::any_of(plan.lines.begin(), plan.lines.end(), [&](const mesh::Line& l) { return l.name == hydraulic.on; });
  const bool is_rain = condition == WaterCondition::rain, is_face = condition == WaterCondition::seepage_face;
  const auto report = [&](const std::string& reason) {
    findings.add(path + ".on", "{} on '{}', which is never a surface of the soil: {}", name_condition(condition),
                 hydraulic.on, reason);
  };
  if (is_rain && !is_named && hydraulic.on != "top") return report("draw a line along the ground and name it");
  const Border border = look_along(data, plans, line);
  if (!border.meets_soil) {
    if (is_named) return report("no soil touches it");
    if (!is_face) report("the soil does not reach it; draw a line along the ground and name it");
    return;
  }
  // Soil that MPM does not move needs no empty space: water may leave through every side, and rain enters level ground.
  const bool is_open_side = !uses(data, Method::mpm) && border.is_surface && (is_face || lies_on_top(plan, line));
  if (is_named && (is_rain || is_face) && !border.meets_air && !is_open_side)
    return report("it lies inside the soil or along a side of the box");
  if (knows_water && !is_face && !border.is_surface)
    report("soil with pore water lies on both of its sides, or on none of them");
}

/// Checks that free drainage is not asked of MPM, nor of sides that do not face down.
void check_drainage(const Case& data, const Hydraulic& hydraulic, const std::string& path, Findings& findings) {
  if (hydraulic.condition != WaterCondition::free_drainage) return;
  if (uses(data, Method::mpm))
    findings.add(path + ".condition",
                 "free drainage is a condition of seepage; MPM has none: give a head or a pressure");
  for (const char* side : {"left", "right", "top"})
    if (hydraulic.on == side)
      findings.add(path + ".on", "free drainage on '{}': it drains through sides that face down, such as 'bottom'",
                   side);
}

void check_head(const Case& data, const Hydraulic& hydraulic, const std::string& path, Findings& findings) {
  const mesh::Plan& plan = data.mesh;
  if (hydraulic.condition != WaterCondition::total_head || plan.polygons.empty() || hydraulic.head.value.empty())
    return;
  const auto [least, most] = std::minmax_element(hydraulic.head.value.begin(), hydraulic.head.value.end());
  const double head = *least;
  const ShownUnit& length = plan.units.length;
  const SoilPlan soil(data, plan);
  const auto [bottom, crest] = soil.find_levels();
  if (head < bottom)
    findings.add(
        path + ".head",
        "'head' is {}, below the lowest point of the soil, {}; heads are levels in the coordinates of the section",
        format_value(head, length), format_value(bottom, length));
  // Behind a side of the box, artesian pressure is possible. A pool on the ground overflows, unless all soil is
  // submerged.
  for (const mesh::Line& line : plan.lines)
    if (line.name == hydraulic.on && *most > crest && soil.look_along(line.points).meets_air)
      findings.warn(path + ".head", "the pool on '{}' stands up to {}, above the crest, {}: it runs over", hydraulic.on,
                    format_value(*most, length), format_value(crest, length));
}

bool fixes_level(const Hydraulic& hydraulic) {
  return hydraulic.condition == WaterCondition::total_head || hydraulic.condition == WaterCondition::pressure ||
         hydraulic.condition == WaterCondition::seepage_face || hydraulic.condition == WaterCondition::free_drainage;
}

/// Checks that gravity acts along -y, since heads and water tables are levels of y.
void check_gravity(const Case& data, Findings& findings) {
  if (!findings.is_sound("gravity") || !findings.is_sound("initial.pore_pressure")) return;
  const InitialPressure start = data.initial.water.pressure;
  const bool has_head = std::any_of(data.hydraulics.begin(), data.hydraulics.end(),
                                    [](const Hydraulic& h) { return h.condition == WaterCondition::total_head; });
  const std::array<double, 3>& down = data.gravity.direction;
  if ((has_head || start != InitialPressure::zero) && !(down[0] == 0 && down[1] < 0 && down[2] == 0))
    findings.add("gravity.direction",
                 "'direction' is inclined, but a total head, a water table and steady seepage count levels along y: "
                 "gravity needs the direction [0, -1] here");
  if (start == InitialPressure::seepage && data.gravity.acceleration == 0)
    findings.add("gravity.acceleration",
                 "'acceleration' is 0, but pore_pressure = \"seepage\" needs gravity to drive water");
}

bool has_increasing_times(const TimeTable& table) {
  return std::adjacent_find(table.time.begin(), table.time.end(), std::greater_equal<>()) == table.time.end();
}

void check_steps(const Hydraulic& hydraulic, const std::string& path, Findings& findings) {
  if (hydraulic.series != SeriesShape::steps) return;
  for (const auto& [key, table] :
       {std::pair{".head", &hydraulic.head}, {".pressure", &hydraulic.pressure}, {".rate", &hydraulic.rate}})
    if (findings.is_sound(path + key) && !has_increasing_times(*table))
      findings.add(path + key, "the times of '{}' must increase from row to row where series = \"steps\"",
                   std::string(key).substr(1));
}

void check_start(const Case& data, Findings& findings) {
  const InitialWater& start = data.initial.water;
  if (!findings.is_sound("initial.pore_pressure") || start.pressure == InitialPressure::zero) return;
  // All methods accept a piezometric line or a grid in any soil.
  const bool takes_line = start.pressure == InitialPressure::water_table || start.pressure == InitialPressure::grid;
  if (!is_wet(data) && !takes_line) {
    if (findings.is_sound("materials") && findings.is_sound("analysis.methods"))
      findings.add(
          "initial.pore_pressure",
          "there is a pore pressure at the start, but no material has pore water: add a table [materials.NAME.water]");
    return;
  }
  if (start.pressure == InitialPressure::water_table) {
    check_water_table(start.water_table, "initial.water_table", data.units().length, findings);
    return;
  }
  if (start.pressure == InitialPressure::grid) return;
  if (findings.is_sound("hydraulic") && std::none_of(data.hydraulics.begin(), data.hydraulics.end(), fixes_level))
    findings.add("initial.pore_pressure",
                 "pore_pressure = \"seepage\" needs a [[hydraulic]] with condition total_head, pressure, "
                 "seepage_face or free_drainage: without one the pressures of a steady flow have no level");
}

}  // namespace

bool check_water_table(const std::vector<std::array<double, 2>>& line, const std::string& path, const ShownUnit& length,
                       Findings& findings) {
  if (!findings.is_sound(path)) return false;
  if (line.empty()) {
    findings.add(path, "'water_table' needs at least one point [x, y]");
    return false;
  }
  for (std::size_t i = 1; i < line.size(); ++i)
    if (line[i][0] <= line[i - 1][0]) {
      findings.add(fmt::format("{}.{}", path, i),
                   "'water_table' goes from x = {} to x = {}; its points must run from left to right, x increasing",
                   format_coordinate(line[i - 1][0], length), format_coordinate(line[i][0], length));
      return false;
    }
  return true;
}

TimeTable Hydraulic::values() const {
  const auto choose = [&]() -> const TimeTable& {
    switch (condition) {
      case WaterCondition::total_head:
        return head;
      case WaterCondition::pressure:
        return pressure;
      default:
        return rate;
    }
  };
  if (condition == WaterCondition::seepage_face || condition == WaterCondition::no_flow ||
      condition == WaterCondition::free_drainage)
    return {{0.0}, {0.0}};
  const TimeTable& rows = choose();
  if (series == SeriesShape::linear) return rows;
  TimeTable jumps;
  for (std::size_t i = 0; i < rows.time.size(); ++i) {
    if (i > 0) {
      jumps.time.push_back(rows.time[i]);
      jumps.value.push_back(rows.value[i - 1]);
    }
    jumps.time.push_back(rows.time[i]);
    jumps.value.push_back(rows.value[i]);
  }
  return jumps;
}

void check_hydraulics(const Case& data, Findings& findings) {
  check_start(data, findings);
  if (is_wet(data)) check_gravity(data, findings);
  if (data.hydraulics.empty()) return;
  if (!is_wet(data)) {
    if (findings.is_sound("materials"))
      findings.add("hydraulic.0",
                   "[[hydraulic]] has no meaning: no material has pore water; add a table [materials.NAME.water]");
    return;
  }
  const bool knows_section = data.mesh.file.empty() && findings.is_sound("geometry") && findings.is_sound("mesh");
  const std::vector<mesh::Plan> plans = list_plans(data);
  std::set<std::string> sides;
  for (std::size_t i = 0; i < data.hydraulics.size(); ++i) {
    const Hydraulic& hydraulic = data.hydraulics[i];
    const std::string path = fmt::format("hydraulic.{}", i);
    if (findings.is_sound(path + ".on") && !sides.insert(hydraulic.on).second)
      findings.add(path + ".on", "there are two hydraulic conditions on '{}'", hydraulic.on);
    check_steps(hydraulic, path, findings);
    if (findings.is_sound(path + ".condition")) check_drainage(data, hydraulic, path, findings);
    if (!knows_section || !findings.is_sound(path + ".condition")) continue;
    if (findings.is_sound(path + ".on")) check_surface(data, hydraulic, plans, path, findings);
    if (findings.is_sound(path + ".head")) check_head(data, hydraulic, path, findings);
  }
}

}  // namespace talus::input
