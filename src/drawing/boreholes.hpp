// SPDX-License-Identifier: MIT
#pragma once
// Boreholes, and the layers that they show: the order of the soils, and the depth of each lower boundary.

#include <optional>
#include <string>
#include <vector>

#include "drawing/section.hpp"

namespace talus::drawing {

/// A layer that a borehole meets.
struct DrilledLayer {
  std::string soil;
  double bottom = 0;  ///< depth [m]
};

struct Borehole {
  std::string name, place;           ///< place: file and line of its first row
  std::optional<double> x;           ///< along the section [m]
  std::optional<double> collar;      ///< elevation of its top [m]
  std::vector<DrilledLayer> layers;  ///< from the top down; empty if `bottoms` are given
  /// Depths of the lower boundaries of the soils of the section; std::nullopt: the borehole ends above [m].
  std::vector<std::optional<double>> bottoms;
  double end = 0;  ///< depth of its end [m]
};

/// A soil of the section.
struct DrilledSoil {
  std::string name, material;
};

/// Puts the soils of the boreholes into one order from the top down, and fills `bottoms`: a soil that a borehole does
/// not meet above its end has no thickness there. A soil that returns in a borehole is a layer of its own, of the same
/// material. Throws Error (wrong_input) with the boreholes if their orders contradict one another.
std::vector<DrilledSoil> order_soils(std::vector<Borehole>& holes);

/// Returns the layers of a section below `ground`, with boreholes sorted along x. The last soil ends at `base`
/// [m], if it is given. Otherwise it ends at the lowest end of a borehole, unless its lower boundary is known. Throws
/// Error (wrong_input) if the base is above a boundary.
std::vector<DrawnSoil> make_drilled_layers(const std::vector<Borehole>& holes, const std::vector<DrilledSoil>& soils,
                                           const mesh::Polyline& ground, std::optional<double> base,
                                           std::vector<std::string>& remarks);

}  // namespace talus::drawing
