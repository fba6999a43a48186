// SPDX-License-Identifier: MIT
#pragma once
// Pore water at the start: pressures by [initial], from a water table or from steady seepage on the same mesh, and the
// weather that followed.

#include <optional>
#include <string>
#include <vector>

#include "fem/seepage/seepage.hpp"
#include "ground/ground_line.hpp"
#include "ground/season.hpp"
#include "ground/seepage_results.hpp"
#include "input/case/case.hpp"
#include "lem/section/section.hpp"
#include "mesh/mesh.hpp"
#include "mpm/body/build.hpp"

namespace talus::ground {

/// By element; zero where there is no pore water.
template <int D>
struct InitialWater {
  std::vector<double> pressure;                  ///< in the middle of the element, positive in tension [Pa]
  std::vector<Vec<D>> velocity;                  ///< of the water in the pores, against the grains [m/s]
  std::optional<fem::SeepageResult<D>> seepage;  ///< steady, before the season
  std::optional<SeasonRecord> season;
  std::vector<double> nodal;  ///< at the nodes, of the seepage or at the end of the season [Pa]; else empty
};

/// Throws Error (wrong_input) when gravity is inclined where levels matter, and what solve_steady_seepage() and
/// run_season() throw.
template <int D>
InitialWater<D> find_initial_water(const input::Case& data, const mesh::Mesh<D>& mesh);

/// The same at the nodes, NaN where no wet element is near; empty for dry soil.
template <int D>
std::vector<double> find_nodal_pressures(const input::Case& data, const mesh::Mesh<D>& mesh,
                                         const InitialWater<D>& water);

/// Level of the water table at x [m]: linear between its points, horizontal beyond its ends.
double find_water_table(const std::vector<std::array<double, 2>>& table, double x);

/// What steady seepage through the case is: materials by region, [[hydraulic]] by boundary; regions without pore water
/// take no part. `wet_mesh` receives the mesh with those regions empty, and must live as long as the model.
template <int D>
fem::SeepageModel<D> make_seepage_model(const input::Case& data, const mesh::Mesh<D>& mesh, mesh::Mesh<D>& wet_mesh);

/// Pressure [Pa] of water that stands on the ground above each point, from the total heads and pressures at time 0 of
/// the surfaces that face upwards. Zero for all in a case without.
template <int D>
std::vector<double> find_ponded_load(const input::Case& data, const mesh::Mesh<D>& mesh,
                                     const std::vector<mpm::InitialPoint<D>>& points);

// Pore water at the start as slices and finite elements take it: pressures at the nodes of a mesh, or a water table,
// and the water that stands on the ground.

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
std::vector<double> find_nodal_pressure(const input::Case& data, const mesh::Mesh<D>& mesh,
                                        WaterResult* summary = nullptr);

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
