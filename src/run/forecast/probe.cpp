// SPDX-License-Identifier: MIT
#include "run/forecast/probe.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/error.hpp"
#include "mesh/generate.hpp"
#include "run/forecast/counts.hpp"
#include "run/mpm/reduction/frozen_factor.hpp"
#include "run/mpm/stage.hpp"
#include "run/mpm/start/initial_state.hpp"
#include "run/mpm/start/prepare.hpp"

namespace talus::run {
namespace {

using Clock = std::chrono::steady_clock;

/// Elements with soil of the coarse mesh: enough to fill the lanes of a step, and meshed in a moment.
constexpr double coarse_elements = 800;
constexpr double probe_seconds = 0.1, most_seconds = 1;  ///< of a stage, and of all together

/// Ends the stage that is stepped for a moment.
struct Enough {};

bool can_be_probed(const input::Case& data) {
  const bool has_library = std::any_of(data.materials.begin(), data.materials.end(), [](const auto& named) {
    return named.second.model == material::model_of<material::External>;
  });
  return input::uses(data, input::Method::mpm) && data.mesh.file.empty() && is_meshed_in_a_moment(data.mesh) &&
         data.initial.result.empty() && data.initial.water.season == 0 && !data.stages.empty() && !has_library;
}

/// Steps of one point in a second of a stage, which is stepped for some `seconds`.
template <int D>
double measure(mpm::Body<D>& body, StagePlan<D> plan, double seconds) {
  plan.duration = 1e9;
  plan.until_rest = false;
  StageState state;
  StageHooks<D> hooks;
  const auto start = Clock::now();
  std::int64_t steps = 0;
  double taken = 0;
  hooks.look = [&](const mpm::Body<D>&, const StageState& now) {
    steps = now.steps;
    taken = std::chrono::duration<double>(Clock::now() - start).count();
    if (taken > seconds) throw Enough{};
  };
  try {
    run_stage(body, plan, state, hooks);
  } catch (const Enough&) {
  }
  return static_cast<double>(steps) * body.points.size() / taken;
}

template <int D>
Pace probe_in(const input::Case& data) {
  input::Case coarse = data;
  const double elements = count_elements(data.mesh).soil;
  const double ratio = std::max(1.0, std::pow(elements / coarse_elements, 1.0 / D));
  const double smallest = find_smallest_size(data.mesh);
  coarse.mesh.refinements.clear();
  coarse.mesh.size = ratio * data.mesh.size;
  mpm::Body<D> body = prepare<D>(coarse, mesh::generate<D>(coarse.mesh));
  const double height = find_soil_height(body, data.gravity);
  const auto find_step = [&](const StagePlan<D>& plan) {
    const double size = plan.equalises_mass ? data.mesh.size : smallest;
    return find_critical_step(body, plan).dt * plan.step.courant * size / coarse.mesh.size;
  };
  Pace pace;
  const input::Stage& first = data.stages.front();
  set_strength(body, coarse, first.cohesion, first.strength_factor.value_or(1));
  const double each = std::min(probe_seconds, most_seconds / static_cast<double>(data.stages.size()));
  for (const input::Stage& stage : data.stages) {
    const StagePlan<D> plan = make_plan<D>(coarse, stage, height, 1);
    StagePace& here = pace.stages.emplace_back(StagePace{find_step(plan), 0});
    // A later stage is stepped from where the ones before it were left after a moment, not from where they end.
    here.point_steps = measure(body, plan, each);
  }
  StagePlan<D> plan = make_plan<D>(coarse, first, height, 1);
  plan.step = data.strength_reduction.curve.step_settings;
  pace.curve = {find_step(plan), pace.stages.back().point_steps};
  pace.frozen = {find_step(make_frozen_plan<D>(coarse, data.strength_reduction.frozen, height, 1)),
                 pace.stages.front().point_steps};  // its water is held
  return pace;
}

}  // namespace

std::optional<Pace> probe(const input::Case& data) {
  if (!can_be_probed(data)) return std::nullopt;
  try {
    return data.mesh.dimension == 2 ? probe_in<2>(data) : probe_in<3>(data);
  } catch (const Error& error) {
    if (error.code() == ExitCode::interrupted) throw;
    return std::nullopt;
  }
}

}  // namespace talus::run
