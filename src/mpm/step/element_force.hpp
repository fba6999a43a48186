// SPDX-License-Identifier: MIT
#pragma once
// Internal force and free surface of single elements, for the few that relocation touches and for a fresh start. B is a
// Body here, or the body on a GPU; element_lines.hpp has the definitions.

#include "mpm/step/step.hpp"

namespace talus::mpm {

/// Share of V_e that an element at the free surface must hold to count as full (2.92).
inline constexpr double full_share = 0.9;

/// Adds `sign` times the internal force of element `e`, from the points that are in it now, to its node rows.
template <class B>
TALUS_PORTABLE void add_internal_force(B& body, int e, bool mixed, double sign);

/// Sets elements.fill_limit of `e`: full_share·V_e at the free surface (some neighbour holds no point), else 0.
/// Returns whether it changed.
template <class B>
TALUS_PORTABLE bool update_fill_limit(B& body, int e);

/// Adds mass, momentum and moments of one point to its element's node rows.
template <class B>
TALUS_PORTABLE void add_point_mass(B& body, int e, const double* fields);

/// Elastic energy that the points of element `e` lose when it is full and shares their stress [J].
template <class B>
TALUS_PORTABLE double find_sharing_loss(const B& body, const StepOptions<B::dimension>& options, int e);

/// Finds out whether a point of element `e` keeps a gap.
template <class B>
TALUS_PORTABLE void note_gaps(B& body, const StepOptions<B::dimension>& options, int e);

}  // namespace talus::mpm
