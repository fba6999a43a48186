// SPDX-License-Identifier: MIT
#pragma once
// A result on two meshes, extrapolated to elements of no size.

namespace talus {

/// What the finer of two values at sizes `coarse` > `fine` still lacks, over their difference, where the error falls
/// with the size (Richardson).
inline double find_rest(double coarse, double fine) {
  return fine / (coarse - fine);
}

/// Two values at sizes `coarse` > `fine`, extrapolated to size 0.
inline double extrapolate_to_zero(double coarse, double value_coarse, double fine, double value_fine) {
  return value_fine - (value_coarse - value_fine) * find_rest(coarse, fine);
}

}  // namespace talus
