// SPDX-License-Identifier: MIT
#pragma once
// Pore water at the start: pressures by [initial] (water table, or steady seepage on the same mesh) and the weather
// after that, in the forms that MPM, FEM and LEM use.

#include <optional>
#include <string>
#include <vector>

#include "fem/seepage/seepage.hpp"
#include "input/case/case.hpp"
#include "lem/section/section.hpp"
#include "mesh/mesh.hpp"
#include "site/season.hpp"
#include "site/seepage_results.hpp"
#include "site/site.hpp"

namespace talus::site {

/// Pore water at the start, per element; zero where there is none.
template <int D>
struct InitialWater {
  std::vector<double> pressure;                  ///< at the middle of the element, positive in tension [Pa]
  std::vector<Vec<D>> velocity;                  ///< of the pore water relative to the grains [m/s]
  std::optional<fem::SeepageResult<D>> seepage;  ///< steady state, before the season
  std::optional<SeasonRecord> season;
  std::vector<double> nodal;  ///< at the nodes, of the seepage or at the end of the season [Pa]; else empty
};

/// Returns the pore water at the start. Throws Error (wrong_input) if gravity is inclined where levels matter, and as
/// solve_steady_seepage() and run_season().
template <int D>
InitialWater<D> find_initial_water(const input::Case& data, const mesh::Mesh<D>& mesh);

/// Returns the same pressures at the nodes, NaN where no adjoining element is wet; empty for dry soil.
template <int D>
std::vector<double> find_nodal_pressures(const input::Case& data, const mesh::Mesh<D>& mesh,
                                         const InitialWater<D>& water);

/// Returns the model of steady seepage: materials by region, [[hydraulic]] by boundary; regions without pore water take
/// no part. `wet_mesh` receives the mesh with those regions empty, and must outlive the model.
template <int D>
fem::SeepageModel<D> make_seepage_model(const input::Case& data, const mesh::Mesh<D>& mesh, mesh::Mesh<D>& wet_mesh);

/// Returns the pressure [Pa] of the water standing on the ground above each place, from the total heads and pressures
/// at time 0 on the sides that face upwards; zero without any.
template <int D>
std::vector<double> find_ponded_load(const input::Case& data, const mesh::Mesh<D>& mesh,
                                     const std::vector<Vec<D>>& places);

/// Returns the piezometric line of a soil of the case, which is the water table for most.
const Polyline& find_piezometric_line(const input::Case& data, const input::Material& soil);

/// Returns the pressure in a soil at `x` under its piezometric line, or of the grid of the case, positive in tension
/// [Pa].
template <int D>
double find_given_pressure(const input::Case& data, const input::Material& soil, const Vec<D>& x);

/// Returns r_u of a soil at `x` [-]; 0 if its pressure follows otherwise.
template <int D>
double find_pressure_ratio(const input::Case& data, const input::Material& soil, const Vec<D>& x);
/// Returns true if some soil has an r_u.
bool has_pressure_ratio(const input::Case& data);
/// Returns true if the case gives pore pressures or heads at points.
bool has_pressure_field(const input::Case& data);

/// Returns the pressures of the grid of a plane case on triangles that cover its section.
lem::PressureGrid make_given_grid(const Site& site);

/// Returns true if pore pressures result from a flow calculation and therefore need a mesh.
bool needs_seepage(const input::Case& data);

/// Origin of the pore pressure of a soil.
enum class PressureSource {
  none,      ///< the pressure is zero, but for r_u
  computed,  ///< seepage, a season, a timeline, or an earlier calculation: in soil with pore water of its own
  given      ///< a water table, a piezometric line or pressures at points: in every other soil
};

/// Returns the origin of the pore pressure of a soil of the case. It is the same in LEM, FEM and limit analysis.
PressureSource find_pressure_source(const input::Case& data, const input::Material& soil);

/// Returns true if some [[hydraulic]] gives a head or a pressure, and with it the level of water on the ground.
bool gives_levels(const input::Case& data);

/// Returns the level of zero pressure at `x` in a soil with given pressures [m].
template <int D>
double find_given_level(const input::Case& data, const input::Material& soil, const Vec<D>& x);

/// Returns the pore pressure at the nodes of a mesh, positive in tension [Pa]; zero in a case without water, and that
/// at the end of a season if there is one. `summary` receives the results on the water.
template <int D>
std::vector<double> find_nodal_pressure(const input::Case& data, const mesh::Mesh<D>& mesh,
                                        WaterResult* summary = nullptr);

/// Returns the case with bottom, left and right side fixed if it names no boundary at all: they are impermeable unless
/// a [[hydraulic]] opens them.
input::Case close_sides(input::Case data);

/// Returns computed pressures on a mesh for LEM. Soil with another source has nodes of its own, after those of the
/// mesh, with the given pressure or zero.
lem::PressureGrid make_pressure_grid(const input::Case& data, const mesh::Mesh<2>& mesh,
                                     const std::vector<double>& pressure);

}  // namespace talus::site
