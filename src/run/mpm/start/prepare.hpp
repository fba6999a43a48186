// SPDX-License-Identifier: MIT
#pragma once
// Preparation of a body in its initial state from a case and its mesh: points, state variables, and the
// preconsolidation pressure that follows from equilibrium.

#include <optional>
#include <vector>

#include "fem/seepage/seepage.hpp"
#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "mpm/solver/build.hpp"
#include "results/trial.hpp"
#include "site/season.hpp"

namespace talus::run {

/// Sets the initial state variables of each point from its stress, its pore pressure and the roots at its place. Soil
/// whose preconsolidation is a ratio remains elastic until set_preconsolidation(). `laws`, `names` and `water` by
/// material number. Throws what find_roots() throws.
template <int D>
void set_initial_state(const input::Case& data, const mesh::Mesh<D>& mesh, const std::vector<material::Law>& laws,
                       const std::vector<std::string>& names, const std::vector<mpm::WaterLaw>& water,
                       std::vector<mpm::InitialPoint<D>>& points);

/// Converts the state variables of a body, moved to the end state of another run, to its own laws: a point keeps them
/// if its model is the same, keeps the common ones if its law is of the same family, and otherwise starts from its
/// stress. Without `same_roots` all roots are new: none is activated or broken. `fresh`: the body before it was moved;
/// `before`: the model of each point in the other run.
template <int D>
void adopt_state(mpm::Body<D>& body, const input::Case& data, const mpm::Body<D>& fresh,
                 const std::vector<input::MaterialModel>& before, bool same_roots);

/// Returns true if preconsolidation given as a ratio follows from the end of the stage with this number.
bool is_equilibrium_stage(const input::Case& data, int stage);

/// Sets the preconsolidation of points that have none yet from their present stress: in saturated soil without roots
/// it is R_0 times the mean effective stress, and at least R_0 times the smallest pressure of the soil.
template <int D>
results::Preconsolidation set_preconsolidation(mpm::Body<D>& body, const input::Case& data);

/// Names of the materials of a case in alphabetical order, which is that of their numbers.
std::vector<std::string> list_materials(const input::Case& data);

/// Sets the strength of every material, and the bond of bars that F divides, to that of a stage or trial.
template <int D>
void set_strength(mpm::Body<D>& body, const input::Case& data, std::optional<double> cohesion, double factor);

/// Prepares points, initial stress, velocity and pore water, boundary conditions and tractions of the case on its
/// mesh; time is 0. A case that starts from a result takes mesh and state from that result, and `mesh` is ignored
/// (end_state.hpp). `chunks` as in mpm::make_layout; `seepage` receives the steady seepage of the pore pressures, and
/// `season` the weather since then, if there is any. Throws Error (wrong_input) if a name of the case is not in the
/// mesh, or no element holds soil, and what find_initial_water(), resolve_water_conditions() and EndState throw.
template <int D>
mpm::Body<D> prepare(const input::Case& data, mesh::Mesh<D> mesh, int chunks = 0,
                     std::optional<fem::SeepageResult<D>>* seepage = nullptr,
                     std::optional<site::SeasonRecord>* season = nullptr);

/// Soil height H [m]: extent against gravity of the elements that hold points.
template <int D>
double find_soil_height(const mpm::Body<D>& body, const input::Gravity& gravity);

/// Gravity [m/s²] at full strength.
template <int D>
Vec<D> find_gravity(const input::Gravity& gravity);

/// Gravity and the acceleration of a pseudo-static earthquake [m/s²].
template <int D>
Vec<D> find_acceleration(const input::Case& data);

}  // namespace talus::run
