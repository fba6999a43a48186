// SPDX-License-Identifier: MIT
#pragma once
// A quantity of a soil along one or several vertical profiles, by elevation or by depth under the ground.

#include <vector>

#include "material/linear_elastic.hpp"

namespace talus::material {}  // namespace talus::material
