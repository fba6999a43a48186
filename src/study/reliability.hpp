// SPDX-License-Identifier: MIT
#pragma once
// Reliability index without sampling: from the derivatives at the means, and from the nearest point of failure.

#include <functional>
#include <optional>
#include <vector>

#include "study/sampled_numbers.hpp"

namespace talus::study {

/// Factor of safety for values of all numbers, in the units of their keys; nothing where there is none.
using FactorOf = std::function<std::optional<double>(const std::vector<double>&)>;

/// β = ln(F/√(1+V²))/√ln(1+V²), V = σ_F/F, of a lognormal factor (Hassan and Wolff 1999).
double find_lognormal_index(double mean, double deviation);

/// Mean-value first-order second-moment, where F is taken as linear in the numbers: `told.first_order`, and F at one
/// deviation below and above the mean of each number, the others at their means: `told.tornado`, longest bar first.
/// Neither where a factor is missing.
void estimate_first_order(const SampledNumbers& sampled, const FactorOf& factor, results::Sampling& summary);

/// Hasofer and Lind's (1974) index: the distance of the failure surface F = 1 from the origin of independent normal
/// scores, found by Rackwitz and Fiessler's (1978) iteration with a line search; negative where the slope fails at the
/// medians. Importance is the square of the direction to the design point; with correlations, of the scores in their
/// order. Nothing where a factor is missing.
std::optional<results::DesignPointEstimate> find_design_point(const SampledNumbers& sampled, const FactorOf& factor);

}  // namespace talus::study
