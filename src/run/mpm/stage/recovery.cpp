// SPDX-License-Identifier: MIT
#include "run/mpm/stage/recovery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "material/every_law.hpp"
#include "mpm/state/partition.hpp"
#include "run/mpm/stage/stage_warnings.hpp"

namespace talus::run {

namespace {

/// Looks between copies of the body from which an unstable run can be repeated.
constexpr int looks_per_copy = 32;
/// A velocity above this multiple of the wave speed is unstable.
constexpr double unstable_speed_ratio = 2;

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

/// Describes soil in element `e`, or beside it, that has lost most of its density.
template <int D>
Runaway<D> find_swollen(const mpm::Body<D>& body, int e) {
  std::array<double, D> centre;
  centre.fill(1.0 / (D + 1));
  return {mesh::to_global(body.mesh(), e, centre), body.monitor.speed, "soil that has swollen beyond bounds"};
}

/// "the grid at (1, 2) m, in material 'sand', has 900 m/s, while compression waves run at 200 m/s".
template <int D>
std::string describe(const Runaway<D>& r, const mpm::Body<D>& last_good, double wave_speed, const ShownUnits& units) {
  const std::string speed = std::isfinite(r.speed) ? format_value(r.speed, units.speed(), 3) : "no finite speed";
  return fmt::format("{} at {}, in material '{}', has {}, while compression waves run at {}", r.what,
                     format_place(r.place, units.length), find_nearest_material<D>(last_good, r.place), speed,
                     format_value(wave_speed, units.speed(), 3));
}

}  // namespace

template <int D>
Recovery<D>::Recovery(SteppedBody<D>& stepped, Stepper<D>& stepper, StageState& state)
    : stepped_(stepped),
      stepper_(stepper),
      body_(stepped.body()),
      state_(state),
      plan_(make_retry_plan(stepped.plan(), state.setbacks.size(), body_.water.is_wet())) {
  // The wave speed is that of the start: later densities may be those of an explosion.
  if (state.wave_speed == 0) state.wave_speed = find_wave_speed(body_, plan_);
  smallest_step_ = find_smallest_step(body_, state.wave_speed, plan_);
  keep();
}

template <int D>
void Recovery<D>::keep_at_look() {
  if (state_.steps % (look_interval * looks_per_copy) != 0) return;
  stepper_.copy_back();
  keep();
}

template <int D>
void Recovery<D>::keep() {
  if (newer_ && newer_->state.steps == state_.steps) return;
  // The newest copy may already contain the beginning of an instability, which is detected only after some steps.
  older_ = newer_;
  newer_ = std::make_shared<const Good>(Good{body_, state_, stepped_.mark()});
  if (!older_) older_ = start_ = newer_;
}

template <int D>
bool Recovery<D>::retry_below_smallest_step(const mpm::CriticalStep& critical) {
  if (critical.dt >= smallest_step_) return false;
  retry(find_swollen<D>(body_, critical.element));
  return true;
}

template <int D>
bool Recovery<D>::retry_above_wave_speed(bool monitored, std::size_t lost_before) {
  check_external_models();
  const auto runaway = find_runaway(monitored, lost_before);
  if (runaway) retry(*runaway);
  return runaway.has_value();
}

template <int D>
std::optional<Runaway<D>> Recovery<D>::find_runaway(bool monitored, std::size_t lost_before) const {
  const double limit = unstable_speed_ratio * state_.wave_speed;
  for (std::size_t i = lost_before; i < body_.lost.size(); ++i) {
    const auto& l = body_.lost[i];
    const double speed = norm(l.momentum) / l.mass;
    if (!(speed <= limit)) return Runaway<D>{l.position, speed, "a point that left the grid"};
  }
  if (!monitored || body_.monitor.speed <= limit) return std::nullopt;
  Runaway<D> r{{}, body_.monitor.speed, "the grid"};
  if (body_.monitor.fastest_node >= 0) r.place = body_.mesh().nodes[body_.monitor.fastest_node];
  return r;
}

template <int D>
void Recovery<D>::retry(const Runaway<D>& runaway) {
  const std::string reason = describe<D>(runaway, older_->body, state_.wave_speed, plan_.units);
  if (state_.setbacks.size() >= most_setbacks) throw_unstable(reason);
  // A copy from which an earlier retry failed as well is not a good state.
  const bool failed_before = !state_.setbacks.empty() && state_.setbacks.back().back_to == older_->body.time;
  const std::shared_ptr<const Good> to = failed_before ? start_ : older_;
  std::vector<results::Retry> retries = std::move(state_.setbacks);
  plan_ = make_retry_plan(stepped_.plan(), retries.size() + 1, to->body.water.is_wet());
  retries.push_back({body_.time, to->body.time, plan_.step.courant, input::get_word(plan_.step.smoothing), reason});
  body_ = to->body;
  state_ = to->state;
  state_.setbacks = std::move(retries);
  if (to->go_back) to->go_back(body_, state_, plan_);
  older_ = newer_ = to;
  mpm::gather_nodal_sums(body_, make_options(plan_));  // smoothing may have changed
  stepper_.note_change();
}

template <int D>
void Recovery<D>::check_external_models() {
  for (const material::Law& law : body_.laws) {
    const auto failure = material::take_failure(law);
    if (!failure) continue;
    std::string place;
    if (failure->point >= 0 && mpm::is_present(body_, failure->point))
      place = " at " + format_place(mpm::view_point(body_, failure->point).position, plan_.units.length);
    const std::string saved = save_last_good();
    throw Error(ExitCode::unstable,
                fmt::format("stage '{}', step {}: {}{}", plan_.name, body_.step_count, failure->describe(place),
                            saved.empty() ? "" : "; the last good state is in " + saved));
  }
}

template <int D>
void Recovery<D>::throw_unstable(const std::string& reason) {
  const std::string saved = save_last_good();
  const std::string again =
      state_.setbacks.empty()
          ? fmt::format("try a smaller courant number (now {:g})", plan_.step.courant)
          : fmt::format(
                "it was calculated again {} times, at last with courant = {:g} and smoothing = \"{}\"; look at "
                "the soil at that place",
                state_.setbacks.size(), plan_.step.courant, input::get_word(plan_.step.smoothing));
  throw Error(ExitCode::unstable,
              fmt::format("the calculation became unstable in stage '{}' at t = {:.4g} s (step {}): {}; {}{}",
                          plan_.name, body_.time, body_.step_count, reason, again,
                          saved.empty() ? "" : "; the last good state is in " + saved));
}

template class Recovery<2>;
template class Recovery<3>;

}  // namespace talus::run
