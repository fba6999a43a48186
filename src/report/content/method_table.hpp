// SPDX-License-Identifier: MIT
#pragma once
// Factors of safety of all methods, as a table and as sentences of the answer.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/folder/result_folder.hpp"

namespace talus::report {

/// Returns the titles of all methods by their words: {"lem": "LEM", …}.
nlohmann::json list_method_titles();

/// Returns `MethodsRead` of web/src/contract/; null for a run of MPM only.
nlohmann::json read_methods(const ResultFolder& folder);

/// A factor of safety in the answer (`Factor` of web/src/contract/).
struct Factor {
  Method method = Method::mpm;
  std::string name;   ///< name in [[compare]]: "lem.noncircular.spencer"
  std::string title;  ///< such as "Spencer, critical circle"
  std::optional<double> value, lower, upper;
  std::string note;
  bool is_main = false;                           ///< the factor represents its method in the first sentence
  std::optional<input::WaterMotion> water;        ///< for MPM in wet ground
  std::optional<SliceMethod> slice_method;        ///< for LEM; nullopt for an optimised surface
  std::optional<results::SurfaceSource> source;   ///< for LEM and FEM
  std::optional<results::Flow> flow;              ///< for FEM
  std::optional<results::FactorMeasure> measure;  ///< for FEM
  std::optional<results::CriterionKind> by;       ///< for MPM
  bool is_extrapolated = false;                   ///< to zero element size
};

nlohmann::json to_json(const Factor& factor);

/// Returns the factors of LEM and FEM. Given and evaluated surfaces are included only if no critical surface was
/// searched or if one of them governs. One factor of each method is marked as main: of LEM the governing one, of FEM
/// the first. The main factor precedes the others of its method.
std::vector<Factor> list_other_factors(const results::RunResult& run);

/// Returns a sentence such as "The factor of safety is 1.441 by LEM (Spencer, critical circle) and 1.398 by FEM
/// (…)."; empty if no method found a factor. `factors` are those of all methods.
std::string format_main_factors(const results::RunResult& run, const std::vector<Factor>& factors);

/// Returns the sentence on the interval of limit analysis for the factors of LEM, with tension up to the apex;
/// empty if no interval was computed.
std::string format_referee(const results::RunResult& run);

/// Returns a sentence such as "For ψ = φ the factor of safety lies between 1.432 and 1.446 by limit analysis."; empty
/// without limit analysis.
std::string format_proven(const results::RunResult& run);

/// Returns the sentence on the differences between the main factors and the part of them that is due to the flow rule
/// or the mesh; empty for fewer than two factors.
std::string format_agreement(const std::vector<Factor>& factors);

/// Returns true if the factors are based on design values by partial factors.
bool has_design_values(const results::RunResult& run);

}  // namespace talus::report
