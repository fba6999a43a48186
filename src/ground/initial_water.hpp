// SPDX-License-Identifier: MIT
#pragma once
// Pore water at the start: pressures by [initial], from a water table or from steady seepage on the same mesh, and the
// weather that followed.

#include <optional>

#include "fem/seepage/seepage.hpp"
#include "ground/season.hpp"
#include "input/case/case.hpp"
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

}  // namespace talus::ground
