// SPDX-License-Identifier: MIT
#pragma once
// The section that a drawing shows: its ground, boundaries, closed regions and water table.

#include <optional>
#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "mesh/planar.hpp"

namespace talus::drawing {

/// Meaning of the lines that divide soils.
enum class LineRole {
  bottoms,  ///< a line is the lower boundary of the soil of its layer
  tops,     ///< a line is the upper boundary of the soil of its layer
};

/// Form in which the soils are written.
enum class SectionForm {
  layers,   ///< a ground and lower boundaries
  regions,  ///< the areas that the lines enclose
};

struct SectionOptions {
  double unit = 1;                       ///< of the drawing [m]
  std::optional<LineRole> role;          ///< bottoms, unless the names of layers suggest tops: then it must be given
  std::optional<double> base;            ///< level of the base of the section below the lowest line [m]
  std::vector<std::string> layers;       ///< layers of the drawing that are used; empty: all
  std::optional<SectionForm> form = {};  ///< regions, if lines cross or fold back and most of them bound areas
  std::optional<double> snap = {};       ///< distance below which ends of lines are moved onto others [m]
};

/// A soil above a line, or within one.
struct DrawnSoil {
  std::string name;
  mesh::Polyline points;             ///< lower boundary from left to right, or outline, or (x, depth) of boreholes [m]
  std::string material = {};         ///< empty: the name
  bool are_depths = false;           ///< `points` are (x, depth of the lower boundary below the ground)
  std::optional<double> level = {};  ///< of a horizontal lower boundary, instead of `points` [m]
};

struct DrawnSection {
  mesh::Polyline ground;           ///< empty: the section is given by outlines only
  std::vector<DrawnSoil> layers;   ///< from the top down
  std::vector<DrawnSoil> regions;  ///< outlines
  mesh::Polyline water_table;
  std::vector<std::string> remarks;  ///< what was recognised, and what was not used
};

/// Finds the section of a drawing. Lines of one layer that meet are joined. A layer named after the ground, or
/// otherwise the uppermost line, is the ground; layers named after water are the water table. A single closed line
/// around open ones is the outline of the section. Where lines cross or fold back, and with closed ones, the areas that
/// they enclose are the soils (drawing/subdivision.hpp). Throws Error (wrong_input) if there is no section.
DrawnSection find_section(const Drawing& drawing, const SectionOptions& options);

/// Returns the case file of a section. Strengths and weights, which no drawing has, are left to the user. `source` is
/// named in its first line.
std::string write_case(const DrawnSection& section, const std::string& source);

}  // namespace talus::drawing
