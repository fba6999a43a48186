// SPDX-License-Identifier: MIT
#pragma once
// Design values after Eurocode 7: the case that every method calculates, with its strengths and loads factored.

#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "results/comparison.hpp"

namespace talus::ground {

struct DesignValues {
  input::Case data;       ///< with design values; the case itself where no factors are asked for
  double resistance = 1;  ///< γ_R;e, which divides the factor of safety
  std::optional<results::DesignStatement> statement;  ///< nothing without factors
};

/// c'/γ_c', tanφ'/γ_φ', c_u/γ_cu where φ = 0, weights over γ_γ, loads by γ_G and γ_Q. γ_G applies to soil, water
/// and permanent loads alike, so all that is in kPa is divided by it instead (input::divide_by_permanent). Throws
/// Error (wrong_input) for a soil without cohesion and friction angle.
DesignValues apply_partial_factors(const input::Case& data);

/// A sentence on partial factors on actions beside an earthquake, whose design situation has none; empty elsewhere.
std::string describe_factored_quake(const input::Case& data);

/// Writes the over-design factor of a factor of safety that was calculated with design values into the statement, and
/// says it in words.
void state_over_design(results::DesignStatement& statement, double resistance, double factor);

}  // namespace talus::ground
