// SPDX-License-Identifier: MIT
#pragma once
// Which elements of a mesh hold soil.

#include <functional>
#include <type_traits>

#include "base/vec.hpp"

namespace talus::support {

template <int D>
using Filling = std::type_identity_t<std::function<int(const Vec<D>& centroid)>>;  ///< material number, -1: no soil

}  // namespace talus::support
