// SPDX-License-Identifier: MIT
#include "input/case/missing_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/encoding.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"

namespace talus::input {
namespace {

/// A longer interval is a gap where this fraction of the intervals between rows is equal; and how much longer it is.
constexpr double regular = 0.8, longer = 1.5;
constexpr std::size_t least_intervals = 4;

[[noreturn]] void reject(const std::string& sentence) {
  throw Error(ExitCode::wrong_input, sentence);
}

/// The interval of a series that has a row in each; nothing where rows are as they come.
std::optional<double> find_interval(const std::vector<double>& times) {
  if (times.size() <= least_intervals) return std::nullopt;
  std::vector<double> intervals;
  for (std::size_t i = 1; i < times.size(); ++i) intervals.push_back(times[i] - times[i - 1]);
  std::vector<double> sorted = intervals;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double usual = *middle;
  const auto equal =
      std::count_if(intervals.begin(), intervals.end(), [&](double d) { return std::abs(d - usual) <= 0.01 * usual; });
  return static_cast<double>(equal) >= regular * static_cast<double>(intervals.size()) ? std::optional(usual)
                                                                                       : std::nullopt;
}

/// The value that fills row i; nothing where there is none to fill from.
std::optional<double> find_filling(const MeasuredColumn& column, std::size_t i, const std::string& fill) {
  if (fill == "zero") return 0.0;
  std::size_t before = i, after = i;
  while (before > 0 && !column.values[before]) --before;
  while (after + 1 < column.values.size() && !column.values[after]) ++after;
  if (!column.values[before]) return std::nullopt;
  if (fill == "previous") return column.values[before];
  if (!column.values[after]) return std::nullopt;
  const double share = (column.times[i] - column.times[before]) / (column.times[after] - column.times[before]);
  return *column.values[before] + share * (*column.values[after] - *column.values[before]);
}

}  // namespace

bool is_missing(const std::string& cell, double code) {
  std::string text = to_lower(cell);
  for (const char* word : {"", "nan", "na", "n/a", "null", "none", "-", "--", "---"})
    if (text == word) return true;
  if (text[0] != '-') return false;
  std::replace(text.begin(), text.end(), ',', '.');
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  const bool are_nines =
      text.size() > 1 && std::all_of(text.begin() + 1, text.end(), [](char c) { return c == '9' || c == '.'; });
  return are_nines && read_number(text) <= code;
}

void add_missing_rows(MeasuredColumn& column) {
  const std::optional<double> interval = find_interval(column.times);
  if (!interval) return;
  MeasuredColumn whole;
  for (std::size_t i = 0; i < column.times.size(); ++i) {
    whole.times.push_back(column.times[i]);
    whole.values.push_back(column.values[i]);
    whole.rows.push_back(column.rows[i]);
    if (i + 1 == column.times.size()) break;
    const double gap = column.times[i + 1] - column.times[i];
    const int missing = gap > longer * *interval ? std::max(1, static_cast<int>(std::lround(gap / *interval)) - 1) : 0;
    for (int k = 1; k <= missing; ++k) {
      whole.times.push_back(column.times[i] + gap * k / (missing + 1));
      whole.values.emplace_back();
      whole.rows.push_back(column.rows[i]);
    }
  }
  column = std::move(whole);
}

std::vector<double> fill_missing(const TextTable& table, const std::string& name, const std::string& fill,
                                 const MeasuredColumn& column, std::string& note) {
  std::vector<double> values;
  std::size_t count = 0, first = 0;
  for (std::size_t i = 0; i < column.values.size(); ++i)
    if (!column.values[i] && count++ == 0) first = i;
  const auto format_first = [&] {
    const bool is_row = first > 0 && column.rows[first] == column.rows[first - 1];
    return fmt::format("{}: {}", table.place(column.rows[first]),
                       is_row ? "the rows after it are missing" : fmt::format("no value of '{}'", name));
  };
  if (count > 0 && fill.empty())
    reject(
        fmt::format("{}; {} of {} values are missing. Correct the table, or write fill = \"zero\", \"previous\" or "
                    "\"linear\" beside 'column'",
                    format_first(), count, column.values.size()));
  for (std::size_t i = 0; i < column.values.size(); ++i) {
    const auto value = column.values[i] ? column.values[i] : find_filling(column, i, fill);
    if (!value)
      reject(fmt::format("{}: fill = \"{}\" has no value {} it", table.place(column.rows[i]), fill,
                         fill == "previous" ? "before" : "on both sides of"));
    values.push_back(*value);
  }
  if (count > 0)
    note = fmt::format("{} of {} values of '{}' in '{}' are missing and were filled with fill = \"{}\"; the first: {}",
                       count, column.values.size(), name, table.file(), fill, format_first());
  return values;
}

}  // namespace talus::input
