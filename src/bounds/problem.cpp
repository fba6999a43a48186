// SPDX-License-Identifier: MIT
// Units of the programs of limit analysis.
#include "bounds/problem.hpp"

#include <algorithm>

namespace talus::bounds {

Units find_units(const Problem& problem) {
  Units units{0, 0};
  Vec<2> low = problem.nodes.front(), high = low;
  for (const Vec<2>& x : problem.nodes)
    for (std::size_t d = 0; d < 2; ++d) low[d] = std::min(low[d], x[d]), high[d] = std::max(high[d], x[d]);
  units.length = high[1] - low[1];
  for (const Vec<2>& b : problem.body_force) units.stress = std::max(units.stress, norm(b) * units.length);
  for (const Side& s : problem.sides)
    for (const Vec<2>& t : s.traction) units.stress = std::max(units.stress, norm(t));
  if (!(units.stress > 0)) units.stress = 1;
  return units;
}

}  // namespace talus::bounds
