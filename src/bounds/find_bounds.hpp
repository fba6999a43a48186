// SPDX-License-Identifier: MIT
#pragma once
// The interval that holds the factor of safety: both programs, on meshes that become finer where the gap is.

#include <functional>
#include <limits>
#include <string>

#include "bounds/check.hpp"
#include "bounds/factor_search.hpp"

namespace talus::bounds {

struct BoundsOptions {
  double gap = 0;          ///< of the interval over its middle, at which the meshes end
  int most_triangles = 0;  ///< a mesh with as many is the last
  double start = 1;        ///< a factor to begin with
  /// Meshes on which the programs come within the gap but their fields prove a wider interval, before the search stops.
  int most_unproven = std::numeric_limits<int>::max();
  int threads = 1;  ///< 2: both programs of a mesh at once
  FactorRange range;
};

/// One mesh.
struct BoundsLevel {
  int triangles = 0;
  double lower = 0, upper = 0;  ///< proven
  int programs = 0, iterations = 0;
  double seconds = 0;  ///< since the beginning
};

struct BoundsResult {
  /// Largest factor of a field that holds, smallest factor of one that moves: of all meshes. 0 and infinite where none
  /// was found.
  double lower = 0, upper = 0;
  std::string no_lower, no_upper;  ///< why there is none; empty where there is one
  std::string stopped;             ///< why no finer mesh followed, but the gap or the size; empty else
  Problem problem;                 ///< the finest mesh
  /// The fields that prove, with the meshes they are on.
  Problem stress_problem, velocity_problem;
  StressField stress;
  VelocityField velocity;
  StaticCheck static_check;
  KinematicCheck kinematic_check;
  std::vector<BoundsLevel> levels;
};

BoundsResult find_bounds(const Problem& problem, const BoundsOptions& options,
                         const std::function<void(const BoundsLevel&)>& report = {});

}  // namespace talus::bounds
