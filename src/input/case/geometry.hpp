// SPDX-License-Identifier: MIT
#pragma once
// [geometry] and [mesh]: soil polygons in the background box, lines that the mesh conforms to, and mesh settings.

#include <array>
#include <limits>
#include <optional>
#include <string>

#include "input/case/layers.hpp"
#include "input/language/forms.hpp"
#include "input/language/spec.hpp"
#include "mesh/plan.hpp"

namespace talus::input {

void describe(auto& v, mesh::Polygon& p) {
  v.key("name", p.name, plain().required().example(R"("soil")"), "Name of the region; [regions] gives it a material.");
  v.key("points", p.points, quantity("m").required().example("[[0, 0], [44, 0], [44, 5], [32, 5], [12, 15], [0, 15]]"),
        "Corners in order, either way round; the first is not repeated. The sides must not cross.");
}

void describe(auto& v, mesh::Line& l) {
  v.key("name", l.name, plain().required().example(R"("crest")"), "Name for boundary conditions and tractions.");
  v.key("points", l.points, quantity("m").required().example("[[0, 15], [12, 15]]"),
        "Points of the polyline. In 3D it is the trace of a wall that is extruded with the section.");
}

struct GeometryBlock {
  mesh::Plan& plan;
  Layering& layering;
};

void describe(auto& v, GeometryBlock& g) {
  mesh::Plan& plan = g.plan;
  const bool has_file = !plan.file.empty();
  v.key("dimension", plan.dimension, plain().at_least(2).at_most(3),
        "2: plane strain, per metre of thickness. 3: the section is extruded along z.");
  Corners box{plan.box_min, plan.box_max};
  v.key("box", box,
        quantity("m").needed_without("mesh.file", has_file).by_methods({"mpm"}).example("[[0, 0], [44, 17]]"),
        "The background box: the room in which the soil may move. Its sides are named left, right, bottom and top. "
        "Without it, methods other than MPM use the bounding box of the polygons.");
  v.key("thickness", plan.thickness, quantity("m").above(0).needed_with("dimension", plan.dimension, 3).example("5"),
        "Length of the extrusion along z, from the side front (z = 0) to the side back (z = thickness).");
  v.key("ground", g.layering.ground, quantity("m").example("[[0, 15], [12, 15], [32, 5], [44, 5]]"),
        "The ground of a section of layers, from left to right, as points or from a table; its ends are those of the "
        "section. Vertical steps are allowed, overhangs need polygons.");
  v.key("smallest_thickness", g.layering.smallest_thickness, quantity("m").at_least(0),
        "Soil of a layer that is thinner is removed; the boundary moves onto the one above.");
  v.tables("polygon", plan.polygons, 1,
           "A region of soil at the start. Regions may share edges, or one may lie inside another and replace it "
           "there; they must not overlap otherwise. What no polygon covers is empty.");
  v.tables("layer", g.layering.layers, 0,
           "A layer below `ground`, from the top down; the polygons of the section are built from them. The lower "
           "boundary of the last layer is the base of the section.");
  v.tables("line", plan.lines, 0, "A named line that element sides follow.");
}

// [mesh]: the background mesh and its material points.

template <>
inline constexpr auto choices<mesh::Algorithm> = std::array{
    Choice{mesh::Algorithm::frontal, "frontal", "the most regular elements; regular patterns lock in some directions"},
    Choice{mesh::Algorithm::delaunay, "delaunay", "irregular; the best agreement with published curves"},
    Choice{mesh::Algorithm::meshadapt, "meshadapt", "irregular; locks least, for the factor of safety"},
};

void describe(auto& v, mesh::Refinement& r) {
  v.key("near", r.near, quantity("m").required().example("[[12, 15], [32, 5]]"), "One point, or a polyline.");
  v.key("size", r.size, quantity("m").above(0).required().example("0.3"), "Element size there.");
  v.key("distance", r.distance, quantity("m").above(0).required().example("2"),
        "Distance at which the general size is reached again.");
}

struct MeshBlock {
  mesh::Plan& plan;
  int& points_per_element;
  std::optional<double>& softening_length;
};

void describe(auto& v, MeshBlock& m) {
  mesh::Plan& plan = m.plan;
  v.key("file", plan.file, plain().example(R"("ready.msh")"),
        "A ready mesh in Gmsh's format (.msh, version 4) instead of polygons; its path is relative to the case file. "
        "Physical groups of elements are regions (\"empty\" is the empty one), groups of sides are sides.");
  const bool has_file = !plan.file.empty();
  v.key(
      "size", plan.size, quantity("m").above(0).needed_without("file", has_file).by_methods({"mpm"}).example("0.75"),
      "General size of an element: the length of its sides. FEM and seepage without MPM need it as well, or `size` in "
      "[fem].");
  v.key("algorithm", plan.algorithm, plain().allowed_without("file", has_file), "Gmsh's algorithm for the triangles.");
  v.key("points_per_element", m.points_per_element, plain().at_least(1).at_most(12),
        "Material points in each element filled with soil: 1, 3, 6 or 12 in 2D; 1, 4, 8 or 10 in 3D (where the default "
        "is 4).");
  v.key("softening_length", m.softening_length, quantity("m").above(0).by_methods({"mpm"}).example("0.3"),
        "Nonlocal length: the plastic strain that softens is averaged over this radius, in MPM and in FEM with [fem] "
        "softening = \"progressive\". At least twice the size of the elements where a band forms. If not given, bands "
        "are as thick as the elements, and the results depend on their size.");
  v.tables("refine", plan.refinements, 0, "Smaller elements near a point or a polyline.");
}

// The outline of the soil in a plane section: extent and ground level.

class SoilOutline {
 public:
  explicit SoilOutline(const mesh::Plan& plan);

  double left() const { return left_; }      ///< [m]
  double right() const { return right_; }    ///< [m]
  double bottom() const { return bottom_; }  ///< [m]
  double top() const { return top_; }        ///< [m]
  /// Returns 1e-9 of the width, the tolerance for rounding errors [m].
  double slack() const { return 1e-9 * (right_ - left_); }
  /// Returns true if there is ground at x.
  bool spans(double x) const { return x >= left_ - slack() && x <= right_ + slack(); }
  const ShownUnits& units() const { return plan_.units; }
  /// Writes the extent: "which goes from x = 0 m to x = 44 m".
  std::string write_span() const;
  /// Returns the highest level of soil at x [m]; minus infinity if there is none.
  double find_ground(double x) const;

 private:
  static constexpr double far_ = std::numeric_limits<double>::infinity();
  const mesh::Plan& plan_;
  double left_ = far_, right_ = -far_, bottom_ = far_, top_ = -far_;
};

}  // namespace talus::input
