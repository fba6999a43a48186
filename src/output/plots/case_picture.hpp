// SPDX-License-Identifier: MIT
#pragma once
// The picture of a case before its calculation: the section with its soils, water, loads, supports, mesh and search
// ranges, and numbered messages at their places. Plain data, drawn as SVG.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/shown_units.hpp"
#include "results/about.hpp"

namespace talus::output {

enum class SupportKind { fixed, rollers, plane, wall, moving };
enum class SearchZoneKind { window, passage, excluded, tangent };
enum class WaterSideKind { head, pressure, seepage_face, rain, flux, no_flow };

struct CasePicture {
  using Point = results::Point;
  using Polyline = std::vector<Point>;

  struct Soil {
    std::string region, material;  ///< `material` is empty if the region has none
    Polyline outline;
  };
  struct NamedLine {
    std::string name;
    Polyline points;
  };
  struct WaterTable {
    std::string name;
    Polyline points;
    bool is_later = false;  ///< after drawdown
  };
  struct Support {
    SupportKind kind = SupportKind::fixed;
    Polyline line;
    std::string text;                 ///< name of the side, and the value if there is one
    std::array<double, 2> outward{};  ///< away from the soil; for a velocity its direction
  };
  struct WaterSide {
    WaterSideKind kind = WaterSideKind::no_flow;
    Polyline line;
    std::string text;
  };
  /// A load that varies linearly between the points of a line.
  struct Load {
    std::string text;
    Polyline line;
    std::vector<std::array<double, 2>> load;  ///< at each point [Pa]
  };
  /// Inertia of a pseudo-static earthquake.
  struct Shaking {
    std::string text;
    std::array<double, 2> direction{};
  };
  /// A part of the ground where slip surfaces of the search begin or end.
  struct GroundRange {
    std::string text;
    Polyline ground;
    bool is_entry = false;
  };
  struct CentreGrid {
    std::string text;
    Point from{}, to{};
    int columns = 0, rows = 0;
    std::vector<double> levels;  ///< of the deepest points of the circles
  };
  /// A window, an area that slip surfaces avoid, or a line to which circles are tangent.
  struct SearchZone {
    SearchZoneKind kind = SearchZoneKind::window;
    std::string text;
    Polyline points;         ///< one point: a window for a vertex
    bool is_closed = false;  ///< a polygon
  };
  struct RootZone {
    std::string text;
    Polyline ground;
    double depth = 0;  ///< normal to the ground
  };
  /// A bar in the soil: a nail, an anchor, a sheet or a pile.
  struct Bar {
    std::string text;  ///< name of the support; empty for all of its bars but one
    Point head{}, end{};
    double free_share = 0;  ///< part of its length behind the head that has no bond
  };
  using Side = std::array<Point, 2>;
  struct Message {
    bool is_error = false;
    std::string text;
    std::optional<Point> place;
  };

  // Lengths and coordinates in [m].
  std::string title;
  ShownUnit length{"m", 1};
  std::vector<Soil> soils;  ///< later ones replace earlier ones
  Polyline box;             ///< corners of the background box; empty if no method needs one
  std::vector<NamedLine> lines;
  std::vector<Side> soil_sides, empty_sides;  ///< sides of the elements
  std::vector<Polyline> ponds;                ///< polygons of water on the ground
  std::vector<Point> pond_levels;             ///< a point on the surface of each pond
  std::vector<WaterTable> water_tables;
  std::vector<WaterSide> water_sides;
  std::vector<Support> supports;
  std::vector<Load> loads;
  std::vector<Shaking> shaking;
  std::vector<RootZone> roots;
  std::vector<Bar> bars;
  std::vector<GroundRange> ranges;
  std::optional<CentreGrid> centres;
  std::vector<SearchZone> zones;
  std::vector<NamedLine> surfaces;  ///< given slip surfaces
  std::vector<std::string> notes;   ///< lines below the section, such as the number of elements
  std::vector<Message> messages;    ///< numbered from 1
};

/// Returns the picture as SVG, true to scale. Each element of the section has a class, such as "soil", "pond" or
/// "mark"; a mark has its number and its place in units of length as data-number, data-x and data-y.
std::string write_case_picture(const CasePicture& picture);

}  // namespace talus::output
