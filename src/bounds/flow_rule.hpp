// SPDX-License-Identifier: MIT
#pragma once
// Flow rule and dissipation at a corner of a triangle (T21.4).

#include "bounds/problem.hpp"

namespace talus::bounds {

/// Strain rates at a corner of a triangle [1/m per unit of velocity].
struct Strain {
  double opening = 0;     ///< ε_v
  double difference = 0;  ///< ε_x − ε_y
  double distortion = 0;  ///< γ_xy

  double find_shear() const { return std::hypot(difference, distortion); }
};

/// Returns sin φ_F of tan φ divided by the factor; of a curved envelope, that of its last line.
double find_sine(const Strength& soil, double factor);

/// Returns sin φ_F √((ε_x − ε_y)² + γ²) − ε_v, which is not positive where the flow rule is satisfied. Of soil with
/// weak planes it is the least of what slip on them leaves.
double find_lack(const Strength& soil, double factor, const Strain& strain);

/// Returns the dissipation [W/m³ per unit of velocity] with the strengths divided by the factor: the least of the
/// divisions of the strain rate among the lines of the criterion and weak planes. Infinity: none satisfies the flow
/// rule.
double find_dissipation(const Strength& soil, double factor, const Strain& strain);

}  // namespace talus::bounds
