// SPDX-License-Identifier: MIT
// Newton's method with a non-monotone line search, and the active set of the face nodes.
#include "fem/seepage/newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/progress.hpp"

namespace talus::fem {

// The active set of the face nodes (open, wet or dry), a mixed complementarity problem (T13.4).

namespace {

constexpr int free_switches = 6;   ///< changes of state of a node before it waits for the rest
constexpr int most_switches = 16;  ///< after these a node keeps its state, as neither fits better

}  // namespace

/// Changes the state of face nodes that violate its condition, and sets the head of those that become wet or dry.
template <int D>
bool SeepageNewton<D>::switch_faces(SeepageState& state, bool balanced) {
  undecided_ = 0;
  bool switched = false;
  std::size_t worst = 0;
  double worst_size = 0;
  FaceState worst_state = FaceState::none;
  int wet = 0;
  for (FaceState f : state.face) wet += f == FaceState::wet;
  // Free drainage sets the pressure by the law of k_r, but not in saturated soil.
  const bool drains =
      input_.stretch > 0 && std::any_of(system_.model.boundaries.begin(), system_.model.boundaries.end(),
                                        [](const auto& b) { return b.kind == HydraulicKind::free_drainage; });
  const bool needs_hold =
      input_.dt == 0 && !drains &&
      std::none_of(conditions_->begin(), conditions_->end(), [](const NodeCondition& c) { return c.fixed; });
  const auto change = [&](std::size_t u, FaceState to) {
    if (state.face[u] == FaceState::wet && --wet == 0 && needs_hold) {
      ++wet;
      return;  // a steady state needs the pressure at one node at least
    }
    if (to == FaceState::wet) {
      state.head[u] = system_.elevation[u];
      ++wet;
    } else if (to == FaceState::dry) {
      state.head[u] = system_.elevation[u] - (*conditions_)[u].suction_limit / system_.model.unit_weight;
    }
    state.face[u] = to;
    ++switches_[u];
    switched = true;
  };
  for (std::size_t u = 0; u < state.face.size(); ++u) {
    const NodeCondition& c = (*conditions_)[u];
    if (!c.face || c.fixed) continue;
    const double suction = system_.suction(u, state.head[u]);
    const double excess = sums_.outflow[u] - c.given - c.offered;  // inflow in excess of the offer
    const double pressure_size = weight_[u] / system_.model.unit_weight;
    FaceState to = state.face[u];
    double size = 0;
    if (to == FaceState::wet && excess > limit_) {
      to = FaceState::open, size = excess;
    } else if (to == FaceState::dry && excess < -limit_) {
      to = FaceState::open, size = -excess;
    } else if (to == FaceState::open && suction < 0) {
      to = FaceState::wet, size = -suction * pressure_size;
    } else if (to == FaceState::open && c.offered < 0 && suction > c.suction_limit) {
      to = FaceState::dry, size = (suction - c.suction_limit) * pressure_size;
    }
    if (to == state.face[u]) continue;
    if (switches_[u] >= most_switches) {
      ++undecided_;
      continue;
    }
    if (switches_[u] < free_switches) {
      change(u, to);
    } else if (size > worst_size) {
      worst = u, worst_size = size, worst_state = to;
    }
  }
  if (!switched && balanced && worst_size > 0) change(worst, worst_state);
  return switched;
}

namespace {

constexpr int switches_allowed = 6;  ///< limit of all iterations of a solve, as a multiple of most_iterations
/// Iterations in which the imbalance must halve; otherwise a smaller stage or step is more efficient.
constexpr std::size_t patience = 8;
constexpr double first_chord = 0.02, small_chord = 1e-8;  ///< ranges of the secants, over the height
constexpr std::size_t memory = 5;                         ///< number of earlier merits that a step is compared with
constexpr double shortest_step = 1.0 / 256;
constexpr double small_change = 1e-4;  ///< over the height: Newton's next change would be of the order of its square

}  // namespace

template <int D>
SeepageNewton<D>::SeepageNewton(const SeepageSystem<D>& system, const SeepageOptions& options)
    : system_(system), options_(options), solver_(system.column_start, system.row) {
  const auto [low, high] = std::minmax_element(system.elevation.begin(), system.elevation.end());
  height_ = std::max(*high - *low, 1e-300);
}

template <int D>
bool SeepageNewton<D>::is_held(const SeepageState& state, std::size_t u) const {
  return (*conditions_)[u].fixed || state.face[u] == FaceState::wet || state.face[u] == FaceState::dry;
}

template <int D>
double SeepageNewton<D>::find_residual(const NodalSums& sums, const SeepageState& state, std::size_t u) const {
  const NodeCondition& c = (*conditions_)[u];
  return sums.outflow[u] - c.given - (state.face[u] == FaceState::open ? c.offered : 0);
}

template <int D>
double SeepageNewton<D>::find_merit(const NodalSums& sums, const SeepageState& state) const {
  double merit = 0;
  for (std::size_t u = 0; u < weight_.size(); ++u) {
    if (is_held(state, u)) continue;
    const double r = find_residual(sums, state, u);
    merit += r * r / weight_[u];
  }
  return merit;
}

/// Evaluates the sums at the state, the imbalance, and its limit: a fraction of the water that flows through the border
/// and into stores, but not less than the rounding error of the sums.
template <int D>
void SeepageNewton<D>::evaluate(const SeepageState& state) {
  sums_ = sum_over_elements(system_, state.head, input_, true);
  weight_ = sums_.weight;
  const double largest = *std::max_element(weight_.begin(), weight_.end());
  for (double& w : weight_) w = std::max(w, 1e-14 * largest);
  fault_ = 0;
  double through = std::abs(sums_.storage_rate);
  for (double q : sums_.drained) through += q;
  for (double q : sums_.drawn) through += q;
  for (std::size_t u = 0; u < weight_.size(); ++u) {
    const NodeCondition& c = (*conditions_)[u];
    through += std::abs(c.given) + (state.face[u] == FaceState::open ? std::abs(c.offered) : 0);
    if (is_held(state, u))
      through += std::abs(sums_.outflow[u] - c.given);
    else
      fault_ += std::abs(find_residual(sums_, state, u));
  }
  limit_ = std::max(options_.tolerance * 0.5 * through, 4e-16 * sums_.rounding);
}

/// Takes the longest of the halved steps whose merit is below the worst of the last few (Grippo, Lampariello and Lucidi
/// 1986). A monotone search would get trapped at the kinks of the laws.
template <int D>
bool SeepageNewton<D>::search_line(SeepageState& state, const std::vector<double>& direction, double& largest) {
  if (recent_.size() == memory) recent_.erase(recent_.begin());
  recent_.push_back(find_merit(sums_, state));
  const double before = *std::max_element(recent_.begin(), recent_.end());
  StepInput values = input_;
  values.chord = 0;  // the slopes are not needed here
  SeepageState trial = state;
  double length = 1;
  while (length >= shortest_step) {
    largest = 0;
    for (std::size_t u = 0; u < direction.size(); ++u) {
      trial.head[u] = state.head[u] + length * direction[u];
      largest = std::max(largest, std::abs(length * direction[u]));
    }
    const NodalSums sums = sum_over_elements(system_, trial.head, values, false);
    const double merit = find_merit(sums, trial);
    if (merit <= (1 - 1e-4 * length) * before || largest < 1e-12 * height_) {
      state.head = trial.head;
      return true;
    }
    length *= 0.5;
  }
  return false;
}

/// Takes a step in Newton's direction, or in that of Picard's method (constant conductivities) if it fails.
template <int D>
bool SeepageNewton<D>::take_step(SeepageState& state, double& largest) {
  const std::size_t n = weight_.size();
  std::vector<double> right(n);
  for (std::size_t u = 0; u < n; ++u) right[u] = is_held(state, u) ? 0 : -find_residual(sums_, state, u);
  for (int attempt = 0; attempt < 2; ++attempt) {
    if (attempt == 1) {
      if (sums_.symmetric) return false;
      StepInput held = input_;
      held.hold_conductivity = true;
      sums_ = sum_over_elements(system_, state.head, held, true);
    }
    std::vector<double> values = sums_.jacobian;
    for (std::size_t j = 0; j < n; ++j) {
      const bool held_column = is_held(state, j);
      for (int k = system_.column_start[j]; k < system_.column_start[j + 1]; ++k) {
        const auto slot = static_cast<std::size_t>(k);
        const auto i = static_cast<std::size_t>(system_.row[slot]);
        if (held_column || is_held(state, i)) values[slot] = i == j ? weight_[j] : 0;
      }
    }
    ++solves_;
    if (!solver_.factorise(values, sums_.symmetric ? sparse::Factors::ldlt : sparse::Factors::lu)) return false;
    std::vector<double> direction = right;
    if (!solver_.solve(direction)) return false;
    if (search_line(state, direction, largest)) return true;
  }
  return false;
}

template <int D>
bool SeepageNewton<D>::solve(SeepageState& state, const std::vector<NodeCondition>& conditions, StepInput input,
                             Slopes slopes) {
  conditions_ = &conditions;
  input_ = std::move(input);
  input_.smallest_conductivity = options_.smallest_conductivity;
  recent_.clear();
  switches_.assign(state.head.size(), 0);
  for (std::size_t u = 0; u < state.head.size(); ++u) {
    const NodeCondition& c = conditions[u];
    if (c.fixed) state.head[u] = c.head;
    if (!c.face || c.fixed)
      state.face[u] = FaceState::none;
    else if (state.face[u] == FaceState::none)
      state.face[u] = system_.suction(u, state.head[u]) > 0 ? FaceState::open : FaceState::wet;
    if (state.face[u] == FaceState::wet) state.head[u] = system_.elevation[u];
  }
  double largest = 0;
  std::vector<double> faults;
  const int most = switches_allowed * options_.most_iterations;
  for (int it = 0; it < most && static_cast<int>(faults.size()) < options_.most_iterations; ++it) {
    throw_if_interrupted();
    const double range = it == 0 ? first_chord * height_ : 0.5 * largest;
    input_.chord = slopes == Slopes::chord && range > small_chord * height_ ? range * system_.model.unit_weight : 0;
    evaluate(state);
    const bool balanced = fault_ <= limit_;
    if ((it > 0 || balanced) && switch_faces(state, balanced)) {
      recent_.clear();
      faults.clear();
      evaluate(state);
    } else if (balanced && (largest <= small_change * height_ || (sums_.symmetric && input_.dt == 0))) {
      return true;
    }
    faults.push_back(fault_);
    if (faults.size() > patience && fault_ > 0.5 * faults[faults.size() - 1 - patience]) return false;
    if (!take_step(state, largest)) return false;
  }
  return false;
}

template class SeepageNewton<2>;
template class SeepageNewton<3>;

}  // namespace talus::fem
