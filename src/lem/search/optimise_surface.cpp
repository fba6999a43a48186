// SPDX-License-Identifier: MIT
// Optimisation of polylines: rounds of a minimiser over the vertices, with vertices inserted in between.

#include "lem/search/optimise_surface.hpp"

#include <algorithm>
#include <cmath>

#include "lem/search/local_minima.hpp"
#include "lem/search/minimise.hpp"
#include "lem/surface/polyline_shape.hpp"

namespace talus::lem {

namespace {

constexpr int samples = 60;
/// Relative tolerances of the rounds with all vertices, and of those before.
constexpr double fine = 1e-6, coarse = 1e-5;
/// A start that is above the best one by more than so many times what a round gained is given up.
constexpr double patience = 10;

/// Points of a surface between its ends.
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

  /// `to_beat`: the start is given up where it does not come near that value.
  OptimisedSurface run(const Surface& start, double to_beat) {
    const double value_of_start = evaluate_(start);
    falls_left_ = falls_left(slope(), start);
    // Coarse first: few vertices move far; then more follow the shape.
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

  /// A vertex within a hand's breadth of a border of a region lies on it, a hair above: cutting a surface allows for
  /// rounding there, which a minimiser would use to run through strong soil as if it were weak.
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

  /// Keeps a surface when it is better.
  void take(const Surface& s) {
    if (s.line.size() < 3) return;
    const double value = evaluate_(s);
    if (value < value_) line_ = best_ = s.line, value_ = value;
  }

  /// Number of vertex `i` counted from the lower end.
  std::size_t at(const std::vector<Point>& line, std::size_t i) const { return falls_left_ ? i : line.size() - 1 - i; }

  /// All vertices and both ends at once.
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

  /// Moves vertices onto borders of regions beside them: the bottom of a weak seam, the top of a strong layer. A hair
  /// above, so that the base lies in the upper soil.
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

  /// Moves one vertex after another along its two edges and up and down, with shrinking steps: corners of the surface
  /// travel along seams this way.
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
      // A hair below the middle, or the hull would drop it again.
      const Point middle{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) - 1e-6 * (b[0] - a[0])};
      line_.insert(line_.begin() + static_cast<std::ptrdiff_t>(longest), middle);
    }
  }

  Evaluator& evaluate_;
  SurfaceRanges ranges_;
  std::vector<Point> line_;  ///< worked on: the best one, with inserted vertices
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
