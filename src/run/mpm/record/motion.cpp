// SPDX-License-Identifier: MIT
#include "run/mpm/record/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/shown_units.hpp"
#include "base/units.hpp"
#include "input/case/result_names.hpp"
#include "output/files/history.hpp"

namespace talus::run {

namespace {

std::string join(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

/// Formats the pattern with its criterion, as the end of a sentence.
std::string describe(results::MotionPattern pattern) {
  const double share = 100 * together_share;
  switch (pattern) {
    case results::MotionPattern::together:
      return fmt::format(": together, as one block (all within {:g} % of the last onset)", share);
    case results::MotionPattern::upwards:
      return fmt::format(
          ": one after the other from the bottom upwards, as in a retrogressive slide (more than {:g} % of the last "
          "onset apart)",
          share);
    case results::MotionPattern::downwards:
      return fmt::format(": one after the other from the top downwards (more than {:g} % of the last onset apart)",
                         share);
    case results::MotionPattern::mixed:
      return ": neither together nor one after the other along the slope";
    default:
      return "";
  }
}

std::string write_sentence(const std::vector<MonitorOnset>& order, results::MotionPattern pattern,
                           const results::Clock& clock, const std::string& threshold, const ShownUnit& unit) {
  std::vector<std::string> moved, still, settled, resting;
  for (const MonitorOnset& m : order) {
    if (m.settled)
      (m.onset ? settled : resting)
          .push_back(fmt::format("'{}' by {:.3g} {}", m.name, *m.settled / unit.si, unit.name));
    if (m.onset)
      moved.push_back(fmt::format("'{}' after {:.4g} s", m.name, *m.onset));
    else if (!m.settled)
      still.push_back(fmt::format("'{}'", m.name));
  }
  const std::string counted =
      fmt::format("displacement above {}, counted from the start of '{}'", threshold, clock.stage);
  std::string text = moved.empty()
                         ? fmt::format("No monitored point moves ({})", counted)
                         : fmt::format("Movement begins at {} ({}){}", join(moved), counted, describe(pattern));
  if (!settled.empty()) text += fmt::format("; before it the soil settles and comes to rest, at {}", join(settled));
  if (!resting.empty()) text += fmt::format("; the soil settles and comes to rest, at {}", join(resting));
  if (!still.empty() && !moved.empty())
    text += fmt::format("; {} {} not move", join(still), still.size() == 1 ? "does" : "do");
  return text + ".";
}

}  // namespace

std::optional<results::Clock> find_clock(const input::Case& data, const std::vector<results::Stage>& stages) {
  const input::Stage* stage = input::find_clock_stage(data);
  if (stage == nullptr) return std::nullopt;
  const auto index = static_cast<std::size_t>(stage - data.stages.data());
  if (index > stages.size()) return std::nullopt;
  // A stage that was interrupted has no report; it began when the previous one ended.
  double start = 0;
  if (index < stages.size())
    start = stages[index].start;
  else if (index > 0)
    start = stages[index - 1].time;
  return results::Clock{stage->name, start, stage->reset_displacement || index == 0, data.output.shown_times};
}

MonitorPath read_monitor_path(const output::HistoryTable& table, const std::string& monitor,
                              const results::Clock& clock) {
  std::vector<std::size_t> columns;
  double unit = 1;
  for (const char* axis : {"x", "y", "z"})
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      if (table.columns[c].name == fmt::format("{}.displacement_{}", output::make_cell(monitor), axis)) {
        columns.push_back(c);
        unit = units::get_si_factor(table.columns[c].unit);
      }
  const std::vector<double>& time = table.values.front();
  // The row at the start of a stage is the last one of the previous stage, before displacements were set to zero.
  std::size_t first = 0;
  while (first < time.size() && time[first] <= clock.start) ++first;
  MonitorPath path{{0}, {0}};
  for (std::size_t i = first; i < time.size(); ++i) {
    double square = 0;
    for (const std::size_t c : columns) {
      const double from = clock.resets || first == 0 ? 0 : table.values[c][first - 1];
      square += (table.values[c][i] - from) * (table.values[c][i] - from);
    }
    path.time.push_back(time[i] - clock.start);
    path.displacement.push_back(unit * std::sqrt(square));
  }
  return path;
}

std::optional<double> find_onset(std::span<const double> time, std::span<const double> displacement, double threshold) {
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (std::isnan(displacement[i])) return std::nullopt;
    if (!(displacement[i] > threshold)) continue;
    if (i == 0) return time[0];
    const double share = (threshold - displacement[i - 1]) / (displacement[i] - displacement[i - 1]);
    return time[i - 1] + share * (time[i] - time[i - 1]);
  }
  return std::nullopt;
}

MovementOnset find_movement_onset(std::span<const double> time, std::span<const double> displacement, double threshold,
                                  double failure) {
  const auto end = std::find_if(displacement.begin(), displacement.end(), [](double u) { return std::isnan(u); });
  const auto count = static_cast<std::size_t>(end - displacement.begin());
  const std::optional<double> first = find_onset(time.first(count), displacement.first(count), threshold);
  if (!first) return {};
  // A slide is beyond `failure` for good from row `gone` on.
  std::size_t gone = count;
  while (gone > 0 && displacement[gone - 1] >= failure) --gone;
  std::optional<std::size_t> rest;
  for (std::size_t i = 1; i + 1 < gone; ++i) {
    if (time[i] <= *first) continue;
    const double mean = (displacement[i] - displacement[0]) / (time[i] - time[0]);
    if (displacement[i + 1] - displacement[i] <= rest_share * mean * (time[i + 1] - time[i])) rest = i + 1;
  }
  if (!rest) return {first, std::nullopt};
  const double settled =
      *std::max_element(displacement.begin(), displacement.begin() + static_cast<std::ptrdiff_t>(*rest) + 1);
  return {find_onset(time.subspan(*rest, count - *rest), displacement.subspan(*rest, count - *rest),
                     std::min(settled + threshold, failure)),
          settled};
}

double find_onset_threshold(const input::Output& output, double slope_height) {
  return output.onset_displacement.value_or(output.onset_ratio * slope_height);
}

results::MotionPattern find_pattern(const std::vector<MonitorOnset>& monitors) {
  std::vector<MonitorOnset> moved;
  std::copy_if(monitors.begin(), monitors.end(), std::back_inserter(moved), [](const auto& m) { return m.onset; });
  if (moved.empty()) return results::MotionPattern::none;
  if (moved.size() == 1) return results::MotionPattern::single;
  std::sort(moved.begin(), moved.end(), [](const auto& a, const auto& b) { return a.height < b.height; });
  const auto by_onset = [](const auto& a, const auto& b) { return *a.onset < *b.onset; };
  const auto [first, last] = std::minmax_element(moved.begin(), moved.end(), by_onset);
  if (*last->onset - *first->onset <= together_share * *last->onset) return results::MotionPattern::together;
  const auto is_strict = [&](auto before) {
    return std::adjacent_find(moved.begin(), moved.end(), [&](const auto& a, const auto& b) {
             return !(a.height < b.height) || !before(a, b);
           }) == moved.end();
  };
  if (is_strict(by_onset)) return results::MotionPattern::upwards;
  if (is_strict([&](const auto& a, const auto& b) { return by_onset(b, a); })) return results::MotionPattern::downwards;
  return results::MotionPattern::mixed;
}

std::optional<results::Motion> find_motion(const input::Case& data, const std::vector<results::Stage>& stages,
                                           double slope_height, const std::filesystem::path& folder) {
  const std::optional<results::Clock> clock = find_clock(data, stages);
  const auto file = folder / "monitors.csv";
  if (!clock || data.output.monitors.empty() || !std::filesystem::exists(file)) return std::nullopt;
  const output::HistoryTable table = output::read_history(file);
  results::Motion motion;
  motion.stage = clock->stage;
  motion.start = clock->start;
  motion.threshold = find_onset_threshold(data.output, slope_height);
  const double failure = std::max(motion.threshold, data.strength_reduction.curve.displacement_ratio * slope_height);
  std::vector<MonitorOnset> order;
  for (const input::Monitor& m : data.output.monitors) {
    const MonitorPath path = read_monitor_path(table, m.name, *clock);
    double height = 0;
    for (std::size_t d = 0; d < 3; ++d) height -= data.gravity.direction[d] * m.at[d];
    const MovementOnset onset = find_movement_onset(path.time, path.displacement, motion.threshold, failure);
    order.push_back({m.name, height, onset.time, onset.settled});
    const double end = path.displacement.back();
    motion.monitors.push_back(
        {m.name, onset.time, std::isfinite(end) ? std::optional(end) : std::nullopt, onset.settled});
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.onset && (!b.onset || *a.onset < *b.onset); });
  for (const MonitorOnset& m : order)
    if (m.onset) motion.order.push_back(m.name);
  motion.pattern = find_pattern(order);
  const std::string unit = data.output.displacement_unit;
  std::string limit = fmt::format("{:.4g} {}", motion.threshold / units::get_si_factor(unit), unit);
  if (!data.output.onset_displacement)
    limit += fmt::format(", {:g} % of the relief of the ground", 100 * data.output.onset_ratio);
  motion.sentence = write_sentence(order, motion.pattern, *clock, limit, {unit, units::get_si_factor(unit)});
  return motion;
}

std::optional<double> find_failure_time(const std::filesystem::path& history, double displacement) {
  if (!std::filesystem::exists(history)) return std::nullopt;
  const output::HistoryTable table = output::read_history(history);
  const auto column = std::find_if(table.columns.begin(), table.columns.end(),
                                   [](const output::Column& c) { return c.name == "largest_displacement"; });
  if (column == table.columns.end()) return std::nullopt;
  const std::vector<double>& time = table.values.front();
  const std::vector<double>& shown = table.values[static_cast<std::size_t>(column - table.columns.begin())];
  const double limit = displacement / units::get_si_factor(column->unit);
  if (shown.empty() || !(shown.back() >= limit)) return std::nullopt;
  std::size_t i = shown.size() - 1;
  while (i > 0 && shown[i - 1] >= limit) --i;
  if (i == 0) return std::nullopt;
  const double share = (limit - shown[i - 1]) / (shown[i] - shown[i - 1]);
  return time[i - 1] + share * (time[i] - time[i - 1]);
}

}  // namespace talus::run
