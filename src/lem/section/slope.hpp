// SPDX-License-Identifier: MIT
#pragma once
// A section made ready for many surfaces: strips of constant layering, so that what stands over x is found by walking.
// Immutable after construction; shared by threads.

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
  double left() const;                 ///< x of the first point of the ground [m]
  double right() const;                ///< x of the last [m]
  double ground(double x) const;       ///< elevation [m]
  double water_table(double x) const;  ///< elevation; -infinity without a line [m]
  int soil_at(const Point& p) const;   ///< number; -1 outside all regions
  /// u at a place, before r_u; negative is suction [Pa].
  double pore_pressure(const Point& p) const;
  /// Weight of the soil between the ground and `bottom` [N/m²], and the soil at `bottom`.
  double weight_above(double x, double bottom, int& soil) const;

  /// Depth of the section's tension crack at x [m]; 0 without one.
  double crack_depth(double x) const;

  /// The slope before a rapid drawdown, of which this is the end; nullptr without one.
  const Slope* before() const;

  struct Strips;
  const Strips& strips() const;  ///< what cut_surface() walks along

 private:
  std::unique_ptr<Strips> strips_;
};

// Faults of the regions of a section whose ground is sound.

/// Adds a sentence per polygon that crosses itself or lies outside, and per place under the ground without soil.
void find_region_faults(const Section& section, std::vector<std::string>& faults);

// How deep a tension crack can be.

/// x and depth of the crack of a section along the ground [m], no deeper than given and than where Rankine's active
/// stress of the soil beside it equals the pressure of the water in it,
/// σ_h = K_a (σ_v - u) - 2c √K_a + u = γ_w min(water, z), with K_a = tan²(45° - φ/2) (Terzaghi 1943).
std::vector<Point> compute_crack_depths(const Slope& slope);

}  // namespace talus::lem
