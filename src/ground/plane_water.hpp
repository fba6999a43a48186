// SPDX-License-Identifier: MIT
#pragma once
// Pore water at the start as slices and finite elements take it: pressures at the nodes of a mesh, or a water table,
// and the water that stands on the ground.

#include <optional>
#include <string>
#include <vector>

#include "ground/ground_line.hpp"
#include "ground/tell_seepage.hpp"
#include "input/case/case.hpp"
#include "lem/section/section.hpp"
#include "mesh/mesh.hpp"

namespace talus::ground {

/// Water over a stretch of the ground, from a total head or a pressure on a named line.
struct Pond {
  Point from{}, to{};                   ///< on the ground, from left to right [m]
  double level_from = 0, level_to = 0;  ///< of the water there [m]
};
/// The time that the methods begin with [s]: 0, and just before it where a timeline follows, whose series may jump at
/// 0.
double find_first_time(const input::Case& data);

/// The same of the weather: just before the season, where there is one [s].
double find_weather_start(const input::Case& data);

/// As it stands at `time` [s].
std::vector<Pond> find_ponds(const input::Case& data, const Polyline& ground, double time);

/// Sentences on ponds without a bank, where the ground beside them is lower than their water.
std::vector<std::string> find_open_ends(const std::vector<Pond>& ponds, const Polyline& ground);

/// Level of the water that stands over the ground at x [m]: a pond's, or that of the water table; nothing where the
/// ground is dry. `table` may be empty.
std::optional<double> find_standing_level(const std::vector<Pond>& ponds, const Polyline& table, const Polyline& ground,
                                          double x);

/// Whether pore pressures follow from a flow calculation and need a mesh.
bool needs_seepage(const input::Case& data);

/// Whether water acts in this material: where some soil of the case has pore water only in those that have, as for
/// material points; else in all.
bool takes_water(const input::Case& data, const input::Material& soil);

/// Pore pressure at the nodes of a mesh, positive in tension [Pa]; zero in a case without water. With a season before
/// the run: of its end. `told` receives what results keep of them.
template <int D>
std::vector<double> find_nodal_pressure(const input::Case& data, const mesh::Mesh<D>& mesh, WaterResult* summary = nullptr);

/// The case with bottom, left and right side held where it names no boundary at all: water does not pass them unless a
/// [[hydraulic]] opens them.
input::Case close_sides(input::Case data);

/// Pressures of a mesh for slices; soil that takes no water has zero.
lem::PressureGrid make_pressure_grid(const input::Case& data, const mesh::Mesh<2>& mesh,
                                     const std::vector<double>& pressure);

/// The line of zero pressure in such a grid, with the water that stands on the ground, as a water table [m].
Polyline trace_water_table(const lem::PressureGrid& grid, const std::vector<Pond>& ponds, const Polyline& ground,
                           double base);

/// A water table with the levels of ponds where they are.
Polyline add_ponds(const Polyline& table, const std::vector<Pond>& ponds, const Polyline& ground);

}  // namespace talus::ground
