// SPDX-License-Identifier: MIT
#include "run/timeline/times.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace talus::run {
namespace {

/// A series with more corners, of a weather station, tells by itself where something happens.
constexpr std::size_t many_corners = 40;
/// Times between two corners: evenly, and ever nearer to the first of them, where pressures change fastest.
constexpr int even_times = 16, near_times = 14;
/// Even times over the whole.
constexpr int least_times = 128;
/// The first times that are tried.
constexpr std::size_t first_tried = 9;
/// A parabola through three times is off a straight line through two neighbours of them by a quarter of the middle's
/// distance; what bends more sharply, by up to all of it.
constexpr double share_of_bend = 0.5;

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

double TimeChoice::find_bend(const std::vector<std::size_t>& tried, std::size_t k) const {
  if (k == 0 || k + 1 >= tried.size()) return 0;
  const auto &a = known_[tried[k - 1]].factor, &b = known_[tried[k]].factor, &c = known_[tried[k + 1]].factor;
  if (!a || !b || !c) return 0;
  const double ta = times_[tried[k - 1]], tb = times_[tried[k]], tc = times_[tried[k + 1]];
  const double line = *a + (*c - *a) * (tb - ta) / (tc - ta);
  return share_of_bend * std::abs(*b - line) / *b;
}

double TimeChoice::find_distance() const {
  const std::vector<std::size_t> tried = list_tried();
  double distance = 0;
  for (std::size_t k = 0; k + 1 < tried.size(); ++k)
    if (tried[k + 1] > tried[k] + 1) distance = std::max({distance, find_bend(tried, k), find_bend(tried, k + 1)});
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
  struct Gap {
    double weight;
    std::size_t middle;
  };
  std::vector<Gap> gaps;
  for (std::size_t k = 0; k + 1 < tried.size(); ++k) {
    const std::size_t from = tried[k], to = tried[k + 1];
    if (to == from + 1) continue;
    const auto &a = known_[from].factor, &b = known_[to].factor;
    const bool passes = a && b && (*a >= target_) != (*b >= target_);
    const double bend = std::max(find_bend(tried, k), find_bend(tried, k + 1));
    // The time of failure comes before the rest of the curve.
    if (passes || bend > tolerance_) gaps.push_back({passes ? 1e9 : bend, (from + to) / 2});
  }
  std::stable_sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.weight > b.weight; });
  std::vector<std::size_t> chosen;
  for (const Gap& gap : gaps)
    if (tried.size() + chosen.size() < most_) chosen.push_back(gap.middle);
  return chosen;
}

}  // namespace talus::run
