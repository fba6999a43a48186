// SPDX-License-Identifier: MIT
#pragma once
// From the keys of a soil's water to the laws that the engine and the seepage solver evaluate.

#include "input/case/water.hpp"
#include "material/water/conductivity.hpp"

namespace talus::input {

/// S(s) of the soil. A dry soil has no curve; it gets that of saturated soil. Throws Error (wrong_input) for a table
/// that is no falling curve. Tables are joined by monotone cubics.
material::Retention make_retention(const PoreWater& soil);

/// k_r(s) of the soil. Throws Error (wrong_input) for a table that is no falling curve. The logarithm of a table's k_r
/// is joined by monotone cubics.
material::Conductivity make_relative_conductivity(const PoreWater& soil);

/// The soil with the air entry that seepage over time takes: 2 cm of water (Vogel et al. 2001) where Mualem's
/// conductivity has an infinite slope at saturation and the case gives none.
PoreWater add_air_entry(const PoreWater& soil);

/// k of the saturated soil [m/s] at the acceleration `gravity` [m/s²]: ρ_w g κ/μ_d of a permeability (3.2), and in
/// proportion to g as well where a conductivity was measured at `drag_gravity`. Pass `water.drag_gravity` for the
/// measured value itself, as the drag of the engine wants it. 0 for soil without either.
double find_saturated_conductivity(const PoreWater& soil, const Water& water, double gravity);

}  // namespace talus::input
