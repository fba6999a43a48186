// SPDX-License-Identifier: MIT
#pragma once
// Richardson extrapolation: from the factors of several mesh sizes to that of size zero, with what is known of its
// error. docs/theory/factor-of-safety.md has the equations.

#include <optional>
#include <string>
#include <vector>

#include "study/study_plan.hpp"

namespace talus::study {

/// F(h) = F_0 + C h^p through factors F(h) at several sizes h: F_0 of the least squares line, p = 1, with its standard
/// error from three sizes on; of the line through the two finest; and with the p in [1/2, 4] that fits best, from four
/// sizes on. Sizes are told from coarse to fine; they must be positive and differ; two or more. Throws Error
/// (wrong_input) otherwise.
results::ExtrapolatedFactor extrapolate(const std::vector<double>& sizes, const std::vector<double>& factors);

/// Every factor of a study's table that was calculated at two values or more of the key, all other varied keys the
/// same. Nothing when the study extrapolates none.
std::optional<results::StudyExtrapolation> extrapolate_factors(const StudyPlan& plan,
                                                               const std::vector<results::StudyColumn>& table);

/// As a table in Markdown; empty without factors. `name` is the short one of the key.
std::string write_extrapolation_markdown(const results::StudyExtrapolation& extrapolation, const std::string& name);

}  // namespace talus::study
