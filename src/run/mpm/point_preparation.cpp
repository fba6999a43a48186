// SPDX-License-Identifier: MIT
#include "run/mpm/point_preparation.hpp"

#include <fmt/format.h>

#include <chrono>
#include <set>

#include "base/hash.hpp"
#include "base/memory.hpp"
#include "mesh/quality.hpp"
#include "mpm/solver/observe.hpp"
#include "run/common/bedding_lines.hpp"
#include "run/mpm/record/checkpoint.hpp"
#include "run/mpm/record/motion.hpp"
#include "run/mpm/record/point_results.hpp"
#include "run/mpm/stage/stepper.hpp"
#include "run/mpm/start/end_state.hpp"
#include "run/mpm/start/prepare.hpp"

namespace talus::run {
namespace {

template <int D>
void check_names(const input::LoadedCase& loaded, const mesh::Mesh<D>& mesh) {
  std::set<std::string> sides, regions(mesh.region_names.begin(), mesh.region_names.end());
  for (const auto& [name, list] : mesh.sides) sides.insert(name);
  input::check_against_mesh(loaded, sides, regions);
}

/// Describes the result that the case starts from.
template <int D>
void write_origin(const input::LoadedCase& loaded, const input::Case& data, const EndState& origin,
                  PreparedPoints<D>& made, results::RunResult& run) {
  run.start = origin.tell();
  const std::string result = data.initial.result;
  if (origin.is_on_another_mesh(loaded.echo))
    made.warnings.push_back(
        fmt::format("[geometry] or [mesh] is not as in the case of the result '{}', and was not used: the mesh is that "
                    "of the result",
                    result));
  for (const std::string& name : origin.list_refilled(made.body))
    made.warnings.push_back(
        fmt::format("material '{}' holds water otherwise than in the result '{}': pore pressures are those of the "
                    "result, the water in the pores has been changed to fit",
                    name, result));
  if (data.analysis == input::AnalysisKind::strength_reduction && data.strength_reduction.frozen.enabled)
    made.warnings.push_back(
        fmt::format("the mesh is that of the result '{}', which cannot be halved: the factor of safety is that of one "
                    "mesh and not extrapolated",
                    result));
}

template <int D>
void warn_about_seepage(const std::optional<fem::SeepageResult<D>>& seepage, PreparedPoints<D>& made) {
  if (seepage && seepage->undecided > 0)
    made.warnings.push_back(
        fmt::format("steady seepage: {} nodes of the ground fit neither a dry nor a wet surface; the "
                    "mesh is coarse for the height of the capillary fringe",
                    seepage->undecided));
}

/// Adds warnings of the device and the boundaries.
template <int D>
void warn_about_steps(const input::Case& data, PreparedPoints<D>& made) {
  if (const std::vector<std::string> left = list_left_to_processor(data); !left.empty())
    made.warnings.push_back(
        fmt::format("the device does not calculate water with a velocity of its own (water = \"flows\"): the processor "
                    "did the stages {}",
                    fmt::join(left, ", ")));
  if (made.body.conditions.constraints.empty())
    made.warnings.push_back("no boundary holds the soil; without [[boundary]] it falls out of the box");
}

}  // namespace

template <int D>
PreparedPoints<D> prepare_points(const input::LoadedCase& loaded, const input::Case& data, const RunOptions& options,
                                 const std::string& input_hash, results::RunResult& run) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  PreparedPoints<D> made;
  made.checkpoint_hash = input_hash;
  made.mesh_input = loaded.echo;
  std::unique_ptr<EndState> origin;
  if (!data.initial.result.empty()) {
    origin = std::make_unique<EndState>(data.initial);
    input::check_against_result(loaded, origin->input());
    made.checkpoint_hash = hash_text(input_hash + origin->hash());
    made.mesh_input = origin->input();
  }
  if (options.resume) made.checkpoint = open_checkpoint(options.folder / "checkpoint.h5", made.checkpoint_hash);
  mesh::Mesh<D> mesh = made.checkpoint ? get_mesh<D>(*made.checkpoint)
                       : origin        ? origin->get_mesh<D>()
                                       : generate_along_bedding<D>(data, data.mesh, made.warnings);
  check_names(loaded, mesh);
  std::optional<fem::SeepageResult<D>> seepage;
  made.body = prepare<D>(data, std::move(mesh), 0, &seepage, &made.season);
  made.work_before = made.body.work;
  if (made.body.water.is_wet()) made.initial_water = mpm::find_water_state(made.body).mass;
  made.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  made.slope_height = find_slope_height(made.body, data.gravity);
  run.mesh = make_mesh_result(made.body);
  run.slope_height = made.slope_height;
  made.water = site::make_water_result<D>(data, made.body.mesh(), seepage, made.season);
  if (origin) made.water.states.reset(), made.water.fields.reset();  // the water of the result replaces them
  site::give(made.water, run);
  warn_about_seepage(seepage, made);
  if (origin) write_origin(loaded, data, *origin, made, run);
  origin.reset();  // frees as much memory as the body takes
  warn_about_steps(data, made);
  made.profile_bin = mesh::measure_quality(made.body.mesh()).mean_size;
  made.runout_start = {find_profile(made.body, made.profile_bin), find_onset_threshold(data.output, made.slope_height),
                       find_specific_volumes(made.body)};
  return_freed_memory();
  return made;
}

template PreparedPoints<2> prepare_points<2>(const input::LoadedCase&, const input::Case&, const RunOptions&,
                                             const std::string&, results::RunResult&);
template PreparedPoints<3> prepare_points<3>(const input::LoadedCase&, const input::Case&, const RunOptions&,
                                             const std::string&, results::RunResult&);

}  // namespace talus::run
