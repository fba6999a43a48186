// SPDX-License-Identifier: MIT
#include "run/mpm/stage/stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "base/error.hpp"
#include "mpm/solver/observe.hpp"
#include "mpm/state/partition.hpp"
#include "run/mpm/stage/auxiliary_body.hpp"
#include "run/mpm/stage/ranks_stage.hpp"
#include "run/mpm/stage/stage_warnings.hpp"
#include "run/mpm/stage/stepper.hpp"
#include "run/mpm/start/prepare.hpp"

namespace talus::run {

namespace {

/// Returns the smoothing after this number of retries.
input::Smoothing choose_smoothing(input::Smoothing now, std::size_t setbacks, bool flows) {
  using input::Smoothing;
  if (setbacks == 0 || now == Smoothing::none) return now;
  if (flows || setbacks > 1) return Smoothing::none;
  return Smoothing::stable;
}

}  // namespace

template <int D>
StagePlan<D> calm_down(StagePlan<D> plan, std::size_t setbacks, bool wet) {
  plan.step.courant *= std::pow(0.5, static_cast<double>(setbacks));
  const bool flows = wet && plan.step.water == input::WaterMotion::flows;
  plan.step.smoothing = choose_smoothing(plan.step.smoothing, setbacks, flows);
  return plan;
}

template <int D>
void GoodStates<D>::keep(const mpm::Body<D>& body, const StageState& state) {
  if (newer_ && newer_->state.steps == state.steps) return;
  // The newest copy may already contain the beginning of an instability, which is detected only after some steps.
  older_ = newer_;
  newer_ = std::make_shared<const Kept>(Kept{body, state, hooks_.mark ? hooks_.mark() : GoBack<D>()});
  if (!older_) older_ = start_ = newer_;
}

template <int D>
bool GoodStates<D>::go_back(mpm::Body<D>& body, StageState& state, const std::string& reason) {
  if (state.setbacks.size() >= most_setbacks) return false;
  // A copy from which an earlier retry failed as well is not a good state.
  const bool failed_before = !state.setbacks.empty() && state.setbacks.back().back_to == older_->body.time;
  const std::shared_ptr<const Kept> to = failed_before ? start_ : older_;
  std::vector<results::Retry> setbacks = std::move(state.setbacks);
  const StagePlan<D> calm = calm_down(plan_, setbacks.size() + 1, to->body.water.is_wet());
  setbacks.push_back({body.time, to->body.time, calm.step.courant, input::get_word(calm.step.smoothing), reason});
  body = to->body;
  state = to->state;
  state.setbacks = std::move(setbacks);
  if (to->go_back) to->go_back(body, state, calm);
  older_ = newer_ = to;
  return true;
}

template StagePlan<2> calm_down<2>(StagePlan<2>, std::size_t, bool);
template StagePlan<3> calm_down<3>(StagePlan<3>, std::size_t, bool);
template class GoodStates<2>;
template class GoodStates<3>;

namespace {

/// Looks between copies of the body from which an unstable run can be repeated.
constexpr int looks_per_copy = 32;
/// A velocity above this multiple of the wave speed is unstable.
constexpr double unstable_speed_ratio = 2;

/// Returns the largest value over all ranks.
template <int D>
double find_largest(const mpm::Body<D>& body, double here) {
  const std::vector<double> all = mpm::join_lists(body, std::vector{here});
  return *std::max_element(all.begin(), all.end());
}

/// Returns an upper bound of the compression wave speed √(E_c/ρ) [m/s]. In the two-velocity formulation it is the
/// speed without drag in saturated soil; in the Darcy formulation that in drained soil, which limits the step.
template <int D>
double find_wave_speed(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  const bool seeps = plan.step.water == input::WaterMotion::seeps;
  double square = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    double sum = material::constrained_modulus(body.laws[p.material], p.stress.data(), p.state.data()) * p.volume /
                 (seeps ? p.mass + p.water_mass : p.mass);
    if (p.wet && !seeps) {
      // The trace of M⁻¹K (T14.13) with S = 1 and ζ' = n/K_w is above its greatest eigenvalue.
      const mpm::WaterLaw& law = body.water.laws[p.material];
      const double n = p.porosity;
      sum += law.bulk_modulus * ((1 - n) / (n * law.grain_density) + 1 / law.density);
    }
    square = std::max(square, sum);
  }
  return std::sqrt(find_largest(body, square));
}

/// Lower limit of the step, as a fraction of that of the smallest element of the mesh. The step falls below that of
/// the smallest element only if soil swells, as separating points do in a collapse. A density of 1/2500 is an
/// explosion.
constexpr double smallest_step_share = 0.02;

template <int D>
double find_smallest_step(const mpm::Body<D>& body, double wave_speed, const StagePlan<D>& plan) {
  const auto& altitudes = body.mesh().altitudes;
  double step = smallest_step_share * *std::min_element(altitudes.begin(), altitudes.end()) *
                std::sqrt(plan.step.mass_scaling) / wave_speed;
  if (body.water.is_wet() && plan.step.water == input::WaterMotion::flows &&
      plan.step.drag == input::Drag::explicit_at_nodes) {
    // With explicit drag the critical step can be far smaller than that of the waves (2.85).
    StagePlan<D> without = plan;
    without.step.drag = input::Drag::implicit_at_nodes;
    step *= std::min(1.0, find_critical_step(body, plan).dt / find_critical_step(body, without).dt);
  }
  return step;
}

/// Steps between two evaluations of the critical step. The interval is short for soil that stiffens as its weight is
/// applied, whose critical step would otherwise fall below the step in use.
template <int D>
int find_step_interval(const mpm::Body<D>& body) {
  constexpr int changing = 4;
  static_assert(look_interval % changing == 0, "a checkpoint, which is made at a look, has the step that follows it");
  const bool follows = std::any_of(body.laws.begin(), body.laws.end(), [](const material::Law& law) {
    return material::get_traits(law).changes_stiffness;
  });
  return follows ? changing : look_interval;
}

/// Place and velocity of an unstable motion.
template <int D>
struct Runaway {
  Vec<D> place{};    ///< [m]
  double speed = 0;  ///< [m/s]
  std::string what;  ///< "the grid", "a point that left the grid"
};

/// Returns a motion above `limit` [m/s]: of a node in the last monitored step, or of a point that left the grid since
/// `lost_before`.
template <int D>
std::optional<Runaway<D>> find_runaway(const mpm::Body<D>& body, bool monitored, std::size_t lost_before,
                                       double limit) {
  for (std::size_t i = lost_before; i < body.lost.size(); ++i) {
    const auto& l = body.lost[i];
    const double speed = norm(l.momentum) / l.mass;
    if (!(speed <= limit)) return Runaway<D>{l.position, speed, "a point that left the grid"};
  }
  if (!monitored || body.monitor.speed <= limit) return std::nullopt;
  Runaway<D> r{{}, body.monitor.speed, "the grid"};
  if (body.monitor.fastest_node >= 0) r.place = body.mesh().nodes[body.monitor.fastest_node];
  return r;
}

/// Describes soil in element `e`, or beside it, that has lost most of its density.
template <int D>
Runaway<D> find_swollen(const mpm::Body<D>& body, int e) {
  std::array<double, D> centre;
  centre.fill(1.0 / (D + 1));
  return {mesh::to_global(body.mesh(), e, centre), body.monitor.speed, "soil that has swollen beyond bounds"};
}

/// Throws Error (unstable) if a UMAT failed in the last step. `save` stores the last good state and returns its place.
template <int D>
void watch_external_models(const mpm::Body<D>& body, const StagePlan<D>& plan,
                           const std::function<std::string()>& save) {
  for (const material::Law& law : body.laws) {
    const auto failure = material::take_failure(law);
    if (!failure) continue;
    std::string place;
    if (failure->point >= 0 && mpm::is_present(body, failure->point))
      place = " at " + format_place(mpm::view_point(body, failure->point).position, plan.units.length);
    const std::string saved = save();
    throw Error(ExitCode::unstable,
                fmt::format("stage '{}', step {}: {}{}", plan.name, body.step_count, failure->describe(place),
                            saved.empty() ? "" : "; the last good state is in " + saved));
  }
}

/// "the grid at (1, 2) m, in material 'sand', has 900 m/s, while compression waves run at 200 m/s".
template <int D>
std::string describe(const Runaway<D>& r, const mpm::Body<D>& last_good, double wave_speed, const ShownUnits& units) {
  const std::string speed = std::isfinite(r.speed) ? format_value(r.speed, units.speed(), 3) : "no finite speed";
  return fmt::format("{} at {}, in material '{}', has {}, while compression waves run at {}", r.what,
                     format_place(r.place, units.length), find_nearest_material<D>(last_good, r.place), speed,
                     format_value(wave_speed, units.speed(), 3));
}

template <int D>
[[noreturn]] void throw_unstable(const mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state,
                                 const std::string& reason, const std::string& saved) {
  const std::string again =
      state.setbacks.empty()
          ? fmt::format("try a smaller courant number (now {:g})", plan.step.courant)
          : fmt::format(
                "it was calculated again {} times, at last with courant = {:g} and smoothing = \"{}\"; look at "
                "the soil at that place",
                state.setbacks.size(), plan.step.courant, input::get_word(plan.step.smoothing));
  throw Error(ExitCode::unstable,
              fmt::format("the calculation became unstable in stage '{}' at t = {:.4g} s (step {}): {}; {}{}",
                          plan.name, body.time, body.step_count, reason, again,
                          saved.empty() ? "" : "; the last good state is in " + saved));
}

}  // namespace

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
  o.darcy = step.water == input::WaterMotion::seeps;
  o.implicit_drag = step.drag == input::Drag::implicit_at_nodes;
  o.water_damping = step.water_damping;
  o.net_damping = step.damped_force == input::DampedForce::net;
  o.smooth_pressure = step.pressure_smoothing;
  o.exchange_water = step.water_exchange;
  o.conductivity_factor = step.conductivity_factor;
  return o;
}

namespace {

template <int D>
bool equalises_mass(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  return plan.equalises_mass && plan.step.geometry == input::Geometry::frozen && !body.water.is_wet();
}

}  // namespace

template <int D>
mpm::CriticalStep find_critical_step(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  if (body.water.is_wet() && plan.step.water == input::WaterMotion::held) return find_drained_critical_step(body, plan);
  if (equalises_mass(body, plan)) return mpm::find_critical_step(make_even_body(body, plan, {}), make_options(plan));
  return mpm::find_critical_step(body, make_options(plan));
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

template <int D>
bool is_calm(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  const mpm::Monitor& m = body.monitor;
  const double reference_speed = std::sqrt(norm(plan.gravity) * plan.soil_height);
  const bool slow = m.kinetic_energy <= plan.rest.energy_ratio * std::abs(body.work.external) ||
                    plan.step.geometry == input::Geometry::frozen;
  return m.out_of_balance < plan.rest.force_ratio * m.external && m.speed < plan.rest.speed_ratio * reference_speed &&
         slow;
}

template <int D>
StagePlan<D> make_plan(const input::Case& data, const input::Stage& stage, double soil_height, int threads) {
  StagePlan<D> plan;
  plan.name = stage.name;
  plan.cohesion = stage.cohesion;
  plan.strength_factor = stage.strength_factor.value_or(1);
  plan.duration = stage.duration;
  plan.until_rest = stage.until == input::Until::rest;
  plan.step = stage.step;
  plan.rest = data.rest;
  plan.gravity = find_acceleration<D>(data);
  plan.gravity_ramp = stage.gravity_ramp;
  plan.soil_height = soil_height;
  plan.threads = threads;
  plan.units = data.units();
  return plan;
}

namespace {

/// Returns true if the soil has been at rest for the time that the plan requires, by the last monitored step.
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

/// Performs the tasks of every look_interval steps. Returns true if a point has moved farther than the plan allows.
template <int D>
bool look(Stepper<D>& stepper, mpm::Body<D>& body, const StageState& state, const StagePlan<D>& plan,
          const StageHooks<D>& hooks) {
  if (hooks.look && (!hooks.look_is_due || hooks.look_is_due())) hooks.look(stepper.copy_back(), state);
  const bool tells = hooks.report && hooks.report_is_due();
  if (!tells && plan.failed_displacement <= 0) return false;
  const double moved = find_largest(body, stepper.find_largest_displacement());
  if (tells) hooks.report(body, state, moved);
  return plan.failed_displacement > 0 && moved > plan.failed_displacement;
}

}  // namespace

template <int D>
results::StageEnd run_stage(mpm::Body<D>& body, const StagePlan<D>& wanted, StageState& state,
                            const StageHooks<D>& hooks) {
  if (body.water.is_wet() && wanted.step.water == input::WaterMotion::held)
    return run_drained_stage(body, wanted, state, hooks);
  if (equalises_mass(body, wanted)) {
    mpm::Body<D> even = make_even_body(body, wanted, state);
    StagePlan<D> plan = wanted;
    plan.equalises_mass = false;
    return run_stand_in(even, body, plan, state, hooks);
  }
  if (get_ranks().size() > 1 && !body.partition) return run_on_ranks(body, wanted, state, hooks);
  StagePlan<D> plan = calm_down(wanted, state.setbacks.size(), body.water.is_wet());
  mpm::StepOptions<D> options = make_options(plan);
  if (!state.started) {
    state.started = true;
    state.start_time = body.time;
    state.next_output = body.time;
    mpm::gather_nodal_sums(body, options);
  }
  const double end = state.start_time + plan.duration;
  mpm::CriticalStep critical = find_critical_step(body, plan);
  Stepper<D> stepper(body, plan);
  GoodStates<D> good(wanted, hooks);
  // The wave speed is that of the start: later densities may be those of an explosion.
  if (state.wave_speed == 0) state.wave_speed = find_wave_speed(body, plan);
  const double smallest_step = find_smallest_step(body, state.wave_speed, plan);
  good.keep(body, state);
  const auto save_last_good = [&]() -> std::string {
    return hooks.save_last_good ? hooks.save_last_good(good.good_body(), good.good_state()) : "";
  };
  // Retries from a good state with a smaller step, or throws Error (unstable).
  const auto recover = [&](const Runaway<D>& runaway) {
    const std::string reason = describe<D>(runaway, good.good_body(), state.wave_speed, plan.units);
    if (!good.go_back(body, state, reason)) throw_unstable(body, plan, state, reason, save_last_good());
    plan = calm_down(wanted, state.setbacks.size(), body.water.is_wet());
    options = make_options(plan);
    mpm::gather_nodal_sums(body, options);  // smoothing may have changed
    stepper.note_change();
  };
  const int step_interval = find_step_interval(body);

  for (;;) {
    if (state.steps % step_interval == 0) {
      critical = stepper.find_critical_step(plan, options);
      if (critical.element < 0) return stepper.end(results::StageEnd::time);  // no material point is left on the grid
      state.dt = plan.step.courant * critical.dt;
      if (!(critical.dt >= smallest_step)) {
        recover(find_swollen<D>(body, critical.element));
        continue;
      }
    }
    if (state.steps % look_interval == 0) {
      if (hooks.rebalance) hooks.rebalance(body);
      if (state.steps % (look_interval * looks_per_copy) == 0) good.keep(stepper.copy_back(), state);
      if (look(stepper, body, state, plan, hooks)) return stepper.end(results::StageEnd::failed);
    }
    if (hooks.output && body.time >= state.next_output) hooks.output(stepper, state);
    const double left = end - body.time;
    if (left <= 1e-12 * plan.duration) return stepper.end(results::StageEnd::time);
    options.dt = std::min(state.dt, left);
    options.gravity = find_stage_gravity(plan, state, body.time);
    options.monitor = state.steps % monitor_interval == 0;
    const std::size_t lost_before = body.lost.size();
    stepper.step(options);
    ++state.steps;
    // Null modes are filtered at the end of a step and before the look, so that a checkpoint contains the result. A
    // wave crosses about as many elements as there are steps between two looks.
    if (plan.step.filter_null_modes && options.moving && state.steps % look_interval == 0)
      stepper.filter_null_modes(options);
    watch_external_models(body, plan, save_last_good);
    if (const auto runaway =
            find_runaway(body, options.monitor, lost_before, unstable_speed_ratio * state.wave_speed)) {
      recover(*runaway);
      continue;
    }
    if (!options.monitor) continue;
    state.largest_speed = std::max(state.largest_speed, body.monitor.speed);
    if (plan.until_rest && has_rested(body, plan, state)) return stepper.end(results::StageEnd::rest);
  }
}

#define TALUS_INSTANTIATE(D)                                                                  \
  template mpm::StepOptions<D> make_options<D>(const StagePlan<D>&);                          \
  template mpm::CriticalStep find_critical_step<D>(const mpm::Body<D>&, const StagePlan<D>&); \
  template Vec<D> find_stage_gravity<D>(const StagePlan<D>&, const StageState&, double);      \
  template bool is_calm<D>(const mpm::Body<D>&, const StagePlan<D>&);                         \
  template StagePlan<D> make_plan<D>(const input::Case&, const input::Stage&, double, int);   \
  template results::StageEnd run_stage<D>(mpm::Body<D>&, const StagePlan<D>&, StageState&, const StageHooks<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
