// SPDX-License-Identifier: MIT
#pragma once
// From a case and its mesh to a body in its initial state.

#include <optional>
#include <vector>

#include "fem/seepage/seepage.hpp"
#include "ground/season.hpp"
#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "mpm/body/build.hpp"
#include "results/trial.hpp"

namespace talus::run {

// State variables of the points at the start, and the preconsolidation pressure that follows from equilibrium.

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

/// Material numbers of a case: the names of its materials in alphabetical order.
std::vector<std::string> list_materials(const input::Case& data);

/// Gives every material of the body the strength of a stage or trial.
template <int D>
void set_strength(mpm::Body<D>& body, const input::Case& data, std::optional<double> cohesion, double factor);

/// Points, initial stress, velocity and pore water, boundary conditions and tractions of the case on its mesh; time 0.
/// A case that starts from a result has the mesh and the state of that, whatever `mesh` is (end_state.hpp).
/// `chunks` as in mpm::make_layout; `seepage` receives the steady seepage that the pore pressures are from, and
/// `season` the weather since, where there are such. Throws Error (wrong_input) when a name of the case is not in the
/// mesh, or no element holds soil; what find_initial_water(), resolve_water_conditions() and open_end_state() throw.
template <int D>
mpm::Body<D> prepare(const input::Case& data, mesh::Mesh<D> mesh, int chunks = 0,
                     std::optional<fem::SeepageResult<D>>* seepage = nullptr,
                     std::optional<ground::SeasonRecord>* season = nullptr);

/// Height H of the soil: extent against gravity of the elements that hold points [m].
template <int D>
double find_soil_height(const mpm::Body<D>& body, const input::Gravity& gravity);

/// Gravity [m/s²] at full strength.
template <int D>
Vec<D> find_gravity(const input::Gravity& gravity);

/// Gravity and the acceleration of a pseudo-static earthquake [m/s²].
template <int D>
Vec<D> find_acceleration(const input::Case& data);

}  // namespace talus::run
