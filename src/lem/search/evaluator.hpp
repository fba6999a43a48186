// SPDX-License-Identifier: MIT
#pragma once
// The factor of one surface after another by one method, with memory that is used again. One per thread.

#include <limits>

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "lem/section/slope.hpp"
#include "lem/slices/solve.hpp"
#include "lem/slices/wedge_mechanism.hpp"

namespace talus::lem {

/// A search may take minutes and keeps nothing before its end. Throws Error (interrupted).
inline void throw_if_search_is_interrupted(bool ends_at_signal) {
  if (ends_at_signal && is_interrupted())
    throw Error(ExitCode::interrupted, "interrupted while slip surfaces were searched");
}

struct OptimisedSurface {
  Surface surface;
  double factor = 0;  ///< Evaluator::refused when nothing was found
  int evaluations = 0;
};

class Evaluator {
 public:
  Evaluator(const Slope& slope, Method method, const Checks& checks, int slices, bool ends_at_signal = false)
      : slope_(&slope), method_(method), checks_(checks), slices_(slices), ends_at_signal_(ends_at_signal) {
    checks_.most_below_wedges = std::numeric_limits<double>::infinity();
    strict_ = checks;
    if (checks.reject && is_rigorous(method)) most_below_wedges_ = 0.95 * checks.most_below_wedges;
  }

  /// F; `refused` for an invalid surface or one without a factor. A polyline below the wedge mechanism of its base has
  /// a value above F that grows with the distance, so that a minimiser returns to those that are not. That is computed
  /// only below the smallest factor that passed so far. Throws Error (interrupted) where asked to.
  double operator()(const Surface& surface);
  /// Returns true where the factor of a surface passes all checks, that of wedges included.
  bool passes_all_checks(const Surface& surface);
  /// The surface with the smallest factor so far that is not below its mechanism.
  const OptimisedSurface& passing() const { return passing_; }
  /// From here on values below the mechanism grow fast. A minimiser returns from there at once, but does not follow the
  /// border between the two, which it does while they grow slowly.
  void steepen() { penalty_ = 4; }
  int count() const { return count_; }
  const Slope& slope() const { return *slope_; }
  Method method() const { return method_; }

  static constexpr double refused = 1e6;  ///< larger than any factor, and finite for the minimisers

 private:
  const Slope* slope_;
  Method method_;
  Checks checks_, strict_;  ///< without the check of wedges, and with it
  /// Slightly less than the check allows, which the result of a minimiser then passes.
  double most_below_wedges_ = std::numeric_limits<double>::infinity();
  int slices_;
  bool ends_at_signal_;
  CutSurface cut_;
  WedgeMechanism wedges_;
  int count_ = 0;
  double penalty_ = 1.5;
  OptimisedSurface passing_{{}, refused, 0};
};

}  // namespace talus::lem
