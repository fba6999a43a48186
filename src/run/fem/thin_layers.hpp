// SPDX-License-Identifier: MIT
#pragma once
// Layers that are too thin for their elements, so that two meshes do not show the error of the factor.

#include <string>
#include <vector>

#include "fem/solid/solid.hpp"

namespace talus::run {

/// A layer needs so many rows of elements over its thickness.
inline constexpr double fewest_element_rows = 4;
/// Largest error of the factor with fewer rows, over itself: a weak seam under a toe was 2.7 to 4.5 % high with one row
/// and 2.0 to 3.8 % with two, by the ends of the proven interval [-].
inline constexpr double thin_layer_error = 0.05;

/// The regions of the section with fewer rows that take part in the mechanism: an element of theirs strains by the
/// γ_c of (T19.10) or more. `motion`: ReductionResult::mechanism.
std::vector<std::string> list_thin_layers(const mesh::Mesh<2>& mesh, const fem::QuadraticMesh<2>& quadratic,
                                          const fem::SolidState<2>& motion);

}  // namespace talus::run
