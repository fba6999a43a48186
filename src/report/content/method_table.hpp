#pragma once
// The factors of safety by slices, finite elements and material points beside each other.

#include <nlohmann/json.hpp>
#include <string>

namespace talus::report {

/// `MethodTable` of web/src/contract/; null for a run of material points alone.
nlohmann::json make_method_table(const nlohmann::json& summary);

/// `Factor`s of web/src/contract/ by slices and finite elements; given and handed surfaces only where no critical one
/// was sought. Of each method one is marked as main: Spencer's critical circle, else the first with a value; of finite
/// elements the first.
nlohmann::json list_other_factors(const nlohmann::json& summary);

/// "The factor of safety is 1.441 by slices (Spencer, critical circle) and 1.398 by finite elements (…)."; empty
/// when no method found one. `factors` are those of all methods.
std::string say_main_factors(const nlohmann::json& summary, const nlohmann::json& factors);

/// How far the main factors lie apart, and how much of it is known to be the flow rule or the mesh; empty for fewer
/// than two.
std::string say_agreement(const nlohmann::json& factors);

/// Where slices found a surface that is weaker than the one of their main factor; empty otherwise.
std::string say_weakest_surface(const nlohmann::json& factors);

/// Whether the factors are those of partial factors' design values.
bool has_design_values(const nlohmann::json& summary);

}  // namespace talus::report
