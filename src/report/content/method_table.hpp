// SPDX-License-Identifier: MIT
#pragma once
// The factors of safety by slices, finite elements and material points beside each other.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/report.hpp"

namespace talus::report {

/// `MethodTable` of web/src/contract/; null for a run of material points alone.
nlohmann::json make_method_table(const ResultFolder& folder);

/// A factor of safety as the answer lists it (`Factor` of web/src/contract/).
struct Factor {
  Method method = Method::mpm;
  std::string name;   ///< as comparisons name it: "lem.noncircular.spencer"
  std::string title;  ///< "Spencer, critical circle"
  std::optional<double> value, lower, upper;
  std::string note;
  bool is_main = false;                     ///< it represents its method in the first sentence
  std::optional<input::WaterMotion> water;  ///< of material points in wet ground
  std::optional<SliceMethod> slice_method;  ///< by which slices found it; nothing where they changed a given surface
  std::optional<results::SurfaceSource> source;   ///< of slices and finite elements
  std::optional<results::Flow> flow;              ///< of finite elements
  std::optional<results::FactorMeasure> measure;  ///< of finite elements
  std::optional<results::CriterionKind> by;       ///< of material points
  bool is_extrapolated = false;                   ///< to elements of no size
};

nlohmann::json to_json(const Factor& factor);

/// Factors by slices and finite elements; given and handed surfaces only where no critical one was sought or where one
/// governs. Of each method one is marked as main: of slices the governing one, which stands first, of finite elements
/// the first.
std::vector<Factor> list_other_factors(const results::RunResult& run);

/// "The factor of safety is 1.441 by slices (Spencer, critical circle) and 1.398 by finite elements (…)."; empty
/// when no method found one. `factors` are those of all methods.
std::string format_main_factors(const results::RunResult& run, const std::vector<Factor>& factors);

/// What limit analysis proves of the factors of limit equilibrium, with tension up to the apex; empty where it does not
/// judge.
std::string format_referee(const results::RunResult& run);

/// "It is proven to lie between 1.432 and 1.446 for ψ = φ."; empty without proven bounds.
std::string format_proven(const results::RunResult& run);

/// How far the main factors lie apart, and how much of it is known to be the flow rule or the mesh; empty for fewer
/// than two.
std::string format_agreement(const std::vector<Factor>& factors);

/// Whether the factors are those of partial factors' design values.
bool has_design_values(const results::RunResult& run);

}  // namespace talus::report
