// SPDX-License-Identifier: MIT
#include "run/construction/steady_water.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace talus::run {

SteadyWater::SteadyWater(const StageModel& stage, std::vector<double> kept, double from, double to)
    : stage_(stage), kept_(std::move(kept)), from_(from), to_(to), head_(kept_) {}

/// Returns true if a boundary value changes between the times.
bool SteadyWater::varies() const {
  return std::any_of(stage_.flow.boundaries.begin(), stage_.flow.boundaries.end(), [&](const auto& boundary) {
    return boundary.value_at(from_) != boundary.value_at(to_) ||
           std::any_of(boundary.history.begin(), boundary.history.end(),
                       [&](const auto& row) { return row[0] > from_ && row[0] < to_; });
  });
}

void SteadyWater::solve(double time) {
  if (!stage_.is_wet || time_ == time || (time_ && !varies())) return;
  const fem::SteadyHeads<2> found =
      fem::find_steady_heads<2>(stage_.flow, kept_, time, time_ ? head_ : std::vector<double>{});
  head_ = found.head;
  time_ = time;
  fault_.reset();
  if (!found.is_given)
    fault_ = found.is_lowered ? "no [[hydraulic]] gives a head: the pore pressures stay as they were, lowered to the "
                                "ground at which water leaves"
                              : "no [[hydraulic]] gives a head: the pore pressures stay as they were";
}

const std::vector<double>& SteadyWater::find_head(double time) {
  try {
    solve(time);
  } catch (const Error& error) {
    fault_ = error.what();
    time_ = time;  // the same for all steps of a stage whose conditions do not change
  }
  return head_;
}

const std::vector<double>& SteadyWater::find_drained_head() {
  solve(to_);
  return head_;
}

}  // namespace talus::run
