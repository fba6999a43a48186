// SPDX-License-Identifier: MIT
#include "run/timeline/times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace talus::run {
namespace {

/// Series with more corners, such as those of a weather station, have corners wherever conditions change, so no times
/// are added between them.
constexpr std::size_t many_corners = 40;
/// Times between two corners: evenly spaced, and increasingly dense towards the first corner, where pressures change
/// fastest.
constexpr int even_times = 16, near_times = 14;
/// Number of evenly spaced times over the whole duration.
constexpr int least_times = 128;
/// Number of times tried first.
constexpr std::size_t first_tried = 5;
/// Fraction of the tolerance that applies near the least factor in time.
constexpr double share_at_least = 0.25;

std::set<double> list_corners(const input::Case& data) {
  const double end = data.timeline->duration;
  std::set<double> corners{0, end};
  for (const input::Hydraulic& h : data.hydraulics)
    for (const double t : h.values().time)
      if (t > 0 && t < end) corners.insert(t);
  return corners;
}

}  // namespace

std::vector<double> list_times(const input::Case& data) {
  const input::Timeline& timeline = *data.timeline;
  if (!timeline.times.empty()) return timeline.times;
  const std::set<double> corners = list_corners(data);
  std::set<double> all = corners;
  if (timeline.element_times) all.insert(timeline.element_times->begin(), timeline.element_times->end());
  if (timeline.release && timeline.release->time) all.insert(*timeline.release->time);
  for (int i = 1; i < least_times; ++i) all.insert(timeline.duration * i / least_times);
  if (corners.size() <= many_corners) {
    for (auto from = corners.begin(), to = std::next(from); to != corners.end(); ++from, ++to) {
      for (int i = 1; i < even_times; ++i) all.insert(*from + (*to - *from) * i / even_times);
      for (int k = 1; k <= near_times; ++k) all.insert(*from + (*to - *from) / even_times * std::pow(0.5, k));
    }
  }
  std::vector<double> times;
  const double apart = 1e-9 * timeline.duration;
  for (const double t : all)
    if (t > apart && (times.empty() || t - times.back() > apart)) times.push_back(t);
  return times;
}

TimeChoice::TimeChoice(std::vector<double> times, double target, double tolerance, int most)
    : times_(std::move(times)),
      known_(times_.size()),
      target_(target),
      tolerance_(tolerance),
      most_(static_cast<std::size_t>(most)) {}

void TimeChoice::set(std::size_t number, std::optional<double> factor) {
  known_[number] = {true, factor};
}

std::vector<std::size_t> TimeChoice::list_tried() const {
  std::vector<std::size_t> tried;
  for (std::size_t i = 0; i < known_.size(); ++i)
    if (known_[i].tried) tried.push_back(i);
  return tried;
}

void TimeChoice::set_guide(std::vector<std::optional<double>> factors) {
  guide_ = std::move(factors);
}

std::optional<double> TimeChoice::line_at(std::size_t from, std::size_t to, std::size_t i) const {
  const auto &a = known_[from].factor, &b = known_[to].factor;
  if (!a || !b) return std::nullopt;
  return *a + (*b - *a) * (times_[i] - times_[from]) / (times_[to] - times_[from]);
}

std::optional<double> TimeChoice::estimate(std::size_t from, std::size_t to, std::size_t i) const {
  const auto line = line_at(from, to, i);
  if (!line || guide_.empty() || !guide_[from] || !guide_[to] || !guide_[i]) return line;
  const double share = (times_[i] - times_[from]) / (times_[to] - times_[from]);
  return *line + *guide_[i] - (*guide_[from] + share * (*guide_[to] - *guide_[from]));
}

TimeChoice::Bend TimeChoice::find_bend(std::size_t from, std::size_t to) const {
  Bend bend;
  for (std::size_t i = from + 1; i < to; ++i) {
    const auto line = line_at(from, to, i), there = estimate(from, to, i);
    if (!line || !there) continue;
    const double distance = (*there - *line) / *line;
    if (std::abs(distance) > std::abs(bend.distance)) bend = {distance, i};
  }
  return bend;
}

/// Returns the untried time next to the first passage of the estimate through the target; `from` if it has none
/// between untried times.
std::size_t TimeChoice::find_passage(std::size_t from, std::size_t to) const {
  if (to == from + 1) return from;
  const auto is_above = [&](std::size_t i) { return estimate(from, to, i).value_or(target_) >= target_; };
  for (std::size_t i = from + 1; i <= to; ++i) {
    const bool passes = i == to ? *known_[to].factor >= target_ : is_above(i);
    if (passes == (*known_[from].factor >= target_)) continue;
    return i == to ? to - 1 : i;
  }
  return from;
}

/// Returns the time at which the estimate is lower than at every tried time, by more than a fraction of the tolerance.
std::optional<std::size_t> TimeChoice::find_least_estimate(const std::vector<std::size_t>& tried) const {
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : tried)
    if (known_[i].factor) least = std::min(least, *known_[i].factor);
  least *= 1 - share_at_least * tolerance_;
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k + 1 < tried.size(); ++k)
    for (std::size_t i = tried[k] + 1; i < tried[k + 1]; ++i)
      if (const auto there = estimate(tried[k], tried[k + 1], i); there && *there < least) least = *there, found = i;
  return found;
}

double TimeChoice::find_distance() const {
  const std::vector<std::size_t> tried = list_tried();
  double distance = 0;
  for (std::size_t k = 0; k + 1 < tried.size(); ++k)
    distance = std::max(distance, std::abs(find_bend(tried[k], tried[k + 1]).distance));
  return distance;
}

std::vector<std::size_t> TimeChoice::next() const {
  const std::vector<std::size_t> tried = list_tried();
  const std::size_t last = times_.size() - 1;
  if (tried.empty()) {
    std::set<std::size_t> first;
    const std::size_t parts = std::min({first_tried, most_, times_.size()}) - 1;
    for (std::size_t i = 0; i <= parts; ++i) first.insert(i * last / std::max<std::size_t>(parts, 1));
    return {first.begin(), first.end()};
  }
  struct Candidate {
    double weight;
    std::size_t at;
  };
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k + 1 < tried.size(); ++k) {
    const std::size_t from = tried[k], to = tried[k + 1];
    const auto &a = known_[from].factor, &b = known_[to].factor;
    if (!a || !b || to == from + 1) continue;
    const Bend bend = find_bend(from, to);
    const double deepest = bend.distance < 0 ? *estimate(from, to, bend.at) : std::min(*a, *b);
    const bool passes = (*a >= target_) != (*b >= target_);
    // The time of failure has priority over the rest of the curve.
    if (passes && find_passage(from, to) != from)
      candidates.push_back({1e9, find_passage(from, to)});
    else if (!passes && *a >= target_ && deepest < target_)
      candidates.push_back({1e9, bend.at});
    else if (std::abs(bend.distance) > tolerance_)
      candidates.push_back({std::abs(bend.distance), bend.at});
  }
  if (const auto low = find_least_estimate(tried)) candidates.push_back({1e8, *low});
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.weight > b.weight; });
  std::vector<std::size_t> chosen;
  for (const Candidate& c : candidates)
    if (tried.size() + chosen.size() < most_ && std::find(chosen.begin(), chosen.end(), c.at) == chosen.end())
      chosen.push_back(c.at);
  return chosen;
}

}  // namespace talus::run
