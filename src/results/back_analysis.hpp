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
void describe(auto& v, As<BackAnalysisRun> auto& r) {
  v.key("value", r.value, {"", "value of the key"});
  v.key("result", r.result, {"", "result of the run"});
  v.key("lower", r.lower, {"", "lower end of its interval"});
  v.key("upper", r.upper, {"", "upper end of its interval"});
  v.key("by", r.by, {"", "method that governs"});
}

/// Two neighbouring values with results on either side of the target.
struct BackAnalysisBracket {
  double low = 0, high = 0, low_result = 0, high_result = 0;
};
void describe(auto& v, As<BackAnalysisBracket> auto& r) {
  v.key("low", r.low, {"", "smaller value of the key"});
  v.key("high", r.high, {"", "larger value of the key"});
  v.key("low_result", r.low_result, {"", "result at the smaller value"});
  v.key("high_result", r.high_result, {"", "result at the larger value"});
}

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
void describe(auto& v, As<BackAnalysisTarget> auto& r) {
  v.key("result", r.result, {"", "name of the result"});
  v.key("title", r.title, {"", "title of the result"});
  v.key("result_unit", r.result_unit, {"", "unit of the result"});
  v.key("column", r.column, {"", "column of the result"});
  v.key("target", r.target, {"", "target of the result"});
  v.key("end", r.end, {"", "how the search ended"});
  v.key("value", r.value, {"", "value of the key at the target"});
  v.key("low", r.low, {"", "smallest value that the interval of the result allows"});
  v.key("high", r.high, {"", "largest value that the interval of the result allows"});
  v.key("interval_of", r.interval_of, {"", "source of the interval"});
  v.key("runs", r.runs, {"", "runs"});
}

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
void describe(auto& v, As<BackAnalysis> auto& r) {
  v.key("key", r.key, {"", "key"});
  v.key("unit", r.unit, {"", "unit of the key"});
  v.key("is_whole", r.is_whole, {"", "the key is a whole number, searched by steps of 1"});
  v.key("result", r.result, {"", "name of the result"});
  v.key("title", r.title, {"", "title of the result"});
  v.key("result_unit", r.result_unit, {"", "unit of the result"});
  v.key("column", r.column, {"", "column of the result"});
  v.key("target", r.target, {"", "target of the result"});
  v.key("tolerance", r.tolerance, {"", "largest relative width of the bracket"});
  v.key("present", r.present, {"", "value of the key in the case"});
  v.key("end", r.end, {"", "how the search ended"});
  v.key("value", r.value, {"", "value of the key at the target"});
  v.maybe("bracket", r.bracket, {"", "bracket of the value"});
  v.key("low", r.low, {"", "smallest value that the interval of the result allows"});
  v.key("high", r.high, {"", "largest value that the interval of the result allows"});
  v.key("interval_of", r.interval_of, {"", "source of the interval"});
  v.key("others", r.others, {"", "further brackets"});
  v.key("further", r.further, {"", "further targets of the same key"});
  v.key("sentences", r.sentences, {"", "the outcome in words"});
  v.key("runs", r.runs, {"", "runs"});
}

}  // namespace talus::results
