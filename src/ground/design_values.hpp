#pragma once
// Design values after Eurocode 7: the case that every method calculates, with its strengths and loads factored.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "input/case/case.hpp"

namespace talus::ground {

struct DesignValues {
  input::Case data;       ///< with design values; the case itself where no factors are asked for
  double resistance = 1;  ///< γ_R;e, which divides the factor of safety
  /// null without factors, else {"set", "values": [{"key", "title", "symbol", "value"}], "materials": [{"material",
  /// "quantity", "symbol", "unit", "characteristic", "design"}], "surcharges": [{"name", "factor"}], "over_design":
  /// null, "text", "notes"}; numbers of materials in `unit`.
  nlohmann::json statement;
};

/// c'/γ_c', tanφ'/γ_φ', c_u/γ_cu where φ = 0, weights over γ_γ, loads by γ_G and γ_Q. γ_G stands on soil, water and
/// permanent loads alike, so all that is in kPa is divided by it instead (input::divide_by_permanent). Throws Error
/// (wrong_input) for a soil without cohesion and friction angle.
DesignValues apply_partial_factors(const input::Case& data);

/// Writes the over-design factor of a factor of safety that was calculated with design values into the statement, and
/// says it in words. Does nothing to null.
void state_over_design(nlohmann::json& statement, double factor);

}  // namespace talus::ground
