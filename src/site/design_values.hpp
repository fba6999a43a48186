// SPDX-License-Identifier: MIT
#pragma once
// Design values after Eurocode 7: the case with factored strengths and loads, which all methods calculate.

#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "results/comparison.hpp"

namespace talus::site {

struct DesignValues {
  input::Case data;                                   ///< with design values; the given case if it has no factors
  double resistance = 1;                              ///< γ_R;e, which divides the factor of safety
  std::optional<results::DesignStatement> statement;  ///< nothing without factors
};

/// Applies the partial factors: c'/γ_c', tanφ'/γ_φ', c_u/γ_cu where φ = 0, weights over γ_γ, loads by γ_G and γ_Q. γ_G
/// applies to soil, water and permanent loads alike, so that all quantities in kPa are divided by it instead
/// (input::divide_by_permanent). The target of a timeline is multiplied by γ_R;e. Throws Error (wrong_input) for a soil
/// without cohesion and friction angle.
DesignValues apply_partial_factors(const input::Case& data);

/// Returns a warning if partial factors on actions are combined with an earthquake, whose design situation has none;
/// else an empty text.
std::string describe_factored_quake(const input::Case& data);

/// Writes the over-design factor Γ = F/γ_R;e of a factor of safety computed with design values into the statement, with
/// its text.
void state_over_design(results::DesignStatement& statement, double resistance, double factor);

}  // namespace talus::site
