// SPDX-License-Identifier: MIT
#pragma once
// What the mesh generator is asked for: the geometry of a case as plain data, in metres.

#include <array>
#include <string>
#include <vector>

namespace talus::mesh {

struct Polygon {
  std::string name;
  std::vector<std::array<double, 2>> points;  ///< corners in order, not repeated [m]
};

/// A line that the mesh conforms to and that boundary conditions may name. In 3D it is the trace of an extruded wall.
struct Line {
  std::string name;
  std::vector<std::array<double, 2>> points;  ///< polyline [m]
};

/// Smaller elements within `distance` of a point or polyline.
struct Refinement {
  std::vector<std::array<double, 2>> near;  ///< one point, or a polyline [m]
  double size = 0;                          ///< element size on it [m]
  double distance = 0;                      ///< where the general size is reached again [m]
};

enum class Algorithm { frontal, delaunay, meshadapt };

struct Plan {
  std::string file;  ///< a ready Gmsh mesh (.msh, version 4); then nothing below but `dimension` is used
  int dimension = 2;
  std::array<double, 2> box_min{};  ///< background box [m]
  std::array<double, 2> box_max{};  ///< [m]
  double thickness = 0;             ///< 3D only: extrusion along z, from 0 to thickness [m]
  std::vector<Polygon> polygons;
  std::vector<Line> lines;
  double size = 0;  ///< general element size [m]
  Algorithm algorithm = Algorithm::delaunay;
  std::vector<Refinement> refinements;

  // Compiled once, in check_plan.cpp: the files that hold one would each compile them again.
  Plan();
  Plan(const Plan&);
  Plan(Plan&&) noexcept;
  Plan& operator=(const Plan&);
  Plan& operator=(Plan&&) noexcept;
  ~Plan();
};

/// The plan with another general element size: finer places stay as much finer as they are.
Plan resize(Plan plan, double size);

// Checks a plan before the mesh generator sees it, whose own messages would tell a user little.

/// Lengths below this are taken as zero: a millionth of the element size [m].
double get_tolerance(const Plan& plan);

/// The plan with points that nearly coincide (within the tolerance) made the same: on the sides and corners of the box
/// and on one another. Throws Error (wrong_input) with one sentence when a size is not positive, a name is missing,
/// used twice or reserved, a polygon crosses itself or leaves the box, two polygons overlap partly, or a line leaves
/// the box.
Plan check_plan(const Plan& plan);

}  // namespace talus::mesh
