// SPDX-License-Identifier: MIT
#pragma once
// The sliding mass as the methods see it: slices in the order of sliding, from the upper end to the lower one, in a
// frame whose axis ξ points the way of sliding.

#include <vector>

#include "lem/slices/solve.hpp"
#include "lem/slices/strips.hpp"

namespace talus::lem {

// The base of a sliding mass as arcs and straight pieces, and where it meets the lines of the section.

/// An arc of the surface's circle, or a straight piece.
struct BasePiece {
  double from = 0, to = 0;  ///< [m]
  bool arc = false;
  StripLine line;  ///< of a straight piece, by its elevation at `from`
};

/// A stretch of the base in one piece, one strip and one layer.
struct Stretch {
  double from = 0, to = 0;  ///< [m]
  int piece = 0, strip = 0, layer = 0;
};

struct BaseLine {
  Circle circle;
  std::vector<BasePiece> pieces;
  std::vector<Stretch> stretches;
  std::vector<double> meets;  ///< scratch
  bool composite = false;

  double at(const BasePiece& piece, double x) const;
  double at(double x) const;
  /// Whether the piece passes a point so near. Beside the steep end of an arc its distance counts, not its height.
  bool passes(const BasePiece& piece, const Point& p, double tolerance) const;
  /// Whether the base ends on the ground at this x, or on a vertical step of it.
  bool ends_on_ground(const Slope::Strips& strips, const BasePiece& piece, double x, double tolerance) const;
  /// Lays the pieces; arcs that reach below the base are cut level there.
  Refusal lay(const Slope& slope, const Surface& surface, const Checks& checks);
  /// Cuts the base between `from` and `to` at all lines of the section; refuses a base that rises above the ground.
  Refusal divide(const Slope& slope, double from, double to);
};

/// How far over the distance of its ends a surface may miss the ground.
inline constexpr double ground_tolerance = 1e-4;

/// Forces on one slice but for those that the methods find [N], and its shape.
struct Wedge {
  double sine = 0, cosine = 0;  ///< of α
  double strength = 0;          ///< (c - u tanφ) l
  double friction = 0;          ///< tanφ
  double uplift = 0;            ///< u l
  double down = 0;              ///< P: weight and loads
  double push = 0;              ///< B: earthquake less horizontal loads on the ground, with the sliding positive
  double arm_shear = 0, arm_normal = 0;  ///< of T (resisting) and N (driving) about the centre [m]
  double ratio = 0;  ///< interslice function f at the side towards the lower end; or X over E where that is given
};

struct Mass {
  std::vector<Wedge> wedges;
  double crack = 0;   ///< thrust of the water in the crack
  double moment = 0;  ///< of weight, loads, earthquake and crack about the centre, driving positive [N m]
  double scale = 0;   ///< sum of P, for tolerances
  double radius = 0;

  /// From a cut surface; the earthquake is `horizontal` times the weight.
  void set(const Slope& slope, const CutSurface& cut, double horizontal);
  void set_interslice_function(bool half_sine, const CutSurface& cut);
  /// X/E of a method with given inclinations, so that λ is 1.
  void set_inclinations(SliceMethod method, const CutSurface& cut);
};

/// Resisting and driving moments about a circle's centre, or forces along the bases, with Fellenius' normal forces.
struct FelleniusSums {
  double resisting = 0, driving = 0;
};
FelleniusSums sum_fellenius(const Mass& mass, bool moments);
/// Bishop's simplified (moments) or Janbu's simplified (horizontal forces) factor; 0 when there is none.
double solve_simplified(const Mass& mass, bool moments, double start, int& iterations);
/// Janbu's f_0 of a surface, and its depth over its length in `ratio`.
double correct_janbu(const CutSurface& cut, double& ratio);

/// Factor and λ of a method that satisfies both equilibria; factor 0 when there is none.
struct Complete {
  double factor = 0, lambda = 0;
  int iterations = 0;
};
/// The factor that closes the forces alone, with λ = 1, from Janbu's factor; factor 0 when there is none.
Complete solve_forces(const Mass& mass, double start);
/// Newton's method in (1/F, λ) from Bishop's or Janbu's factor.
Complete solve_newton(const Mass& mass, double start);
/// The crossing of the two curves F_f(λ) and F_m(λ) (GLE), along the branch that begins with Janbu's factor.
Complete solve_bracket(const Mass& mass, double start);

/// Forces on the slices of a solution: N, T, E and X at the side towards the lower end; m_α over √(1 + a²).
struct Forces {
  double normal = 0, shear = 0, normal_side = 0, shear_side = 0, m_alpha = 0;
};
void find_forces(const Mass& mass, double factor, double lambda, std::vector<Forces>& forces);

/// What is left of the equations that a method is to meet, over the weight (and the radius): E at the lower end, and
/// the moments about the centre [-].
double measure_residual(const Mass& mass, const std::vector<Forces>& forces, bool of_forces, bool of_moments);

/// Elevation of E at the side of each slice towards the lower end, from the slices' moments; NaN where E vanishes.
void find_thrust_line(const CutSurface& cut, const Mass& mass, double horizontal, const std::vector<Forces>& forces,
                      std::vector<double>& level);

/// Why the checks refuse a solution.
Refusal check_solution(const CutSurface& cut, const Solution& solution, const Checks& checks);

/// What solve() does in one stage, with the earthquake given.
Solution solve_with(const Slope& slope, CutSurface& cut, Method method, const Checks& checks, bool keep_forces,
                    double horizontal);

}  // namespace talus::lem
