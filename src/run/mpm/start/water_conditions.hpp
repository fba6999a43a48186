// SPDX-License-Identifier: MIT
#pragma once
// Where pore water is held, and its conditions where the wet soil ends: [[hydraulic]] and [[boundary]] on a body's
// mesh.

#include "input/case/case.hpp"
#include "mpm/body/body.hpp"

namespace talus::run {

/// Fills the conditions of body.water; nothing when the body is dry.
///
/// Water does not cross a side that holds the soil along its normal, unless a [[hydraulic]] other than no_flow is on
/// it, nor a line with no_flow inside the soil. Every other side of the wet soil at the start has a condition: that of
/// its
/// [[hydraulic]], or number 0, a seepage face. A node that lies on none of these sides takes the condition of the
/// nearest, so that conditions go with a free surface that moves; those of walls stay with the elements at the wall.
/// Throws Error (wrong_input) for a side that the mesh does not have, and for a condition on no side of the wet soil.
template <int D>
void resolve_water_conditions(mpm::Body<D>& body, const input::Case& data);

/// Makes the values that conditions have at `time` [s] constant: those that belong to pore pressures which are held.
template <int D>
void hold_surfaces(mpm::Body<D>& body, double time);

}  // namespace talus::run
