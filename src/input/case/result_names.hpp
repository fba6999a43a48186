// SPDX-License-Identifier: MIT
#pragma once
// Names of the numbers that a case yields: what [[compare]] may name, and how `results` of summary.json is labelled.

#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "results/named.hpp"

namespace talus::input {

/// The stage at whose start the clock of onset and sections is zero; nullptr for a case without stages.
const Stage* find_clock_stage(const Case& data);

/// All results that the case yields, in the order of the report, without those of single trials of the curve; their
/// values are placeholders.
std::vector<results::NamedValue> list_result_names(const Case& data);

/// The factor of "curve.displacement[1.45]"; nothing for another name.
std::optional<double> find_trial_factor(const std::string& name);

/// A result of an element test: "test[cell 100].q[0.1]", of the row at axial strain 0.1 (of simple shear: shear
/// strain), "test[cell 100].q" of the last row, "test[cell 100].peak_q".
struct PointResultName {
  std::string test, quantity;
  std::optional<double> strain;
};

/// Nothing for another name.
std::optional<PointResultName> find_point_result_name(const std::string& name);

/// The result called `name`, also of a trial of the curve; nothing when the case does not yield it.
std::optional<results::NamedValue> find_result_name(const Case& data, const std::string& name);

/// The result called `name` of the same case with more calculations, so that a [[compare]] stays valid when --set or a
/// study leaves one out. Nothing when no such case yields it.
std::optional<results::NamedValue> find_possible_name(const Case& data, const std::string& name);

}  // namespace talus::input
