// SPDX-License-Identifier: MIT
#pragma once
// Reliability index without sampling: from the derivatives at the means, and from the design point.

#include <functional>
#include <optional>
#include <vector>

#include "study/sampled_numbers.hpp"

namespace talus::study {

/// Factor of safety for values of all numbers, in the units of their keys; nullopt if there is none.
using FactorOf = std::function<std::optional<double>(const std::vector<double>&)>;

/// β = ln(F/√(1+V²))/√ln(1+V²), V = σ_F/F, of a lognormal factor (Hassan and Wolff 1999).
double find_lognormal_index(double mean, double deviation);

/// Estimates the index by first-order second-moment at the means, with F linear in the numbers, as
/// `summary.first_order`; and F at one deviation below and above the mean of each number, the others at their means,
/// as `summary.tornado`, longest bar first. Sets neither if a factor is missing.
void estimate_first_order(const SampledNumbers& sampled, const FactorOf& factor, results::Sampling& summary);

/// Computes the index of Hasofer and Lind (1974): the distance of the failure surface F = 1 from the origin of
/// independent normal scores, by the iteration of Rackwitz and Fiessler (1978) with a line search; negative if the
/// slope fails at the medians. Importance is the square of the direction to the design point; with correlations, of
/// the scores in their order. Returns nullopt if a factor is missing.
std::optional<results::DesignPointEstimate> find_design_point(const SampledNumbers& sampled, const FactorOf& factor);

}  // namespace talus::study
