// SPDX-License-Identifier: MIT
// Free and tied optimisation of a circle.

#include "lem/search/optimise_circle.hpp"

#include <algorithm>
#include <cmath>

#include "lem/search/local_minima.hpp"
#include "lem/search/minimise.hpp"

namespace talus::lem {

namespace {

constexpr int most_rounds = 20;
constexpr double least_gain = 1e-4;  ///< of a round, for another one

/// What holds still while the rest is optimised.
struct Tie {
  std::optional<double> left, right;  ///< end at this x [m]
  const Region* touches = nullptr;    ///< the circle just touches it
  bool shallowest = false;            ///< as shallow as a circle between its ends may be
};

/// A circle as the minimisers see it: ends and the place of its half angle in its range.
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

  /// Improves `place` and `value`; true when it did by more than rounding.
  bool improve(const Tie& tie, Place& place, double& value, int most) {
    std::vector<double> start, step, lower, upper;
    auto add = [&](double x, double by, double low, double high) {
      start.push_back(x), step.push_back(by), lower.push_back(low), upper.push_back(high);
    };
    // A circle smaller than the distance of the trial ends would step out of the place that makes it critical.
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

  /// Corners of the ground and edges of loads that an end could snap to: the nearest three.
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

  /// Regions whose touching is not far from the depth of the circle.
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

  /// With the depth tied, and then with one end in a corner besides.
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
      // A simplex may have collapsed: again with fresh steps, while that gains something.
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
  /// The left end and the right one, that at the toe first: the mirror image of a circle is optimised in the same
  /// steps.
  std::array<bool, 2> toe_first() const { return {way_ > 0, way_ < 0}; }

  Evaluator& evaluate_;
  const Arcs& arcs_;
  CircleRanges ranges_;
  double way_ = 1;  ///< turns x to run uphill
  Surface best_;
};

}  // namespace

OptimisedSurface optimise_circle(Evaluator& evaluate, const Arcs& arcs, const Surface& start,
                                 const CircleRanges& ranges) {
  return CircleOptimiser(evaluate, arcs, ranges).run(start);
}

}  // namespace talus::lem
