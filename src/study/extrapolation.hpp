#pragma once
// Richardson extrapolation: from the factors of several mesh sizes to that of size zero, with what is known of its
// error. docs/theory/factor-of-safety.md has the equations.

#include <optional>
#include <string>
#include <vector>

#include "study/study.hpp"

namespace talus::study {

/// F(h) = F_0 + C h^p through factors at several sizes, coarse to fine.
struct Extrapolation {
  std::vector<double> sizes;             ///< h, in the unit of the key
  std::vector<double> factors;           ///< F(h)
  double linear = 0;                     ///< F_0 of the least squares line, p = 1
  std::optional<double> standard_error;  ///< of `linear`, from the scatter about the line; three sizes or more
  double finest_pair = 0;                ///< F_0 of the line through the two finest sizes
  std::optional<double> order;           ///< p in [1/2, 4] that fits best; four sizes or more
  std::optional<double> by_order;        ///< F_0 with that p
};

/// Sizes must be positive and differ; two or more. Throws Error (wrong_input) otherwise.
Extrapolation extrapolate(std::vector<double> sizes, std::vector<double> factors);

/// Every factor of a study that was calculated at two values or more of the key, all other varied keys the same.
/// Nothing when the study extrapolates none.
std::optional<results::StudyExtrapolation> extrapolate_factors(const StudyPlan& plan,
                                                               const std::vector<StudyRow>& rows);

/// As a table in Markdown; empty without factors.
std::string write_extrapolation_markdown(const StudyPlan& plan,
                                         const std::optional<results::StudyExtrapolation>& extrapolation);

}  // namespace talus::study
