// SPDX-License-Identifier: MIT
#pragma once
// From a case and its mesh to a body in its initial state.

#include <optional>
#include <vector>

#include "fem/seepage/seepage.hpp"
#include "ground/season.hpp"
#include "input/case/case.hpp"
#include "mpm/body/build.hpp"

namespace talus::run {

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
