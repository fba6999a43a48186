// SPDX-License-Identifier: MIT
#pragma once
// Definition of a stage, its state, and the equations of its gravity, its rest criterion and its retries.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "mpm/solver/step.hpp"
#include "results/trial.hpp"

namespace talus::run {

template <int D>
class Helpers;  // see helpers.hpp

/// Definition of a stage, without the body. All of it follows from the case.
template <int D>
struct StagePlan {
  std::string name;
  std::optional<double> cohesion;  ///< of every material, instead of its own [Pa]
  double strength_factor = 1;      ///< divides the strength
  double duration = 0;             ///< [s]; the longest time if until_rest
  bool until_rest = false;
  input::StepSettings step;
  input::RestCriterion rest;
  Vec<D> gravity{};                ///< at full strength [m/s²]
  double gravity_ramp = 0;         ///< [s]
  double soil_height = 0;          ///< H of the rest criterion [m]
  double failed_displacement = 0;  ///< the stage ends when a point has moved farther [m]; 0: never
  bool brings_weight = false;      ///< first stage of soil without stress; anchors keep their prestress
  bool equalises_mass = false;     ///< small elements do not limit the step (auxiliary_body.hpp)
  int threads = 1;
  Helpers<D>* helpers = nullptr;  ///< the other ranks, if only this one has the body
  ShownUnits units;               ///< units of messages
};

/// State of a stage. Together with the body it suffices to resume bitwise identically.
struct StageState {
  bool started = false;
  double start_time = 0;  ///< [s]
  std::int64_t steps = 0;
  double dt = 0;             ///< last time step [s]
  double gravity_share = 0;  ///< fraction of full gravity at the start of the stage
  double calm_since = -1;    ///< time since which the rest criterion holds [s]; -1: it does not
  double next_output = 0;    ///< simulated time of the next call of StageHooks::output [s]
  double largest_speed = 0;  ///< of any node, in the whole stage [m/s]
  double wave_speed = 0;     ///< of compression waves, at the start of the stage [m/s]
  double soft_band = 0;      ///< smallest thickness of a softening band so far, in elements; 0: no band
  double soft_size = 0;      ///< largest element size of such a band [m]
  std::vector<results::Retry> setbacks;
};

/// Steps between looks at time step, progress and interruption, and between evaluations of the rest criterion.
inline constexpr int look_interval = 64;
inline constexpr int monitor_interval = 8;

/// Plan of a stage with these settings under the gravity of a case.
template <int D>
StagePlan<D> make_plan(const input::Case& data, const std::string& name, double duration,
                       const input::StepSettings& step, double soil_height, int threads);
/// Plan of stage `stage` of a case.
template <int D>
StagePlan<D> make_plan(const input::Case& data, const input::Stage& stage, double soil_height, int threads);

/// Returns the settings of the plan for the engine, without time step and gravity.
template <int D>
mpm::StepOptions<D> make_options(const StagePlan<D>& plan);

/// Gravity [m/s²] at `time` of the stage.
template <int D>
Vec<D> find_stage_gravity(const StagePlan<D>& plan, const StageState& state, double time);

/// Unbalanced force over the external force in the last monitored step.
inline double find_force_ratio(const mpm::Monitor& monitor) {
  return monitor.external > 0 ? monitor.out_of_balance / monitor.external : 0;
}

/// Returns true if the soil has been at rest for the time that the plan requires, by the last monitored step. Stores
/// in `state` since when it has.
template <int D>
bool has_rested(const mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state);

/// Largest number of retries of an unstable stage.
inline constexpr std::size_t most_setbacks = 3;

/// Returns the plan after this number of retries: the time step is halved for each, and smoothing that may be the cause
/// is replaced. With the two-velocity formulation smoothing is switched off; otherwise the first retry uses the stable
/// form, and from the second retry on there is no smoothing.
template <int D>
StagePlan<D> make_retry_plan(StagePlan<D> plan, std::size_t retries, bool wet);

}  // namespace talus::run
