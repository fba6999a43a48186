// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety of one slip surface by the methods of slices.

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/methods.hpp"
#include "lem/section/slope.hpp"
#include "lem/surface/surface.hpp"

namespace talus::lem {

using Method = SliceMethod;

/// One slice, from left to right. Forces per metre of thickness [N].
struct Slice {
  double left = 0, right = 0;          ///< [m]
  Point base_left{}, base_right{};     ///< [m]
  double top_left = 0, top_right = 0;  ///< ground [m]
  int soil = 0;                        ///< at the middle of the base
  double slope = 0;                    ///< tan α of the base, positive where it falls in the direction of sliding
  double length = 0;                   ///< of the base [m]
  double weight = 0;                   ///< W of soil and its water, without ponded water
  double surface_load = 0;             ///< vertical: loads on the ground and ponded water, down positive
  double surface_thrust = 0;           ///< their horizontal part, against the sliding positive
  double surface_moment = 0;           ///< of both about the middle of the base, clockwise positive [N m]
  double earthquake = 0;               ///< k_h W, with the sliding positive
  double centroid = 0;                 ///< elevation of the centre of the weight at the slice's middle [m]
  double pore_pressure = 0;            ///< u at the middle of the base, compression positive; suction negative [Pa]
  double cohesion = 0;                 ///< c with roots and suction [Pa]
  double root_cohesion = 0;            ///< part of it [Pa]
  double suction_strength = 0;         ///< part of it [Pa]
  double tan_friction = 0;
  // Of a solution:
  double normal = 0;  ///< total N
  double shear = 0;   ///< mobilised T
  double m_alpha = 0;
  /// E (compression positive) and X (positive where the lower part holds up the upper) on the right side.
  double normal_right = 0, shear_right = 0;
  double thrust_right = 0;  ///< elevation of E on the right side; NaN where E vanishes [m]

  double alpha() const { return std::atan(slope); }  ///< [rad]
};

struct Solution {
  Method method = Method::spencer;
  double factor = 0;      ///< F; 0 when refused. After drawdown, where there is one
  double before = 0;      ///< F before drawdown; 0 without one, or when refused
  double undrained = 0;   ///< F of the second stage of three; 0 otherwise
  double lambda = 0;      ///< of Spencer and Morgenstern–Price [-]
  double correction = 1;  ///< Janbu's f_0
  int iterations = 0;
  Refusal refusal = Refusal::none;
  double smallest_m_alpha = 0;
  double tensile_share = 0;   ///< share of the base's length with N' < 0 [-]
  double thrust_outside = 0;  ///< share of E over all sides that acts clearly outside the mass [-]
  double residual = 0;        ///< of the equations that the method is to meet, over the weight [-]
};

struct Checks {
  double smallest_m_alpha = 0.2;
  double most_tension = 0.2;         ///< share of the length that may bear N' < 0 [-]
  double most_thrust_outside = 0.3;  ///< share of E that may act outside the mass; Spencer, Morgenstern–Price [-]
  /// λ; beyond these the forces between slices are steeper than soil can bear, or the upper part holds up the lower
  /// [-].
  double smallest_lambda = -0.1, largest_lambda = 1.5;
  bool has_sensible_lambda(double lambda) const { return lambda >= smallest_lambda && lambda <= largest_lambda; }
  /// How far the factor of a polyline may lie below the upper bound of wedges on its base; Spencer, Morgenstern–Price
  /// [-].
  double most_below_wedges = 0.03;
  double smallest_depth = 0;                   ///< of the sliding mass [m]
  double steepest_toe = std::numbers::pi / 2;  ///< rise of the base at the lower end, e.g. 45° - φ/2 [rad]
  bool composite = true;  ///< circles that reach below the base are cut level there; else they are refused
  bool reject = true;     ///< false: only report
};

/// Rapid drawdown at the base of a slice, by total stresses.
struct DrawnBase {
  double normal = 0;               ///< σ'_fc, effective normal stress before drawdown [Pa]
  double shear = 0;                ///< τ_fc, shear stress before drawdown [Pa]
  std::optional<double> strength;  ///< undrained, of the envelope; nothing in soil that drains [Pa]
  bool drains = true;              ///< the drained strength counts
};

/// Strength as it stands in a slice.
struct BaseStrength {
  double cohesion = 0, tan_friction = 0, pore_pressure = 0;
};

/// The slices of a surface, from left to right; empty with `refusal` set when it cannot be cut. Slice sides stand at
/// least at the breaks of the ground and where the base meets another soil; about `count` in all.
struct CutSurface {
  std::vector<Slice> slices;
  std::vector<Slice> before;          ///< the same before drawdown; empty without one
  std::vector<BaseStrength> drained;  ///< strengths of the slices after drawdown before any stage; likewise
  std::vector<DrawnBase> bases;       ///< of a solution with forces; only of methods by total stresses
  Surface surface;
  bool slides_left = true;        ///< towards falling x
  Point moment_centre{};          ///< of the circle, or of that fitted to a polyline [m]
  double radius = 0;              ///< [m]
  double area = 0;                ///< of the sliding mass [m²]
  double depth = 0;               ///< largest, vertical [m]
  bool composite = false;         ///< cut level at the section's base
  bool cut_at_toe = false;        ///< a circle that would go on below the ground beyond its lower end
  double crack_thrust = 0;        ///< force of the water in the crack [N]
  double crack_thrust_level = 0;  ///< its elevation [m]
  Refusal refusal = Refusal::none;
  std::vector<std::string> warnings;  ///< e.g. arc cut at the toe, negative effective stress everywhere
};
CutSurface cut_surface(const Slope& slope, const Surface& surface, int count, const Checks& checks);
/// The same into `cut`, whose memory is used again: for many surfaces.
void cut_surface(const Slope& slope, const Surface& surface, int count, const Checks& checks, CutSurface& cut);

/// Factor of safety; writes the forces into the slices of `cut` when `keep_forces`. With a drawdown by its stages:
/// forces and strengths are then those of the last one.
Solution solve(const Slope& slope, CutSurface& cut, Method method, const Checks& checks, bool keep_forces);

/// k_y: horizontal acceleration over g with F = 1 on this surface, in place of the section's [-]; none when it fails
/// without any, and after a drawdown, whose strengths an earthquake does not leave as they are.
std::optional<double> find_yield_acceleration(const Slope& slope, const CutSurface& cut, Method method,
                                              const Checks& checks);

}  // namespace talus::lem
