// SPDX-License-Identifier: MIT
// What must hold between the keys of [lem.drawdown] and the rest of a case.

#include <fmt/format.h>

#include <algorithm>

#include "base/numbers.hpp"
#include "input/case/checks.hpp"

namespace talus::input {
namespace {

using Line = std::vector<std::array<double, 2>>;

/// Level of a water table at x, level beyond its ends [m].
double find_level(const Line& line, double x) {
  if (x <= line.front()[0]) return line.front()[1];
  for (std::size_t i = 1; i < line.size(); ++i)
    if (x <= line[i][0]) {
      const auto &a = line[i - 1], &b = line[i];
      return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
    }
  return line.back()[1];
}

/// Water falls, or stays.
void check_fall(const Line& before, const Line& after, Findings& findings) {
  constexpr double rounding = 1e-9;  // of the levels
  for (const Line* line : {&before, &after})
    for (const auto& [x, y] : *line) {
      const double from = find_level(before, x), to = find_level(after, x);
      if (to <= from + rounding * std::max(1.0, std::abs(from))) continue;
      return findings.add("lem.drawdown.water_table",
                          fmt::format("At x = {} m the water table after drawdown ({} m) is above the one before "
                                      "({} m); drawdown lowers the water",
                                      format_coordinate(x), format_coordinate(to), format_coordinate(from)));
    }
}

void check_soils(const Case& data, Findings& findings) {
  const bool by_b_bar = data.lem.drawdown->method == DrawdownMethod::b_bar;
  bool holds_water = false;
  for (const auto& [name, m] : data.materials) {
    const bool is_used = std::any_of(data.regions.begin(), data.regions.end(),
                                     [&, &name = name](const auto& region) { return region.second == name; });
    holds_water =
        holds_water || (is_used && (by_b_bar ? m.slices.b_bar.has_value() : m.slices.undrained_envelope.has_value()));
  }
  if (holds_water || !findings.is_sound("regions")) return;
  findings.add("lem.drawdown.method",
               by_b_bar ? "method = \"b_bar\" of [lem.drawdown] needs a soil with a `b_bar`; all soils drain"
                        : fmt::format("method = \"{}\" of [lem.drawdown] needs a soil with an `undrained_envelope`; "
                                      "all soils drain",
                                      get_word(data.lem.drawdown->method)));
}

/// What would answer for the slope before drawdown, or would need strengths that no test gives.
void check_others(const Case& data, Findings& findings) {
  const std::string path = "lem.drawdown";
  if (data.methods.size() != 1)
    findings.add(path,
                 "rapid drawdown is calculated by slices alone, and other methods would answer for the slope before "
                 "it: write methods = [\"lem\"] in [analysis]");
  if (data.timeline)
    findings.add(path,
                 "not with [timeline], which follows the water through a drawdown by seepage; take one of the two out");
  if (data.earthquake.horizontal != 0 || data.earthquake.vertical != 0)
    findings.add(path, "not with [earthquake]: an earthquake during a rapid drawdown has no strengths here");
  if (data.lem.yield_acceleration && findings.places.is_given("lem.yield_acceleration"))
    findings.add("lem.yield_acceleration",
                 "not with [lem.drawdown]: an earthquake during a rapid drawdown has no strengths here");
  if (data.partial_factors.set != DesignApproach::none)
    findings.add(path, "not with [partial_factors]: which of them divides an undrained envelope is not agreed on");
  if (data.study.mode == StudyMode::sample && findings.is_sound("study.mode"))
    findings.add(path, "not with mode = \"sample\" in [study]: samples know one state of the water");
}

}  // namespace

void check_drawdown(const Case& data, Findings& findings) {
  for (const auto& [name, m] : data.materials) {
    const std::string path = "materials." + name + ".undrained_envelope";
    if (!m.slices.undrained_envelope || !findings.is_sound("materials." + name)) continue;
    if (!material::find_slice_strength(m.model, m) || m.friction_angle == 0)
      findings.add(path, fmt::format("material '{}' has an undrained envelope but no friction angle in effective "
                                     "stresses, which a drawdown starts from",
                                     name));
  }
  if (!data.lem.drawdown || !findings.is_sound("analysis.methods") || !uses(data, Method::lem)) return;
  check_others(data, findings);
  const InitialWater& before = data.initial.water;
  if (before.pressure == InitialPressure::zero) {
    if (findings.is_sound("initial.pore_pressure"))
      findings.add("lem.drawdown",
                   "there is no water to draw down: give the water table before drawdown as [initial] pore_pressure = "
                   "\"water_table\", or as \"seepage\" with a pool");
    return;
  }
  if (findings.is_sound("lem.drawdown.method")) check_soils(data, findings);
  if (!check_water_table(data.lem.drawdown->water_table, "lem.drawdown.water_table", findings)) return;
  // Pools of [[hydraulic]] stand above this line: run::make_section() compares those.
  if (before.pressure == InitialPressure::water_table && data.hydraulics.empty() &&
      findings.is_sound("initial.water_table") && !before.water_table.empty())
    check_fall(before.water_table, data.lem.drawdown->water_table, findings);
}

}  // namespace talus::input
