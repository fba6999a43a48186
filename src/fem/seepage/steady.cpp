// SPDX-License-Identifier: MIT
// Steady flow by continuation from saturated flow to the conductivity law of the soil, in as few stages as possible.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "fem/seepage/newton.hpp"

namespace talus::fem {

namespace {

constexpr double first_factor = 4;    ///< growth of the stretch of the suction from stage to stage
constexpr double chord_factor = 1.5;  ///< stages with a smaller factor are tried with secant slopes as well
constexpr double smallest_factor = 1.003;
constexpr double smallest_stretch = 1e-6;  ///< at which any law gives saturated soil

template <int D>
void check_hold(const SeepageModel<D>& model, const std::vector<NodeCondition>& conditions) {
  const bool held =
      std::any_of(conditions.begin(), conditions.end(), [](const NodeCondition& c) { return c.fixed || c.face; });
  const bool drained = std::any_of(model.boundaries.begin(), model.boundaries.end(),
                                   [](const auto& b) { return b.kind == HydraulicKind::free_drainage; });
  if (!held && !drained)
    throw Error(
        ExitCode::wrong_input,
        "Steady seepage needs a head, a pressure or a seepage face somewhere: fluxes alone do not set the pressure.");
}

/// Solves saturated flow first, and then soils with k_r at an increasing fraction of the suction. The capillary fringe
/// becomes lower from stage to stage, and each solution is close to the next.
template <int D>
void solve_in_stages(SeepageNewton<D>& newton, SeepageState& state, const std::vector<NodeCondition>& conditions,
                     StepInput input) {
  input.stretch = 0;
  if (!newton.solve(state, conditions, input))
    throw Error(ExitCode::unstable,
                "Steady seepage was not found even for saturated soil; is a part of the soil cut off from all heads?");
  double reached = 0, next = 1, factor = first_factor;
  while (reached < 1) {
    SeepageState trial = state;
    input.stretch = next;
    bool solved = newton.solve(trial, conditions, input);
    if (!solved && reached > 0 && factor < chord_factor) {
      trial = state;
      solved = newton.solve(trial, conditions, input, Slopes::chord);
    }
    if (solved) {
      state = std::move(trial);
      reached = next;
    } else if (reached == 0 && next > smallest_stretch) {
      next /= factor;
      continue;
    } else {
      factor = std::sqrt(factor);
      if (reached == 0 || factor < smallest_factor)
        throw Error(ExitCode::unstable,
                    "Steady seepage did not converge: the fall of conductivity with suction could be followed for "
                    "{:.3g} of the suctions only; a finer mesh or a flatter law may help.",
                    reached);
    }
    next = std::min(1.0, reached * factor);
  }
}

}  // namespace

template <int D>
SeepageResult<D> solve_steady_seepage(const SeepageModel<D>& model, const SeepageOptions& options,
                                      const std::vector<double>& guess, double time) {
  const SeepageSystem<D> system(model);
  const auto conditions = system.find_conditions(time);
  check_hold(model, conditions);
  SeepageNewton<D> newton(system, options);
  StepInput input;
  input.sink_rates = find_sink_rates(model, time);
  SeepageState state{system.elevation, std::vector<FaceState>(system.elevation.size(), FaceState::none)};
  bool done = false;
  if (!guess.empty()) {
    SeepageState trial{to_unknowns(system, guess), state.face};
    done = newton.solve(trial, conditions, input);
    if (done) state = trial;
  }
  if (!done) solve_in_stages(newton, state, conditions, input);
  input.smallest_conductivity = options.smallest_conductivity;
  auto result = make_flow_result(system, state, newton.sums(), conditions, time, input);
  add_fields(system, state, input, result);
  result.iterations = newton.solves();
  result.undecided = newton.undecided();
  return result;
}

template SeepageResult<2> solve_steady_seepage<2>(const SeepageModel<2>&, const SeepageOptions&,
                                                  const std::vector<double>&, double);
template SeepageResult<3> solve_steady_seepage<3>(const SeepageModel<3>&, const SeepageOptions&,
                                                  const std::vector<double>&, double);

}  // namespace talus::fem
