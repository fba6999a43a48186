// SPDX-License-Identifier: MIT
#pragma once
// The outcome of a back-analysis in sentences, and its columns in the table of the runs.

#include <optional>
#include <string>
#include <vector>

#include "results/study.hpp"

namespace talus::study {

/// Formats a number with its unit.
std::string write_amount(double value, const std::string& unit, int digits = 6);

/// A value of the key without a result, and the reason.
struct MissingResult {
  double value = 0;
  std::string reason;
};

/// Returns the sentences on the outcome: value, bracket, interval, further brackets, runs without a result. `reversal`
/// is the largest change of the result against its trend.
std::vector<std::string> describe_outcome(const results::BackAnalysis& finding, std::optional<double> reversal,
                                          const std::vector<MissingResult>& missing);

/// Returns a Markdown table of all targets with the value of the key at each; empty for a single one.
std::string write_targets(const results::BackAnalysis& finding);

/// Inserts the interval of the result and the governing method into the table, after the column of the result, which is
/// added after the key if the table does not have it.
void add_back_analysis(const results::BackAnalysis& finding, std::vector<results::StudyColumn>& table);

}  // namespace talus::study
