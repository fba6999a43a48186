// SPDX-License-Identifier: MIT
#pragma once
// A result on two meshes, extrapolated to elements of no size.

namespace talus {

/// Linear extrapolation of two values at sizes `coarse` > `fine` to size 0: Richardson's, of first order.
inline double extrapolate_to_zero(double coarse, double value_coarse, double fine, double value_fine) {
  return value_fine - (value_coarse - value_fine) * fine / (coarse - fine);
}

}  // namespace talus
