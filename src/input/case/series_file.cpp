// SPDX-License-Identifier: MIT
#include "input/case/series_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/units.hpp"

namespace talus::input {

namespace {

/// If this fraction of the intervals between rows is equal, an interval longer by the second factor is a gap.
constexpr double regular = 0.8, longer = 1.5;
constexpr std::size_t least_intervals = 4;

/// Returns the sampling interval of a regular series; std::nullopt for an irregular one.
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

/// Returns the value that fills row i; std::nullopt if there is no value to fill from.
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
    fail_input(
        "{}; {} of {} values are missing. Correct the table, or write fill = \"zero\", \"previous\" or \"linear\" "
        "beside 'column'",
        format_first(), count, column.values.size());
  for (std::size_t i = 0; i < column.values.size(); ++i) {
    const auto value = column.values[i] ? column.values[i] : find_filling(column, i, fill);
    if (!value)
      fail_input("{}: fill = \"{}\" has no value {} it", table.place(column.rows[i]), fill,
                 fill == "previous" ? "before" : "on both sides of");
    values.push_back(*value);
  }
  if (count > 0)
    note = fmt::format("{} of {} values of '{}' in '{}' are missing and were filled with fill = \"{}\"; the first: {}",
                       count, column.values.size(), name, table.file(), fill, format_first());
  return values;
}

namespace {

/// A series of the case and the dimension of its values.
struct Wanted {
  std::string path;  ///< "hydraulic.0.rate"
  TimeTable& table;
  SeriesShape* shape;  ///< null: measurements, which have none
  const char* unit;    ///< SI: "m", "Pa", "m/s"
  bool positive_only;  ///< negative values are invalid
};

std::vector<Wanted> list_series(Case& data) {
  std::vector<Wanted> all;
  const auto add = [&](const std::string& path, TimeTable& table, SeriesShape* shape, const char* unit, bool positive) {
    if (table.source) all.push_back({path, table, shape, unit, positive});
  };
  for (std::size_t i = 0; i < data.hydraulics.size(); ++i) {
    Hydraulic& h = data.hydraulics[i];
    const std::string path = fmt::format("hydraulic.{}", i);
    add(path + ".head", h.head, &h.series, "m", false);
    add(path + ".pressure", h.pressure, &h.series, "Pa", false);
    add(path + ".rate", h.rate, &h.series, "m/s", false);
  }
  for (std::size_t i = 0; i < data.roots.size(); ++i)
    if (auto& t = data.roots[i].transpiration)
      add(fmt::format("roots.{}.transpiration.rate", i), t->rate, &t->series, "m/s", true);
  for (std::size_t i = 0; i < data.output.monitors.size(); ++i) {
    Monitor& m = data.output.monitors[i];
    const std::string path = fmt::format("output.monitor.{}.measured_", i);
    add(path + "settlement", m.settlement, nullptr, "m", false);
    add(path + "lateral", m.lateral, nullptr, "m", false);
    add(path + "pressure", m.pressure, nullptr, "Pa", false);
  }
  return all;
}

/// Returns the times of the rows [s], which must increase. A column `date` requires the date of time 0.
std::vector<double> read_times(const TextTable& table, const std::optional<Date>& zero) {
  const bool dated = table.has_column("date");
  if (!dated && !table.has_column("time")) fail_input("'{}' has no column 'date' and no column 'time'", table.file());
  const std::size_t column = table.find_column(dated ? "date" : "time");
  const std::string& unit = table.header()[column].unit;
  if (dated && !zero) fail_input("'{}' has dates: [initial] date must say which one is time 0", table.file());
  if (!dated && unit.empty())
    fail_input("the column 'time' of '{}' has no unit; head it 'time [h]' or 'time [day]'", table.file());
  const double second = dated ? 1 : units::parse_as_si("1 " + unit, "s", "time");
  std::vector<double> times;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (dated) {
      const std::string& text = table.cell(i, column);
      const auto date = parse_date(text);
      if (!date) fail_input("{}: '{}' is no date; write it as 2023-07-01 or 2023-07-01 06:00", table.place(i), text);
      times.push_back(*date - zero->seconds);
    } else {
      times.push_back(second * table.number(i, column));
    }
    if (i > 0 && times[i] <= times[i - 1])
      fail_input("{}: its {} is not after that of the row before", table.place(i), dated ? "date" : "time");
  }
  return times;
}

/// Reads a column, in the SI unit of its own dimension, at the times of its rows. `is_amount` is set if the values are
/// amounts, i.e. lengths where rates are wanted.
MeasuredColumn read_column(const TextTable& table, const std::vector<double>& times, const std::string& name,
                           const std::string& wanted, bool& is_amount) {
  const std::size_t column = table.find_column(name);
  const std::string& unit = table.header()[column].unit;
  const char* example = wanted == "m/s" ? "mm" : wanted == "Pa" ? "kPa" : "m";
  if (unit.empty())
    fail_input("the column '{0}' of '{1}' has no unit; head it '{0} [{2}]'", name, table.file(), example);
  is_amount = wanted == "m/s" && units::get_dimension_name(unit) == units::get_dimension_name("m");
  const double factor = units::parse_as_si("1 " + unit, is_amount ? "m" : wanted,
                                           fmt::format("the column '{}' of '{}'", name, table.file()));
  const double code = wanted == "Pa" ? -999 : -99;
  MeasuredColumn read{times, {}, {}};
  for (std::size_t i = 0; i < table.rows(); ++i) {
    read.values.push_back(is_missing(table.cell(i, column), code) ? std::nullopt
                                                                  : std::optional(factor * table.number(i, column)));
    read.rows.push_back(i);
  }
  add_missing_rows(read);
  return read;
}

/// Converts amounts to rates, each constant from its row to the next.
void spread_amounts(const TextTable& table, std::vector<double>& times, std::vector<double>& values) {
  if (times.size() < 2)
    fail_input("'{}' has amounts and a single row, so that nothing says how long it lasts", table.file());
  times.push_back(2 * times.back() - times[times.size() - 2]);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] /= times[i + 1] - times[i];
  values.push_back(0);
}

void load(const Wanted& wanted, const std::filesystem::path& folder, const std::optional<Date>& zero,
          Findings& findings) {
  const SeriesFile source = *wanted.table.source;
  const TextTable table((folder / source.file).lexically_normal());
  if (table.rows() == 0) fail_input("the table '{}' has no row", table.file());
  const std::vector<double> rows = read_times(table, zero);
  bool is_amount = false;
  const MeasuredColumn column = read_column(table, rows, source.column, wanted.unit, is_amount);
  std::vector<double> times = column.times;
  std::string note;
  std::vector<double> values = fill_missing(table, source.column, source.fill, column, note);
  if (!note.empty()) findings.warn(wanted.path, note);
  if (!source.minus.empty()) {
    bool is_other_amount = false;
    const MeasuredColumn other = read_column(table, rows, source.minus, wanted.unit, is_other_amount);
    note.clear();
    const std::vector<double> less = fill_missing(table, source.minus, source.fill, other, note);
    if (!note.empty()) findings.warn(wanted.path, note);
    if (is_amount != is_other_amount)
      fail_input("'{}' and '{}' of '{}' have different dimensions", source.column, source.minus, table.file());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= less[i];
  }
  if (wanted.positive_only)
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] < 0) fail_input("{}: '{}' is below zero", table.place(column.rows[i]), source.column);
  if (is_amount) {
    spread_amounts(table, times, values);
    *wanted.shape = SeriesShape::steps;
  }
  wanted.table = {std::move(times), std::move(values)};
}

/// Reports a file that does not cover the whole time span: the series would be constant beyond its ends.
void check_span(const Case& data, const Wanted& wanted, const std::string& file, Findings& findings) {
  const double from = -data.initial.water.season, to = data.timeline ? data.timeline->duration : 0;
  const auto say = [&](double t) {
    return data.initial.date ? format_date(data.initial.date->seconds + t) : units::format_time(t);
  };
  if (const double first = wanted.table.time.front(); first > from)
    findings.add(wanted.path, "'{}' begins at {}, after {}, where the water is first asked for", file, say(first),
                 say(from));
  if (const double last = wanted.table.time.back(); last < to)
    findings.add(wanted.path, "'{}' ends at {}, before {}, where the timeline ends", file, say(last), say(to));
}

/// Converts times that are given as dates to times relative to time 0.
void find_moments(Case& data, Findings& findings) {
  if (!findings.is_sound("initial.date")) return;
  Timeline& timeline = *data.timeline;
  const auto is_dated = [&](const std::string& path, const char* what) {
    if (!data.initial.date) findings.add(path, "{} needs [initial] date, the date of time 0", what);
    return data.initial.date.has_value();
  };
  const auto since_start = [&](const Date& date) { return date.seconds - data.initial.date->seconds; };
  if (!timeline.dates.empty() && is_dated("timeline.dates", "a list of dates"))
    for (const Date& date : timeline.dates) timeline.times.push_back(since_start(date));
  if (timeline.element_dates && is_dated("timeline.element_dates", "a list of dates")) {
    timeline.element_times.emplace();
    for (const Date& date : *timeline.element_dates) timeline.element_times->push_back(since_start(date));
  }
  if (timeline.release && timeline.release->date && is_dated("timeline.release.date", "a date"))
    timeline.release->time = since_start(*timeline.release->date);
  timeline.dates.clear();
  timeline.element_dates.reset();
  if (timeline.release) timeline.release->date.reset();
}

void find_duration(Case& data, Findings& findings) {
  if (!data.timeline || !data.timeline->until || !findings.is_sound("timeline.until") ||
      !findings.is_sound("initial.date"))
    return;
  Timeline& timeline = *data.timeline;
  if (!data.initial.date)
    return findings.add("timeline.until", "a timeline that ends at a date needs [initial] date, the date of time 0");
  timeline.duration = timeline.until->seconds - data.initial.date->seconds;
  if (timeline.duration <= 0)
    findings.add("timeline.until", "the timeline ends at {}, not after time 0, {}",
                 format_date(timeline.until->seconds), format_date(data.initial.date->seconds));
  timeline.until.reset();
}

}  // namespace

void load_series(Case& data, const std::string& file, Findings& findings) {
  find_duration(data, findings);
  if (data.timeline) find_moments(data, findings);
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  for (const Wanted& wanted : list_series(data)) {
    const std::string table = wanted.table.source->file;
    try {
      load(wanted, folder, data.initial.date, findings);
      if (wanted.shape && findings.is_sound("timeline")) check_span(data, wanted, table, findings);
    } catch (const Error& error) {
      findings.add(wanted.path, error.what());
      wanted.table = {{0}, {0}};
    }
  }
}

}  // namespace talus::input
