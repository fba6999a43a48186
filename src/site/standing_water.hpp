// SPDX-License-Identifier: MIT
#pragma once
// Water standing on the ground, water tables as lines, and warnings on those that are physically implausible.

#include <optional>
#include <string>
#include <vector>

#include "base/shown_units.hpp"
#include "input/case/case.hpp"
#include "lem/section/section.hpp"
#include "site/ground_line.hpp"

namespace talus::site {

class Site;

/// Water over a stretch of the ground, from a total head or a pressure on a named line.
struct Pond {
  Point from{}, to{};                   ///< ends on the ground, from left to right [m]
  double level_from = 0, level_to = 0;  ///< level of the water there [m]
};

/// Returns the time at which the methods start [s]: 0, or just before it if a timeline follows, whose series may jump
/// at 0.
double find_first_time(const input::Case& data);

/// Returns the time at which the weather starts [s]: just before the season if there is one, else find_first_time().
double find_weather_start(const input::Case& data);

/// Returns the ponds of a case at `time` [s].
std::vector<Pond> find_ponds(const input::Case& data, const Polyline& ground, double time);

/// Returns warnings on ponds without a bank, where the ground beside them is lower than their water.
std::vector<std::string> find_open_ends(const std::vector<Pond>& ponds, const Polyline& ground,
                                        const ShownUnit& length);

/// Returns the level of the water table at x [m]: linear between its points, horizontal beyond its ends.
double find_water_table(const std::vector<std::array<double, 2>>& table, double x);

// A part of a water table steeper than 10 : 1 is a step, as beside a wall: each side of it has its own level, and no
// water stands on it.

bool is_step(const Point& a, const Point& b);
bool has_step(const Polyline& table);
/// Returns the x at which the table is read for a place at `x` of an element or a side with its middle at `middle`, so
/// that all of it has the level of its own side of a step.
double leave_steps(const Polyline& table, double x, double middle);

/// Returns the level of the water standing over the ground at x [m], that of a pond or of the water table; nothing
/// where the ground is dry. `table` may be empty.
std::optional<double> find_standing_level(const std::vector<Pond>& ponds, const Polyline& table, const Polyline& ground,
                                          double x);

/// Returns the line of zero pressure of a grid as a water table, together with the water standing on the ground [m].
Polyline trace_water_table(const lem::PressureGrid& grid, const std::vector<Pond>& ponds, const Polyline& ground,
                           double base);

/// Returns a water table with the levels of the ponds where there are any.
Polyline add_ponds(const Polyline& table, const std::vector<Pond>& ponds, const Polyline& ground);

/// Returns warnings on the water tables of a plane case, before and after a drawdown: free water that slopes, ends
/// inside the section that flood lower ground, water far above the crest, and lines outside the section.
std::vector<std::string> find_odd_water(const Site& site);

/// Returns the warnings on one line; `name` begins the sentences: "The water table".
std::vector<std::string> find_odd_water(const Polyline& table, const Polyline& ground, double base,
                                        const ShownUnit& length, const std::string& name);

}  // namespace talus::site
