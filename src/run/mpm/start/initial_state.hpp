// SPDX-License-Identifier: MIT
#pragma once
// State variables of the points at the start, and the preconsolidation pressure that follows from equilibrium.

#include <vector>

#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "mpm/body/build.hpp"
#include "results/trial.hpp"

namespace talus::run {

/// Gives each point the state variables that its law starts with, from its stress, its pore pressure and the roots at
/// its place. Soil whose preconsolidation is a ratio stays elastic until set_preconsolidation(). `laws`,
/// `names` and `water` by material number. Throws what find_roots() throws.
template <int D>
void set_initial_state(const input::Case& data, const mesh::Mesh<D>& mesh, const std::vector<material::Law>& laws,
                       const std::vector<std::string>& names, const std::vector<mpm::WaterLaw>& water,
                       std::vector<mpm::InitialPoint<D>>& points);

/// Fits the state variables of a body that was moved to the end of another run to its own laws: soil of the same model
/// keeps them, a law of the same family what they share, and all else starts from the stress it
/// has. Without `same_roots` all roots are those of this case and new: nothing of them is activated or broken. `fresh`:
/// the body before it was moved; `before`: the model of each point in the other run.
template <int D>
void adopt_state(mpm::Body<D>& body, const input::Case& data, const mpm::Body<D>& fresh,
                 const std::vector<input::MaterialModel>& before, bool same_roots);

/// Whether the preconsolidation that is given as a ratio follows from the end of the stage with this number.
bool is_equilibrium_stage(const input::Case& data, int stage);

/// Gives points whose preconsolidation is not set yet that of their present stress: saturated and without
/// roots R_0 times the mean effective stress, or times the smallest pressure of the soil where that is more.
template <int D>
results::Preconsolidation set_preconsolidation(mpm::Body<D>& body, const input::Case& data);

}  // namespace talus::run
