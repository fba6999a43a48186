// SPDX-License-Identifier: MIT
#pragma once
// The standard normal distribution, and the exact interval of a counted share.

#include <array>

namespace talus::study {

/// Φ(z), with full relative accuracy in the lower tail.
double find_normal_probability(double z);
/// Φ⁻¹(p) for 0 < p < 1; ∓infinity at 0 and 1.
double find_normal_score(double p);

/// Clopper and Pearson's (1934) interval for a probability of which `count` out of `samples` were seen: the true one
/// lies outside it with at most 1 - `confidence`, half on each side.
std::array<double, 2> bound_share(long count, long samples, double confidence);

}  // namespace talus::study
