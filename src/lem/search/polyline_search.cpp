// SPDX-License-Identifier: MIT
// Starts of the polylines (circles, blocks, given surfaces), their optimisation, and the choice of the best for
// each method.
#include "lem/search/trial_circles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "lem/search/optimise.hpp"
#include "lem/search/search.hpp"
#include "lem/search/search_findings.hpp"
#include "lem/surface/surface.hpp"

namespace talus::lem {
namespace {

/// Places along each border at which blocks begin and end.
constexpr int stations = 16;
/// Inclinations of the end wedges of a block: active and passive Rankine planes for φ = 30° [rad]. The optimisation
/// changes them.
constexpr double active = 60 * std::numbers::pi / 180, passive = 30 * std::numbers::pi / 180;
/// Numbers of starts that are optimised, from circles and from blocks.
constexpr std::size_t circle_starts = 2, block_starts = 2;
/// Number of starts that are optimised when surfaces of a similar slope are given.
constexpr std::size_t starts_beside_known = 2;
constexpr int shakes = 2;
/// Perturbation of a vertex over the depth of the mass [-].
constexpr double shake = 0.15;
/// Two masses with a greater overlap are assumed to lead to the same minimum.
constexpr double same_mass = 0.9;

/// Returns where the line from `from` that rises at `angle` in the direction `way` (-1, 1) of x meets the ground;
/// nothing if that is outside the model.
std::optional<double> find_exit(const Slope& slope, const Point& from, int way, double angle) {
  const double farthest = way < 0 ? from[0] - slope.left() : slope.right() - from[0], rise = std::tan(angle);
  constexpr int steps = 200;
  double before = 0;
  for (int i = 1; i <= steps; ++i) {
    const double run = farthest * i / steps, x = from[0] + way * run;
    const double above = from[1] + rise * run - slope.ground(x);
    if (above >= 0) {
      const double share = i == 1 ? 0 : before / (before - above);
      return from[0] + way * farthest * (i - 1 + share) / steps;
    }
    before = above;
  }
  return std::nullopt;
}

struct Start {
  Surface surface;
  double factor;
};

/// Adds to `chosen` the best `count` starts, at most, that differ from one another and from those in it.
void choose(const Slope& slope, std::vector<Start> starts, std::size_t count, std::vector<Start>& chosen) {
  std::stable_sort(starts.begin(), starts.end(), [](auto& a, auto& b) { return a.factor < b.factor; });
  const std::size_t most = chosen.size() + count;
  for (Start& s : starts) {
    if (chosen.size() == most) return;
    const bool known = std::any_of(chosen.begin(), chosen.end(), [&](const Start& other) {
      return measure_overlap(slope, s.surface, other.surface) > same_mass;
    });
    if (!known) chosen.push_back(std::move(s));
  }
}

/// Search for the critical polyline of one method.
class PolylineSearch {
 public:
  PolylineSearch(const Slope& slope, const SearchOptions& options, Method method, const SurfaceRanges& ranges)
      : evaluate_(slope, method, options.checks, options.slices, options.ends_at_signal),
        ranges_(ranges),
        seed_(options.seed) {}

  /// Starts from circles, also lifted onto the borders of regions, and from blocks.
  void search(const std::vector<Surface>& circles, const std::vector<Surface>& blocks) {
    std::vector<Start> from_circles, from_blocks, chosen;
    for (const Surface& circle : circles) {
      add(make_polyline(slope(), circle, ranges_.vertices), from_circles);
      for (const Surface& s : make_seam_starts(slope(), circle, ranges_.vertices)) add(s, from_circles);
    }
    for (const Surface& block : blocks) add(block, from_blocks);
    choose(slope(), std::move(from_circles), circle_starts, chosen);
    choose(slope(), std::move(from_blocks), block_starts, chosen);
    for (const Start& s : chosen) improve(s.surface);
  }

  /// The same with additional starts from the surfaces of a similar slope.
  void follow(const std::vector<Surface>& known, const std::vector<Surface>& circles,
              const std::vector<Surface>& blocks) {
    std::vector<Start> starts, chosen;
    for (const Surface& s : known) add(s, starts);
    for (const Surface& circle : circles) add(make_polyline(slope(), circle, ranges_.vertices), starts);
    for (const Surface& block : blocks) add(block, starts);
    choose(slope(), std::move(starts), starts_beside_known, chosen);
    for (const Start& s : chosen) improve(s.surface);
  }

  void improve(const Surface& start) {
    const OptimisedSurface found = optimise_polyline(evaluate_, start, ranges_, best_.factor);
    if (found.factor < best_.factor) best_ = found;
  }

  /// Restarts from perturbations of the best surface, since a minimiser may stop at a kink of the factor.
  void shake_best() {
    RandomParts parts(seed_);
    for (int i = 0; i < shakes && !best_.surface.line.empty(); ++i) {
      const std::vector<Point> line = best_.surface.line;
      double depth = 0;
      for (const Point& p : line) depth = std::max(depth, slope().ground(p[0]) - p[1]);
      std::vector<Point> moved(line.begin() + 1, line.end() - 1);
      const double way = falls_left(slope(), best_.surface) ? 1 : -1;
      const auto shake_point = [&](Point& p) {
        p[0] += way * shake * depth * parts.draw();
        p[1] += shake * depth * parts.draw();
      };
      if (way > 0)
        std::for_each(moved.begin(), moved.end(), shake_point);
      else
        std::for_each(moved.rbegin(), moved.rend(), shake_point);
      const Surface start = hang_polyline(slope(), line.front()[0], line.back()[0], moved);
      if (start.line.size() > 2 && evaluate_(start) < Evaluator::refused) improve(start);
    }
  }

  const OptimisedSurface& best() const { return best_; }

  /// Returns the best surface whose factor passes the wedge check; refused if there is none.
  OptimisedSurface select_admissible() {
    if (evaluate_.passing().factor > best_.factor) {
      best_ = evaluate_.passing();
      evaluate_.steepen();
      improve(Surface(best_.surface));  // a copy: best_ may change during the call
    }
    const OptimisedSurface& passing = evaluate_.passing();
    if (evaluate_.passes_all_checks(passing.surface)) return passing;
    return {{}, Evaluator::refused, best_.evaluations};
  }

 private:
  const Slope& slope() const { return evaluate_.slope(); }

  void add(const Surface& s, std::vector<Start>& starts) {
    if (s.line.size() < 3 || !is_in(s.line.front()[0], ranges_.left) || !is_in(s.line.back()[0], ranges_.right)) return;
    const double factor = evaluate_(s);
    if (factor < Evaluator::refused) starts.push_back({s, factor});
  }

  static bool is_in(double x, const std::array<double, 2>& range) {
    const double rounding = 1e-9 * (range[1] - range[0]);
    return x >= range[0] - rounding && x <= range[1] + rounding;
  }

  Evaluator evaluate_;
  SurfaceRanges ranges_;
  int seed_;
  OptimisedSurface best_{{}, Evaluator::refused, 0};
};

/// Returns the circles that polylines of a method start from: its minima, and the best trial circle of each depth,
/// since a seam may lie where no circle is critical.
std::vector<Surface> choose_circles(const TrialCircles& circles, const SearchResult& result, std::size_t method,
                                    const std::vector<OptimisedSurface>& minima) {
  std::vector<Surface> starts;
  for (std::size_t i = 0; i < std::min<std::size_t>(minima.size(), 2); ++i) starts.push_back(minima[i].surface);
  const int depths = circles.size[2];
  const std::size_t cells = circles.first.size() - 1;
  for (int k = 0; k < depths; ++k) {
    int best = -1;
    for (std::size_t cell = static_cast<std::size_t>(k); cell < cells; cell += static_cast<std::size_t>(depths))
      for (int s = circles.first[cell]; s < circles.first[cell + 1]; ++s) {
        const float f = result.trials[static_cast<std::size_t>(s)].factors[method];
        if (f > 0 && (best < 0 || f < result.trials[static_cast<std::size_t>(best)].factors[method])) best = s;
      }
    if (best >= 0) starts.push_back(circles.surfaces[static_cast<std::size_t>(best)]);
  }
  return starts;
}

}  // namespace

std::vector<Surface> make_blocks(const Slope& slope, int vertices, int seed) {
  const double width = slope.right() - slope.left(), hair = 1e-7 * width;
  std::vector<Surface> blocks;
  RandomParts parts(seed);
  // Border 0 is the base of the section from side to side; then follow the lower and the upper border of each region.
  for (std::size_t border = 0; border < 1 + 2 * slope.section().regions.size(); ++border) {
    std::vector<Point> places;
    for (int i = 1; i < stations; ++i) {
      const double x = slope.left() + width * (i + (seed > 0 ? 0.5 * parts.draw() : 0)) / stations;
      std::optional<double> y = slope.section().base;
      if (border > 0) {
        const auto borders = find_borders(slope.section().regions[(border - 1) / 2].polygon, x);
        y = borders ? std::optional((*borders)[(border - 1) % 2]) : std::nullopt;
      }
      if (y && *y < slope.ground(x) - 1e-3 * width) places.push_back({x, *y + hair});
    }
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t j = i + 1; j < places.size(); ++j) {
        const bool falls_right = slope.ground(places[i][0]) > slope.ground(places[j][0]);
        const auto left = find_exit(slope, places[i], -1, falls_right ? active : passive),
                   right = find_exit(slope, places[j], 1, falls_right ? passive : active);
        if (!left || !right) continue;
        const std::vector<Point> bed(places.begin() + static_cast<std::ptrdiff_t>(i),
                                     places.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        const auto thin = thin_points(hang_polyline(slope, *left, *right, bed).line, vertices);
        blocks.push_back(hang_polyline(slope, *left, *right, thin));
      }
  }
  return blocks;
}

namespace {

/// Returns polylines that pass behind the ends of bars, from a corner of the ground or a flat lower end to a steep
/// upper one, for pairs of ends.
std::vector<Surface> make_bar_starts(const Slope& slope, int vertices) {
  std::vector<Point> ends = list_bar_ends(slope.section());
  std::sort(ends.begin(), ends.end());
  std::erase_if(ends, [&](const Point& p) {
    return !(p[0] > slope.left() && p[0] < slope.right() && p[1] < slope.ground(p[0]));
  });
  const std::vector<Point>& ground = slope.section().ground;
  std::vector<Surface> starts;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i; j < ends.size(); ++j)
      for (const bool falls_right : {false, true}) {
        const Point &lower = falls_right ? ends[j] : ends[i], &upper = falls_right ? ends[i] : ends[j];
        const int down = falls_right ? 1 : -1;
        const auto top = find_exit(slope, upper, -down, active);
        if (!top || slope.ground(upper[0]) < slope.ground(lower[0])) continue;
        std::vector<double> toes;
        if (const auto toe = find_exit(slope, lower, down, passive)) toes.push_back(*toe);
        for (const Point& p : ground)
          if ((p[0] - lower[0]) * down > 0 && p[1] < slope.ground(*top)) toes.push_back(p[0]);
        const std::vector<Point> bed(ends.begin() + static_cast<std::ptrdiff_t>(i),
                                     ends.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        for (const double toe : toes) {
          const double left = std::min(toe, *top), right = std::max(toe, *top);
          const auto thin = thin_points(hang_polyline(slope, left, right, bed).line, vertices);
          starts.push_back(hang_polyline(slope, left, right, thin));
        }
      }
  return starts;
}

/// Returns the nearest point of the ground on the line through a point of it, in the direction `way` of x below the
/// ground; nothing if the line leaves the section otherwise.
std::optional<double> find_crossing(const Slope& slope, const Point& from, int way, double rise) {
  const std::vector<Point>& ground = slope.section().ground;
  const double least = 1e-6 * (slope.right() - slope.left());
  const auto find_depth = [&](const Point& p) { return p[1] - from[1] - rise * (p[0] - from[0]); };
  std::optional<double> nearest;
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const double a = find_depth(ground[i - 1]), b = find_depth(ground[i]);
    if ((a > 0) == (b > 0)) continue;
    const double x = ground[i - 1][0] + (ground[i][0] - ground[i - 1][0]) * a / (a - b);
    if (way * (x - from[0]) > least && (!nearest || way * (x - *nearest) < 0)) nearest = x;
  }
  if (!nearest || *nearest <= slope.left() || *nearest >= slope.right()) return std::nullopt;
  const double middle = 0.5 * (from[0] + *nearest), y = from[1] + rise * (middle - from[0]);
  if (y >= slope.ground(middle) || y <= slope.section().base) return std::nullopt;
  return nearest;
}

/// Returns polylines along the weakest planes of soils whose strength has a direction, from corners of the ground and
/// places between them: through the slope, or along a part of that line and steeply up.
std::vector<Surface> make_bedding_starts(const Slope& slope) {
  constexpr double steepest = 80 * std::numbers::pi / 180;
  std::vector<double> rises, places;
  for (const Soil& soil : slope.section().soils)
    if (soil.law)
      for (const double inclination : soil.law->weak_inclinations)
        if (std::abs(inclination) < steepest) rises.push_back(std::tan(inclination));
  if (rises.empty()) return {};
  for (const Point& p : slope.section().ground) places.push_back(p[0]);
  for (int i = 1; i < stations; ++i) places.push_back(slope.left() + (slope.right() - slope.left()) * i / stations);
  std::erase_if(places, [&](double x) { return x <= slope.left() || x >= slope.right(); });
  std::vector<Surface> starts;
  const auto add = [&](double one, double other, const Point& between) {
    starts.push_back(hang_polyline(slope, std::min(one, other), std::max(one, other), {between}));
  };
  constexpr int parts = 4;
  for (const double rise : rises)
    for (const double x : places)
      for (const int way : {-1, 1}) {
        const Point from{x, slope.lower_ground(x)};
        const auto to = find_crossing(slope, from, way, rise);
        if (!to) continue;
        for (int i = 1; i < parts; ++i) {
          const double run = (*to - x) * i / parts;
          const Point bend{x + run, from[1] + rise * run};
          if (const auto top = find_exit(slope, bend, way, active)) add(x, *top, bend);
          // A straight line has a vertex so little below it that its parts keep their inclination.
          if (2 * i == parts) add(x, *to, {bend[0], bend[1] - 1e-10 * std::abs(run)});
        }
      }
  return starts;
}

}  // namespace

std::vector<OptimisedSurface> find_polylines(const Slope& slope, const SearchOptions& options,
                                             const TrialCircles& circles, const SearchResult& result,
                                             const std::vector<std::vector<OptimisedSurface>>& minima) {
  const SurfaceRanges ranges{circles.left, circles.right, options.vertices};
  std::vector<PolylineSearch> searches;
  for (const Method method : options.methods) searches.emplace_back(slope, options, method, ranges);
  std::vector<Surface> blocks = make_blocks(slope, options.vertices, options.seed);
  for (Surface& start : make_bar_starts(slope, options.vertices)) blocks.push_back(std::move(start));
  for (Surface& start : make_bedding_starts(slope)) blocks.push_back(std::move(start));
  const auto for_each = [&](auto&& work) {
    parallel_tasks(static_cast<int>(searches.size()), options.threads, [&](int i) {
      const auto m = static_cast<std::size_t>(i);
      if (suits_polylines(options.methods[m])) work(m);
    });
  };
  for_each([&](std::size_t m) {
    const std::vector<Surface> starts = choose_circles(circles, result, m, minima[m]);
    if (options.known.empty())
      searches[m].search(starts, blocks);
    else
      searches[m].follow(options.known, starts, blocks);
  });
  // The best surfaces of all methods are starts for the others; then each method restarts from perturbations of its
  // own.
  std::vector<Surface> found;
  for (const PolylineSearch& s : searches) found.push_back(s.best().surface);
  for_each([&](std::size_t m) {
    if (!options.known.empty()) return;
    for (std::size_t i = 0; i < found.size(); ++i)
      if (i != m && !found[i].line.empty()) searches[m].improve(found[i]);
    searches[m].shake_best();
  });
  std::vector<OptimisedSurface> best;
  for (PolylineSearch& s : searches) best.push_back(s.select_admissible());
  return best;
}

}  // namespace talus::lem
