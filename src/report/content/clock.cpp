// SPDX-License-Identifier: MIT
#include "report/content/clock.hpp"

#include <algorithm>
#include <cmath>

#include "report/content/thinning.hpp"

namespace talus::report {
namespace {

/// Curves and pictures of more times than this are hard to tell apart.
constexpr std::size_t most_times = 5;

std::size_t find_nearest(const std::vector<double>& times, double time) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < times.size(); ++i)
    if (std::abs(times[i] - time) <= std::abs(times[nearest] - time)) nearest = i;
  return nearest;
}

}  // namespace

std::vector<std::size_t> choose_shown(const std::vector<double>& times, const results::Clock& clock) {
  std::vector<std::size_t> shown;
  if (times.empty()) return shown;
  if (clock.shown_times.empty()) {
    const std::size_t first = find_nearest(times, clock.start);
    for (const std::size_t i : choose_frames(times.size() - first, most_times)) shown.push_back(first + i);
  }
  for (const double time : clock.shown_times) shown.push_back(find_nearest(times, clock.start + time));
  std::sort(shown.begin(), shown.end());
  shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
  return shown;
}

}  // namespace talus::report
