// SPDX-License-Identifier: MIT
#pragma once
// A result on meshes of several sizes, extrapolated to elements of no size.

#include <vector>

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

/// Where a straight line through values at `sizes`, by least squares with weights 1/size, is at size 0: the share of
/// each value. They sum up to 1. Of two sizes these are those of extrapolate_to_zero().
inline std::vector<double> find_line_shares(const std::vector<double>& sizes) {
  double weight = 0, mean = 0, spread = 0;  // Σ w, Σ w h/Σ w, Σ w (h − mean)²
  for (const double h : sizes) {
    weight += 1 / h;
    mean += 1;
  }
  mean /= weight;
  for (const double h : sizes) spread += (h - mean) * (h - mean) / h;
  std::vector<double> shares;
  for (const double h : sizes) shares.push_back((1 / weight - mean * (h - mean) / spread) / h);
  return shares;
}

}  // namespace talus
