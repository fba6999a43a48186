// SPDX-License-Identifier: MIT
// Minimisation with NLopt (docs/decisions/0022-optimiser.md gives the choice of algorithms), and with it the local
// optimisation of circles and of polylines.
#include "lem/search/optimise.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>

#include "lem/search/search_findings.hpp"
#include "lem/surface/surface.hpp"

namespace talus::lem {

namespace {

struct Task {
  const std::function<double(const std::vector<double>&)>* function;
  nlopt_opt optimiser;
  Minimum best;
  std::exception_ptr thrown;
};

double evaluate(unsigned n, const double* x, double*, void* data) {
  Task& task = *static_cast<Task*>(data);
  if (task.thrown) return 0;
  try {  // no exception may propagate through a C library
    const std::vector<double> at(x, x + n);
    const double value = (*task.function)(at);
    ++task.best.evaluations;
    if (value < task.best.value) task.best.at = at, task.best.value = value;
    return value;
  } catch (...) {
    task.thrown = std::current_exception();
    nlopt_force_stop(task.optimiser);
    return 0;
  }
}

nlopt_algorithm choose_algorithm(Minimiser minimiser) {
  if (minimiser == Minimiser::subspaces) return NLOPT_LN_SBPLX;
  return minimiser == Minimiser::quadratic ? NLOPT_LN_BOBYQA : NLOPT_LN_NELDERMEAD;
}

}  // namespace

Minimum minimise(const std::function<double(const std::vector<double>&)>& function, const std::vector<double>& start,
                 const std::vector<double>& step, const std::vector<double>& lower, const std::vector<double>& upper,
                 const MinimiseOptions& options) {
  std::vector<double> x = start, steps = step;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::clamp(x[i], lower[i], upper[i]);
    if (x[i] + steps[i] > upper[i]) steps[i] = -steps[i];
    if (x[i] + steps[i] < lower[i]) steps[i] = 0.5 * std::max(upper[i] - x[i], x[i] - lower[i]);
    if (!(upper[i] > lower[i])) steps[i] = 1;
  }
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> optimiser(
      nlopt_create(choose_algorithm(options.minimiser), static_cast<unsigned>(x.size())), nlopt_destroy);
  Task task{&function, optimiser.get(), {x, function(x), 1}, nullptr};
  nlopt_set_min_objective(optimiser.get(), evaluate, &task);
  nlopt_set_lower_bounds(optimiser.get(), lower.data());
  nlopt_set_upper_bounds(optimiser.get(), upper.data());
  nlopt_set_initial_step(optimiser.get(), steps.data());
  nlopt_set_ftol_rel(optimiser.get(), options.tolerance);
  // Absolute, as fractions of the ranges: a tolerance relative to the variables would depend on the origin of the
  // coordinates.
  std::vector<double> nearest;
  for (std::size_t i = 0; i < x.size(); ++i) nearest.push_back(1e-9 * (upper[i] - lower[i]));
  nlopt_set_xtol_abs(optimiser.get(), nearest.data());
  nlopt_set_maxeval(optimiser.get(), options.most_evaluations);
  double value = 0;
  // NLopt's return code gives the reason for stopping; the result is the best point evaluated.
  nlopt_optimize(optimiser.get(), x.data(), &value);
  if (task.thrown) std::rethrow_exception(task.thrown);
  return task.best;
}

// Local optimisation of a circle: with ends and depth free, and with an end tied to a corner of the ground or the
// circle tied to touch a region.

namespace {

constexpr int most_rounds = 20;
constexpr double least_gain = 1e-4;  ///< relative gain below which the rounds end

/// Constraints of one minimisation.
struct Tie {
  std::optional<double> left, right;  ///< x of an end that is tied [m]
  const Region* touches = nullptr;    ///< region that the circle touches
  bool shallowest = false;            ///< the circle is the shallowest between its ends
};

/// Variables of the minimisation: x of the ends, and the half angle as a fraction of its admissible range.
struct Place {
  double left = 0, right = 0, depth = 0;
};

class CircleOptimiser {
 public:
  CircleOptimiser(Evaluator& evaluate, const Arcs& arcs, const CircleRanges& ranges)
      : evaluate_(evaluate), arcs_(arcs), ranges_(ranges) {}

  std::optional<Surface> make(const Place& p, const Region* touches) const {
    const auto range = arcs_.find_range(p.left, p.right);
    if (!range) return {};
    double angle = range->from + p.depth * (range->to - range->from);
    if (touches) {
      const auto touch = arcs_.find_touch(p.left, p.right, *touches);
      if (!touch || *touch < range->from || *touch > range->to) return {};
      angle = *touch;
    }
    auto surface = arcs_.make_arc(p.left, p.right, angle);
    surface.crack = best_.crack;
    return surface;
  }

  /// Improves `place` and `value`; returns true if the gain exceeds rounding.
  bool improve(const Tie& tie, Place& place, double& value, int most) {
    std::vector<double> start, step, lower, upper;
    auto add = [&](double x, double by, double low, double high) {
      start.push_back(x), step.push_back(by), lower.push_back(low), upper.push_back(high);
    };
    // Limits the step for circles smaller than the spacing of the trial ends, which a full step would move out of their
    // minimum.
    const double most_step = 0.25 * (place.right - place.left);
    auto add_end = [&](double x, double by, const std::array<double, 2>& range) {
      const std::array<double, 2> turned{way_ * range[0], way_ * range[1]};
      add(way_ * x, std::min(0.5 * by, most_step), std::min(turned[0], turned[1]), std::max(turned[0], turned[1]));
    };
    for (const bool left : toe_first())
      if (left && !tie.left)
        add_end(place.left, ranges_.step[0], ranges_.left);
      else if (!left && !tie.right)
        add_end(place.right, ranges_.step[1], ranges_.right);
    if (!tie.touches && !tie.shallowest) add(place.depth, 0.05, 0, 1);
    auto read = [&](const std::vector<double>& x) {
      Place p = place;
      std::size_t n = 0;
      for (const bool left : toe_first()) {
        const auto& tied = left ? tie.left : tie.right;
        (left ? p.left : p.right) = tied ? *tied : way_ * x[n++];
      }
      if (!tie.touches) p.depth = tie.shallowest ? 0 : x[n];
      return p;
    };
    auto function = [&](const std::vector<double>& x) {
      const auto surface = make(read(x), tie.touches);
      return surface ? evaluate_(*surface) : Evaluator::refused;
    };
    if (start.empty()) return false;
    const Minimum m = minimise(function, start, step, lower, upper, {Minimiser::simplex, 1e-6, most});
    if (!(m.value < value * (1 - 1e-9))) return false;
    Place better = read(m.at);
    best_ = *make(better, tie.touches);
    if (tie.touches) {
      const auto range = *arcs_.find_range(better.left, better.right);
      better.depth = (Arcs::measure_half_angle(best_) - range.from) / (range.to - range.from);
    }
    place = better, value = m.value;
    return true;
  }

  /// Returns the (at most three) nearest corners of the ground and ends of loads to which an end could be tied.
  std::vector<double> find_corners(double x, double reach, const std::array<double, 2>& range) const {
    std::vector<double> corners;
    auto add = [&](double corner) {
      if (std::abs(corner - x) < reach && corner >= range[0] && corner <= range[1]) corners.push_back(corner);
    };
    for (const Point& p : evaluate_.slope().section().ground) add(p[0]);
    for (const Surcharge& s : evaluate_.slope().section().surcharges)
      if (!s.load.empty()) add(s.load.front()[0]), add(s.load.back()[0]);
    std::sort(corners.begin(), corners.end(), [&](double a, double b) { return std::abs(a - x) < std::abs(b - x); });
    if (corners.size() > 3) corners.resize(3);
    return corners;
  }

  /// Returns the regions that a circle with these ends touches at a half angle of 0.6 to 1.6 times its own, and nullptr
  /// for none.
  std::vector<const Region*> find_regions(const Place& place) const {
    std::vector<const Region*> regions{nullptr};
    const auto range = arcs_.find_range(place.left, place.right);
    if (!range) return regions;
    const double angle = range->from + place.depth * (range->to - range->from);
    for (const Region& r : arcs_.regions()) {
      const auto touch = arcs_.find_touch(place.left, place.right, r);
      if (touch && *touch > 0.6 * angle && *touch < 1.6 * angle) regions.push_back(&r);
    }
    return regions;
  }

  /// Minimises with the depth tied, and then with one end tied to a corner as well.
  void try_ties(Tie tie, Place& place, double& value) {
    const Place base = place;
    if (tie.touches) improve(tie, place, value, 120);
    for (const bool left : toe_first()) {
      auto& end = left ? tie.left : tie.right;
      const auto corners = left ? find_corners(base.left, 2 * ranges_.step[0], ranges_.left)
                                : find_corners(base.right, 2 * ranges_.step[1], ranges_.right);
      for (const double x : corners) end = x, improve(tie, place, value, 100);
      end = {};
    }
  }

  OptimisedSurface run(const Surface& start) {
    Place place{start.from, start.to, 0};
    best_ = start;
    way_ = falls_left(evaluate_.slope(), start) ? 1 : -1;
    double value = evaluate_(start);
    const auto range = arcs_.find_range(place.left, place.right);
    if (range && range->to > range->from) {
      place.depth = std::clamp((Arcs::measure_half_angle(start) - range->from) / (range->to - range->from), 0.0, 1.0);
      improve({}, place, value, 200);
      for (const Region* region : find_regions(place)) try_ties({{}, {}, region, false}, place, value);
      // The simplex may have degenerated: restart with fresh steps as long as that gains something.
      for (int round = 0; round < most_rounds; ++round) {
        const double before = value;
        improve({}, place, value, 150);
        improve({{}, {}, nullptr, true}, place, value, 120);
        if (!(value < (1 - least_gain) * before)) break;
      }
    }
    return {best_, value, evaluate_.count()};
  }

 private:
  /// The left and the right end, the one at the toe first, so that the mirror image of a circle is optimised in the
  /// same steps.
  std::array<bool, 2> toe_first() const { return {way_ > 0, way_ < 0}; }

  Evaluator& evaluate_;
  const Arcs& arcs_;
  CircleRanges ranges_;
  double way_ = 1;  ///< sign that makes x increase uphill
  Surface best_;
};

}  // namespace

OptimisedSurface optimise_circle(Evaluator& evaluate, const Arcs& arcs, const Surface& start,
                                 const CircleRanges& ranges) {
  return CircleOptimiser(evaluate, arcs, ranges).run(start);
}

// Local optimisation of a polyline: rounds of a minimiser over the vertices, with vertices inserted in between.

namespace {

constexpr int samples = 60;
/// Relative tolerances of the rounds with all vertices, and of the earlier ones.
constexpr double fine = 1e-6, coarse = 1e-5;
/// A start is abandoned when its value exceeds the best one by more than this multiple of the gain of a round.
constexpr double patience = 10;

/// Returns points of a surface between its ends.
std::vector<Point> sample(const Slope& slope, const Surface& surface) {
  const auto [left, right] = find_ends(surface);
  std::vector<Point> points;
  for (int i = 1; i < samples; ++i) {
    const double x = left + (right - left) * i / samples;
    points.push_back({x, find_elevation(slope, surface, x)});
  }
  return points;
}

class PolylineOptimiser {
 public:
  PolylineOptimiser(Evaluator& evaluate, const SurfaceRanges& ranges) : evaluate_(evaluate), ranges_(ranges) {
    const auto& ground = slope().section().ground;
    for (const Point& p : ground) highest_ = std::max(highest_, p[1]);
  }

  /// Abandons the start when it does not come near `to_beat`.
  OptimisedSurface run(const Surface& start, double to_beat) {
    const double value_of_start = evaluate_(start);
    falls_left_ = falls_left(slope(), start);
    // A few vertices first, which can move far; further ones then follow the shape.
    int count = std::min(6, ranges_.vertices);
    const auto thin = thin_points(start.line, count);
    set(hang(thin.front()[0], thin.back()[0], thin));
    if (value_ == Evaluator::refused) set(start);
    double reach = 0.1;
    for (int round = 0; round < 12; ++round) {
      const double before = value_;
      const bool full = static_cast<int>(line_.size()) >= ranges_.vertices;
      improve_all(reach, full ? fine : coarse);
      snap();
      slide();
      if (round > 0 && value_ - to_beat > patience * (before - value_)) break;
      if (full && value_ > before * (1 - 1e-4)) {
        if (reach < 0.03) break;
        reach *= 0.4;
      }
      insert(count += 2);
    }
    if (!(value_ < value_of_start)) return {start, value_of_start, evaluate_.count()};
    Surface best;
    best.line = best_;
    return {best, value_, evaluate_.count()};
  }

 private:
  const Slope& slope() const { return evaluate_.slope(); }

  /// Returns the admissible polyline through the points. A vertex closer to the border of a region than 0.1 % of the
  /// width is moved just above it: cut_surface() has a tolerance there, which a minimiser would exploit to pass through
  /// strong soil with the strength of the weak one.
  Surface hang(double left, double right, std::vector<Point> points) const {
    const double near = 1e-3 * (right - left), hair = 1e-7 * (slope().right() - slope().left());
    for (Point& p : points)
      for (const Region& region : slope().section().regions) {
        const auto borders = find_borders(region.polygon, p[0]);
        if (!borders) continue;
        for (const double y : *borders)
          if (std::abs(p[1] - y) < near && y < slope().ground(p[0]) - near) p[1] = y + hair;
      }
    return hang_polyline(slope(), left, right, points);
  }

  void set(const Surface& s) { line_ = best_ = s.line, value_ = evaluate_(s); }

  /// Keeps a surface if its value is smaller.
  void take(const Surface& s) {
    if (s.line.size() < 3) return;
    const double value = evaluate_(s);
    if (value < value_) line_ = best_ = s.line, value_ = value;
  }

  /// Index of vertex `i` counted from the lower end.
  std::size_t at(const std::vector<Point>& line, std::size_t i) const { return falls_left_ ? i : line.size() - 1 - i; }

  /// Minimises over all vertices and both ends.
  void improve_all(double reach, double tolerance) {
    const std::vector<Point> old = line_;
    const double width = old.back()[0] - old.front()[0], depth = std::max(0.02 * width, measure_depth());
    const double way = falls_left_ ? 1 : -1;
    std::vector<double> start, step, lower, upper;
    auto add = [&](double at, double by, double low, double high) {
      start.push_back(at), step.push_back(by), lower.push_back(low), upper.push_back(high);
    };
    auto add_x = [&](double x, const std::array<double, 2>& range) {
      add(way * x, 0.3 * reach * width, std::min(way * range[0], way * range[1]),
          std::max(way * range[0], way * range[1]));
    };
    add_x(old[at(old, 0)][0], falls_left_ ? ranges_.left : ranges_.right);
    add_x(old[at(old, old.size() - 1)][0], falls_left_ ? ranges_.right : ranges_.left);
    for (std::size_t i = 1; i + 1 < old.size(); ++i) {
      add_x(old[at(old, i)][0], {slope().left(), slope().right()});
      add(old[at(old, i)][1], reach * depth, slope().section().base, highest_);
    }
    auto read = [&](const std::vector<double>& x) {
      std::vector<Point> points;
      for (std::size_t i = 2; i < x.size(); i += 2) points.push_back({way * x[i], x[i + 1]});
      return hang(std::min(way * x[0], way * x[1]), std::max(way * x[0], way * x[1]), points);
    };
    auto function = [&](const std::vector<double>& x) {
      if (!(x[1] - x[0] > 0.01 * width)) return Evaluator::refused;
      const Surface s = read(x);
      return s.line.size() < 3 ? Evaluator::refused : evaluate_(s);
    };
    const int most = 120 * static_cast<int>(start.size());
    const Minimum m = minimise(function, start, step, lower, upper, {Minimiser::subspaces, tolerance, most});
    if (m.value < value_) line_ = best_ = read(m.at).line, value_ = m.value;
  }

  double measure_depth() const {
    double depth = 0;
    for (const Point& p : line_) depth = std::max(depth, slope().ground(p[0]) - p[1]);
    return depth;
  }

  /// Moves vertices onto nearby borders of regions (the bottom of a weak seam, the top of a strong layer), by a
  /// rounding distance above them so that the base lies in the upper soil.
  void snap() {
    const double reach = 0.15 * measure_depth(), hair = 1e-7 * (slope().right() - slope().left());
    for (std::size_t i = 1; i + 1 < line_.size(); ++i)
      for (const Region& region : slope().section().regions) {
        if (i + 1 >= line_.size()) break;
        const auto borders = find_borders(region.polygon, line_[at(line_, i)][0]);
        if (!borders) continue;
        for (double y : *borders) {
          if (i + 1 >= line_.size() || std::abs(line_[at(line_, i)][1] - y) > reach) continue;
          std::vector<Point> points = line_;
          points[at(line_, i)][1] = y + hair;
          take(hang(points.front()[0], points.back()[0], points));
        }
      }
  }

  /// Moves one vertex after another towards either neighbour, with shrinking steps. Corners of the surface move along
  /// seams in this way.
  void slide() {
    for (double part : {0.5, 0.2, 0.05})
      for (std::size_t i = 1; i + 1 < line_.size(); ++i)
        for (const int to : {-1, 1}) {
          if (i + 1 >= line_.size()) break;
          std::vector<Point> points = line_;
          const Point& other = points[at(points, i + static_cast<std::size_t>(to + 1) - 1)];
          Point& moved = points[at(points, i)];
          moved = {moved[0] + part * (other[0] - moved[0]), moved[1] + part * (other[1] - moved[1])};
          take(hang(points.front()[0], points.back()[0], points));
        }
  }

  /// Splits the longest edges until there are `count` vertices.
  void insert(int count) {
    const int most = std::min(count, ranges_.vertices);
    while (static_cast<int>(line_.size()) < most) {
      const std::size_t edges = line_.size() - 1;
      const auto edge = [&](std::size_t i) { return falls_left_ ? i : edges + 1 - i; };
      std::size_t longest = edge(1);
      auto length = [&](std::size_t i) {
        return std::hypot(line_[i][0] - line_[i - 1][0], line_[i][1] - line_[i - 1][1]);
      };
      for (std::size_t i = 2; i <= edges; ++i)
        if (length(edge(i)) > length(longest)) longest = edge(i);
      const Point &a = line_[longest - 1], &b = line_[longest];
      // Slightly below the middle of the edge: the convex hull would drop a vertex on it.
      const Point middle{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) - 1e-6 * (b[0] - a[0])};
      line_.insert(line_.begin() + static_cast<std::ptrdiff_t>(longest), middle);
    }
  }

  Evaluator& evaluate_;
  SurfaceRanges ranges_;
  std::vector<Point> line_;  ///< working polyline: the best one with inserted vertices
  std::vector<Point> best_;
  double value_ = 0, highest_ = -1e300;
  bool falls_left_ = true;
};

}  // namespace

std::optional<std::array<double, 2>> find_borders(const std::vector<Point>& polygon, double x) {
  std::optional<std::array<double, 2>> borders;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a[0] <= x) == (b[0] <= x)) continue;
    const double y = a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
    borders = borders ? std::array<double, 2>{std::min((*borders)[0], y), std::max((*borders)[1], y)}
                      : std::array<double, 2>{y, y};
  }
  return borders;
}

Surface make_polyline(const Slope& slope, const Surface& surface, int vertices) {
  const auto [left, right] = find_ends(surface);
  const auto line = hang_polyline(slope, left, right, sample(slope, surface)).line;
  const auto thin = thin_points(line, vertices);
  return hang_polyline(slope, left, right, thin);
}

std::vector<Surface> make_seam_starts(const Slope& slope, const Surface& surface, int vertices) {
  const auto [left, right] = find_ends(surface);
  const double hair = 1e-7 * (slope.right() - slope.left());
  const std::vector<Point> points = sample(slope, surface);
  std::vector<Surface> starts;
  for (const Region& region : slope.section().regions)
    for (const std::size_t side : {0u, 1u}) {
      std::vector<Point> lifted = points;
      int touched = 0;
      for (Point& p : lifted) {
        const auto borders = find_borders(region.polygon, p[0]);
        if (!borders || p[1] >= (*borders)[side] || (*borders)[side] > slope.ground(p[0])) continue;
        p[1] = (*borders)[side] + hair;
        ++touched;
      }
      if (touched < samples / 10) continue;
      const auto thin = thin_points(hang_polyline(slope, left, right, lifted).line, vertices);
      starts.push_back(hang_polyline(slope, left, right, thin));
    }
  return starts;
}

OptimisedSurface optimise_polyline(Evaluator& evaluate, const Surface& start, const SurfaceRanges& ranges,
                                   double to_beat) {
  return PolylineOptimiser(evaluate, ranges).run(start, to_beat);
}

}  // namespace talus::lem
