// SPDX-License-Identifier: MIT
#pragma once
// Pore water of a case for MPM and FEM: constant pore pressures, with the weight of the wet soil.

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "site/seepage_results.hpp"
#include "site/site.hpp"

namespace talus::site {

/// Returns true if some soil that fills a region has pore water.
bool has_water(const input::Case& data);

// Constant pore water: pressures at the corners of the elements and the unit weight of the soil with its water, for FEM
// and for MPM without a phase of water.

/// Constant pore water per element; zero in empty ones.
template <int D>
struct HeldWater {
  std::vector<double> unit_weight;              ///< γ of the soil with its water [N/m³]
  std::vector<std::array<double, D + 1>> pore;  ///< χp at the corners, positive in tension [Pa]; 0 for total stresses
  bool acts = false;                            ///< true if some pressure is not 0
};

/// Returns the pore water from the water table or the seepage of the case, and from r_u. `summary` as in
/// find_nodal_pressure().
template <int D>
HeldWater<D> find_held_water(const input::Case& data, const mesh::Mesh<D>& mesh, WaterResult* summary = nullptr);

/// Returns the same from the pore pressure at the nodes, as find_nodal_pressure() has it [Pa].
template <int D>
HeldWater<D> hold_water(const input::Case& data, const mesh::Mesh<D>& mesh, const std::vector<double>& pressure);

/// Returns the same of soil without pore water of its own in which given pressures act: for MPM, which moves the pore
/// water of the others. Other elements have zero.
template <int D>
HeldWater<D> find_given_water(const input::Case& data, const mesh::Mesh<D>& mesh);

/// Adds the pore pressure due to r_u alone, with these unit weights [N/m³]. Returns false if no soil has an r_u.
template <int D>
bool add_pressure_ratio(const input::Case& data, const mesh::Mesh<D>& mesh, const std::vector<double>& unit_weight,
                        std::vector<std::array<double, D + 1>>& pore);

}  // namespace talus::site
