// SPDX-License-Identifier: MIT
#pragma once
// Derivative-free minimisation between bounds (NLopt), and the local optimisation of circles and polylines.

#include <functional>
#include <random>
#include <vector>

#include "lem/search/arcs.hpp"
#include "lem/search/search.hpp"

namespace talus::lem {

enum class Minimiser { simplex, subspaces, quadratic };

struct MinimiseOptions {
  Minimiser minimiser = Minimiser::simplex;
  double tolerance = 1e-6;  ///< of the function, relative
  int most_evaluations = 300;
};

struct Minimum {
  std::vector<double> at;
  double value = 0;
  int evaluations = 0;
};

/// Minimises from `start` with initial steps `step`. The start is evaluated first, so the result is never worse.
/// Exceptions of `function` are rethrown.
Minimum minimise(const std::function<double(const std::vector<double>&)>& function, const std::vector<double>& start,
                 const std::vector<double>& step, const std::vector<double>& lower, const std::vector<double>& upper,
                 const MinimiseOptions& options);

// Pseudo-random numbers in [-1, 1] that perturb the starts of a search, identical on every machine.

class RandomParts {
 public:
  /// Spreads the seed: neighbouring seeds of this generator give nearly equal first numbers.
  explicit RandomParts(int seed) : random_(1 + 104729u * static_cast<std::minstd_rand::result_type>(seed)) {}

  /// Returns the next number, computed without the standard distributions, which differ between libraries.
  double draw() {
    constexpr double first = std::minstd_rand::min(), last = std::minstd_rand::max();
    return 2 * (static_cast<double>(random_()) - first) / (last - first) - 1;
  }

 private:
  std::minstd_rand random_;
};

// Local optimisation of a circle: its two ends on the ground and its depth.

/// Ranges of x of the ends of a circle, and initial steps [m].
struct CircleRanges {
  std::array<double, 2> left{}, right{};
  std::array<double, 2> step{};
};

/// Optimises a circle; the result is never worse than `start`. Besides free ends and depth it tries ends tied to
/// corners of the ground, and depths at which the circle just touches a region: the factor has a kink there that a
/// minimiser does not follow.
OptimisedSurface optimise_circle(Evaluator& evaluate, const Arcs& arcs, const Surface& start,
                                 const CircleRanges& ranges);

// Local optimisation of a polyline: its ends on the ground and its vertices.

struct SurfaceRanges {
  std::array<double, 2> left{}, right{};  ///< ranges of x of the ends [m]
  int vertices = 12;                      ///< including the ends
};

/// Returns the lowest and the highest elevation of a polygon at x; none outside its range of x.
std::optional<std::array<double, 2>> find_borders(const std::vector<Point>& polygon, double x);

/// Returns a polyline with `vertices` vertices that approximates a circle (or composite circle) below the ground.
Surface make_polyline(const Slope& slope, const Surface& surface, int vertices);

/// Returns, for the upper and the lower border of each region, the surface with its part below that border lifted onto
/// it: the starts for weak seams.
std::vector<Surface> make_seam_starts(const Slope& slope, const Surface& surface, int vertices);

/// Optimises a polyline; the result is never worse than `start`. Surfaces stay kinematically admissible: convex from
/// below, under the ground and above the base. Starts with few vertices, inserts more, and stops early where `to_beat`
/// is out of reach.
OptimisedSurface optimise_polyline(Evaluator& evaluate, const Surface& start, const SurfaceRanges& ranges,
                                   double to_beat = Evaluator::refused);

}  // namespace talus::lem
