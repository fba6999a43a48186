// SPDX-License-Identifier: MIT
// Trial circles through an entry and an exit on the ground, with several depths each.

#include <algorithm>
#include <cmath>

#include "lem/search/trial_circles.hpp"

namespace talus::lem {

namespace {

/// Where points stand, and how far apart they are in the middle of the field.
double find_step(const std::vector<double>& points) {
  if (points.size() < 2) return 0;
  std::vector<double> gaps;
  for (std::size_t i = 1; i < points.size(); ++i) gaps.push_back(points[i] - points[i - 1]);
  std::nth_element(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2), gaps.end());
  return gaps[gaps.size() / 2];
}

}  // namespace

TrialCircles make_entry_exit_circles(const Slope& slope, const Arcs& arcs, const std::optional<EntryExitSearch>& asked,
                                     int seed, EntryExitSearch& used) {
  TrialCircles circles;
  used = asked.value_or(EntryExitSearch{});
  circles.whole_ground = used.exit[0] == used.exit[1] && used.entry[0] == used.entry[1];
  if (circles.whole_ground) used.exit = used.entry = {slope.left(), slope.right()};
  for (auto* range : {&used.exit, &used.entry})
    *range = {std::clamp((*range)[0], slope.left(), slope.right()),
              std::clamp((*range)[1], slope.left(), slope.right())};
  std::vector<double> exits, entries;
  if (circles.whole_ground) {  // any two points: the circle slides to the lower one
    exits = entries = place_points(slope, slope.left(), slope.right(), used.exits + used.entries, seed);
  } else {
    exits = place_points(slope, used.exit[0], used.exit[1], used.exits, seed);
    entries = place_points(slope, used.entry[0], used.entry[1], used.entries, seed);
  }
  const bool exit_left = used.exit[0] + used.exit[1] <= used.entry[0] + used.entry[1];
  circles.left = exit_left ? used.exit : used.entry;
  circles.right = exit_left ? used.entry : used.exit;
  circles.step = {find_step(exit_left ? exits : entries), find_step(exit_left ? entries : exits)};
  circles.size = {static_cast<int>(exits.size()), static_cast<int>(entries.size()), used.depths};
  for (double exit : exits)
    for (double entry : entries) {
      const double left = exit_left ? exit : entry, right = exit_left ? entry : exit;
      const auto range = left < right ? arcs.find_range(left, right) : std::nullopt;
      for (int k = 1; k <= used.depths; ++k) {
        circles.first.push_back(static_cast<int>(circles.surfaces.size()));
        if (!range) continue;
        // The shallowest arc only where a smallest depth makes it a surface of its own.
        const double t = used.depths > 1 ? static_cast<double>(k) / used.depths : 0.5;
        circles.surfaces.push_back(arcs.make_arc(left, right, range->from + t * (range->to - range->from)));
      }
    }
  circles.first.push_back(static_cast<int>(circles.surfaces.size()));
  return circles;
}

}  // namespace talus::lem
