// SPDX-License-Identifier: MIT
// The best circle that touches each region.

#include "lem/surface/touching_circles.hpp"

#include <algorithm>
#include <set>

namespace talus::lem {

std::vector<Surface> find_touching_circles(Evaluator& evaluate, Evaluator& quick, const Arcs& arcs,
                                           const TrialCircles& circles, int most) {
  std::set<std::array<double, 2>> distinct;
  for (const Surface& s : circles.surfaces) distinct.insert({s.from, s.to});
  std::vector<std::array<double, 2>> ends(distinct.begin(), distinct.end());
  // From the lower side of the section on, so that its mirror image tries the same ones.
  const Slope& slope = evaluate.slope();
  if (slope.ground(slope.left()) > slope.ground(slope.right()))
    std::sort(ends.begin(), ends.end(), [](auto& a, auto& b) { return a[1] != b[1] ? a[1] > b[1] : a[0] > b[0]; });
  const std::size_t stride = ends.size() / static_cast<std::size_t>(std::max(1, most)) + 1;
  std::vector<std::array<double, 2>> tried;
  for (std::size_t i = 0; i < ends.size(); i += stride) tried.push_back(ends[i]);
  std::vector<Surface> best;
  for (const Region& region : arcs.regions()) {
    std::vector<std::pair<double, Surface>> ranked;
    for (const auto& [left, right] : tried) {
      const auto range = arcs.find_range(left, right);
      const auto touch = range ? arcs.find_touch(left, right, region) : std::nullopt;
      if (!touch || *touch < range->from || *touch > range->to) continue;
      const Surface s = arcs.make_arc(left, right, *touch);
      if (const double factor = quick(s); factor < Evaluator::refused) ranked.push_back({factor, s});
    }
    std::stable_sort(ranked.begin(), ranked.end(), [](auto& a, auto& b) { return a.first < b.first; });
    double smallest = Evaluator::refused;
    Surface own;
    for (std::size_t k = 0; k < std::min<std::size_t>(ranked.size(), 20); ++k)
      if (const double factor = evaluate(ranked[k].second); factor < smallest)
        smallest = factor, own = ranked[k].second;
    if (smallest < Evaluator::refused) best.push_back(own);
  }
  return best;
}

}  // namespace talus::lem
