// SPDX-License-Identifier: MIT
#pragma once
// A case as the finite elements for stress see it.

#include <memory>
#include <string>
#include <vector>

#include "fem/solid/solid.hpp"
#include "ground/seepage_results.hpp"
#include "input/case/case.hpp"

namespace talus::run {

template <int D>
struct SolidOfCase {
  std::shared_ptr<const mesh::Mesh<D>> mesh;  ///< that the model points to
  fem::SolidModel<D> model;                   ///< with the dilatancy angles as given
  ground::WaterResult water;                  ///< that pore pressures are from
  std::vector<std::string> notes;             ///< what finite elements cannot take from the case, in sentences
};

/// Mesh, supports, weights, water and loads of a case. Pore pressures of steady seepage are calculated on the same
/// mesh. `share` of the element size. Throws Error (wrong_input) for a material or a boundary that finite elements at
/// small strain do not have; what mesh::generate() and find_initial_water() throw.
template <int D>
SolidOfCase<D> make_solid(const input::Case& data, double share = 1);

/// The same on a mesh that is there.
template <int D>
SolidOfCase<D> make_solid_on(const input::Case& data, std::shared_ptr<const mesh::Mesh<D>> mesh);

/// The laws of the case with ψ = φ instead of ψ as given.
template <int D>
void set_associated_flow(const input::Case& data, SolidOfCase<D>& solid);

/// Throws Error (wrong_input) for materials and boundaries that make_solid() refuses, without a mesh.
void check_solid(const input::Case& data);

/// The plan that make_solid() meshes: the case's with that share of the element size, and the algorithm, of [fem].
mesh::Plan make_fem_plan(const input::Case& data, double share = 1);

// Layers that are too thin for their elements, so that two meshes do not show the error of the factor.

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
