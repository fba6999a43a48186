// SPDX-License-Identifier: MIT
#pragma once
// The model of one stage of construction: the case with what is there in it, its soil and its water on the mesh of the
// whole section.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fem/consolidation/consolidation.hpp"
#include "input/case/case.hpp"
#include "run/fem/solid_of_case.hpp"

namespace talus::run {

/// Stage before the first: what is there at the start.
inline constexpr int before_stages = -1;

/// Returns the case with the regions, loads, supports and drains of a stage, and without stages.
input::Case make_stage_case(const input::Case& data, int number);

/// Start and end of a stage [s].
double find_stage_start(const input::Case& data, int number);
double find_stage_end(const input::Case& data, int number);

/// Returns the mesh of all regions, which has nodes at the ends of the loads of every stage. Throws what
/// mesh::generate() and Site::ground() throw.
std::shared_ptr<const mesh::Mesh<2>> make_whole_mesh(const input::Case& data, std::vector<std::string>& notes);

/// Not to be moved: its parts refer to one another.
struct StageModel {
  input::Case data;  ///< of the stage; the loads and weights are those of its end
  SolidOfCase<2> solid;
  mesh::Mesh<2> wet_mesh;
  std::shared_ptr<const mesh::Mesh<2>> water_mesh;  ///< of the heads: that of the solid, cut at impermeable walls
  fem::SeepageModel<2> flow;
  fem::ConsolidationModel<2> model;
  bool is_wet = false;            ///< some soil has pore water
  std::vector<double> elevation;  ///< per node of water_mesh [m]

  StageModel() = default;
  StageModel(const StageModel&) = delete;
};

/// Makes the model of a stage. `water`: that of its start, null before the first one. Throws Error (wrong_input) for
/// soil that nothing bears, and as make_solid_on() and make_seepage_model().
std::unique_ptr<StageModel> make_stage_model(const input::Case& data, int number,
                                             const std::shared_ptr<const mesh::Mesh<2>>& whole,
                                             std::shared_ptr<const input::KnownWater> water);

/// Returns values per node of the mesh of the water of one stage for that of another one.
std::vector<double> map_nodes(const StageModel& from, const std::vector<double>& values, const StageModel& to);

/// Returns heads per node [m] from pore pressures, positive in tension [Pa], and back.
std::vector<double> find_heads(const StageModel& stage, const std::vector<double>& pressure);
std::vector<double> find_pressures(const StageModel& stage, const std::vector<double>& head);

}  // namespace talus::run
