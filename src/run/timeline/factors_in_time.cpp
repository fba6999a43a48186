// SPDX-License-Identifier: MIT
#include "run/timeline/factors_in_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <numeric>

#include "base/atomic_file.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "base/units.hpp"
#include "results/json.hpp"
#include "run/bounds/referee.hpp"
#include "run/timeline/times.hpp"

namespace talus::run {
namespace {

constexpr const char* kept_file = "timeline.json";

}  // namespace

FactorsInTime::FactorsInTime(const WaterInTime& water, const RunOptions& options, std::string input_hash,
                             results::Timeline& summary)
    : water_(water),
      options_(options),
      hash_(std::move(input_hash)),
      search_(make_search_options(data_, 1)),
      summary_(summary) {}

void FactorsInTime::search_curve(const results::SliceResult& first) {
  const input::Timeline& asked = *data_.timeline;
  const int most = summary_.chosen ? asked.most_times : static_cast<int>(times_.size());
  TimeChoice choice(times_, asked.target, asked.tolerance, most);
  std::size_t guided = 0;  // number of moments whose surfaces are part of the guide
  guide_.assign(times_.size(), std::nullopt);
  moments_.push_back(water_.make_moment(0));
  take_known(first, search_, moments_.back());
  tried_.push_back(0);
  take_kept_moments();
  search_more({times_.size() - 1});  // all other searches start from these two
  std::vector<std::size_t> all(times_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (std::vector<std::size_t> next = summary_.chosen ? choice.next() : all; !next.empty(); next = choice.next()) {
    search_more(next);
    share();
    std::vector<results::TimedFactor> fresh;
    for (std::size_t i = 0; i < moments_.size(); ++i) {
      results::TimedFactor factor = make_moment_result(search_, moments_[i]);
      choice.set(tried_[i], factor.factor);
      if (i >= guided) fresh.push_back(std::move(factor));
    }
    if (!summary_.chosen) break;
    guided = moments_.size();
    extend_guide(fresh);
    choice.set_guide(guide_);
  }
  if (summary_.chosen) summary_.distance = choice.find_distance();
  make_results();
}

bool FactorsInTime::search_at(const std::vector<std::size_t>& numbers) {
  if (!search_more(numbers)) return false;
  share();
  make_results();
  return true;
}

void FactorsInTime::judge_governing_times() {
  constexpr int most_times = 12;
  for (int judged = 0; judged < most_times; ++judged) {
    const auto is_governing = [&](double time) {
      return summary_.least_time == time ||
             (summary_.failure && (summary_.failure->from == time || summary_.failure->to == time));
    };
    const auto next = std::find_if(moments_.begin(), moments_.end(),
                                   [&](const Moment& m) { return !m.referee && is_governing(m.time); });
    if (next == moments_.end()) return;
    const std::size_t number = tried_[static_cast<std::size_t>(next - moments_.begin())];
    next->referee = search_referee_interval(water_.begin_at(number), find_factor(number), options_);
    make_results();
  }
}

/// Searches at those of the times that were not tried yet. Returns true if there was such a time.
bool FactorsInTime::search_more(std::vector<std::size_t> next) {
  std::erase_if(next, [&](std::size_t n) { return std::find(tried_.begin(), tried_.end(), n) != tried_.end(); });
  if (next.empty()) return false;
  if (options_.progress) options_.progress->show(fmt::format("timeline: {} searches", moments_.size() + next.size()));
  std::vector<Moment> found(next.size());
  std::size_t done = tried_.size();
  std::mutex keeping;
  parallel_tasks(static_cast<int>(next.size()), options_.threads, [&](int i) {
    Moment& moment = found[static_cast<std::size_t>(i)] = water_.make_moment(next[static_cast<std::size_t>(i)]);
    throw_if_interrupted();
    search_moment(data_, search_, moments_, moment);
    const std::lock_guard lock(keeping);
    show_moment(moment, ++done, tried_.size() + next.size());
    kept_.moments.push_back(keep_moment(moment));
    results::write_file(options_.folder / kept_file, kept_, -1);
  });
  tried_.insert(tried_.end(), next.begin(), next.end());
  std::move(found.begin(), found.end(), std::back_inserter(moments_));
  return true;
}

void FactorsInTime::show_moment(const Moment& moment, std::size_t done, std::size_t total) const {
  if (!options_.progress) return;
  const results::TimedFactor found = make_moment_result(search_, moment);
  options_.progress->show(fmt::format("timeline: {} of {} searches, {}", done, total, units::format_time(found.time)),
                          {.method = "timeline",
                           .factor = found.factor,
                           .time = found.time,
                           .done = static_cast<int>(done),
                           .total = static_cast<int>(total),
                           .surface = found.surface.points});
}

void FactorsInTime::share() {
  if (data_.lem.search != input::SurfaceSearch::none) share_surfaces(search_, options_.threads, moments_);
}

/// Writes the factors of all tried times in order of time, and the times at which they pass the target.
void FactorsInTime::make_results() {
  summary_.factors.clear();
  summary_.fails_from_start = false;
  summary_.failure.reset();
  summary_.least.reset();
  for (const Moment& moment : moments_) summary_.factors.push_back(make_moment_result(search_, moment));
  std::sort(summary_.factors.begin(), summary_.factors.end(),
            [](const auto& a, const auto& b) { return a.time < b.time; });
  results::find_failure(summary_);
}

/// Takes the surfaces that an interrupted run has found at times after 0.
void FactorsInTime::take_kept_moments() {
  if (!options_.resume) return;
  auto known = results::find_file<results::TimelineFile>(options_.folder / kept_file);
  if (!known || known->input_hash != hash_) return;
  kept_ = std::move(*known);
  for (const results::SearchedMoment& moment : kept_.moments) {
    tried_.push_back(water_.find_nearest(moment.time));
    moments_.push_back(water_.make_moment(tried_.back()));
    take_kept(moment, search_, moments_.back());
  }
}

/// Evaluates the surfaces that govern at some times at all times, which gives an upper limit of what searches there
/// would find.
void FactorsInTime::extend_guide(const std::vector<results::TimedFactor>& fresh) {
  parallel_tasks(static_cast<int>(times_.size()), options_.threads, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    const auto factor = try_surfaces(fresh, search_, *water_.make_moment(k).slope);
    if (factor && !(guide_[k] && *guide_[k] <= *factor)) guide_[k] = factor;
  });
}

std::vector<const Moment*> FactorsInTime::list_moments() const {
  std::vector<const Moment*> list;
  for (const Moment& moment : moments_) list.push_back(&moment);
  std::ranges::sort(list, {}, &Moment::time);
  return list;
}

std::optional<double> FactorsInTime::find_factor(std::size_t number) const {
  for (const results::TimedFactor& f : summary_.factors)
    if (f.time == times_[number]) return f.factor;
  return std::nullopt;
}

void FactorsInTime::forget() const {
  remove_file(options_.folder / kept_file);
}

}  // namespace talus::run
