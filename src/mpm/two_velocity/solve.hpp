// SPDX-License-Identifier: MIT
#pragma once
// Solution of the two equations of a node: water and grains with the drag between them (T14.5, T14.6).

#include <cmath>

#include "mpm/kernels/water_surface.hpp"
#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Coefficients of the equations, the same in all directions.
struct PhasePair {
  double solid, water;  ///< βM_s, βM_w [kg]; no water: water = 0
  double content;       ///< θ [-]
  double drag;          ///< D [kg/s]
  double implicit;      ///< G = ΔtD, or 0 when the drag is explicit [kg]
  double inverse;       ///< 1/Δ of T14.6

  PhasePair(double solid_mass, double whole_mass, double theta, double resistance, double beta, double dt,
            bool is_implicit)
      : solid(beta * solid_mass),
        water(beta * whole_mass),
        content(theta),
        drag(theta * resistance),
        implicit(is_implicit ? dt * drag : 0.0),
        inverse(1 / (solid * water + implicit * (solid + content * water))) {}
};

/// Forces on a node's phases, without drag: on the grains, and on the water per unit of content [N].
template <int D>
struct PhaseForces {
  Vec<D> solid{}, water{};
};

/// Velocities, or accelerations, of both phases.
template <int D>
struct PhaseVectors {
  Vec<D> solid{}, water{};
};

/// Acceleration of the water along an axis on which that of the grains is known.
inline double solve_water(const PhasePair& pair, double force, double relative, double solid_acceleration) {
  return (force - pair.drag * relative + pair.implicit * solid_acceleration) / (pair.water + pair.implicit);
}

/// Accelerations [m/s²] of a node without constraints under `f` (T14.6).
template <int D>
TALUS_KERNEL PhaseVectors<D> solve_free_phases(const PhasePair& pair, const PhaseForces<D>& f,
                                               const PhaseVectors<D>& now) {
  PhaseVectors<D> a;
  if (!(pair.water > 0)) {
    for (int d = 0; d < D; ++d) a.solid[d] = f.solid[d] / pair.solid;
    return a;
  }
  const double ss = (pair.water + pair.implicit) * pair.inverse, sw = pair.content * pair.implicit * pair.inverse;
  const double ww = (pair.solid + pair.content * pair.implicit) * pair.inverse, ws = pair.implicit * pair.inverse;
  for (int d = 0; d < D; ++d) {
    const double pull = pair.drag * (now.water[d] - now.solid[d]);
    const double water = f.water[d] - pull, solid = f.solid[d] + pair.content * pull;
    a.water[d] = ww * water + ws * solid;
    a.solid[d] = ss * solid + sw * water;
  }
  return a;
}

/// The same with fixed directions: a fixed phase takes the velocity that its points bring, a = -v/Δt with `now`.
template <int D>
PhaseVectors<D> solve_held_phases(const PhasePair& pair, const HeldAxes<D>& held, const PhaseForces<D>& f,
                                  const PhaseVectors<D>& now, double dt) {
  PhaseVectors<D> a;
  for (int k = 0; k < D; ++k) {
    const Vec<D>& axis = held.axis[k];
    const double v = dot(now.solid, axis), w = dot(now.water, axis), fs = dot(f.solid, axis), fw = dot(f.water, axis);
    const double relative = w - v, pull = pair.drag * relative;
    double solid = held.solid[k] ? -v / dt : 0.0, water = held.water[k] ? -w / dt : 0.0;
    if (pair.water <= 0) {
      water = 0;
      if (!held.solid[k]) solid = fs / pair.solid;
    } else if (!held.solid[k] && !held.water[k]) {
      water = ((pair.solid + pair.content * pair.implicit) * (fw - pull) + pair.implicit * (fs + pair.content * pull)) *
              pair.inverse;
      solid = ((pair.water + pair.implicit) * (fs + pair.content * pull) + pair.content * pair.implicit * (fw - pull)) *
              pair.inverse;
    } else if (!held.water[k]) {
      water = solve_water(pair, fw, relative, solid);
    } else if (!held.solid[k]) {
      solid = (fs + pair.content * pull + pair.content * pair.implicit * water) /
              (pair.solid + pair.content * pair.implicit);
    }
    for (int d = 0; d < D; ++d) {
      a.solid[d] += solid * axis[d];
      a.water[d] += water * axis[d];
    }
  }
  return a;
}

/// Accelerations of the water alone when those of the grains are `solid`.
template <int D>
Vec<D> solve_water_alone(const PhasePair& pair, const HeldAxes<D>& held, const Vec<D>& force,
                         const PhaseVectors<D>& now, const std::type_identity_t<Vec<D>>& solid, double dt) {
  Vec<D> a{};
  if (pair.water <= 0) return a;
  for (int k = 0; k < D; ++k) {
    const Vec<D>& axis = held.axis[k];
    const double w = dot(now.water, axis);
    const double along =
        held.water[k] ? -w / dt : solve_water(pair, dot(force, axis), w - dot(now.solid, axis), dot(solid, axis));
    for (int d = 0; d < D; ++d) a[d] += along * axis[d];
  }
  return a;
}

/// -α sign(velocity)|unbalanced| in every component (2.89).
template <int D>
TALUS_KERNEL Vec<D> find_damping(const Vec<D>& unbalanced, const std::type_identity_t<Vec<D>>& velocity, double alpha) {
  Vec<D> f{};
  for (int d = 0; d < D; ++d)
    f[d] = velocity[d] != 0 ? -std::copysign(alpha * std::abs(unbalanced[d]), velocity[d]) : 0.0;
  return f;
}

}  // namespace talus::mpm
