// SPDX-License-Identifier: MIT
#pragma once
// A result on two meshes, extrapolated to elements of no size.

#include <cmath>

namespace talus {

/// What the finer of two values at sizes `coarse` > `fine` still lacks, over their difference, where the error falls
/// with that power of the size (Richardson).
inline double find_rest(double coarse, double fine, double order = 1) {
  return 1 / (std::pow(coarse / fine, order) - 1);
}

/// Two values at sizes `coarse` > `fine`, extrapolated to size 0.
inline double extrapolate_to_zero(double coarse, double value_coarse, double fine, double value_fine,
                                  double order = 1) {
  return value_fine - (value_coarse - value_fine) * find_rest(coarse, fine, order);
}

}  // namespace talus
