// SPDX-License-Identifier: MIT
#pragma once
// Construction of a body from a mesh and a list of points.

#include "base/message.hpp"
#include "mpm/solver/step.hpp"
#include "mpm/state/body.hpp"

namespace talus::mpm {

/// A material point at the start.
template <int D>
struct InitialPoint {
  int element = 0;
  Vec<D> xi{};                                            ///< local coordinates
  Vec<D> velocity{};                                      ///< [m/s]
  std::array<double, material::stress_size<D>> stress{};  ///< [Pa]
  double mass = 0;                                        ///< of the grains [kg]
  double volume = 0;                                      ///< [m³]
  int material = 0;
  std::array<double, material::max_state_size> state{};  ///< state variables of its law
  double pressure = 0;      ///< of the pore water, tension positive [Pa]; determines the mass of the water
  Vec<D> water_velocity{};  ///< [m/s]
};

/// Blocks, chunks and node rows of a mesh. `points_in_element` balances the chunks. `chunks` = 0 derives their number
/// from the size of the problem alone, never from the number of threads.
template <int D>
std::shared_ptr<const Layout<D>> make_layout(mesh::Mesh<D> mesh, const std::vector<int>& points_in_element,
                                             int chunks = 0);

/// The same with given chunks: chunk_start is the first block of each, [chunks + 1].
template <int D>
std::shared_ptr<const Layout<D>> lay_out(mesh::Mesh<D> mesh, std::vector<int> chunk_start);

/// Allocates the fields of a body with known layout, fields per point and water laws. All are zero, and none of the
/// `points` points is on the grid.
template <int D>
void allocate_fields(Body<D>& body, int points);

/// A body at rest at time 0 without constraints. Point numbers are the indices in `points`. With water laws (one per
/// material) the body has two phases, and all surfaces are seepage faces.
template <int D>
Body<D> make_body(std::shared_ptr<const Layout<D>> layout, std::vector<material::Law> laws,
                  std::vector<std::string> names, const std::vector<InitialPoint<D>>& points,
                  const std::vector<WaterLaw>& water = {});

// The description of a body: conditions, totals and zero fields, without soil. All ranks have it before each receives
// its part in the scatter. Zero fields take no memory (base/aligned.hpp).

/// A body like `body` with all fields zero and no point on the grid.
template <int D>
Body<D> copy_description(const Body<D>& body);

/// Writes the description into a message, without layout, laws and nonlocal reach.
template <int D>
void put_description(const Body<D>& body, Message& message);
/// Reads it; the body has no laws yet.
template <int D>
Body<D> get_description(Message& message, std::shared_ptr<const Layout<D>> layout);

/// Broadcasts the layout of rank 0 to all ranks.
template <int D>
std::shared_ptr<const Layout<D>> broadcast_layout(std::shared_ptr<const Layout<D>> layout);

}  // namespace talus::mpm
