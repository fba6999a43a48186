// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety of one slip surface by the methods of slices: slices, checks, solution.

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/methods.hpp"
#include "lem/section/bars.hpp"
#include "lem/section/slope.hpp"
#include "lem/surface/limits.hpp"
#include "lem/surface/surface.hpp"

namespace talus::lem {

using Method = SliceMethod;

/// One slice. Forces are per metre of thickness [N].
struct Slice {
  double left = 0, right = 0;          ///< [m]
  Point base_left{}, base_right{};     ///< [m]
  double top_left = 0, top_right = 0;  ///< ground [m]
  int soil = 0;                        ///< at the middle of the base
  double slope = 0;                    ///< tan α of the base, positive where it falls in the direction of sliding
  double length = 0;                   ///< of the base [m]
  double weight = 0;                   ///< W of soil and pore water, without ponded water
  double surface_load = 0;             ///< Q, vertical: loads on the ground and ponded water, positive downwards
  double surface_thrust = 0;           ///< H, their horizontal part, positive against the direction of sliding
  double surface_moment = 0;           ///< moment of Q and H about the middle of the base, positive clockwise [N m]
  double earthquake = 0;               ///< k_h W, positive in the direction of sliding
  double centroid = 0;                 ///< elevation of the centre of the weight at the slice's middle [m]
  double pore_pressure = 0;            ///< u at the middle of the base; suction is negative [Pa]
  double water_pressure = 0;           ///< the same in soil with a law, also where u has no effect on the strength [Pa]
  double cohesion = 0;                 ///< c, including roots and suction [Pa]
  double root_cohesion = 0;            ///< part of c due to roots [Pa]
  double suction_strength = 0;         ///< part of c due to suction [Pa]
  double tan_friction = 0;
  // Set by a solution:
  double normal = 0;  ///< total normal force N
  double shear = 0;   ///< mobilised shear force T
  double m_alpha = 0;
  /// Interslice forces on the right side: E (positive in compression) and X (positive where the lower part supports the
  /// upper).
  double normal_right = 0, shear_right = 0;
  double thrust_right = 0;  ///< elevation of E on the right side; NaN where E vanishes [m]

  double alpha() const { return std::atan(slope); }  ///< [rad]
};

struct Solution {
  Method method = Method::spencer;
  double factor = 0;      ///< F, after drawdown if there is one; 0 if rejected
  double before = 0;      ///< F before drawdown; 0 without drawdown, or if rejected
  double undrained = 0;   ///< F of the second of three stages; 0 otherwise
  double lambda = 0;      ///< of Spencer and Morgenstern–Price [-]
  double correction = 1;  ///< Janbu's f_0
  int iterations = 0;
  Refusal refusal = Refusal::none;
  double smallest_m_alpha = 0;
  double tensile_share = 0;   ///< fraction of the base's length with N' < 0 [-]
  double thrust_outside = 0;  ///< fraction of Σ|E| that acts clearly outside the mass [-]
  double residual = 0;        ///< of the equations that the method satisfies, over the weight [-]
};

struct Checks {
  double smallest_m_alpha = 0.2;
  double most_tension = 0.2;         ///< limit of the fraction of the length with N' < 0 [-]
  double most_thrust_outside = 0.3;  ///< limit of the fraction of Σ|E| outside the mass; Spencer, Morgenstern–Price [-]
  /// Limits of λ. Beyond them the interslice forces are steeper than the strength of soil allows, or the upper part
  /// supports the lower [-].
  double smallest_lambda = -0.1, largest_lambda = 1.5;
  bool has_sensible_lambda(double lambda) const { return lambda >= smallest_lambda && lambda <= largest_lambda; }
  /// Limit of the relative difference by which the factor of a polyline may lie below the upper bound of wedges on its
  /// base; Spencer, Morgenstern–Price [-].
  double most_below_wedges = 0.03;
  double smallest_depth = 0;                   ///< smallest depth of the sliding mass [m]
  double steepest_toe = std::numbers::pi / 2;  ///< limit of the rise of the base at the lower end, e.g. 45° - φ/2 [rad]
  bool composite = true;  ///< circles below the bottom of the soil continue along it; else they are rejected
  bool reject = true;     ///< false: the results of the checks are only reported
  std::shared_ptr<const SurfaceLimits> limits{};  ///< of the user; nullptr: none
};

/// State of rapid drawdown at the base of a slice, by total stresses.
struct DrawnBase {
  double normal = 0;               ///< σ'_fc, effective normal stress before drawdown [Pa]
  double shear = 0;                ///< τ_fc, shear stress before drawdown [Pa]
  std::optional<double> strength;  ///< undrained, from the envelope; none in soil that drains [Pa]
  bool drains = true;              ///< the drained strength is used
};

/// Strength at the base of a slice: c [Pa], tanφ [-], u [Pa].
struct BaseStrength {
  double cohesion = 0, tan_friction = 0, pore_pressure = 0;
};

/// A bar that the base of a mass crosses, and its force there.
struct BarPull {
  int bar = 0;            ///< of the section
  int slice = 0;          ///< from the left
  Point at{};             ///< [m]
  double distance = 0;    ///< from the head of the bar [m]
  double resistance = 0;  ///< [N/m]
  Point direction{};      ///< of the force on the mass
  double behind = 0;      ///< resistance of the part in the soil that is stable [N/m]
  double front = 0;       ///< of the part in the mass, with the head [N/m]
  BarLimit limit = BarLimit::tension;
  double prestress = 0;  ///< of an active bar, at most its resistance [N/m]
  // Set by a solution:
  bool is_slack = false;   ///< the motion of the mass does not lengthen the bar: it has its prestress alone
  bool is_turned = false;  ///< the force across the bar was turned to its other side

  double force() const { return is_slack ? prestress : resistance; }  ///< [N/m]
};

/// The part of the force of a bar that acts on one slice. It is spread along a short part of the base, so that its
/// effect does not jump where a corner of the base passes the bar.
struct BarPart {
  int pull = 0, slice = 0;
  double fraction = 1;  ///< of the resistance
  Point direction{};    ///< of the force on the mass
};

/// A surface with its slices from left to right; without slices, and with `refusal` set, if it cannot be cut. Sides of
/// slices stand at the breaks of the ground and where the base meets another soil, at least; about `count` in all.
struct CutSurface {
  std::vector<Slice> slices;
  std::vector<Slice> before;          ///< the same slices before drawdown; empty without one
  std::vector<BaseStrength> drained;  ///< strengths after drawdown, unchanged by the stages; empty without one
  std::vector<BarPull> pulls;         ///< of the bars that the base crosses
  std::vector<BarPart> parts;         ///< of their forces
  std::vector<DrawnBase> bases;       ///< of a solution with forces; by the methods of total stresses only
  Surface surface;
  bool slides_left = true;        ///< towards smaller x
  Point moment_centre{};          ///< centre of the circle, or of that fitted to a polyline [m]
  double radius = 0;              ///< [m]
  double area = 0;                ///< of the sliding mass [m²]
  double depth = 0;               ///< largest vertical depth [m]
  bool composite = false;         ///< a part of the surface follows the bottom of the soil or impenetrable soil
  bool cut_at_toe = false;        ///< the circle would continue below the ground beyond its lower end
  double crack_thrust = 0;        ///< force of the water in the crack [N]
  double crack_thrust_level = 0;  ///< elevation of that force [m]
  Refusal refusal = Refusal::none;
  std::vector<std::string> warnings;  ///< e.g. arc cut off at the toe, negative effective stress everywhere
};
CutSurface cut_surface(const Slope& slope, const Surface& surface, int count, const Checks& checks);
/// Cuts into `cut` and reuses its memory, for many surfaces.
void cut_surface(const Slope& slope, const Surface& surface, int count, const Checks& checks, CutSurface& cut);

/// Returns the factor of safety, and writes the forces into the slices of `cut` if `keep_forces`. With a drawdown it
/// runs the stages, and forces and strengths are those of the last one.
Solution solve(const Slope& slope, CutSurface& cut, Method method, const Checks& checks, bool keep_forces);

/// Returns k_y, the horizontal acceleration over g with which F = 1 on this surface, in place of that of the section
/// [-]; none if F < 1 without any, and after a drawdown, as an earthquake changes the undrained strengths.
std::optional<double> find_yield_acceleration(const Slope& slope, const CutSurface& cut, Method method,
                                              const Checks& checks);

}  // namespace talus::lem
