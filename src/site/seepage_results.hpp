// SPDX-License-Identifier: MIT
#pragma once
// Results on the pore water at the start of the methods: seepage, season, water tables and fields.

#include <optional>
#include <vector>

#include "fem/seepage/seepage.hpp"
#include "input/case/case.hpp"
#include "results/water.hpp"
#include "site/season.hpp"
#include "site/site.hpp"

namespace talus::results {
struct RunResult;
}

namespace talus::site {

/// The results on the pore water before the first stage or trial.
struct WaterResult {
  std::optional<results::Seepage> seepage;  ///< steady state
  std::optional<results::Season> season;
  std::optional<std::vector<results::WaterState>> states;  ///< in the order of time
  std::optional<results::WaterFields> fields;              ///< fields of `states`
};

/// Returns the results of steady seepage and of a season on this mesh.
template <int D>
WaterResult make_water_result(const Site& site, const mesh::Mesh<D>& mesh,
                              const std::optional<fem::SeepageResult<D>>& steady,
                              const std::optional<SeasonRecord>& season);

/// Returns the results of a plane case with water at rest under a table; empty for other cases.
WaterResult make_water_table_result(const Site& site);

/// Adds the state after a rapid drawdown to `table`.
void add_lowered_state(const Site& site, const Polyline& table, WaterResult& summary);

/// Copies to a run the results that it does not have from another method.
void give(const WaterResult& water, results::RunResult& run);

/// Returns flow per side, wet parts of the seepage faces, the water table and the largest suction.
template <int D>
results::Seepage make_seepage_result(const mesh::Mesh<D>& mesh, const fem::SeepageResult<D>& seepage);

/// Returns one state of a flow calculation at `time` [s], with the water standing on the ground at that time.
template <int D>
results::WaterState make_state_result(const Site& site, const fem::SeepageResult<D>& seepage, results::WaterFlow flow,
                                      double time);

/// Returns fields without states on the elements of `wet_mesh` that take part; nothing if they are too many for a
/// figure.
std::optional<results::WaterFields> begin_fields(const input::Case& data, const mesh::Mesh<2>& wet_mesh);

/// Returns the fields of one state on the elements of `wet_mesh` that take part.
template <int D>
results::WaterField make_field_result(const mesh::Mesh<D>& wet_mesh, const fem::SeepageResult<D>& seepage,
                                      results::WaterFlow flow, double time);

}  // namespace talus::site
