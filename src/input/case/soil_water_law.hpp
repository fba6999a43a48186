// SPDX-License-Identifier: MIT
#pragma once
// Conversion of a soil's water keys to the laws used by MPM and the seepage solver.

#include "input/case/water.hpp"
#include "material/water/conductivity.hpp"

namespace talus::input {

/// Returns S(s) of the soil; for dry soil, constant saturation. Tables are interpolated by monotone cubics. Throws
/// Error (wrong_input) if a table is not a decreasing curve.
material::Retention make_retention(const PoreWater& soil);

/// Returns k_r(s) of the soil. Tables are interpolated by monotone cubics in ln k_r. Throws Error (wrong_input) if a
/// table is not a decreasing curve.
material::Conductivity make_relative_conductivity(const PoreWater& soil);

/// Returns the soil with the air entry for transient seepage: 2 cm of water (Vogel et al. 2001) if Mualem's
/// conductivity has an infinite slope at saturation and the case gives none.
PoreWater add_air_entry(const PoreWater& soil);

/// Returns k of the saturated soil [m/s] at the acceleration `gravity` [m/s²]: ρ_w g κ/μ_d for a permeability (3.2); a
/// conductivity measured at `drag_gravity` is scaled by the ratio of accelerations. Pass `water.drag_gravity` for the
/// measured value itself, as for the drag. Returns 0 if neither is given.
double find_saturated_conductivity(const PoreWater& soil, const Water& water, double gravity);

}  // namespace talus::input
