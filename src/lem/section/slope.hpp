// SPDX-License-Identifier: MIT
#pragma once
// A section prepared for the cutting of many surfaces: strips of constant layering, which give weights and soils above
// and below a point without a search. Immutable after construction, and shared by threads.

#include <memory>
#include <string>
#include <vector>

#include "lem/section/section.hpp"

namespace talus::lem {

class Slope {
 public:
  /// Throws Error (wrong_input) with the sentences of find_faults().
  explicit Slope(Section section);
  ~Slope();
  Slope(Slope&&) noexcept;
  Slope(const Slope&) = delete;

  const Section& section() const;
  double left() const;                  ///< x of the first point of the ground [m]
  double right() const;                 ///< x of its last point [m]
  double ground(double x) const;        ///< elevation of the ground [m]
  double lower_ground(double x) const;  ///< the same, at a vertical step the foot of it [m]
  double water_table(double x) const;   ///< elevation; -infinity without a water table [m]
  /// Elevation of the top of impenetrable soil at x; that of the bottom of the soil where there is none [m].
  double floor(double x) const;
  double lower_floor(double x) const;  ///< the same, at a vertical step the foot of it [m]
  int soil_at(const Point& p) const;   ///< index of the soil; -1 outside all regions
  /// Returns u at a point, without r_u; suction is negative [Pa].
  double pore_pressure(const Point& p) const;
  /// Returns u at a point under a weight of soil [N/m²], which r_u of the soil multiplies where it has one [Pa].
  double pore_pressure(const Point& p, const Soil& soil, double weight) const;
  /// Returns σ'_v at a point from the weight of soil and ponded water above it, without surcharges [Pa].
  double effective_stress(const Point& p) const;
  /// Returns the weight of the soil between the ground and `bottom` [N/m²], and in `soil` the soil at `bottom`.
  double weight_above(double x, double bottom, int& soil) const;

  /// Depth of the tension crack of the section at x [m]; 0 without one.
  double crack_depth(double x) const;

  /// The slope before the rapid drawdown; nullptr without one.
  const Slope* before() const;

  struct Strips;
  const Strips& strips() const;  ///< the strips that cut_surface() divides a base by

 private:
  std::unique_ptr<Strips> strips_;
};

// Check of the regions of a section whose ground has no faults.

/// Adds a sentence per polygon that crosses itself or lies outside, and per place under the ground without soil.
void find_region_faults(const Section& section, std::vector<std::string>& faults);

// Depth of a tension crack.

/// Returns x and depth of the crack of a section along the ground [m]: the given depth, or that at which Rankine's
/// active stress of the soil equals the pressure of the water in the crack, if it is less deep, σ_h = K_a (σ_v - u) -
/// 2c √K_a + u = γ_w min(water, z), with K_a = tan²(45° - φ/2) (Terzaghi 1943).
std::vector<Point> compute_crack_depths(const Slope& slope);

}  // namespace talus::lem
