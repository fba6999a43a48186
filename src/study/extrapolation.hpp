// SPDX-License-Identifier: MIT
#pragma once
// Richardson extrapolation of factors on several mesh sizes to size zero, with an estimate of its error.
// docs/theory/factor-of-safety.md has the equations.

#include <optional>
#include <string>
#include <vector>

#include "study/study_plan.hpp"

namespace talus::study {

/// Fits F(h) = F_0 + C h^p to factors F(h) at several sizes h. Returns F_0 of the least squares line, p = 1, with its
/// standard error from three sizes on; F_0 of the line through the two finest; and F_0 with the best-fitting p in
/// [1/2, 4], from four sizes on. Sizes are sorted from coarse to fine. Throws Error (wrong_input) for fewer than two,
/// and for sizes that are not positive and distinct.
results::ExtrapolatedFactor extrapolate(const std::vector<double>& sizes, const std::vector<double>& factors);

/// Extrapolates every factor of the table that was computed at two or more values of the key with all other varied
/// keys equal. Returns nullopt if the study extrapolates none.
std::optional<results::StudyExtrapolation> extrapolate_factors(const StudyPlan& plan,
                                                               const std::vector<results::StudyColumn>& table);

/// Formats the extrapolation as a table in Markdown; empty without factors. `name` is the short name of the key.
std::string write_extrapolation_markdown(const results::StudyExtrapolation& extrapolation, const std::string& name);

}  // namespace talus::study
