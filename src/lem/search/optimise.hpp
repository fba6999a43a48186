// SPDX-License-Identifier: MIT
#pragma once
// The smallest value of a function between bounds without its derivatives, by NLopt.

#include <functional>
#include <random>
#include <vector>

#include "lem/search/search.hpp"
#include "lem/surface/arcs.hpp"

namespace talus::lem {

enum class Minimiser { simplex, subspaces, quadratic };

struct MinimiseOptions {
  Minimiser minimiser = Minimiser::simplex;
  double tolerance = 1e-6;  ///< relative, of the function
  int most_evaluations = 300;
};

struct Minimum {
  std::vector<double> at;
  double value = 0;
  int evaluations = 0;
};

/// Starts at `start` with steps `step` per variable. The start counts as tried: the result is never worse. Exceptions
/// of `function` are passed on.
Minimum minimise(const std::function<double(const std::vector<double>&)>& function, const std::vector<double>& start,
                 const std::vector<double>& step, const std::vector<double>& lower, const std::vector<double>& upper,
                 const MinimiseOptions& options);

// Numbers between -1 and 1 that move the starts of a search: the same ones on every machine.

class RandomParts {
 public:
  /// Seeds side by side begin with near numbers in this generator, so they are spread.
  explicit RandomParts(int seed) : random_(1 + 104729u * static_cast<std::minstd_rand::result_type>(seed)) {}

  /// The next one. The standard's distributions differ between libraries; its generators do not.
  double draw() {
    constexpr double first = std::minstd_rand::min(), last = std::minstd_rand::max();
    return 2 * (static_cast<double>(random_()) - first) / (last - first) - 1;
  }

 private:
  std::minstd_rand random_;
};

// Local optimisation of a circle: its two ends on the ground and its depth.

/// Where the ends of a circle may go, and how far the first steps reach [m].
struct CircleRanges {
  std::array<double, 2> left{}, right{};
  std::array<double, 2> step{};
};

/// Never worse than `start`. Besides free ends and depth it tries ends held in corners of the ground, and depths at
/// which the circle just touches a region: the factor has a crease there that a minimiser does not follow.
OptimisedSurface optimise_circle(Evaluator& evaluate, const Arcs& arcs, const Surface& start,
                                 const CircleRanges& ranges);

// Local optimisation of a surface of any shape: the vertices of a polyline.

struct SurfaceRanges {
  std::array<double, 2> left{}, right{};  ///< where the ends may go [m]
  int vertices = 12;                      ///< the ends included
};

/// Lowest and highest elevation of a polygon at x; none beside it.
std::optional<std::array<double, 2>> find_borders(const std::vector<Point>& polygon, double x);

/// The polyline with `vertices` vertices through a circle (or composite circle), lying below the ground.
Surface make_polyline(const Slope& slope, const Surface& surface, int vertices);

/// The same surface, but nowhere below the upper or lower border of a region: the starts for weak seams.
std::vector<Surface> make_seam_starts(const Slope& slope, const Surface& surface, int vertices);

/// Never worse than `start`. Surfaces stay kinematically admissible: no steeper towards the toe, under the ground,
/// above the base. Begins with few vertices and inserts more, and gives up where `to_beat` is out of reach.
OptimisedSurface optimise_polyline(Evaluator& evaluate, const Surface& start, const SurfaceRanges& ranges,
                                   double to_beat = Evaluator::refused);

}  // namespace talus::lem
