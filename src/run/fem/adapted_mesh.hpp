// SPDX-License-Identifier: MIT
#pragma once
// Meshes that are refined where the soil shears at failure (T19.17), and the interval of the factor from their sequence
// (T19.18).

#include <optional>
#include <vector>

#include "fem/solid/solid.hpp"
#include "results/elements.hpp"
#include "run/fem/element_run.hpp"

namespace talus::run {

/// Relative width of the interval at which refinement ends [-].
inline constexpr double widest_interval = 0.03;
/// Largest number of elements, over that of a mesh of the [fem] size [-].
inline constexpr double most_elements = 1.5;

/// Safety factor of the grid convergence index for three or more grids (Roache 1998, Verification and validation in
/// computational science and engineering) [-].
inline constexpr double sequence_safety = 1.25;

/// Returns the rate of shear work of each quadratic element in the mechanism, Σ w |s:Δε| over the points that yield
/// [N m per metre]. `failure` has stress and yielding, `motion` the strains: ReductionResult::at_failure and mechanism.
std::vector<double> compute_shear_work(const fem::QuadraticMesh<2>& mesh, const fem::SolidState<2>& failure,
                                       const fem::SolidState<2>& motion);

/// Returns the mean size of the elements, weighted by their shear work (T19.17) [m]; 0 if there is none. The size of an
/// element is the edge of the equilateral triangle of its area.
double compute_shear_size(const mesh::Mesh<2>& mesh, const fem::QuadraticMesh<2>& quadratic,
                          const std::vector<double>& work);

/// Returns which elements of the linear mesh to divide into four: those with the largest products of work and size,
/// which sum to `refined_work` of all, and their neighbours. nullopt if the mesh would have more than `most` elements
/// before enough of the work is in them that the size (T19.17) falls.
std::optional<std::vector<bool>> mark_shear(const mesh::Mesh<2>& mesh, const fem::QuadraticMesh<2>& quadratic,
                                            const std::vector<double>& work, std::size_t most);

/// Returns the order of convergence of the last three meshes, between 0.1 and 1; 1 if the factor no longer falls.
double compute_order(const std::vector<results::ElementMeshFactor>& meshes);

/// Returns the interval (T19.18) of the factor from meshes that are refined one after the other, coarse to fine; of
/// two meshes that of (T19.12). `safety`: of three and more; mesh_safety where the factor need not converge. nullopt if
/// one of the last two has no trial that failed by flow.
std::optional<results::ElementInterval> find_sequence_interval(const std::vector<results::ElementMeshFactor>& meshes,
                                                               const LeastMeshError& least = {},
                                                               double safety = sequence_safety);

}  // namespace talus::run
