// SPDX-License-Identifier: MIT
#pragma once
// Places of supports on the ground, in stages of construction on that of the stage that adds them.

#include <array>
#include <optional>
#include <string>

#include "input/case/case.hpp"
#include "input/case/support.hpp"

namespace talus::input {

using PlanePoint = std::array<double, 2>;

/// A head within this fraction of the width of the section lies on the ground: its coordinates are rounded.
inline constexpr double near_ground = 1e-3;

/// Returns the distance of the ends of the ground [m].
double measure_width(const mesh::Polyline& ground);

/// Returns the levels of the ground at x, the lower and the upper end of a vertical step; nullopt beyond its ends.
std::optional<std::array<double, 2>> find_levels(const mesh::Polyline& ground, double x);

/// Returns the first stage of construction that has a support; nullopt if it is there at the start.
std::optional<std::size_t> find_placing_stage(const Case& data, const std::string& name);
/// Returns the ground of the regions that are there in stage `number`, nullopt: at the start; nullopt if it is not
/// unique.
std::optional<mesh::Polyline> find_stage_ground(const Case& data, std::optional<std::size_t> number);
/// Returns the ground on which a support is placed: that of the section, or with stages of construction that of the
/// first stage in which the support is there. Throws as mesh::find_ground().
mesh::Polyline find_placing_ground(const Case& data, const std::string& name);
/// Places the bars of a support of a case on that ground, whose fault is one of the layout.
BarLayout lay_bars(const Case& data, const std::string& name);
/// Returns true if two bars cross between their ends.
bool do_cross(const BarLine& a, const BarLine& b);
/// Returns the name by which stages of construction add and remove a strut of a wall: "sheet.strut_1".
std::string name_strut(const std::string& wall, std::size_t index);
/// Returns the support with its bars where a layout has them, whatever ground comes later.
Support fix_places(Support support, const BarLayout& layout);

}  // namespace talus::input
