// SPDX-License-Identifier: MIT
// The value of a surface for the minimisers: the factor, and more for polylines that no wedge mechanism supports.

#include "lem/search/evaluator.hpp"

#include <algorithm>
#include <cmath>

namespace talus::lem {

double Evaluator::operator()(const Surface& surface) {
  throw_if_search_is_interrupted(ends_at_signal_);
  ++count_;
  cut_surface(*slope_, surface, slices_, checks_, cut_);
  if (cut_.refusal != Refusal::none) return refused;
  const Solution solution = solve(*slope_, cut_, method_, checks_, false);
  if (solution.refusal != Refusal::none || !(solution.factor > 0)) return refused;
  const double factor = solution.factor;
  if (factor >= passing_.factor) return factor;
  if (has_wedge_check(*slope_, cut_, method_) && std::isfinite(most_below_wedges_)) {
    const double allowed = 1 - most_below_wedges_;
    const Section& section = slope_->section();
    wedges_.set(*slope_, cut_, section.turn_to_sliding(section.horizontal_acceleration, cut_.slides_left));
    if (wedges_.compute_net_power(factor / allowed) < 0) {
      const double bound = std::min(allowed * wedges_.search_factor(factor / allowed), 10 * factor);
      // Steeper than 1: else a polyline further below its mechanism could have a smaller value.
      if (bound > factor) return factor + penalty_ * (bound - factor);
    }
  }
  passing_ = {surface, factor, count_};
  return factor;
}

bool Evaluator::passes_all_checks(const Surface& surface) {
  cut_surface(*slope_, surface, slices_, strict_, cut_);
  if (cut_.refusal != Refusal::none) return false;
  return solve(*slope_, cut_, method_, strict_, false).refusal == Refusal::none;
}

}  // namespace talus::lem
