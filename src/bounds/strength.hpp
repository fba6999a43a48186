// SPDX-License-Identifier: MIT
#pragma once
// Mohr–Coulomb's criterion in plane strain with the strength divided by F, and the F that a stress or a strain rate
// allows.

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/problem.hpp"

namespace talus::bounds {

/// Half the difference of the principal stresses, R, and their mean.
struct Circle {
  double radius = 0, mean = 0;
};

inline Circle find_circle(const Stress& s) {
  return {std::hypot(0.5 * (s[0] - s[1]), s[2]), 0.5 * (s[0] + s[1])};
}

/// Divided strength in the program of the lower bound is at most so many units of stress: a block of steel beside soil
/// without cohesion would leave the soil below the tolerance of the solver. A field that holds in weaker soil holds in
/// stronger soil too.
inline constexpr double most_strength = 30;
/// Soil of a triangle with more cohesion, in units of stress, moves as a rigid body in the upper bound: fewer motions
/// give no smaller upper bound.
inline constexpr double rigid_strength = 100;

inline bool is_rigid(const std::array<Strength, 3>& corners, const Units& units) {
  return std::all_of(corners.begin(), corners.end(), [&](const Strength& s) {
    const double least = rigid_strength * units.stress;
    return s.cohesion >= least && (!s.tension || *s.tension >= least);
  });
}

/// The largest F with R cos φ_F-criterion fulfilled: R √(1 + tan²φ/F²) ≤ c/F − σ'_m tan φ/F, that is
/// F² ≤ ((c − σ'_m tan φ)/R)² − tan²φ; and R + σ'_m ≤ tension/F. 0 where no F is small enough, infinite without shear.
inline double find_factor(const Strength& soil, const Stress& effective) {
  const Circle circle = find_circle(effective);
  constexpr double any = std::numeric_limits<double>::infinity();
  if (!std::isfinite(circle.radius) || !std::isfinite(circle.mean)) return 0;
  const double available = soil.cohesion - circle.mean * soil.tan_friction;
  double factor = any;
  if (circle.radius > 0) {
    const double ratio = available / circle.radius;
    factor = ratio > soil.tan_friction ? std::sqrt((ratio - soil.tan_friction) * (ratio + soil.tan_friction)) : 0;
  } else if (available < 0) {
    factor = 0;
  }
  if (soil.tension && circle.radius + circle.mean > 0)
    factor = std::min(factor, *soil.tension / (circle.radius + circle.mean));
  return factor;
}

}  // namespace talus::bounds
