// SPDX-License-Identifier: MIT
#pragma once
// The smallest value of a function between bounds without its derivatives, by NLopt.

#include <functional>
#include <vector>

namespace talus::lem {

enum class Minimiser { simplex, subspaces, quadratic };

struct MinimiseOptions {
  Minimiser minimiser = Minimiser::simplex;
  double tolerance = 1e-6;  ///< relative, of the function
  int most_evaluations = 300;
};

struct Minimum {
  std::vector<double> at;
  double value = 0;
  int evaluations = 0;
};

/// Starts at `start` with steps `step` per variable. The start counts as tried: the result is never worse. Exceptions
/// of `function` are passed on.
Minimum minimise(const std::function<double(const std::vector<double>&)>& function, const std::vector<double>& start,
                 const std::vector<double>& step, const std::vector<double>& lower, const std::vector<double>& upper,
                 const MinimiseOptions& options);

}  // namespace talus::lem
