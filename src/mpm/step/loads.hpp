// SPDX-License-Identifier: MIT
#pragma once
// Tractions as nodal forces, wherever the points are.

#include <functional>
#include <vector>

#include "mpm/body/body.hpp"

namespace talus::mpm {

/// Where a point is.
template <int D>
struct PointPlace {
  int element = -1;  ///< -1: nowhere
  Vec<D> xi{};
};

/// The nodal forces of a body's tractions at `time` [N]. `locate` tells where its points are.
template <int D>
std::vector<Vec<D>> find_loads(const Body<D>& body, double time,
                               const std::function<std::vector<PointPlace<D>>(const std::vector<int>&)>& locate);

}  // namespace talus::mpm
