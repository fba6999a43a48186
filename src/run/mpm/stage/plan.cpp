// SPDX-License-Identifier: MIT
#include "run/mpm/stage/plan.hpp"

#include <algorithm>
#include <cmath>

#include "run/mpm/start/prepare.hpp"

namespace talus::run {

template <int D>
StagePlan<D> make_plan(const input::Case& data, const std::string& name, double duration,
                       const input::StepSettings& step, double soil_height, int threads) {
  StagePlan<D> plan;
  plan.name = name;
  plan.duration = duration;
  plan.step = step;
  plan.rest = data.rest;
  plan.gravity = find_acceleration<D>(data);
  plan.soil_height = soil_height;
  plan.threads = threads;
  plan.units = data.units();
  return plan;
}

template <int D>
StagePlan<D> make_plan(const input::Case& data, const input::Stage& stage, double soil_height, int threads) {
  StagePlan<D> plan = make_plan<D>(data, stage.name, stage.duration, stage.step, soil_height, threads);
  plan.cohesion = stage.cohesion;
  plan.strength_factor = stage.strength_factor.value_or(1);
  plan.until_rest = stage.until == input::Until::rest;
  plan.gravity_ramp = stage.gravity_ramp;
  plan.brings_weight = !data.stages.empty() && stage.name == data.stages.front().name && data.initial.result.empty() &&
                       data.initial.stress == input::InitialStress::none;
  return plan;
}

template <int D>
mpm::StepOptions<D> make_options(const StagePlan<D>& plan) {
  const input::StepSettings& step = plan.step;
  mpm::StepOptions<D> o;
  o.damping = step.damping;
  o.mass_scaling = step.mass_scaling;
  o.mixed = step.integration == input::Integration::mixed;
  o.smoothing = step.smoothing;
  o.moving = step.geometry == input::Geometry::moving;
  o.objective = step.objective_rate;
  o.threads = plan.threads;
  o.jacks = plan.brings_weight;
  o.darcy = step.water == input::WaterMotion::seeps;
  o.implicit_drag = step.drag == input::Drag::implicit_at_nodes;
  o.water_damping = step.water_damping;
  o.net_damping = step.damped_force == input::DampedForce::net;
  o.smooth_pressure = step.pressure_smoothing;
  o.exchange_water = step.water_exchange;
  o.conductivity_factor = step.conductivity_factor;
  return o;
}

template <int D>
Vec<D> find_stage_gravity(const StagePlan<D>& plan, const StageState& state, double time) {
  double share = 1;
  if (plan.gravity_ramp > 0) {
    const double progress = std::min(1.0, (time - state.start_time) / plan.gravity_ramp);
    share = state.gravity_share + (1 - state.gravity_share) * progress;
  }
  Vec<D> g = plan.gravity;
  for (double& c : g) c *= share;
  return g;
}

namespace {

/// Returns true if the last monitored step satisfies the rest criterion, regardless of the holding time.
template <int D>
bool is_calm(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  const mpm::Monitor& m = body.monitor;
  const double reference_speed = std::sqrt(norm(plan.gravity) * plan.soil_height);
  const bool slow = m.kinetic_energy <= plan.rest.energy_ratio * std::abs(body.work.external) ||
                    plan.step.geometry == input::Geometry::frozen;
  return m.out_of_balance < plan.rest.force_ratio * m.external && m.speed < plan.rest.speed_ratio * reference_speed &&
         slow;
}

}  // namespace

template <int D>
bool has_rested(const mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state) {
  const bool full_gravity = body.time >= state.start_time + plan.gravity_ramp;
  if (!full_gravity || !is_calm(body, plan)) {
    state.calm_since = -1;
  } else if (state.calm_since < 0) {
    state.calm_since = body.time;
  } else if (body.time - state.calm_since >= plan.rest.hold) {
    return true;
  }
  return false;
}

namespace {

/// Returns the smoothing after this number of retries.
input::Smoothing choose_smoothing(input::Smoothing now, std::size_t retries, bool flows) {
  using input::Smoothing;
  if (retries == 0 || now == Smoothing::none) return now;
  if (flows || retries > 1) return Smoothing::none;
  return Smoothing::stable;
}

}  // namespace

template <int D>
StagePlan<D> make_retry_plan(StagePlan<D> plan, std::size_t retries, bool wet) {
  plan.step.courant *= std::pow(0.5, static_cast<double>(retries));
  const bool flows = wet && plan.step.water == input::WaterMotion::flows;
  plan.step.smoothing = choose_smoothing(plan.step.smoothing, retries, flows);
  return plan;
}

#define TALUS_INSTANTIATE(D)                                                                                     \
  template StagePlan<D> make_plan<D>(const input::Case&, const std::string&, double, const input::StepSettings&, \
                                     double, int);                                                               \
  template StagePlan<D> make_plan<D>(const input::Case&, const input::Stage&, double, int);                      \
  template mpm::StepOptions<D> make_options<D>(const StagePlan<D>&);                                             \
  template Vec<D> find_stage_gravity<D>(const StagePlan<D>&, const StageState&, double);                         \
  template bool has_rested<D>(const mpm::Body<D>&, const StagePlan<D>&, StageState&);                            \
  template StagePlan<D> make_retry_plan<D>(StagePlan<D>, std::size_t, bool);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
