// SPDX-License-Identifier: MIT
#include "run/mpm/setback.hpp"

#include <cmath>

namespace talus::run {
namespace {

/// Smoothing after so many setbacks.
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
  // The newest copy may already hold the beginning of an instability, which takes a while to be noticed.
  older_ = newer_;
  newer_ = std::make_shared<const Kept>(Kept{body, state, hooks_.mark ? hooks_.mark() : GoBack<D>()});
  if (!older_) older_ = start_ = newer_;
}

template <int D>
bool GoodStates<D>::go_back(mpm::Body<D>& body, StageState& state, const std::string& reason) {
  if (state.setbacks.size() >= most_setbacks) return false;
  // A copy to which it went back before, and which failed again, was not good.
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

}  // namespace talus::run
