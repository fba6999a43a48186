// SPDX-License-Identifier: MIT
#pragma once
// The weight of pools on the soil under them, for seepage in soil that is compressed by it.

#include <functional>
#include <vector>

#include "input/case/case.hpp"
#include "mesh/mesh.hpp"

namespace talus::ground {

/// Weight of the pools over each node of `mesh` as a function of time [Pa]: that of the water over the ground of its
/// vertical; at time 0 those just before it. The function keeps `data`. Throws what find_ground() throws.
std::function<std::vector<double>(double time)> make_pool_weight(const input::Case& data, const mesh::Mesh<2>& mesh);

}  // namespace talus::ground
