// SPDX-License-Identifier: MIT
#pragma once
// Layers that are too thin for their elements, so that two meshes do not show the error of the factor.

#include <string>
#include <vector>

#include "fem/solid/solid.hpp"

namespace talus::run {

/// A layer needs so many rows of elements over its thickness.
inline constexpr double fewest_element_rows = 4;
/// What the factor is too high at most with fewer of them, over itself: a weak seam under a toe with one row to three
/// was 2 to 4.3 % above the proven interval, and 0.7 % lower with each halving [-].
inline constexpr double thin_layer_error = 0.05;

/// The regions of the section with fewer rows that take part in the mechanism: an element of theirs strains by the
/// γ_c of (T19.10) or more. `motion`: ReductionResult::mechanism.
std::vector<std::string> list_thin_layers(const mesh::Mesh<2>& mesh, const fem::QuadraticMesh<2>& quadratic,
                                          const fem::SolidState<2>& motion);

}  // namespace talus::run
