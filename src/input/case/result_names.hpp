// SPDX-License-Identifier: MIT
#pragma once
// Names of the results of a case, for [[compare]] and for `results` of summary.json.

#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "results/named.hpp"

namespace talus::input {

/// Returns the stage at whose start the time of onset and sections is zero; nullptr without stages.
const Stage* find_clock_stage(const Case& data);

/// Lists all results of the case in the order of the report, except those of single trials of the curve; values are
/// placeholders.
std::vector<results::NamedValue> list_result_names(const Case& data);

/// Returns the factor in "curve.displacement[1.45]"; std::nullopt for another name.
std::optional<double> find_trial_factor(const std::string& name);

/// A result of an element test: "test[cell 100].q[0.1]" at axial strain 0.1 (in simple shear: shear strain), "test[cell
/// 100].q" in the last row, or "test[cell 100].peak_q".
struct PointResultName {
  std::string test, quantity;
  std::optional<double> strain;
};

/// Returns std::nullopt for another name.
std::optional<PointResultName> find_point_result_name(const std::string& name);

/// Returns the result `name`, including those of a trial of the curve; std::nullopt if the case does not yield it.
std::optional<results::NamedValue> find_result_name(const Case& data, const std::string& name);

/// Returns "did you mean 'lem.spencer'?", or "it yields …" with all names, for a result that the case does not yield.
std::string suggest_result(const Case& data, const std::string& name);

/// Returns the result `name` of the case with additional calculations, so that a [[compare]] stays valid if --set or a
/// study leaves one out; std::nullopt if no such case yields it.
std::optional<results::NamedValue> find_possible_name(const Case& data, const std::string& name);

}  // namespace talus::input
