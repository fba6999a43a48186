// SPDX-License-Identifier: MIT
#include "study/back_analysis_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace talus::study {

using results::BackAnalysis;
using results::BackAnalysisBracket;
using results::BackAnalysisEnd;
using results::BackAnalysisRun;
using results::StudyCell;
using results::StudyColumn;

std::string write_amount(double value, const std::string& unit, int digits) {
  return fmt::format("{:.{}g}{}{}", value, digits, unit.empty() ? "" : " ", unit);
}

namespace {

/// Further runs without a result are counted only.
constexpr std::size_t most_missing = 3;

/// Writes the sentences of one outcome.
class Outcome {
 public:
  explicit Outcome(const BackAnalysis& finding)
      : f_(finding), digits_(2 + static_cast<int>(std::ceil(-std::log10(finding.tolerance)))) {}

  std::string write_end() const {
    switch (f_.end) {
      case BackAnalysisEnd::found:
        if (f_.is_whole) return write_whole();
        return fmt::format("At {} = {} {} is {}{}.", f_.key, key(*f_.value), title(), result(f_.target), present());
      case BackAnalysisEnd::jump:
        return fmt::format(
            "{} jumps over {} between {}: a run with exactly this result does not exist, and another mechanism "
            "probably governs beyond.",
            start(), result(f_.target), bracket(*f_.bracket));
      case BackAnalysisEnd::gap:
        return fmt::format("{} reaches {} between {}, where runs have no result.", start(), result(f_.target),
                           bracket(*f_.bracket));
      case BackAnalysisEnd::not_reached:
        return write_ends(fmt::format("{} {}", f_.is_whole && is_exceeded() ? "is everywhere above" : "does not reach",
                                      result(f_.target)));
      case BackAnalysisEnd::no_effect:
        return fmt::format("{} does not depend on {}: it is {} {}.", start(), f_.key, result(*first()->result), span());
      case BackAnalysisEnd::no_result:
        return fmt::format("No run has the result '{}'.", f_.result);
      default:
        return fmt::format("The search was interrupted after {} runs; --resume continues it.", f_.runs.size());
    }
  }

  std::string write_bracket() const {
    if (f_.is_whole) return fmt::format("Only whole numbers were tried, in {} runs.", f_.runs.size());
    if (f_.bracket->low == f_.bracket->high) return "The run with this value has the target exactly.";
    return fmt::format("It is interpolated between {}, after {} runs.", bracket(*f_.bracket), f_.runs.size());
  }

  std::string write_interval() const {
    if (f_.interval_of.empty())
      return "The result has no interval: the bracket is that of the search, and does not include the error of the "
             "model.";
    const std::string of = fmt::format("The interval of the result ({})", f_.interval_of);
    if (f_.low && f_.high) return fmt::format("{} allows values from {} to {}.", of, key(*f_.low), key(*f_.high));
    if (f_.low)
      return fmt::format("{} allows values from {} upwards; its other end was not reached.", of, key(*f_.low));
    if (f_.high) return fmt::format("{} allows values up to {}; its other end was not reached.", of, key(*f_.high));
    return of + " excludes no value that was tried.";
  }

  std::string write_other(const BackAnalysisBracket& other) const {
    return fmt::format("The target is also crossed between {}.", bracket(other));
  }

  std::string write_reversal(double reversal) const {
    return fmt::format(
        "The result is not monotone: it changes by up to {} against its trend, so further values may reach the target.",
        write_amount(reversal, f_.result_unit, 2));
  }

  std::string write_missing(const MissingResult& missing) const {
    return fmt::format("{} = {} has no result: {}", f_.key, key(missing.value), missing.reason);
  }

 private:
  /// The result within a sentence and at its start.
  std::string title() const { return f_.result == "main_factor" ? "the " + f_.title : "'" + f_.result + "'"; }
  std::string start() const { return f_.result == "main_factor" ? "The " + f_.title : title(); }
  std::string key(double value) const { return write_amount(value, f_.unit, digits_); }
  std::string result(double value) const { return write_amount(value, f_.result_unit, 5); }
  std::string bracket(const BackAnalysisBracket& b) const {
    return fmt::format("{} ({}) and {} ({})", key(b.low), result(b.low_result), key(b.high), result(b.high_result));
  }

  /// Names the smallest or largest whole number that meets the target, and its neighbour that does not.
  std::string write_whole() const {
    const bool is_low = *f_.value == f_.bracket->low;
    const double mine = is_low ? f_.bracket->low_result : f_.bracket->high_result,
                 other = is_low ? f_.bracket->high_result : f_.bracket->low_result;
    return fmt::format("The {} number with at least {} is {} = {}: {} is {} there, and {} at {}{}.",
                       is_low ? "largest" : "smallest", result(f_.target), f_.key, key(*f_.value), title(),
                       result(mine), result(other), key(is_low ? f_.bracket->high : f_.bracket->low),
                       f_.present == f_.bracket->low || f_.present == f_.bracket->high ? "" : present());
  }

  /// Returns true if every run with a result is above the target.
  bool is_exceeded() const {
    return std::all_of(f_.runs.begin(), f_.runs.end(),
                       [&](const BackAnalysisRun& run) { return run.result.value_or(f_.target + 1) > f_.target; });
  }

  std::string present() const {
    for (const BackAnalysisRun& run : f_.runs)
      if (f_.present && run.value == *f_.present && run.result && run.value != *f_.value)
        return fmt::format(" ({} at the value of the case, {})", result(*run.result), key(run.value));
    return "";
  }

  /// Runs with the smallest and the largest value of the key that have a result.
  const BackAnalysisRun* first() const {
    return find_end([](double a, double b) { return a < b; });
  }
  const BackAnalysisRun* last() const {
    return find_end([](double a, double b) { return a > b; });
  }
  template <class Before>
  const BackAnalysisRun* find_end(Before before) const {
    const BackAnalysisRun* found = nullptr;
    for (const BackAnalysisRun& run : f_.runs)
      if (run.result && (found == nullptr || before(run.value, found->value))) found = &run;
    return found;
  }

  std::string span() const { return fmt::format("from {} to {}", key(first()->value), key(last()->value)); }

  std::string write_ends(const std::string& what) const {
    const BackAnalysisRun *low = first(), *high = last(), *nearest = low;
    for (const BackAnalysisRun& run : f_.runs)
      if (run.result && std::abs(*run.result - f_.target) < std::abs(*nearest->result - f_.target)) nearest = &run;
    if (low == high)
      return fmt::format("{} {}: it is {} at {} = {}, and no other run has a result.", start(), what,
                         result(*low->result), f_.key, key(low->value));
    std::string text = fmt::format("{} {}: it is {} at {} = {} and {} at {}", start(), what, result(*low->result),
                                   f_.key, key(low->value), result(*high->result), key(high->value));
    if (nearest->value != low->value && nearest->value != high->value)
      text += fmt::format(", and nearest to it with {} at {}", result(*nearest->result), key(nearest->value));
    return text + ".";
  }

  const BackAnalysis& f_;
  int digits_;
};

}  // namespace

std::vector<std::string> describe_outcome(const BackAnalysis& finding, std::optional<double> reversal,
                                          const std::vector<MissingResult>& missing) {
  const Outcome outcome(finding);
  std::vector<std::string> sentences{outcome.write_end()};
  if (finding.end == BackAnalysisEnd::found) {
    sentences.push_back(outcome.write_bracket());
    if (!finding.is_whole) sentences.push_back(outcome.write_interval());
  }
  for (const BackAnalysisBracket& other : finding.others) sentences.push_back(outcome.write_other(other));
  if (reversal) sentences.push_back(outcome.write_reversal(*reversal));
  for (std::size_t i = 0; i < std::min(missing.size(), most_missing); ++i)
    sentences.push_back(outcome.write_missing(missing[i]));
  if (missing.size() > most_missing)
    sentences.push_back(fmt::format("{} further runs have no result.", missing.size() - most_missing));
  return sentences;
}

std::string write_targets(const BackAnalysis& finding) {
  if (finding.further.empty()) return "";
  const int digits = 2 + static_cast<int>(std::ceil(-std::log10(finding.tolerance)));
  const auto write = [&](const std::optional<double>& value) {
    return value ? write_amount(*value, finding.unit, digits) : std::string("–");
  };
  const auto add = [&](const auto& t) {
    std::string interval = "–";
    if (t.low || t.high) interval = fmt::format("{} to {}", write(t.low), write(t.high));
    return fmt::format("| {} = {} | {} | {} |\n", t.result, write_amount(t.target, t.result_unit, 5),
                       t.value ? write(t.value) : results::to_word(t.end), interval);
  };
  std::string text = fmt::format("| target | {} | its interval allows |\n|---|--:|---|\n", finding.key);
  text += add(finding);
  for (const results::BackAnalysisTarget& t : finding.further) text += add(t);
  return text;
}

void add_back_analysis(const BackAnalysis& finding, std::vector<StudyColumn>& table) {
  const auto make = [](const auto& of, const std::string& name, const std::string& title, auto member) {
    StudyColumn made{name, title, of.result_unit, {}, results::ColumnKind::other, ""};
    for (const BackAnalysisRun& run : of.runs)
      made.cells.push_back(
          run.*member ? StudyCell{write_shortest(*(run.*member)), fmt::format("{:.4g}", *(run.*member))} : StudyCell{});
    return made;
  };
  const auto is_empty = [](const StudyColumn& c) {
    return std::all_of(c.cells.begin(), c.cells.end(), [](const StudyCell& cell) { return cell.full.empty(); });
  };
  const auto find = [&](const std::string& name) {
    return std::find_if(table.begin(), table.end(), [&](const StudyColumn& c) { return c.name == name; });
  };
  const auto need = [&](const auto& of) {
    if (const auto at = find(of.column); at != table.end()) return at;
    const auto key = find(finding.key);
    return table.insert(key == table.end() ? table.begin() : key + 1,
                        make(of, of.column, of.result, &BackAnalysisRun::result));
  };
  for (const results::BackAnalysisTarget& t : finding.further) need(t);
  auto at = need(finding);
  StudyColumn by{"governs", "governs", "", {}, results::ColumnKind::other, ""};
  for (const BackAnalysisRun& run : finding.runs) by.cells.push_back({run.by, run.by});
  StudyColumn lower = make(finding, "lower end", "lower end", &BackAnalysisRun::lower),
              upper = make(finding, "upper end", "upper end", &BackAnalysisRun::upper);
  ++at;
  for (StudyColumn* added : {&by, &upper, &lower})
    if (!is_empty(*added)) at = table.insert(at, std::move(*added));
}

}  // namespace talus::study
