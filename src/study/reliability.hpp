#pragma once
// Reliability index without sampling: from the derivatives at the means, and from the nearest point of failure.

#include <functional>
#include <optional>
#include <vector>

#include "study/distributions.hpp"

namespace talus::study {

/// Factor of safety for values of all numbers, in the units of their keys; nothing where there is none.
using FactorOf = std::function<std::optional<double>(const std::vector<double>&)>;

/// F at one deviation below and above the mean of a number, the others at their means.
struct Sensitivity {
  double low_value = 0, high_value = 0;
  double low_factor = 0, high_factor = 0;
};

/// Mean-value first-order second-moment: F is taken as linear in the numbers.
struct FirstOrder {
  double mean_factor = 0;      ///< F at the means
  double deviation = 0;        ///< of F
  double index_normal = 0;     ///< β = (F-1)/σ_F
  double index_lognormal = 0;  ///< β = ln(F/√(1+V²))/√ln(1+V²), V = σ_F/F (Hassan and Wolff 1999)
  std::vector<Sensitivity> sensitivities;
};

/// `correlation` is that of the normal scores, numbers × numbers; empty: none. Nothing where a factor is missing.
std::optional<FirstOrder> estimate_first_order(const std::vector<Marginal>& numbers,
                                               const std::vector<double>& correlation, const FactorOf& factor);

/// Hasofer and Lind's (1974) index: the distance of the failure surface F = 1 from the origin of independent normal
/// scores, found by Rackwitz and Fiessler's (1978) iteration with a line search.
struct DesignPoint {
  double index = 0;  ///< β; negative where the slope fails at the medians
  bool converged = false;
  int iterations = 0;
  std::vector<double> values;      ///< the most probable failure, in the units of the keys
  std::vector<double> importance;  ///< squares of the direction to it; with correlations, of the scores in their order
  double factor = 0;               ///< F there
};
std::optional<DesignPoint> find_design_point(const std::vector<Marginal>& numbers,
                                             const std::vector<double>& correlation, const FactorOf& factor);

}  // namespace talus::study
