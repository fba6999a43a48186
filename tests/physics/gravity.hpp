// SPDX-License-Identifier: MIT
#pragma once
// Gravity and the weight of water of the tests of soil with water.

namespace talus::reference {

inline constexpr double g = 9.81, gamma_w = 1000 * g;  ///< [m/s²], [N/m³]

}  // namespace talus::reference
