// SPDX-License-Identifier: MIT
#include "run/timeline/timeline_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/progress.hpp"
#include "base/units.hpp"
#include "run/fem/start_stress.hpp"

namespace talus::run {

TimelineRun::TimelineRun(const input::Case& data, const RunOptions& options, std::string input_hash)
    : options_(options), water_(data), factors_(water_, options, std::move(input_hash), summary_) {
  summary_.pool_loading = data.timeline->pool_loading;
}

void TimelineRun::show(const std::string& what) const {
  if (options_.progress) options_.progress->show("timeline: " + what);
}

void TimelineRun::calculate(const PreparedSlope& prepared, const results::SliceResult& first) {
  show("seepage");
  water_.calculate(prepared, summary_);
  search(first);
  add_notes();
  std::vector<double> tried;
  for (const results::TimedFactor& factor : summary_.factors) tried.push_back(factor.time);
  water_.keep_states(tried, summary_);
  if (options_.progress) options_.progress->clear();
}

void TimelineRun::search(const results::SliceResult& first) {
  const auto start = std::chrono::steady_clock::now();
  const input::Timeline& asked = *data_.timeline;
  summary_.duration = asked.duration;
  if (data_.initial.date) summary_.start = format_date(data_.initial.date->seconds);
  summary_.target = asked.target;
  summary_.chosen = asked.times.empty();
  factors_.search_curve(first);
  if (asked.release && asked.release->criterion == input::ReleaseCriterion::equilibrium) search_loss();
  if (asked.release) search_releases();
  summary_.search_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (data_.lem.referee) factors_.judge_governing_times();
}

/// Searches at the times of release as well. A search there may find an earlier failure, whose times are then searched
/// too.
void TimelineRun::search_releases() {
  for (auto at = find_release(); at; at = find_release()) {
    std::vector<std::size_t> next = find_beside(*at);
    next.push_back(*at);
    if (!factors_.search_at(next)) return;
  }
}

/// Searches the loss of equilibrium by FEM, between two consecutive stored times. First the times of the searches
/// are tried one after the other, then those in between by bisection.
void TimelineRun::search_loss() {
  results::EquilibriumLoss& loss = summary_.equilibrium.emplace();
  const auto is_balanced = [&](std::size_t number) {
    show("equilibrium at " + units::format_time(times_[number]));
    ++loss.trials;
    const Balance found = find_balance(water_.begin_at(number), options_.threads);
    (found.stands ? loss.from : loss.to) = times_[number];
    if (found.undecided)
      note(
          fmt::format("at {} FEM ran out of iterations before its soil flowed: with more `iterations` under [fem] it "
                      "may find equilibrium later than that",
                      units::format_time(times_[number])));
    return found.stands;
  };
  std::vector<std::size_t> tried = factors_.tried();
  std::sort(tried.begin(), tried.end());
  auto fails = std::find_if_not(tried.begin(), tried.end(), is_balanced);
  if (fails == tried.end() || fails == tried.begin()) return;
  for (std::size_t low = *(fails - 1), high = *fails; high - low > 1;) {
    const std::size_t middle = low + (high - low) / 2;
    (is_balanced(middle) ? low : high) = middle;
  }
}

/// Returns the index of the time of release to MPM.
std::optional<std::size_t> TimelineRun::find_release() const {
  const input::Release& asked = *data_.timeline->release;
  std::optional<double> time = asked.time;
  if (asked.criterion == input::ReleaseCriterion::equilibrium) {
    time = summary_.equilibrium->to;
  } else {
    if (!time && summary_.fails_from_start) time = 0;
    if (!time && summary_.failure) time = summary_.failure->to;
  }
  return time ? std::optional(water_.find_nearest(*time)) : std::nullopt;
}

/// Returns the stored times nearest to `apart` before and after the release; the adjacent ones if none is given.
std::vector<std::size_t> TimelineRun::find_beside(std::size_t at) const {
  const std::optional<double> apart = data_.timeline->release->apart;
  std::vector<std::size_t> beside;
  if (apart == 0.0) return beside;
  const auto is_nearer = [&](std::size_t a, std::size_t b) {
    const auto miss = [&](std::size_t i) { return std::abs(std::abs(times_[i] - times_[at]) - apart.value_or(0)); };
    return miss(a) < miss(b);
  };
  std::vector<std::size_t> numbers(times_.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(at);
  if (middle != numbers.begin()) beside.push_back(*std::min_element(numbers.begin(), middle, is_nearer));
  if (middle + 1 != numbers.end()) beside.push_back(*std::min_element(middle + 1, numbers.end(), is_nearer));
  return beside;
}

ReleaseCase TimelineRun::make_release(std::size_t number) const {
  ReleaseCase release;
  release.summary.time = times_[number];
  release.summary.factor = factors_.find_factor(number);
  release.data = water_.begin_at(number);
  return release;
}

std::vector<ReleaseCase> TimelineRun::list_releases() {
  const auto at = find_release();
  if (!at) {
    note(fmt::format("MPM does not start: {}; [timeline.release] time starts it all the same",
                     summary_.equilibrium
                         ? "FEM converges at every time that was tried"
                         : fmt::format("the factor is not below {:g} at any time that was tried", summary_.target)));
    return {};
  }
  std::vector<ReleaseCase> releases{make_release(*at)};
  for (const std::size_t beside : find_beside(*at)) {
    releases.push_back(make_release(beside));
    releases.back().summary.folder = beside < *at ? "released_earlier" : "released_later";
  }
  return releases;
}

std::vector<ReductionCase> TimelineRun::list_reductions() const {
  std::vector<double> times;
  if (const auto& asked = data_.timeline->element_times)
    times = *asked;
  else if (summary_.least_time)
    times = {*summary_.least_time};
  std::vector<ReductionCase> reductions;
  for (const double time : times) {
    const std::size_t number = water_.find_nearest(time);
    if (number == 0) continue;  // calculated by the run itself
    ReductionCase& reduction = reductions.emplace_back();
    reduction.summary.time = times_[number];
    reduction.summary.folder = fmt::format("elements_{}", reductions.size());
    reduction.data = water_.begin_at(number);
  }
  return reductions;
}

void TimelineRun::add_notes() {
  const std::vector<const Moment*> moments = factors_.list_moments();
  for (std::size_t i = 0; i < moments.size(); ++i)
    if (!summary_.factors[i].factor && !moments[i]->error.empty())
      note(fmt::format("no factor at {:g} s: {}", moments[i]->time, moments[i]->error));
  add_refusal_note(moments);
  add_pool_notes();
  if (summary_.distance && *summary_.distance > data_.timeline->tolerance)
    note(
        fmt::format("after {} times straight lines between them may still be off by {:.2g} % of the "
                    "factor; a larger most_times or times of your own show more",
                    moments.size(), 100 * *summary_.distance));
}

/// Notes surfaces with lower factors that are rejected: the curve may be too high there.
void TimelineRun::add_refusal_note(const std::vector<const Moment*>& moments) {
  constexpr double noticeable = 0.99;
  std::vector<double> when;
  double least = std::numeric_limits<double>::infinity();
  const char* why = "";
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const Moment& m = *moments[i];
    if (!summary_.factors[i].factor || m.refused_factor >= noticeable * *summary_.factors[i].factor) continue;
    when.push_back(m.time);
    if (m.refused_factor < least) least = m.refused_factor, why = lem::name_refusal(m.refusal);
  }
  if (when.empty()) return;
  note(fmt::format(
      "at {} of {} times, from {} to {}, surfaces with lower factors, down to {:.3f}, are refused ({}): the factor "
      "may be lower there than it is shown",
      when.size(), moments.size(), units::format_time(when.front()), units::format_time(when.back()), least, why));
}

/// Notes pools that change suddenly: the pore pressures just after depend on whether the weight of the water counts.
void TimelineRun::add_pool_notes() {
  const bool gives_way = std::any_of(data_.materials.begin(), data_.materials.end(),
                                     [](const auto& m) { return m.second.water.compressibility > 0; });
  if (data_.timeline->pool_loading || !gives_way) return;
  for (const input::Hydraulic& h : data_.hydraulics) {
    if (h.condition != input::WaterCondition::total_head) continue;
    for (std::size_t i = 1; i < h.head.time.size(); ++i) {
      const double at = h.head.time[i];
      const bool jumps = at == h.head.time[i - 1] && h.head.value[i] != h.head.value[i - 1];
      if (!jumps || at < 0 || at >= summary_.duration ||
          !water_.stands_on_ground(h, std::max(h.head.value[i], h.head.value[i - 1])))
        continue;
      const bool falls = h.head.value[i] < h.head.value[i - 1];
      note(fmt::format(
          "the pool on '{}' {} at once at {}, and total stress is taken as constant: right after, pore pressures are "
          "too "
          "{} and factors too {}; pool_loading = true lets its weight count",
          h.on, falls ? "falls" : "rises", units::format_time(at), falls ? "high" : "low", falls ? "low" : "high"));
    }
  }
}

void TimelineRun::write_result(results::RunResult& run) const {
  run.timeline = summary_;
  for (const std::string& note : summary_.notes) run.warnings.push_back("timeline: " + note);
}

}  // namespace talus::run
