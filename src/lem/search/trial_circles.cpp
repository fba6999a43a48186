// SPDX-License-Identifier: MIT
// Trial circles of a search (entry and exit, grid of centres), circles that touch a region, and the map of the smallest
// factor per centre.
#include "lem/search/trial_circles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "lem/search/search_findings.hpp"

namespace talus::lem {

std::vector<Surface> find_touching_circles(Evaluator& evaluate, Evaluator& quick, const Arcs& arcs,
                                           const TrialCircles& circles, int most) {
  std::set<std::array<double, 2>> distinct;
  for (const Surface& s : circles.surfaces) distinct.insert({s.from, s.to});
  std::vector<std::array<double, 2>> ends(distinct.begin(), distinct.end());
  // Ordered from the lower side of the section, so that its mirror image tries the same circles.
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

// Trial circles through an entry and an exit on the ground, with several depths each.

namespace {

/// Returns the median distance of neighbouring points [m].
double find_step(const std::vector<double>& points) {
  if (points.size() < 2) return 0;
  std::vector<double> gaps;
  for (std::size_t i = 1; i < points.size(); ++i) gaps.push_back(points[i] - points[i - 1]);
  std::nth_element(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2), gaps.end());
  return gaps[gaps.size() / 2];
}

}  // namespace

std::vector<int> list_directions(const Slope& slope, const EntryExitSearch& ranges) {
  constexpr int samples = 100;
  const auto place = [&](const std::array<double, 2>& range, int i) {
    return std::clamp(range[0] + (range[1] - range[0]) * i / samples, slope.left(), slope.right());
  };
  std::vector<int> directions;
  for (const int direction : {-1, 1}) {
    bool has_pair = false;
    for (int i = 0; i <= samples && !has_pair; ++i)
      for (int k = 0; k <= samples && !has_pair; ++k) {
        const double exit = place(ranges.exit, i), entry = place(ranges.entry, k);
        has_pair = direction * (exit - entry) > 0 && slope.lower_ground(exit) < slope.ground(entry);
      }
    if (has_pair) directions.push_back(direction);
  }
  return directions;
}

TrialCircles make_entry_exit_circles(const Slope& slope, const Arcs& arcs, const SearchOptions& options,
                                     EntryExitSearch& used) {
  TrialCircles circles;
  used = options.entry_exit.value_or(EntryExitSearch{});
  circles.whole_ground = used.is_whole_ground();
  if (circles.whole_ground) used.exit = used.entry = {slope.left(), slope.right()};
  // One tangent leaves one circle between two ends.
  if (options.tangent && options.tangent->upper == options.tangent->lower) used.depths = 1;
  for (auto* range : {&used.exit, &used.entry})
    *range = {std::clamp((*range)[0], slope.left(), slope.right()),
              std::clamp((*range)[1], slope.left(), slope.right())};
  std::vector<double> exits, entries;
  if (circles.whole_ground) {  // any two points; the circle slides to the lower one
    exits = entries = place_points(slope, slope.left(), slope.right(), used.exits + used.entries, options.seed);
  } else {
    exits = place_points(slope, used.exit[0], used.exit[1], used.exits, options.seed);
    entries = place_points(slope, used.entry[0], used.entry[1], used.entries, options.seed);
  }
  const bool exit_left = circles.whole_ground || !options.checks.limits || options.checks.limits->direction <= 0;
  circles.left = exit_left ? used.exit : used.entry;
  circles.right = exit_left ? used.entry : used.exit;
  circles.step = {find_step(exit_left ? exits : entries), find_step(exit_left ? entries : exits)};
  circles.size = {static_cast<int>(exits.size()), static_cast<int>(entries.size()), used.depths};
  for (double exit : exits) {
    throw_if_search_is_interrupted(options.ends_at_signal);
    for (double entry : entries) {
      const double left = exit_left ? exit : entry, right = exit_left ? entry : exit;
      const bool falls = circles.whole_ground || slope.lower_ground(exit) <= slope.ground(entry);
      const auto range = left < right && falls ? arcs.find_range(left, right) : std::nullopt;
      for (int k = 1; k <= used.depths; ++k) {
        circles.first.push_back(static_cast<int>(circles.surfaces.size()));
        if (!range) continue;
        // The shallowest arc is omitted unless it is the only depth.
        const double t = used.depths > 1 ? static_cast<double>(k) / used.depths : 0.5;
        circles.surfaces.push_back(arcs.make_arc(left, right, range->from + t * (range->to - range->from)));
      }
    }
  }
  circles.first.push_back(static_cast<int>(circles.surfaces.size()));
  return circles;
}

// Trial circles about a grid of centres, with radii between two elevations of their deepest points.

GridSearch choose_grid(const std::vector<Point>& ground, double base, GridSearch grid) {
  double low = ground.front()[1], high = low, left = ground.back()[0], right = ground.front()[0], widest = 0, from = 0;
  for (std::size_t i = 0; i < ground.size(); ++i) {
    low = std::min(low, ground[i][1]), high = std::max(high, ground[i][1]);
    if (i == 0 || ground[i][1] == ground[i - 1][1]) continue;
    const bool same = i > 1 && (ground[i][1] - ground[i - 1][1]) * (ground[i - 1][1] - ground[i - 2][1]) > 0;
    from = same ? from : ground[i - 1][0];
    widest = std::max(widest, ground[i][0] - from);
    left = std::min(left, ground[i - 1][0]), right = std::max(right, ground[i][0]);
  }
  if (!(right > left)) left = ground.front()[0], right = ground.back()[0];
  const double height = high - low;
  if (grid.from == grid.to) {
    grid.from = {left, high + 0.05 * height};
    grid.to = {right, high + std::max(1.5 * height, 1.5 * widest)};
  }
  if (!grid.lowest) grid.lowest = std::max(base, low - 1.5 * height);
  if (!grid.highest) grid.highest = high - 0.05 * height;
  return grid;
}

namespace {

/// Returns the point of a polyline that is nearest to p.
Point find_nearest(const Point& p, const std::vector<Point>& line) {
  double least = std::numeric_limits<double>::infinity();
  Point nearest = line.front();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point &a = line[i - 1], &b = line[i];
    const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
    const double t = square > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0.0, 1.0) : 0;
    const Point foot{a[0] + t * dx, a[1] + t * dy};
    const double distance = std::hypot(p[0] - foot[0], p[1] - foot[1]);
    if (distance < least) least = distance, nearest = foot;
  }
  return nearest;
}

}  // namespace

TrialCircles make_grid_circles(const Slope& slope, const SearchOptions& options, GridSearch& used) {
  used = choose_grid(slope.section().ground, slope.section().base, options.grid.value_or(GridSearch{}));
  const std::optional<TangentLines>& tangent = options.tangent;
  if (tangent && tangent->is_level) used.lowest = tangent->lower[0][1], used.highest = tangent->upper[0][1];
  if (tangent && tangent->upper == tangent->lower) used.radii = 1;
  TrialCircles circles;
  circles.whole_ground = true;
  circles.left = circles.right = {slope.left(), slope.right()};
  circles.size = {used.columns, used.rows, used.radii};
  auto between = [](double a, double b, int i, int n) { return n > 1 ? a + (b - a) * i / (n - 1) : 0.5 * (a + b); };
  for (int i = 0; i < used.columns; ++i) {
    throw_if_search_is_interrupted(options.ends_at_signal);
    for (int j = 0; j < used.rows; ++j)
      for (int k = 0; k < used.radii; ++k) {
        circles.first.push_back(static_cast<int>(circles.surfaces.size()));
        const Point centre{between(used.from[0], used.to[0], i, used.columns),
                           between(used.from[1], used.to[1], j, used.rows)};
        // From deep to shallow, in the order of the depths of the other search; slightly above the base, which a circle
        // may touch.
        const double bottom = between(*used.highest, *used.lowest, k, used.radii);
        const Point touch =
            tangent && !tangent->is_level ? find_nearest(centre, tangent->upper) : Point{centre[0], bottom};
        const double radius = centre[1] > touch[1] ? std::hypot(centre[0] - touch[0], centre[1] - touch[1]) : 0;
        if (!(radius > 0)) continue;
        const Circle circle{centre, radius * (1 - 1e-9)};
        for (const auto& [left, right] : find_arcs(slope, circle)) {
          if (tangent && (touch[0] <= left || touch[0] >= right)) continue;
          Surface s;
          s.circle = circle;
          s.from = left, s.to = right;
          circles.surfaces.push_back(s);
        }
      }
  }
  circles.first.push_back(static_cast<int>(circles.surfaces.size()));
  const double step = 0.03 * (slope.right() - slope.left());
  circles.step = {step, step};
  return circles;
}

// Map of the smallest factor per centre of the trial circles.

namespace {

/// Chooses a box of the centres of the circles with the smaller factors; the centres of flat arcs lie very far away.
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
  // The first and the last cells are centred at the ends of the box, so the map extends half a cell beyond it.
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
