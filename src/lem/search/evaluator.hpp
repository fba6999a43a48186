// SPDX-License-Identifier: MIT
#pragma once
// The factor of one surface after another by one method, with memory that is used again. One per thread.

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "lem/section/slope.hpp"
#include "lem/slices/solve.hpp"

namespace talus::lem {

/// A search may take minutes and keeps nothing before its end. Throws Error (interrupted).
inline void throw_if_search_is_interrupted(bool ends_at_signal) {
  if (ends_at_signal && is_interrupted())
    throw Error(ExitCode::interrupted, "interrupted while slip surfaces were searched");
}

class Evaluator {
 public:
  Evaluator(const Slope& slope, Method method, const Checks& checks, int slices, bool ends_at_signal = false)
      : slope_(&slope), method_(method), checks_(checks), slices_(slices), ends_at_signal_(ends_at_signal) {}

  /// F; `refused` for an invalid surface or one without a factor. Throws Error (interrupted) where asked to.
  double operator()(const Surface& surface) {
    throw_if_search_is_interrupted(ends_at_signal_);
    ++count_;
    cut_surface(*slope_, surface, slices_, checks_, cut_);
    if (cut_.refusal != Refusal::none) return refused;
    const Solution solution = solve(*slope_, cut_, method_, checks_, false);
    return solution.refusal == Refusal::none && solution.factor > 0 ? solution.factor : refused;
  }
  int count() const { return count_; }
  const Slope& slope() const { return *slope_; }
  Method method() const { return method_; }

  static constexpr double refused = 1e6;  ///< larger than any factor, and finite for the minimisers

 private:
  const Slope* slope_;
  Method method_;
  Checks checks_;
  int slices_;
  bool ends_at_signal_;
  CutSurface cut_;
  int count_ = 0;
};

}  // namespace talus::lem
