// SPDX-License-Identifier: MIT
#include "run/mpm/stage/stepped_body.hpp"

#include "base/ranks.hpp"
#include "mpm/solver/build.hpp"
#include "mpm/state/body.hpp"
#include "mpm/state/partition.hpp"
#include "run/mpm/stage/helpers.hpp"

namespace talus::run {

template <int D>
SteppedBody<D>::SteppedBody(mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state,
                            const StageHooks<D>& hooks)
    : plan_(plan),
      hooks_(hooks),
      called_{static_cast<bool>(hooks.output), static_cast<bool>(hooks.look), static_cast<bool>(hooks.report),
              static_cast<bool>(hooks.save_last_good), static_cast<bool>(hooks.mark)},
      bodies_{&body} {
  const auto add = [&](mpm::Body<D> made) { bodies_.push_back(&auxiliary_.emplace_back(std::move(made))); };
  if (is_drained(*bodies_.back(), plan_)) add(make_drained_body(*bodies_.back(), plan_, state));
  if (equalises_mass(*bodies_.back(), plan_)) {
    add(make_even_body(*bodies_.back(), plan_, state));
    plan_.equalises_mass = false;
  }
  mpm::Body<D>& whole = *bodies_.back();
  if (get_ranks().size() == 1 || whole.partition) return;
  if (plan_.helpers != nullptr)
    plan_.helpers->begin(whole, plan_, state, called_);
  else
    check_equal(whole);
  part_ = std::make_unique<PartitionedBody<D>>(&whole, mpm::copy_description(whole), plan_.helpers == nullptr);
}

template <int D>
SteppedBody<D>::SteppedBody(mpm::Body<D> description, const StagePlan<D>& plan, const HooksOfRank0& hooks)
    : plan_(plan),
      hooks_(no_hooks_),
      called_(hooks),
      part_(std::make_unique<PartitionedBody<D>>(nullptr, std::move(description), false)) {}

template <int D>
const mpm::Body<D>& SteppedBody<D>::update_case(const mpm::Body<D>& whole) {
  const mpm::Body<D>* from = &whole;
  for (std::size_t i = bodies_.size() - 1; i > 0; --i) {
    copy_from_auxiliary(*from, *bodies_[i - 1]);
    from = bodies_[i - 1];
  }
  return *from;
}

template <int D>
void SteppedBody<D>::lead(const mpm::Body<D>& stepped, const std::function<void(const mpm::Body<D>&)>& work) {
  const auto with_case = [&](const mpm::Body<D>& whole) { work(update_case(whole)); };
  part_ ? part_->lead(stepped, with_case) : with_case(stepped);
}

template <int D>
bool SteppedBody<D>::agree(bool value) {
  if (part_) part_->leave_out([&] { broadcast(value); });
  return value;
}

template <int D>
void SteppedBody<D>::rebalance() {
  if (part_) part_->rebalance();
  if (hooks_.rebalance) hooks_.rebalance(body());
}

template <int D>
void SteppedBody<D>::write_output(Stepper<D>& stepper, StageState& state) {
  if (!called_.output || !(body().time >= state.next_output)) return;
  if (!part_ && auxiliary_.empty()) return hooks_.output(stepper, state);  // a device writes rows without a copy
  lead(stepper.whole(), [&](const mpm::Body<D>& of_case) {
    PauseHere<D> here(of_case);
    hooks_.output(here, state);
  });
  if (!part_) return;
  part_->leave_out([&] {
    for (double* result : {&state.next_output, &state.soft_band, &state.soft_size}) broadcast(*result);
  });
}

template <int D>
void SteppedBody<D>::look(Stepper<D>& stepper, const StageState& state) {
  if (!called_.look || !agree(!hooks_.look_is_due || hooks_.look_is_due())) return;
  lead(stepper.whole(), [&](const mpm::Body<D>& of_case) { hooks_.look(of_case, state); });
}

template <int D>
bool SteppedBody<D>::is_report_due() {
  return called_.report && agree(hooks_.report_is_due && hooks_.report_is_due());
}

template <int D>
void SteppedBody<D>::report(const StageState& state, double moved) {
  if (hooks_.report) hooks_.report(body(), state, moved);
}

template <int D>
std::string SteppedBody<D>::save_last_good(const mpm::Body<D>& good, const StageState& state) {
  std::string saved;
  if (called_.save_last_good)
    lead(good, [&](const mpm::Body<D>& of_case) { saved = hooks_.save_last_good(of_case, state); });
  return saved;
}

template <int D>
GoBack<D> SteppedBody<D>::mark() {
  if (!called_.mark) return {};
  GoBack<D> go_back;
  const auto make = [&] { go_back = hooks_.mark(); };
  part_ ? lead_ranks(make) : make();
  return [this, go_back](const mpm::Body<D>& good, const StageState& state, const StagePlan<D>& plan) {
    lead(good, [&](const mpm::Body<D>& of_case) { go_back(of_case, state, plan); });
  };
}

template <int D>
void SteppedBody<D>::finish() {
  if (part_) part_->finish();
  if (plan_.helpers != nullptr) plan_.helpers->end();
  for (std::size_t i = bodies_.size(); i > 1; --i) {
    mpm::Body<D>& outer = *bodies_[i - 2];
    copy_from_auxiliary(*bodies_[i - 1], outer);
    outer.nodes.load.clear();  // they include the loads of the auxiliary body
    mpm::gather_loads(outer);
  }
}

template class SteppedBody<2>;
template class SteppedBody<3>;

}  // namespace talus::run
