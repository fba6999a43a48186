// SPDX-License-Identifier: MIT
// One stage in time: the two-part implicit Runge–Kutta method of Alexander (1977), with an estimate of the error of
// each step (T26.4 to T26.6).

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "fem/consolidation/coupled_newton.hpp"
#include "fem/seepage/newton.hpp"
#include "fem/solid/creep.hpp"

namespace talus::fem {
namespace {

/// γ of the method: L-stable and of second order.
constexpr double part = 0.29289321881345247560;
/// Error of a step over Δt³ p''' (T26.6), |3γ² − 2γ³ − 1/6|.
constexpr double error_constant = 0.040440114519881;
constexpr double safety = 0.9, least_growth = 0.3, most_growth = 3, kept_below = 1.25;
/// Length of the step that takes up jumps of heads and loads, over the duration of the stage. It has no estimate.
constexpr double jump_step = 1e-7;
/// Smallest scale of the error, over the height of the soil and over the head that bears the change of the stage: water
/// at rest has no error, and the first moments of a load matter little.
constexpr double least_height_share = 1e-6, least_load_share = 0.02;
constexpr int even_steps = 10;     ///< of a stage without flow
constexpr int few_iterations = 6;  ///< of a step, after which the next one of such a stage is longer

using creep::find_norm;

template <int D>
class StageRun {
 public:
  StageRun(const ConsolidationModel<D>& model, const ConsolidationState<D>& start,
           const ConsolidationSchedule& schedule, const StepReport<D>& report)
      : model_(model), schedule_(schedule), report_(report), system_(model, schedule.threads) {
    now_.solid = start.solid;
    has_supports_ = !model.solid->bars.empty() || !model.solid->walls.empty();
    first_displacement_ = start.solid.displacement;
    now_.head = to_unknowns(system_.flow(), start.head);
    first_head_ = now_.head;
    face_.assign(now_.head.size(), FaceState::none);
    fixed_.assign(now_.head.size(), 0);
    find_imbalance();
    newton_.emplace(system_, schedule_, force_scale_);
    if (model.drainage == StageDrainage::drained) steady_ = to_unknowns(system_.flow(), model.steady_head);
    floor_ = find_least_scale();
    for (const auto& store : system_.flow().stores) {
      volume_.resize(now_.head.size(), 0);
      volume_[static_cast<std::size_t>(store.unknown)] += store.volume;
    }
  }

  ConsolidationResult<D> run() {
    result_.unknowns = system_.unknowns();
    result_.converged = schedule_.duration > 0 ? march() : act_at_once();
    if (result_.outputs.empty() || result_.outputs.back().time < time()) keep();
    result_.factorisations = system_.factorisations();
    return std::move(result_);
  }

 private:
  double time() const { return schedule_.start + past_; }
  double share(double past) const { return schedule_.duration > 0 ? std::min(1.0, past / schedule_.duration) : past; }

  /// Computes the out-of-balance force at the start, which the stage removes.
  void find_imbalance() {
    CoupledTarget target;
    target.force = system_.solid().load;
    target.supply.assign(now_.head.size(), 0);
    target.fixed.assign(now_.head.size(), 0);
    CoupledPlace<D> place = now_;
    system_.evaluate(now_, std::vector<double>(target.force.size(), 0), target, false, place);
    imbalance_ = place.force;
    force_scale_ = std::max({find_norm(target.force), find_norm(imbalance_), system_.find_pore_force(now_.head)});
    result_.start_imbalance = force_scale_ > 0 ? find_norm(imbalance_) / force_scale_ : 0;
    if (!(force_scale_ > 0)) force_scale_ = 1;  // heads alone will load the soil
  }

  /// Returns the smallest scale of the error [m].
  double find_least_scale() {
    const auto& level = system_.flow().elevation;
    if (level.empty()) return 0;
    const auto [low, high] = std::minmax_element(level.begin(), level.end());
    std::vector<double> raised = level;
    for (double& h : raised) h += 1;
    const double force = system_.find_pore_force(raised);  // of an even head of 1 m
    return std::max(least_height_share * (*high - *low),
                    force > 0 ? least_load_share * find_norm(imbalance_) / force : 0);
  }

  CoupledConditions make_conditions(double past, double at, double dt) {
    CoupledConditions c;
    c.force = system_.solid().load;
    const double left = 1 - share(past);
    for (std::size_t i = 0; i < c.force.size(); ++i) c.force[i] -= left * imbalance_[i];
    c.flow.resize(now_.head.size());
    if (model_.drainage == StageDrainage::drained)
      for (std::size_t u = 0; u < c.flow.size(); ++u) {
        c.flow[u].fixed = true;
        c.flow[u].head = first_head_[u] + share(past) * (steady_[u] - first_head_[u]);
      }
    if (model_.drainage != StageDrainage::consolidating || schedule_.duration == 0) return c;
    c.flow = system_.flow().find_conditions(at);
    for (std::size_t u = 0; u < c.flow.size(); ++u) fixed_[u] = c.flow[u].fixed;
    c.sink_rates = find_sink_rates(*model_.flow, at);
    c.dt = dt;
    return c;
  }

  /// Applies the change without flow, in load steps.
  bool act_at_once() {
    double length = 1.0 / std::max(1, schedule_.load_steps);
    int halvings = 0;
    while (reached_ < 1) {
      const double next = std::min(1.0, reached_ + length);
      const CoupledConditions conditions = make_conditions(next > 1 - 1e-12 ? 1 : next, 0, 0);
      std::vector<double> q(conditions.force.size(), 0);
      CoupledPlace<D> place = now_;
      auto face = face_;
      const CoupledOutcome out = newton_->solve(now_, conditions, face, q, place);
      if (!out.converged || has_gone(place)) {
        ++result_.rejected;
        if (++halvings > schedule_.most_halvings) return false;
        length /= 2;
        continue;
      }
      reached_ = next > 1 - 1e-12 ? 1 : next;
      accept(std::move(place), out, 0, 0);
    }
    return true;
  }

  bool march() {
    const std::vector<double> stops = list_stops();
    const double first = schedule_.first_step > 0 ? schedule_.first_step : 1e-3 * schedule_.duration;
    const double jump = std::min(first, jump_step * schedule_.duration);
    const bool flows = model_.drainage == StageDrainage::consolidating;
    double length = flows ? jump : schedule_.duration / even_steps;
    jumps_ = flows;
    int failures = 0;
    std::size_t stop = 0;
    while (stop < stops.size()) {
      length = std::min(length, schedule_.largest_step);
      const double left = stops[stop] - past_;
      const bool lands = length >= left * (1 - 1e-9);
      const double step = lands ? left : length > 0.5 * left ? 0.5 * left : length;
      const Tried tried = attempt(step, lands ? stops[stop] : past_ + step);
      const bool is_rough =
          !jumps_ && tried.converged && tried.error > 2 * schedule_.tolerance && step > 1e-7 * schedule_.duration;
      if (!tried.converged || is_rough) {
        ++result_.rejected;
        if (!tried.converged && ++failures > schedule_.most_halvings) return false;
        length = step * (tried.converged ? std::clamp(find_growth(tried.error), 0.2, 0.7) : 0.5);
        continue;
      }
      failures = 0;
      past_ = lands ? stops[stop] : past_ + step;
      reached_ = share(past_);
      take(tried, step);
      if (flows) {
        // Elastic soil keeps the factors of its matrix with the length of the step.
        const double growth = std::clamp(find_growth(tried.error), least_growth, most_growth);
        const double wished = jumps_ ? first : step * (growth > 1 && growth < kept_below ? 1 : growth);
        length = lands ? std::max(length, wished) : wished;
        jumps_ = false;
      } else if (has_supports_ && tried.out.iterations <= few_iterations) {
        // Interfaces of walls open and slip in a few short steps, after which long ones serve.
        length = std::min(std::max(length, 2 * step), schedule_.duration / even_steps);
      }
      if (!lands) continue;
      if (is_output(stops[stop])) keep();
      if (is_corner(time())) {
        rate_.clear();
        jumps_ = flows;
        length = flows ? jump : length;
      }
      ++stop;
    }
    return true;
  }

  struct Tried {
    bool converged = false;
    double error = 0;  ///< over the scale [-]
    CoupledOutcome out;
    CoupledPlace<D> place;
    std::vector<FaceState> face;
    std::vector<double> rate;  ///< of the heads at the end [m/s]
  };

  /// Computes a step of both parts.
  Tried attempt(double step, double end) {
    Tried tried;
    const double dt = part * step, middle = past_ + dt;
    const bool flows = model_.drainage == StageDrainage::consolidating;
    tried.face = face_;
    CoupledPlace<D> halfway = now_;
    std::vector<double> q(system_.solid().load.size(), 0);
    if (flows) predict(dt, halfway.head);
    const double before = end - 1e-9 * step;  // a table that jumps at the end has its old value up to there
    if (flows) {
      tried.out = newton_->solve(now_, make_conditions(middle, schedule_.start + middle, dt), tried.face, q, halfway);
      if (!tried.out.converged) return tried;
    }
    CoupledConditions last = make_conditions(end, schedule_.start + before, flows ? dt : 0);
    if (flows) {
      last.entered = halfway.inflow;
      for (double& w : last.entered) w *= (1 - part) * step;
    }
    tried.place = halfway;
    const CoupledOutcome out = newton_->solve(now_, last, tried.face, q, tried.place);
    tried.out = {out.converged, tried.out.iterations + out.iterations, out.residual};
    tried.converged = out.converged && !has_gone(tried.place);
    if (tried.converged && flows) find_error(step, halfway.head, tried);
    return tried;
  }

  /// Returns true if a node has moved too far in this stage.
  bool has_gone(const CoupledPlace<D>& place) const {
    if (!std::isfinite(schedule_.most_displacement)) return false;
    for (std::size_t n = 0; n < first_displacement_.size(); ++n) {
      double square = 0;
      for (std::size_t d = 0; d < D; ++d) {
        const double moved = place.solid.displacement[n][d] - first_displacement_[n][d];
        square += moved * moved;
      }
      if (square > schedule_.most_displacement * schedule_.most_displacement) return true;
    }
    return false;
  }

  void predict(double dt, std::vector<double>& head) const {
    for (std::size_t u = 0; u < rate_.size(); ++u) head[u] += dt * rate_[u];
  }

  /// Estimates the error of a step, without nodes whose head is given or whose face changes, from the rates at its
  /// parts and at its start; without the latter, as that of a method of first order, which is larger.
  void find_error(double step, const std::vector<double>& halfway, Tried& tried) const {
    const std::size_t n = now_.head.size();
    tried.rate.resize(n);
    double sum = 0, volume = 0, scale = std::max(scale_, floor_);
    for (std::size_t u = 0; u < n; ++u) {
      const double one = (halfway[u] - now_.head[u]) / (part * step);
      const double two = (tried.place.head[u] - now_.head[u] - (1 - part) * step * one) / (part * step);
      double error = (1 - part) * step * (two - one);
      if (!rate_.empty()) error = 2 * error_constant * step * ((two - one) / (1 - part) - (one - rate_[u]) / part);
      tried.rate[u] = two;
      volume += volume_[u];
      if (fixed_[u] != 0 || tried.face[u] != face_[u]) error = 0;
      sum += volume_[u] * error * error;
      scale = std::max(scale, std::abs(tried.place.head[u] - first_head_[u]));
    }
    tried.error = volume > 0 && scale > 0 ? std::sqrt(sum / volume) / scale : 0;
  }

  double find_growth(double error) const {
    return error > 0 ? safety * std::cbrt(schedule_.tolerance / error) : most_growth;
  }

  void take(const Tried& tried, double step) {
    rate_ = tried.rate;
    if (jumps_) rate_.clear();
    face_ = tried.face;
    for (std::size_t u = 0; u < tried.place.head.size(); ++u)
      scale_ = std::max(scale_, std::abs(tried.place.head[u] - first_head_[u]));
    accept(tried.place, tried.out, step, jumps_ ? 0 : tried.error);
  }

  void accept(CoupledPlace<D> place, const CoupledOutcome& out, double step, double error) {
    now_ = std::move(place);
    result_.reached = reached_;
    result_.steps.push_back({time(), step, error, out.residual, out.iterations, now_.sums.yielding});
    if (report_) report_(result_.steps.back(), now_.solid, to_nodes(system_.flow(), now_.head));
  }

  void keep() { result_.outputs.push_back({time(), {now_.solid, to_nodes(system_.flow(), now_.head)}}); }

  /// Times that differ by rounding are one.
  bool is_same_time(double a, double b) const { return std::abs(a - b) <= 1e-9 * schedule_.duration; }
  bool is_output(double past) const {
    return std::any_of(schedule_.outputs.begin(), schedule_.outputs.end(),
                       [&](double t) { return is_same_time(t - schedule_.start, past); });
  }
  bool is_corner(double at) const {
    return std::any_of(model_.flow->boundaries.begin(), model_.flow->boundaries.end(), [&](const auto& b) {
      return std::any_of(b.history.begin(), b.history.end(),
                         [&](const auto& pair) { return is_same_time(pair[0], at); });
    });
  }

  /// Times since the start of the stage at which a step must end.
  std::vector<double> list_stops() const {
    std::vector<double> stops{schedule_.duration};
    for (const double t : schedule_.outputs) stops.push_back(t - schedule_.start);
    if (model_.drainage == StageDrainage::consolidating)
      for (const auto& b : model_.flow->boundaries)
        for (const auto& pair : b.history) stops.push_back(pair[0] - schedule_.start);
    std::erase_if(stops, [&](double t) {
      return is_same_time(t, 0) || t < 0 || (t > schedule_.duration && !is_same_time(t, schedule_.duration));
    });
    std::sort(stops.begin(), stops.end());
    stops.back() = schedule_.duration;
    stops.erase(std::unique(stops.begin(), stops.end(), [&](double a, double b) { return is_same_time(a, b); }),
                stops.end());
    return stops;
  }

  const ConsolidationModel<D>& model_;
  const ConsolidationSchedule& schedule_;
  const StepReport<D>& report_;
  CoupledSystem<D> system_;
  std::optional<CoupledNewton<D>> newton_;
  CoupledPlace<D> now_;
  std::vector<FaceState> face_;
  std::vector<Vec<D>> first_displacement_;   ///< at the start [m]
  std::vector<double> imbalance_;            ///< at the start [N]
  std::vector<double> first_head_, steady_;  ///< at the start, and at the end of a drained stage [m]
  std::vector<double> rate_;                 ///< of the heads at the end of the last step [m/s]; empty: unknown
  std::vector<double> volume_;               ///< of soil per unknown of the flow, weights of the error
  std::vector<char> fixed_;                  ///< heads that are given, at the last conditions
  bool has_supports_ = false;                ///< bars or walls
  bool jumps_ = false;                       ///< the next step takes up a jump
  double force_scale_ = 1, scale_ = 0, floor_ = 0;
  double past_ = 0, reached_ = 0;  ///< since the start [s], and the fraction of the change
  ConsolidationResult<D> result_;
};

void check_schedule(const ConsolidationSchedule& s) {
  if (!(s.duration >= 0))
    fail_input("a stage of consolidation lasts {:g} s: its duration must not be negative", s.duration);
  if (!(s.tolerance > 0)) fail_input("the tolerance of consolidation is {:g}: it must be above 0", s.tolerance);
}

}  // namespace

template <int D>
ConsolidationResult<D> run_stage(const ConsolidationModel<D>& model, const ConsolidationState<D>& start,
                                 const ConsolidationSchedule& schedule, const StepReport<D>& report) {
  check_schedule(schedule);
  return StageRun<D>(model, start, schedule, report).run();
}

template ConsolidationResult<2> run_stage<2>(const ConsolidationModel<2>&, const ConsolidationState<2>&,
                                             const ConsolidationSchedule&, const StepReport<2>&);
template ConsolidationResult<3> run_stage<3>(const ConsolidationModel<3>&, const ConsolidationState<3>&,
                                             const ConsolidationSchedule&, const StepReport<3>&);

}  // namespace talus::fem
