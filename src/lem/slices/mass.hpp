// SPDX-License-Identifier: MIT
#pragma once
// The sliding mass as the methods use it: slices in the order of sliding, from the upper end to the lower one, in a
// frame whose axis ξ points in the direction of sliding.

#include <vector>

#include "lem/slices/solve.hpp"

namespace talus::lem {

/// Shape of one slice and the forces on it that do not depend on the solution [N].
struct Wedge {
  double sine = 0, cosine = 0;  ///< of α
  double strength = 0;          ///< (c - u tanφ) l
  double friction = 0;          ///< tanφ
  double uplift = 0;            ///< u l
  double down = 0;              ///< P: weight and loads
  double push = 0;              ///< B: earthquake less horizontal loads on the ground, with the sliding positive
  double arm_shear = 0, arm_normal = 0;  ///< arms of T (resisting) and N (driving) about the centre [m]
  double ratio = 0;  ///< interslice function f at the side towards the lower end; or X/E where that is given
};

/// Forces of passive bars on a slice, of which the factor's part acts [N].
struct Held {
  double down = 0, push = 0;
};

struct Mass {
  std::vector<Wedge> wedges;
  std::vector<Held> held;  ///< of each slice; empty without passive bars
  double held_moment = 0;  ///< about the centre, positive if driving [N m]
  double crack = 0;        ///< thrust of the water in the crack [N]
  double moment = 0;       ///< of weights, loads, earthquake and crack about the centre, positive if driving [N m]
  double scale = 0;        ///< ΣP, for tolerances [N]
  double radius = 0;

  /// Sets the mass from a cut surface; the earthquake is `horizontal` times the weight.
  void set(const Slope& slope, const CutSurface& cut, double horizontal);
  /// Adds the forces of the bars that the base crosses.
  void add_bars(const Slope& slope, const CutSurface& cut);
  bool has_held() const { return !held.empty(); }
  void set_interslice_function(bool half_sine, const CutSurface& cut);
  /// Sets X/E of a method with given inclinations, so that λ is 1.
  void set_inclinations(SliceMethod method, const CutSurface& cut);
};

/// Resisting and driving moments about the centre of a circle, or forces along the bases, with the normal forces of
/// Fellenius (T18.7).
struct FelleniusSums {
  double resisting = 0, driving = 0;
  double held_friction = 0;  ///< friction of the normal forces of passive bars, which the factor divides once more
  /// Returns F of F driving = resisting + held_friction / F.
  double find_factor() const;
};
FelleniusSums sum_fellenius(const Mass& mass, bool moments);
/// Returns the factor of Bishop's simplified method (moments) or Janbu's (horizontal forces); 0 if there is none.
double solve_simplified(const Mass& mass, bool moments, double start, int& iterations);
/// Returns Janbu's f_0 of a surface (T18.8), and in `ratio` its depth over its length.
double correct_janbu(const CutSurface& cut, double& ratio);

/// Factor and λ of a method; factor 0 if there is no solution.
struct Complete {
  double factor = 0, lambda = 0;
  int iterations = 0;
};
/// Returns the factor that satisfies force equilibrium alone, with λ = 1, from Janbu's factor; 0 if there is none.
Complete solve_forces(const Mass& mass, double start);
/// Solves both equations by Newton's method in (1/F, λ) from Bishop's or Janbu's factor.
Complete solve_newton(const Mass& mass, double start);
/// Solves both equations as the intersection of the curves F_f(λ) and F_m(λ) (GLE), along the branch from Janbu's
/// factor.
Complete solve_bracket(const Mass& mass, double start);

/// Forces on a slice of a solution: N, T, and E and X at the side towards the lower end; m_α over √(1 + a²).
struct Forces {
  double normal = 0, shear = 0, normal_side = 0, shear_side = 0, m_alpha = 0;
};
void find_forces(const Mass& mass, double factor, double lambda, std::vector<Forces>& forces);

/// Returns the residual of the equations that a method satisfies, over the weight (and the radius): E at the lower end,
/// and the moment about the centre [-].
double measure_residual(const Mass& mass, double factor, const std::vector<Forces>& forces, bool of_forces,
                        bool of_moments);

/// Computes the elevation of E at the lower side of each slice from moments about its base (T18.9); NaN where E
/// vanishes.
void find_thrust_line(const Slope& slope, const CutSurface& cut, const Mass& mass, double horizontal, double factor,
                      const std::vector<Forces>& forces, std::vector<double>& level);

/// Returns the reason for which the checks reject a solution.
Refusal check_solution(const CutSurface& cut, const Solution& solution, const Checks& checks);

/// Solves one stage for solve(), with the earthquake given.
Solution solve_with(const Slope& slope, CutSurface& cut, Method method, const Checks& checks, bool keep_forces,
                    double horizontal);

// Rapid drawdown on one slip surface: undrained strengths from the stresses before drawdown, and the stages.

/// Drained strength of a soil.
struct EffectiveStrength {
  double cohesion = 0;        ///< c' [Pa]
  double friction_angle = 0;  ///< φ', above 0 [rad]
};

/// Returns the undrained strength [Pa] of soil consolidated under the effective normal stress `normal` and the shear
/// stress `shear` on the slip surface [Pa]. By the Corps of Engineers (1970) it is the lower of the R envelope and the
/// effective one (T18.13); by the other methods it is interpolated between τ(Kc = 1) and τ(Kc = Kf) by the ratio K1 of
/// the principal stresses (T18.14), and the lower of the two where one of these stresses would be a tension (USACE EM
/// 1110-2-1902, 2003, appendix G). It is not negative, and K1 does not exceed Kf, as soil is not consolidated beyond
/// failure.
double find_undrained_strength(DrawdownMethod method, const UndrainedEnvelope& envelope,
                               const EffectiveStrength& effective, double normal, double shear);

/// Stores the strengths of a surface after it was cut, so that its stages can be repeated. Does nothing without a
/// drawdown.
void keep_drained_strengths(CutSurface& cut);

/// Computes the factor of a slope with a drawdown, for solve(). Stages: before drawdown; after it with undrained
/// strengths from the stresses before; and with the drained strength where that is lower (three_stage).
Solution solve_drawdown(const Slope& slope, CutSurface& cut, Method method, const Checks& checks, bool keep_forces);

}  // namespace talus::lem
