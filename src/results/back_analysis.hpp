// SPDX-License-Identifier: MIT
#pragma once
// Results of a back-analysis, "back_analysis" of study.json: the value of a key at which a result reaches its target,
// with all runs of the search.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "results/about.hpp"

namespace talus::results {

/// One run of the search. Values are in the unit of the key, results in the unit of the target.
struct BackAnalysisRun {
  double value = 0;
  std::optional<double> result, lower, upper;  ///< nullopt: no result, no interval
  std::string by;                              ///< method that governs; empty for other results than the main factor
};
void describe(Visitor& v, BackAnalysisRun& r);

/// Two neighbouring values with results on either side of the target.
struct BackAnalysisBracket {
  double low = 0, high = 0, low_result = 0, high_result = 0;
};
void describe(Visitor& v, BackAnalysisBracket& r);

enum class BackAnalysisEnd { found, jump, gap, not_reached, no_effect, no_result, interrupted };
template <>
inline constexpr auto words<BackAnalysisEnd> =
    std::array{"found", "jump", "gap", "not reached", "no effect", "no result", "interrupted"};

/// A further target of the same key, with the results of the runs for it.
struct BackAnalysisTarget {
  std::string result, title, result_unit, column;
  double target = 0;
  BackAnalysisEnd end = BackAnalysisEnd::interrupted;
  std::optional<double> value, low, high;  ///< as in BackAnalysis
  std::string interval_of;
  std::vector<BackAnalysisRun> runs;
};
void describe(Visitor& v, BackAnalysisTarget& r);

struct BackAnalysis {
  std::string key, unit;                   ///< varied key
  bool is_whole = false;                   ///< it is a whole number; `value` has at least the target
  std::string result, title, result_unit;  ///< name, title and unit of the result
  std::string column;                      ///< name of the column of the result in the table of the study
  double target = 0, tolerance = 0;        ///< tolerance: relative width of the bracket
  std::optional<double> present;           ///< value of the key in the case
  BackAnalysisEnd end = BackAnalysisEnd::interrupted;
  std::optional<double> value;                 ///< if `end` is found: by linear interpolation in the bracket, or whole
  std::optional<BackAnalysisBracket> bracket;  ///< the narrowest one
  std::optional<double> low, high;             ///< values beyond which the interval of the result excludes the target
  std::string interval_of;                     ///< source of the interval; empty without one
  std::vector<BackAnalysisBracket> others;     ///< further brackets: the result is not monotone
  std::vector<BackAnalysisTarget> further;     ///< further targets, whose values stand beside this one
  std::vector<std::string> sentences;          ///< the outcome in words
  std::vector<BackAnalysisRun> runs;           ///< in the order of calculation, as the variants of the study
};
void describe(Visitor& v, BackAnalysis& r);

}  // namespace talus::results
