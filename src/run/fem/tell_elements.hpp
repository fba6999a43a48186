// SPDX-License-Identifier: MIT
#pragma once
// The results of finite elements.

#include <array>

#include "fem/solid/solid.hpp"
#include "input/case/case.hpp"
#include "results/elements.hpp"

namespace talus::run {

/// Least and greatest ψ of the soils with a strength [rad].
std::array<double, 2> find_dilatancy(const input::Case& data, bool associated);

results::ElementTrial tell_trial(const fem::ReductionTrial& trial);

template <int D>
results::ElementMesh tell_mesh(const fem::QuadraticMesh<D>& mesh);

/// Displacement and shear strain at the nodes, and which elements yield.
template <int D>
results::ElementFields tell_fields(const fem::QuadraticMesh<D>& mesh, const fem::SolidState<D>& state,
                                   results::Flow flow);

}  // namespace talus::run
