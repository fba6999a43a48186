#pragma once
// The numbers of a run under the names of input/case/result_names.hpp, and how they compare with what the case expects.

#include <nlohmann/json.hpp>
#include <optional>

#include "input/case/case.hpp"

namespace talus::run {

/// The result `name` of the run that `summary` tells about [SI]; nothing when the run did not come to it. The
/// displacement of a trial that was not calculated is interpolated between its neighbours on the curve.
std::optional<double> find_result(const nlohmann::json& summary, const std::string& name);

/// All results that the run came to: [{name, title, value, unit: {name, si}}]. `value` is SI, `unit` says how it is
/// shown.
nlohmann::json list_results(const input::Case& data, const nlohmann::json& summary);

/// The case's [[compare]], each with the computed value, the tolerance in SI, and whether it passes.
nlohmann::json compare_results(const input::Case& data, const nlohmann::json& summary);

}  // namespace talus::run
