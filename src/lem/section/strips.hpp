// SPDX-License-Identifier: MIT
#pragma once
// The section divided into vertical strips between the breaks of ground, regions, water table and loads. Inside a strip
// every line is straight and no two of them cross, so that weights are exact from the mid-ordinates.

#include <limits>
#include <vector>

#include "lem/section/bars.hpp"
#include "lem/section/section.hpp"
#include "lem/section/slope.hpp"

namespace talus::lem {

/// A straight line over a strip, given by its elevation at the strip's left side.
struct StripLine {
  double y = 0, slope = 0;
  double at(double dx) const { return y + slope * dx; }
};

/// One soil, above or below the water table, in one strip.
struct Layer {
  StripLine top, bottom;
  StripLine weight;        ///< of all layers above its top [N/m²]
  double unit_weight = 0;  ///< [N/m³]
  int soil = -1;           ///< -1: no region there
  bool wet = false;        ///< below the water table
  bool was_wet = false;    ///< below the water table before drawdown
};

struct Strip {
  double left = 0, right = 0;          ///< [m]
  StripLine ground, water;             ///< water: -infinity without a water table
  StripLine water_before;              ///< water table before drawdown; the same without one
  std::vector<StripLine> piezometric;  ///< the piezometric lines of the section
  StripLine floor;                     ///< top of impenetrable soil; without it the bottom of the soil
  bool is_firm = false;                ///< it has impenetrable soil
  bool is_raised = false;              ///< it has none, and its soil ends above the base of the section
  StripLine load, thrust;              ///< loads on the ground, down and towards larger x [Pa]
  StripLine variable_load;             ///< part of `load` under which soil does not consolidate [Pa]
  int first = 0, last = 0;             ///< its layers, from the ground down: [first, last)
  bool ponded = false;                 ///< ponded water on the ground

  /// Returns the water table or the piezometric line of a soil.
  const StripLine& find_water(const Soil& soil) const {
    return soil.piezometric_line < 0 ? water : piezometric[static_cast<std::size_t>(soil.piezometric_line)];
  }
};

struct Slope::Strips {
  Section section;
  std::vector<Strip> strips;  ///< from left to right, without gaps
  std::vector<Layer> layers;
  std::vector<double> tan_friction, tan_phi_b;  ///< per soil
  std::vector<int> at;                          ///< strip at the left side of each bin; starts of find()
  double bin = 1;                               ///< width of a bin [m]
  PressureLocator pressure;
  std::unique_ptr<const Slope> before;  ///< the slope before drawdown
  std::vector<Point> crack_depths;      ///< of a crack of limited depth: x and depth [m]
  std::vector<BarDiagram> bars;         ///< of the bars of the section
  std::vector<BarDiagram> embedded;     ///< of the piles among them, in stable soil
  double deepest_roots = 0;             ///< [m]
  bool roots = false, loads = false, firm = false, raised = false;
  bool laws = false, curved_laws = false;  ///< of the soils
  bool unreduced = false;                  ///< the factor does not divide the strength of some soil

  /// Returns the index of the strip over x; at a break that to the right.
  int find(double x) const;
  /// Returns the index of the layer that contains the elevation; the last one below all, -1 without layers.
  int find_layer(const Strip& strip, double dx, double y) const {
    for (int i = strip.first; i < strip.last; ++i)
      if (y >= layers[static_cast<std::size_t>(i)].bottom.at(dx)) return i;
    return strip.last - 1;
  }
  const Layer& layer(int i) const { return layers[static_cast<std::size_t>(i)]; }
  const Strip& strip(int i) const { return strips[static_cast<std::size_t>(i)]; }
};

/// Returns the elevation of a polyline at x, level beyond its ends; at a vertical step that of the right side.
double follow_line(const std::vector<Point>& line, double x);

/// Builds the strips of a section without faults.
void build_strips(Slope::Strips& strips);

// The layers of one strip.

struct Edge {
  Point a{}, b{};  ///< from left to right; never vertical
  int region = -1;
  double at(double x) const { return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]); }
};

/// Elevation that stands for 'no water table'.
inline constexpr double no_water = -std::numeric_limits<double>::infinity();

/// Returns the line of an edge over a strip.
inline StripLine cut_edge(const Edge& edge, double left) {
  const double slope = (edge.b[1] - edge.a[1]) / (edge.b[0] - edge.a[0]);
  return {edge.a[1] + slope * (left - edge.a[0]), slope};
}

/// Appends the layers of a strip from the ground down to the base. A layer thinner than `sliver` is merged with the one
/// beside it.
void stack_layers(Slope::Strips& strips, Strip& strip, const std::vector<Edge>& edges, double sliver);

}  // namespace talus::lem
