// SPDX-License-Identifier: MIT
#pragma once
// Bracketed search for the argument at which a function reaches a target. The function may be non-monotone, may jump,
// may have an interval around each value, and may be undefined for some arguments. Arguments are real or whole numbers.

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "results/back_analysis.hpp"

namespace talus::study {

/// The function at one argument.
struct Sample {
  double x = 0;
  std::optional<double> y;             ///< nullopt: undefined
  std::optional<double> lower, upper;  ///< interval of y
  double resolution = 0;               ///< smaller differences of y are not significant
};

/// Limits of the arguments.
struct SearchRange {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;  ///< the limit itself is excluded

  bool holds(double x) const { return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high); }
};

struct RootOptions {
  double target = 1;
  double tolerance = 1e-3;      ///< largest width of the bracket relative to the argument
  std::optional<double> start;  ///< without `is_given`: the search expands from here
  double step = 0;              ///< first step of the expansion
  SearchRange range;
  bool is_given = false;  ///< `range` is the bracket of the user, and both limits are arguments
};

/// Result of a search; words are those of results::BackAnalysis.
struct RootFinding {
  results::BackAnalysisEnd end = results::BackAnalysisEnd::no_result;
  std::optional<double> x;
  std::optional<results::BackAnalysisBracket> bracket;
  std::vector<results::BackAnalysisBracket> others;
  std::optional<double> low, high;         ///< x beyond which the interval of y excludes the target
  std::vector<Sample> samples;             ///< in ascending order
  std::optional<double> largest_reversal;  ///< change of y against its trend, if it exceeds scatter and resolution
};

using Evaluate = std::function<Sample(double x)>;

/// Runs of an expansion in one direction. Steps double.
inline constexpr int most_expansions = 16;
/// Steps away from the target in succession that end the expansion in one direction.
inline constexpr int most_recessions = 3;
/// Undefined arguments inside one bracket.
inline constexpr int most_gaps = 5;

/// Searches the root and the ends of its interval. Calls `evaluate` once for each argument; what it throws ends the
/// search.
RootFinding search_root(const RootOptions& options, const Evaluate& evaluate);

/// Searches two whole numbers in succession between which the function crosses the target, by doubled steps and
/// bisection. The root is the one whose value is at least the target. Calls `evaluate` once for each number; what it
/// throws ends the search.
RootFinding search_whole_number(const RootOptions& options, const Evaluate& evaluate);

/// Returns the largest change of the values against their trend, if it exceeds scatter and resolution. Samples are in
/// ascending order.
std::optional<double> find_reversal(const std::vector<Sample>& samples, double trend, double target);
/// Returns how a search without a crossing ended.
results::BackAnalysisEnd judge_missing_root(const std::vector<Sample>& samples, double target);

/// Returns the number with the fewest digits that differs from `x` by at most `tolerance`.
double round_within(double x, double tolerance);

}  // namespace talus::study
