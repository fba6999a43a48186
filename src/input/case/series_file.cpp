// SPDX-License-Identifier: MIT
#include "input/case/series_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/dates.hpp"
#include "base/error.hpp"
#include "base/units.hpp"
#include "input/case/missing_values.hpp"

namespace talus::input {
namespace {

/// A series of the case, and what its values are.
struct Wanted {
  std::string path;  ///< "hydraulic.0.rate"
  TimeTable& table;
  SeriesShape& shape;
  const char* unit;    ///< SI: "m", "Pa", "m/s"
  bool positive_only;  ///< values below zero have no meaning
};

std::vector<Wanted> list_series(Case& data) {
  std::vector<Wanted> all;
  const auto add = [&](const std::string& path, TimeTable& table, SeriesShape& shape, const char* unit, bool positive) {
    if (table.source) all.push_back({path, table, shape, unit, positive});
  };
  for (std::size_t i = 0; i < data.hydraulics.size(); ++i) {
    Hydraulic& h = data.hydraulics[i];
    const std::string path = fmt::format("hydraulic.{}", i);
    add(path + ".head", h.head, h.series, "m", false);
    add(path + ".pressure", h.pressure, h.series, "Pa", false);
    add(path + ".rate", h.rate, h.series, "m/s", false);
  }
  for (std::size_t i = 0; i < data.roots.size(); ++i)
    if (auto& t = data.roots[i].transpiration)
      add(fmt::format("roots.{}.transpiration.rate", i), t->rate, t->series, "m/s", true);
  return all;
}

/// The times of the rows [s], increasing. A column `date` needs the date of time 0.
std::vector<double> read_times(const TextTable& table, const std::optional<Date>& zero) {
  const bool dated = table.has_column("date");
  if (!dated && !table.has_column("time"))
    reject(fmt::format("'{}' has no column 'date' and no column 'time'", table.file()));
  const std::size_t column = table.find_column(dated ? "date" : "time");
  const std::string& unit = table.header()[column].unit;
  if (dated && !zero) reject(fmt::format("'{}' has dates: [initial] date must say which one is time 0", table.file()));
  if (!dated && unit.empty())
    reject(fmt::format("the column 'time' of '{}' has no unit; head it 'time [h]' or 'time [day]'", table.file()));
  const double second = dated ? 1 : units::parse_as_si("1 " + unit, "s", "time");
  std::vector<double> times;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (dated) {
      const std::string& text = table.cell(i, column);
      const auto date = parse_date(text);
      if (!date)
        reject(fmt::format("{}: '{}' is no date; write it as 2023-07-01 or 2023-07-01 06:00", table.place(i), text));
      times.push_back(*date - zero->seconds);
    } else {
      times.push_back(second * table.number(i, column));
    }
    if (i > 0 && times[i] <= times[i - 1])
      reject(fmt::format("{}: its {} is not after that of the row before", table.place(i), dated ? "date" : "time"));
  }
  return times;
}

/// The values of a column in the SI unit of its own dimension at the times of its rows, and whether they are amounts:
/// lengths for rates.
MeasuredColumn read_column(const TextTable& table, const std::vector<double>& times, const std::string& name,
                           const std::string& wanted, bool& is_amount) {
  const std::size_t column = table.find_column(name);
  const std::string& unit = table.header()[column].unit;
  const char* example = wanted == "m/s" ? "mm" : wanted == "Pa" ? "kPa" : "m";
  if (unit.empty())
    reject(fmt::format("the column '{0}' of '{1}' has no unit; head it '{0} [{2}]'", name, table.file(), example));
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

/// Amounts become rates, which hold from row to row.
void spread_amounts(const TextTable& table, std::vector<double>& times, std::vector<double>& values) {
  if (times.size() < 2)
    reject(fmt::format("'{}' has amounts and a single row, so that nothing says how long it lasts", table.file()));
  times.push_back(2 * times.back() - times[times.size() - 2]);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] /= times[i + 1] - times[i];
  values.push_back(0);
}

void load(const Wanted& wanted, const std::filesystem::path& folder, const std::optional<Date>& zero,
          Findings& findings) {
  const SeriesFile source = *wanted.table.source;
  const TextTable table((folder / source.file).lexically_normal());
  if (table.rows() == 0) reject(fmt::format("the table '{}' has no row", table.file()));
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
      reject(fmt::format("'{}' and '{}' of '{}' have different dimensions", source.column, source.minus, table.file()));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= less[i];
  }
  if (wanted.positive_only)
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] < 0) reject(fmt::format("{}: '{}' is below zero", table.place(column.rows[i]), source.column));
  if (is_amount) {
    spread_amounts(table, times, values);
    wanted.shape = SeriesShape::steps;
  }
  wanted.table = {std::move(times), std::move(values)};
}

/// A file that begins late or ends early would be taken as constant there.
void check_span(const Case& data, const Wanted& wanted, const std::string& file, Findings& findings) {
  const double from = -data.initial.water.season, to = data.timeline ? data.timeline->duration : 0;
  const auto say = [&](double t) {
    return data.initial.date ? format_date(data.initial.date->seconds + t) : units::format_time(t);
  };
  if (const double first = wanted.table.time.front(); first > from)
    findings.add(wanted.path, fmt::format("'{}' begins at {}, after {}, where the water is first asked for", file,
                                          say(first), say(from)));
  if (const double last = wanted.table.time.back(); last < to)
    findings.add(wanted.path,
                 fmt::format("'{}' ends at {}, before {}, where the timeline ends", file, say(last), say(to)));
}

/// Moments that are given as dates, as times since time 0.
void find_moments(Case& data, Findings& findings) {
  if (!findings.is_sound("initial.date")) return;
  Timeline& timeline = *data.timeline;
  const auto is_dated = [&](const std::string& path, const char* what) {
    if (!data.initial.date) findings.add(path, fmt::format("{} needs [initial] date, the date of time 0", what));
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
    findings.add("timeline.until",
                 fmt::format("the timeline ends at {}, not after time 0, {}", format_date(timeline.until->seconds),
                             format_date(data.initial.date->seconds)));
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
      if (findings.is_sound("timeline")) check_span(data, wanted, table, findings);
    } catch (const Error& error) {
      findings.add(wanted.path, error.what());
      wanted.table = {{0}, {0}};
    }
  }
}

}  // namespace talus::input
