// SPDX-License-Identifier: MIT
#include "results/back_analysis.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, BackAnalysisRun& r) {
  v.key("value", r.value, {"", "value of the key"});
  v.key("result", r.result, {"", "result of the run"});
  v.key("lower", r.lower, {"", "lower end of its interval"});
  v.key("upper", r.upper, {"", "upper end of its interval"});
  v.key("by", r.by, {"", "method that governs"});
}

void describe(Visitor& v, BackAnalysisBracket& r) {
  v.key("low", r.low, {"", "smaller value of the key"});
  v.key("high", r.high, {"", "larger value of the key"});
  v.key("low_result", r.low_result, {"", "result at the smaller value"});
  v.key("high_result", r.high_result, {"", "result at the larger value"});
}

void describe(Visitor& v, BackAnalysisTarget& r) {
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

void describe(Visitor& v, BackAnalysis& r) {
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
