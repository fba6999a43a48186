// SPDX-License-Identifier: MIT
// The smallest factor per centre of the trial circles.

#include <algorithm>
#include <cmath>
#include <limits>

#include "lem/search/search_findings.hpp"

namespace talus::lem {

namespace {

/// A box that holds the centres of the circles with the smaller factors: those of flat arcs lie very far away.
void choose_box(const SearchResult& result, std::size_t method, SearchResult::Map& map) {
  float smallest = std::numeric_limits<float>::infinity();
  for (const TriedCircle& t : result.trials)
    if (t.factors[method] > 0) smallest = std::min(smallest, t.factors[method]);
  double left = 0, right = 0, low = 0, high = 0;
  bool first = true;
  for (const TriedCircle& t : result.trials) {
    if (!(t.factors[method] > 0) || t.factors[method] > 1.4f * smallest) continue;
    const Point& c = t.surface.circle->centre;
    left = first ? c[0] : std::min(left, c[0]), right = first ? c[0] : std::max(right, c[0]);
    low = first ? c[1] : std::min(low, c[1]), high = first ? c[1] : std::max(high, c[1]);
    first = false;
  }
  const double width = std::max({right - left, high - low, 1e-9});
  // Cells stand in their middles at the map's ends: half a cell of room around.
  map.from = {left, low};
  map.to = {right > left ? right : left + width, high > low ? high : low + width};
}

}  // namespace

SearchResult::Map map_centres(const SearchResult& result, std::size_t method, int columns, int rows) {
  SearchResult::Map map;
  map.columns = columns, map.rows = rows;
  if (result.grid) {
    map.from = result.grid->from, map.to = result.grid->to;
  } else {
    choose_box(result, method, map);
  }
  map.factor.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                    std::numeric_limits<float>::quiet_NaN());
  auto cell = [](double x, double from, double to, int n) {
    return n > 1 ? static_cast<int>(std::lround((x - from) / (to - from) * (n - 1))) : 0;
  };
  for (const TriedCircle& t : result.trials) {
    if (!(t.factors[method] > 0)) continue;
    const Point& c = t.surface.circle->centre;
    const int i = cell(c[0], map.from[0], map.to[0], columns), j = cell(c[1], map.from[1], map.to[1], rows);
    if (i < 0 || j < 0 || i >= columns || j >= rows) continue;
    float& f =
        map.factor[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i)];
    if (!(f <= t.factors[method])) f = t.factors[method];
  }
  return map;
}

}  // namespace talus::lem
