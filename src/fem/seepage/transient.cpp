// SPDX-License-Identifier: MIT
// Transient seepage by implicit Euler with error-controlled steps.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "fem/seepage/newton.hpp"
#include "fem/seepage/seepage.hpp"

namespace talus::fem {

namespace {

/// Limit of the solutions of a step for its run-on; then a smaller step is tried.
constexpr int most_routes = 60;

/// Returns the times at which a step must end: outputs, and corners of the tables of boundaries and sinks.
template <int D>
std::vector<double> find_stops(const SeepageModel<D>& model, const SeepageSchedule& schedule) {
  std::vector<double> stops = schedule.outputs;
  for (const auto& b : model.boundaries) {
    for (const auto& pair : b.history) stops.push_back(pair[0]);
  }
  for (const RootSink& sink : model.sinks) stops.insert(stops.end(), sink.rate.time.begin(), sink.rate.time.end());
  const double end = schedule.outputs.back();
  std::erase_if(stops, [&](double t) { return t <= schedule.start || t > end; });
  std::sort(stops.begin(), stops.end());
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  return stops;
}

template <int D>
bool is_corner(const SeepageModel<D>& model, double time) {
  const bool of_sink = std::any_of(model.sinks.begin(), model.sinks.end(), [&](const RootSink& sink) {
    return std::find(sink.rate.time.begin(), sink.rate.time.end(), time) != sink.rate.time.end();
  });
  return of_sink || std::any_of(model.boundaries.begin(), model.boundaries.end(), [&](const auto& b) {
           return std::any_of(b.history.begin(), b.history.end(), [&](const auto& pair) { return pair[0] == time; });
         });
}

void check_schedule(const SeepageSchedule& s) {
  const bool increases = std::is_sorted(s.outputs.begin(), s.outputs.end(), std::less_equal<>());
  if (s.outputs.empty() || !(s.outputs.front() > s.start) || !increases)
    fail_input("Seepage in time needs output times that increase from the start on.");
  if (!(s.head_tolerance > 0)) fail_input("The head tolerance of seepage in time must be above 0.");
}

void add_volumes(std::vector<Discharge>& volumes, const std::vector<Discharge>& rates, double dt) {
  for (std::size_t b = 0; b < rates.size(); ++b) {
    volumes[b].name = rates[b].name;
    volumes[b].inflow += rates[b].inflow * dt;
    volumes[b].outflow += rates[b].outflow * dt;
    volumes[b].runoff += rates[b].runoff * dt;
    volumes[b].standing += rates[b].standing * dt;
  }
}

void add_uptakes(std::vector<Uptake>& volumes, const std::vector<Uptake>& rates, double dt) {
  volumes.resize(rates.size());
  for (std::size_t q = 0; q < rates.size(); ++q) {
    volumes[q].name = rates[q].name;
    volumes[q].potential += rates[q].potential * dt;
    volumes[q].actual += rates[q].actual * dt;
  }
}

/// Returns the largest difference of the heads from their linear extrapolation, by the rates of the last step of `last`
/// seconds [m].
double find_error(const SeepageState& after, const SeepageState& before, const std::vector<double>& rate, double step,
                  double last) {
  double error = 0;
  for (std::size_t u = 0; u < rate.size(); ++u)
    error = std::max(error, std::abs(after.head[u] - before.head[u] - rate[u] * step) * step / (step + last));
  return error;
}

/// Solves one step and iterates on the run-on: water that reaches a node may saturate it and run on from there.
template <int D>
bool solve_step(SeepageNewton<D>& newton, Runoff<D>& runoff, const StepInput& input,
                std::vector<NodeCondition>& conditions, SeepageState& trial) {
  if (!runoff.is_used()) return newton.solve(trial, conditions, input);
  const std::vector<NodeCondition> rain = std::move(conditions);
  for (int i = 0; i < most_routes; ++i) {
    conditions = rain;
    runoff.offer(input.dt, conditions);
    if (!newton.solve(trial, conditions, input)) return false;
    if (runoff.route(input.dt, conditions, trial, newton.sums())) return true;
  }
  return false;
}

/// Changes of the weight of pools. Under one-dimensional compression the pore volume of saturated soil decreases by m_v
/// times the increase of the weight, and as much water is expelled. Soil that is unsaturated at the start of a step is
/// not affected.
template <int D>
class PoolLoading {
 public:
  PoolLoading(const SeepageSystem<D>& system, double start) : system_(system) {
    if (system.model.pool_weight) weight_ = system.model.pool_weight(start);
  }

  /// Returns the contents [m³] of the stores at the heads before the step under the weight at its end; `contents` are
  /// those under the weight at its start.
  std::vector<double> load(std::vector<double> contents, const SeepageState& before, double time) {
    if (weight_.empty()) return contents;
    next_ = system_.model.pool_weight(time);
    given_ = 0;
    for (std::size_t k = 0; k < contents.size(); ++k) {
      const auto& store = system_.stores[k];
      const auto u = static_cast<std::size_t>(store.unknown);
      if (system_.suction(u, before.head[u]) > 0) continue;
      const auto node = static_cast<std::size_t>(system_.node_of_unknown[u]);
      const double given = store.volume *
                           system_.model.soils[static_cast<std::size_t>(store.soil)].skeleton_compressibility *
                           (next_[node] - weight_[node]);
      contents[k] += given;
      given_ += given;
    }
    return contents;
  }
  void end_step() {
    if (weight_.empty()) return;
    std::swap(weight_, next_);
    all_given_ += given_;
  }
  /// Water expelled from the pores since the start [m³].
  double given() const { return all_given_; }

 private:
  const SeepageSystem<D>& system_;
  std::vector<double> weight_, next_;
  double given_ = 0, all_given_ = 0;
};

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

template <int D>
void keep_output(const SeepageNewton<D>& newton, SeepageResult<D> result, const std::vector<Discharge>& volumes,
                 const std::vector<Uptake>& drawn, const SeepageOutput<D>& on_output, SeepageHistory<D>& history) {
  result.iterations = newton.solves();
  result.undecided = newton.undecided();
  history.states.push_back(std::move(result));
  history.volumes.push_back(volumes);
  history.uptakes.push_back(drawn);
  if (on_output) on_output(history.states.back());
}

}  // namespace

template <int D>
SeepageHistory<D> solve_transient_seepage(const SeepageModel<D>& model, const std::vector<double>& initial,
                                          const SeepageSchedule& schedule, const SeepageOptions& options,
                                          const SeepageOutput<D>& on_output) {
  const SeepageSystem<D> system(model);
  check_storage(model);
  check_schedule(schedule);
  SeepageNewton<D> newton(system, options);
  Runoff<D> runoff(system);
  PoolLoading<D> pools(system, schedule.start);
  const double whole = schedule.outputs.back() - schedule.start;
  const double smallest = schedule.smallest_step > 0 ? schedule.smallest_step : 1e-9 * whole;
  const double first_step =
      schedule.first_step > 0 ? schedule.first_step : 1e-3 * (schedule.outputs.front() - schedule.start);
  double dt = first_step;
  const auto stops = find_stops(model, schedule);
  SeepageState state{to_unknowns(system, initial), std::vector<FaceState>(system.elevation.size(), FaceState::none)};
  std::vector<double> contents = system.find_contents(state.head), rate;  // rate of the heads in the last step [m/s]
  const double stored_at_start = sum(contents);
  std::vector<Discharge> volumes(model.boundaries.size());
  std::vector<Uptake> drawn;
  SeepageHistory<D> history;
  double time = schedule.start, last_dt = 0;
  std::size_t stop = 0, output = 0;
  while (stop < stops.size()) {
    dt = std::min(dt, schedule.largest_step);
    const double left = stops[stop] - time;
    const bool lands = dt >= left * (1 - 1e-9);
    const double step = lands ? left : dt > 0.5 * left ? 0.5 * left : dt;
    const double then = lands ? stops[stop] : time + step;
    // A table that jumps at a stop has its old value up to there.
    const double at = lands ? then - 1e-9 * step : then;
    const std::vector<double> loaded = pools.load(contents, state, at);
    StepInput input;
    input.dt = step;
    input.old_contents = &loaded;
    auto conditions = system.find_conditions(at);
    input.sink_rates = find_sink_rates(model, at);
    SeepageState trial = state;
    const bool solved = solve_step(newton, runoff, input, conditions, trial);
    const double error = solved ? find_error(trial, state, rate, step, last_dt) : 0;
    if (!solved || (error > 2 * schedule.head_tolerance && step > 4 * smallest)) {
      ++history.rejected;
      dt = step * (solved ? std::clamp(0.9 * std::sqrt(schedule.head_tolerance / error), 0.2, 0.7) : 0.25);
      // A node of the border that a rising level reaches jumps to it in a step of any length.
      if (solved) dt = std::max(dt, smallest);
      if (dt < smallest)
        throw Error(ExitCode::unstable, "Seepage did not converge at {:.6g} s, not even with a step of {:.3g} s.", time,
                    dt);
      continue;
    }
    const auto new_contents = system.find_contents(trial.head);
    rate.resize(trial.head.size());
    for (std::size_t u = 0; u < rate.size(); ++u) rate[u] = (trial.head[u] - state.head[u]) / step;
    auto result = make_flow_result(system, trial, newton.sums(), conditions, at, input);
    result.time = then;
    runoff.end_step(step, conditions, result);
    pools.end_step();
    add_volumes(volumes, result.discharges, step);
    add_uptakes(drawn, result.uptakes, step);
    state = std::move(trial);
    contents = new_contents;
    last_dt = step;
    time = then;
    ++history.steps;
    history.largest_error = std::max(history.largest_error, error);
    if (schedule.report) schedule.report(time);
    const double growth = error > 0 ? std::clamp(0.9 * std::sqrt(schedule.head_tolerance / error), 0.3, 2.0) : 1.5;
    dt = lands ? std::max(dt, step * growth) : step * growth;
    if (!lands) continue;
    if (output < schedule.outputs.size() && stops[stop] == schedule.outputs[output]) {
      add_fields(system, state, input, result);
      keep_output(newton, std::move(result), volumes, drawn, on_output, history);
      history.stored.push_back(sum(contents) - stored_at_start - pools.given());
      ++output;
    }
    if (is_corner(model, then)) {  // the rates before a corner of a table are no basis for a prediction
      rate.clear();
      dt = std::min(dt, first_step);
    }
    ++stop;
  }
  history.iterations = newton.solves();
  return history;
}

template <int D>
double find_stored_water(const SeepageModel<D>& model, const std::vector<double>& head) {
  const SeepageSystem<D> system(model);
  return sum(system.find_contents(to_unknowns(system, head)));
}

#define TALUS_INSTANTIATE(D)                                                                                \
  template SeepageHistory<D> solve_transient_seepage<D>(const SeepageModel<D>&, const std::vector<double>&, \
                                                        const SeepageSchedule&, const SeepageOptions&,      \
                                                        const SeepageOutput<D>&);                           \
  template double find_stored_water<D>(const SeepageModel<D>&, const std::vector<double>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::fem
