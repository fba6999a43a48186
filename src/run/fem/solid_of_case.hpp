// SPDX-License-Identifier: MIT
#pragma once
// A case as the finite elements for stress see it.

#include <memory>
#include <string>
#include <vector>

#include "fem/solid/solid.hpp"
#include "ground/tell_seepage.hpp"
#include "input/case/case.hpp"

namespace talus::run {

template <int D>
struct SolidOfCase {
  std::shared_ptr<const mesh::Mesh<D>> mesh;  ///< that the model points to
  fem::SolidModel<D> model;                   ///< with the dilatancy angles as given
  ground::WaterResult water;                    ///< that pore pressures are from
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

}  // namespace talus::run
