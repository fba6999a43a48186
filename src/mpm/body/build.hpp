// SPDX-License-Identifier: MIT
#pragma once
// From a mesh and a list of points to a body that can step.

#include "base/message.hpp"
#include "mpm/body/body.hpp"
#include "mpm/step/step.hpp"

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
  std::array<double, material::max_state_size> state{};  ///< of its law
  double pressure = 0;      ///< of the pore water, tension positive [Pa]; its mass follows from it
  Vec<D> water_velocity{};  ///< [m/s]
};

/// Blocks, chunks and node rows of a mesh. `points_in_element` balances the chunks; `chunks` = 0 chooses their number
/// from the size of the problem alone (never from the number of threads).
template <int D>
std::shared_ptr<const Layout<D>> make_layout(mesh::Mesh<D> mesh, const std::vector<int>& points_in_element,
                                             int chunks = 0);

/// The same with the first block of each chunk, [chunks + 1], given.
template <int D>
std::shared_ptr<const Layout<D>> lay_out(mesh::Mesh<D> mesh, std::vector<int> chunk_start);

/// Room for the fields of a body that has its layout, its fields of a point and its water laws: all zero, and none of
/// `points` points on the grid.
template <int D>
void allocate_fields(Body<D>& body, int points);

/// A body at rest at time 0, without constraints. Point numbers are the positions in `points`. With water laws (one per
/// material) it is one of two phases, all surfaces seepage faces.
template <int D>
Body<D> make_body(std::shared_ptr<const Layout<D>> layout, std::vector<material::Law> laws,
                  std::vector<std::string> names, const std::vector<InitialPoint<D>>& points,
                  const std::vector<WaterLaw>& water = {});

// A body without its soil, which several ranks have before each takes its part: conditions and totals, and room for all
// fields. What is zero takes no memory (base/aligned.hpp).

/// A body like `body` with all fields zero and no point on its grid.
template <int D>
Body<D> copy_description(const Body<D>& body);

/// Into a message, but for layout, laws and the reach of softening.
template <int D>
void put_description(const Body<D>& body, Message& message);
/// Out of it; the body has no laws yet.
template <int D>
Body<D> get_description(Message& message, std::shared_ptr<const Layout<D>> layout);

/// The layout that rank 0 has, on all ranks.
template <int D>
std::shared_ptr<const Layout<D>> broadcast_layout(std::shared_ptr<const Layout<D>> layout);

}  // namespace talus::mpm
