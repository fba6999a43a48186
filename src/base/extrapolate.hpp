// SPDX-License-Identifier: MIT
#pragma once
// Extrapolation of a result on meshes of several element sizes to size zero.

#include <vector>

namespace talus {

/// Returns the remaining error of the value at size `fine`, over the difference of the values at `coarse` and `fine`,
/// for an error proportional to the size (Richardson extrapolation).
inline double find_rest(double coarse, double fine) {
  return fine / (coarse - fine);
}

/// Fraction of the value on the finer mesh above which an extrapolation from two meshes is no result. For an error
/// c = a h + b h² of the finer mesh, with terms as they are in a convergent series (b h² up to c²), extrapolation from
/// h and 2 h is wrong by 2 b h²: by up to 2 c², which is 1 % at 7 %. Two meshes do not show that error.
inline constexpr double most_extrapolated = 0.07;

/// Returns the extrapolation to size 0 of two values at sizes `coarse` > `fine`.
inline double extrapolate_to_zero(double coarse, double value_coarse, double fine, double value_fine) {
  return value_fine - (value_coarse - value_fine) * find_rest(coarse, fine);
}

/// Returns the weight of each value in the intercept at size 0 of a straight line through values at `sizes`, by least
/// squares with weights 1/size. The weights sum to 1. For two sizes they are those of extrapolate_to_zero().
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
