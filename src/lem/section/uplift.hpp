// SPDX-License-Identifier: MIT
#pragma once
// Hydraulic uplift: soil whose pore pressure exceeds the weight above it.

#include <optional>

#include "lem/section/slope.hpp"

namespace talus::lem {

/// The place at which the pore pressure exceeds the vertical total stress most.
struct Uplift {
  Point at{};
  double stress = 0;    ///< σ_v of soil, standing water and loads above [Pa]
  double pressure = 0;  ///< u [Pa]
  /// Returns the factor of safety against uplift, σ_v/u.
  double factor() const { return stress / pressure; }
};

/// Returns the uplift of a slope where σ_v < u, i.e. the vertical effective stress is tensile; std::nullopt if it is
/// nowhere. Verticals at 200 places and in all strips are examined, at the boundaries of soils and at 40 levels between
/// ground and base. Soil analysed by total stresses has no u. An excess below 1 % of u
/// is not reported: pressures of seepage have errors of that size.
std::optional<Uplift> find_uplift(const Slope& slope);

}  // namespace talus::lem
