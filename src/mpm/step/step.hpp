// SPDX-License-Identifier: MIT
#pragma once
// The computational cycle of section 2.2.3 (MUSL), rearranged so that the points are read and written once per step.
//
// On linear simplices everything a step does to a point is affine in its local coordinates. The second mapping of MUSL,
// Σ_p N_i m_p (v_p + Δt Σ_j N_j a_j) = p_i + Δt Σ_j M_ij a_j, therefore needs no second pass: M is the element's
// consistent mass matrix, from the moments gathered in the one pass. tests/reference holds the textbook order.

#include "input/case/case.hpp"
#include "mpm/body/body.hpp"

namespace talus::mpm {

template <int D>
struct StepOptions {
  double dt = 0;            ///< [s]
  Vec<D> gravity{};         ///< [m/s²]
  double damping = 0;       ///< α of (2.89)
  double mass_scaling = 1;  ///< β of (2.91)
  bool mixed = false;       ///< mixed integration (2.92-2.93)
  input::Smoothing smoothing = input::Smoothing::none;
  bool moving = true;     ///< false: frozen geometry, small strain
  bool objective = true;  ///< rotate stresses with the soil
  bool monitor = false;   ///< fill Body::monitor in this step
  int threads = 1;
  // Soil with pore water.
  bool darcy = false;                ///< one velocity, and pressures at the nodes (darcy_step.hpp)
  double pressure_tolerance = 1e-5;  ///< of their residual, over what drives them [-]
  bool implicit_drag = true;
  double water_damping = 0;        ///< α of the water
  bool net_damping = true;         ///< damp what is left with drag and skin, T14.10; else the source's form
  bool smooth_pressure = false;    ///< (2.96-2.97)
  bool exchange_water = false;     ///< between elements, against pressures that no node feels (T14.9)
  double conductivity_factor = 1;  ///< multiplies k
};

/// Advances the body by one step. Reads the nodes' sums of the last pass, leaves those of this one.
template <int D>
void step(Body<D>& body, const StepOptions<D>& options);

/// Which lines a body goes through: those of soil alone, or those of soil and pore water (coupled_step.hpp).
struct Dry {
  static constexpr bool has_water = false;
};
struct Wet {
  static constexpr bool has_water = true;
};

// The lines of the step, in order.

/// a_i = (f_ext - f_int + f_damp)_i / (β m_i), constraints (2.39, 2.89). Reads sums; writes motion (a), work, monitor.
template <int D>
void solve_momentum(Dry, Body<D>& body, const StepOptions<D>& options);

/// v_i = (p_i + Δt Σ_j M_ij a_j) / m_i, constraints (2.41). Reads motion (a), moments; writes motion (v), zeroes sums.
template <int D>
void remap_momentum(Dry, Body<D>& body, const StepOptions<D>& options);

/// Nodal averages of the volumetric strain increment (2.94), without the plastic part of the last step where smoothing
/// is stable (T4.4). Reads motion (v), plastic_dilation; writes smoothed.
template <int D>
void smooth_increments(Dry, Body<D>& body, const StepOptions<D>& options);

/// What advance_points leaves for relocate: the points that are now outside their element.
struct Mover {
  int block, slot;
  unsigned lanes;  ///< bit set
};
using MoverLists = std::vector<std::vector<Mover>>;  ///< by chunk

/// v_p, ξ_p, Δε_p, σ_p, V_p (2.40, 2.42-2.45) and the nodal sums of the next step (2.35, 2.38), in one pass.
template <int D>
MoverLists advance_points(Dry, Body<D>& body, const StepOptions<D>& options);

/// Moves the points that left their element, and their share of the nodal sums, in an order that does not depend on
/// threads. Points that left the grid are recorded in `lost`.
template <int D>
void relocate(Body<D>& body, const StepOptions<D>& options, const MoverLists& movers);

/// Between steps: takes the velocities away that points have and no node sees. Reads and writes the nodal sums of
/// momentum. Linear momentum is kept exactly; the kinetic energy that is lost goes to work.mapping.
template <int D>
void fade_unseen(Body<D>& body, const StepOptions<D>& options);

/// Nodal forces of the tractions (2.37) for the step that starts at body.time. Writes nodes.load.
template <int D>
void gather_loads(Body<D>& body);

/// Nodal sums from scratch: at the start of a stage, when the options of the internal force may have changed.
template <int D>
void gather_nodal_sums(Body<D>& body, const StepOptions<D>& options);

}  // namespace talus::mpm
