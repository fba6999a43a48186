// SPDX-License-Identifier: MIT
#pragma once
// Polygons of a layered section from its ground and the lower boundary of each layer, from the top down.

#include <optional>
#include <string>
#include <vector>

#include "mesh/planar.hpp"

namespace talus::mesh {

/// A layer and its lower boundary.
struct Layer {
  std::string name;
  Polyline bottom;                  ///< x must not decrease; a vertical step has two points with one x [m]
  std::optional<double> thickness;  ///< instead of `bottom`: vertical distance below the boundary above [m]
  bool cut = false;                 ///< the boundary above cuts this one where they cross
};

/// A change that make_layers() made to a boundary, or a fault of it.
struct LayerNote {
  enum class Kind {
    crossed,   ///< the boundary is above the one above, and `cut` is false: a fault
    cut,       ///< it is cut by the boundary above
    outcrop,   ///< it is above the ground and ends there
    extended,  ///< it ends inside the section and was extended horizontally
    trimmed,   ///< it continues beyond the ground, and was cut off
    sliver,    ///< soil thinner than the smallest thickness was removed
    vanished,  ///< nothing is left of the layer
  };
  Kind kind = Kind::extended;
  int layer = 0;
  double from = 0, to = 0;  ///< along x [m]
  double size = 0;          ///< largest height by which the boundary crosses or soil was removed [m]
};

struct LayeredSection {
  std::vector<Polygon> polygons;  ///< from the top down; a layer that pinches out may have several, or none
  std::vector<int> layers;        ///< layer of each polygon
  std::vector<LayerNote> notes;
};

/// Returns the first point at which x decreases; -1 if there is none.
int find_fold(const Polyline& line);

/// Returns the level of a line at x, constant beyond its ends; at a vertical step the lower level [m].
double find_level(const Polyline& line, double x);

/// Builds polygons that share their corners. `ground` and the boundaries need two points at least and no fold. Soil
/// thinner than `least` [m] is removed: the boundary moves onto the one above. The second polygon of a layer "clay" is
/// named "clay (2)".
LayeredSection make_layers(const Polyline& ground, const std::vector<Layer>& layers, double least);

}  // namespace talus::mesh
