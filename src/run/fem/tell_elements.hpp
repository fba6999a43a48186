// SPDX-License-Identifier: MIT
#pragma once
// The results of finite elements.

#include <array>
#include <optional>

#include "fem/solid/solid.hpp"
#include "input/case/case.hpp"
#include "results/elements.hpp"

namespace talus::run {

/// Least and greatest ψ of the soils with a strength [rad].
std::array<double, 2> find_dilatancy(const input::Case& data, bool associated);

/// √(⅔ e:e) of a strain with γ as shear components.
double find_shear_strain(const std::array<double, 6>& e);

results::ElementTrial make_trial_result(const fem::ReductionTrial& trial);

/// The search on one mesh of that mean size [m].
template <int D>
results::ElementMeshFactor make_mesh_factor_result(const fem::ReductionResult<D>& found, double size);

/// Factors of two meshes whose sizes differ by a rounding are this far apart [-].
inline constexpr double known_scatter = 0.006;

/// What the error of the fine mesh is at least, over the factor, whatever the difference of two meshes [-].
struct LeastMeshError {
  double below = known_scatter;  ///< the limit may be lower by this
  double above = 0;              ///< and higher by this; displacement elements with ψ = φ are never too weak
};

/// The interval (T19.11) of the factor that a mesh and one of about twice its size extrapolate to. Nothing where a mesh
/// has no trial that failed by flow.
std::optional<results::ElementInterval> find_mesh_interval(const results::ElementMeshFactor& coarse,
                                                           const results::ElementMeshFactor& fine,
                                                           const LeastMeshError& least = {});

template <int D>
results::ElementMesh make_mesh_result(const fem::QuadraticMesh<D>& mesh);

/// Displacement and shear strain at the nodes, and which elements yield.
template <int D>
results::ElementFields make_fields_result(const fem::QuadraticMesh<D>& mesh, const fem::SolidState<D>& state,
                                   results::Flow flow);

}  // namespace talus::run
