// SPDX-License-Identifier: MIT
#pragma once
// Input of the mesh generator: the geometry of a case as plain data, in metres.

#include <array>
#include <string>
#include <vector>

#include "base/shown_units.hpp"

namespace talus::mesh {

struct Polygon {
  std::string name;
  std::vector<std::array<double, 2>> points;  ///< corners in order, not repeated [m]
};

/// A line that the mesh conforms to and to which boundary conditions may refer. In 3D it is the trace of an extruded
/// wall.
struct Line {
  std::string name;
  std::vector<std::array<double, 2>> points;  ///< polyline [m]
};

/// Local refinement within `distance` of a point or polyline.
struct Refinement {
  std::vector<std::array<double, 2>> near;  ///< one point, or a polyline [m]
  double size = 0;                          ///< element size at the point or line [m]
  double distance = 0;                      ///< distance at which the general size is reached [m]
};

enum class Algorithm { frontal, delaunay, meshadapt };

struct Plan {
  std::string file;  ///< external Gmsh mesh (.msh, version 4), which replaces all following members but `dimension`
  int dimension = 2;
  std::array<double, 2> box_min{};  ///< background box [m]
  std::array<double, 2> box_max{};  ///< [m]
  double thickness = 0;             ///< 3D only: extrusion along z from 0 to thickness [m]
  std::vector<Polygon> polygons;
  std::vector<Line> lines;
  double size = 0;  ///< general element size [m]
  Algorithm algorithm = Algorithm::delaunay;
  std::vector<Refinement> refinements;
  ShownUnits units;  ///< units of messages
};

/// Returns the target element size at a point: the general one or that of the nearest refinement [m].
double compute_size(const Plan& plan, const std::array<double, 2>& x);

/// Returns the plan with another general element size; local sizes are scaled in proportion.
Plan resize(Plan plan, double size);

// Validation of a plan before meshing, because the messages of the mesh generator are not meant for users.

/// Returns the length below which distances count as zero, 1e-6 of the element size [m].
double get_tolerance(const Plan& plan);

/// Returns the plan with points that coincide within the tolerance made identical: with sides and corners of the box
/// and with one another. Throws Error (wrong_input) with one sentence if a size is not positive, a name is missing,
/// used twice or reserved, a polygon intersects itself or leaves the box, two polygons overlap partly, or a line leaves
/// the box.
Plan check_plan(const Plan& plan);

}  // namespace talus::mesh
