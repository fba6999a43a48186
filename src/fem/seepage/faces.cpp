// SPDX-License-Identifier: MIT
// The states of face nodes: open, wet or dry, as a mixed complementarity problem.

#include <algorithm>
#include <cmath>

#include "fem/seepage/newton.hpp"

namespace talus::fem {

namespace {

constexpr int free_switches = 6;   ///< a node may change its state in any iteration; then only when the rest is solved
constexpr int most_switches = 16;  ///< after these a node keeps its state: neither fits better

}  // namespace

/// Changes the state of face nodes that contradict it; a node that becomes wet or dry gets its head at once.
template <int D>
bool SeepageNewton<D>::switch_faces(SeepageState& state, bool balanced) {
  undecided_ = 0;
  bool switched = false;
  std::size_t worst = 0;
  double worst_size = 0;
  FaceState worst_state = FaceState::none;
  int wet = 0;
  for (FaceState f : state.face) wet += f == FaceState::wet;
  const bool needs_hold = input_.dt == 0 && std::none_of(conditions_->begin(), conditions_->end(),
                                                         [](const NodeCondition& c) { return c.fixed; });
  const auto change = [&](std::size_t u, FaceState to) {
    if (state.face[u] == FaceState::wet && --wet == 0 && needs_hold) {
      ++wet;
      return;  // a steady state needs one pressure at least
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
    const double excess = sums_.outflow[u] - c.given - c.offered;  // what enters beyond the offer
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

template bool SeepageNewton<2>::switch_faces(SeepageState&, bool);
template bool SeepageNewton<3>::switch_faces(SeepageState&, bool);

}  // namespace talus::fem
