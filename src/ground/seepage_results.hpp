// SPDX-License-Identifier: MIT
#pragma once
// What results keep of the pore water that the methods begin with: seepage, season, and where the water stood.

#include <optional>
#include <vector>

#include "fem/seepage/seepage.hpp"
#include "ground/ground_line.hpp"
#include "ground/season.hpp"
#include "input/case/case.hpp"
#include "results/water.hpp"

namespace talus::results {
struct RunResult;
}

namespace talus::ground {

/// The parts of a result that are about the pore water before the first stage or trial.
struct WaterResult {
  std::optional<results::Seepage> seepage;  ///< steady
  std::optional<results::Season> season;
  std::optional<std::vector<results::WaterState>> states;  ///< in time
  std::optional<results::WaterFields> fields;              ///< of these states
};

/// Of seepage, steady and through a season, on this mesh.
template <int D>
WaterResult make_water_result(const input::Case& data, const mesh::Mesh<D>& mesh,
                              const std::optional<fem::SeepageResult<D>>& steady,
                              const std::optional<SeasonRecord>& season);

/// Of a plane case whose water stands at rest under a table; nothing for others.
WaterResult make_water_table_result(const input::Case& data);

/// Adds the state after a rapid drawdown to `table`.
void add_lowered_state(const input::Case& data, const Polyline& table, WaterResult& summary);

/// Gives a run what it has not got from another method.
void give(const WaterResult& water, results::RunResult& run);

/// Flow by side, where water comes out, the water table and the largest suction.
template <int D>
results::Seepage make_seepage_result(const mesh::Mesh<D>& mesh, const fem::SeepageResult<D>& seepage);

/// One state of a flow calculation at the time `time` [s], with the water that stood on the ground then.
template <int D>
results::WaterState make_state_result(const input::Case& data, const fem::SeepageResult<D>& seepage,
                                      results::WaterFlow flow, double time);

/// Fields without states on the elements of `wet_mesh` that take part; nothing where they are more than a report draws.
std::optional<results::WaterFields> begin_fields(const input::Case& data, const mesh::Mesh<2>& wet_mesh);

/// Its fields on the elements of `mesh` that take part.
template <int D>
results::WaterField make_field_result(const mesh::Mesh<D>& wet_mesh, const fem::SeepageResult<D>& seepage,
                                      results::WaterFlow flow, double time);

}  // namespace talus::ground
