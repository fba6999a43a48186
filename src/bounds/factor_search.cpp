// SPDX-License-Identifier: MIT
// The lack grows with the factor, and its derivative is known: Newton's method, kept between what is known already.

#include "bounds/factor_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace talus::bounds {

namespace {

/// Lack that the tolerance of the solver cannot tell from none, in units of stress.
constexpr double no_lack = 2e-6;
constexpr int most_trials = 40;

}  // namespace

bool FactorSearch::try_factor(double factor) {
  // The solver may stall on a degenerate program; the program of a neighbouring factor then often has a solution.
  Trial trial;
  for (const double beside : {1.0, 0.99, 1.01, 0.97, 1.03}) {
    trial = solve_(beside * factor);
    ++programs_, iterations_ += trial.solution.iterations;
    if (trial.solution.end != ConicEnd::stalled) break;
  }
  factor = trial.factor;
  if (trial.solution.end != ConicEnd::solved) {
    why_ = trial.solution.end == ConicEnd::infeasible
               ? "no stress field is in equilibrium with the loads"
               : "the solver of the cone programs stopped: " + trial.solution.why;
    return false;
  }
  // Between the two nothing is decided: what is computed is neither a field nor a lack of one.
  const bool falls = trial.lack > no_lack + trial.doubt;
  const bool stands = trial.lack + trial.doubt <= no_lack || trial.lack + trial.doubt < 0;
  if (stands) stood_ = std::max(stood_.value_or(0), factor);
  if (falls) fell_ = std::min(fell_.value_or(factor), factor);
  is_undecided_ = !stands && !falls;
  // Without cohesion nothing lacks below the root, and only what fell points at it.
  if (std::abs(trial.lack) > no_lack + trial.doubt && trial.rate > 0) root_ = factor - trial.lack / trial.rate;
  if (root_ && stood_ && *root_ < *stood_) root_ = stood_;
  if (root_ && fell_ && *root_ > *fell_) root_ = fell_;
  if (stood_ && fell_ && *fell_ - *stood_ < 1e-6 * *fell_) root_ = stood_;
  last_ = std::move(trial);
  return true;
}

bool FactorSearch::approach(double start, double tolerance) {
  double factor = start, reach = 0.1;
  for (int i = 0; i < most_trials; ++i) {
    if (!try_factor(factor)) return false;
    double next = is_undecided_ || last_->lack > no_lack ? factor / (1 + reach) : factor * (1 + reach);
    reach *= 2;
    if (root_) {
      if (std::abs(*root_ - factor) <= tolerance * factor) return true;
      next = *root_;
    }
    // Newton's steps are long where the lack bends; between what stood and what fell they go half-way instead.
    if (stood_ && fell_ && (next <= *stood_ || next >= *fell_)) next = std::sqrt(*stood_ * *fell_);
    next = std::clamp(next, range_.smallest, range_.largest);
    if (next == factor) break;
    factor = next;
  }
  why_ = stood_ && *stood_ >= range_.largest
             ? fmt::format("the slope is stable at every factor up to {:g}", range_.largest)
         : fell_ && *fell_ <= range_.smallest
             ? fmt::format(
                   "no stress field was found at any factor down to {:g}; this is usually a fault of the model, "
                   "such as a load or water on soil without cohesion and tensile strength",
                   range_.smallest)
             : "the cone programs are undecided at all factors that were tried";
  return false;
}

}  // namespace talus::bounds
