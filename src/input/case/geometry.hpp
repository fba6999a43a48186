// SPDX-License-Identifier: MIT
#pragma once
// [geometry]: the soil polygons in the background box, and lines that the mesh conforms to.

#include "input/language/forms.hpp"
#include "input/language/spec.hpp"
#include "mesh/plan.hpp"

namespace talus::input {

template <class Visitor>
void describe(Visitor& v, mesh::Polygon& p) {
  v.key("name", p.name, plain().required().example(R"("soil")"), "Name of the region; [regions] gives it a material.");
  v.key("points", p.points, quantity("m").required().example("[[0, 0], [44, 0], [44, 5], [32, 5], [12, 15], [0, 15]]"),
        "Corners in order, either way round; the first is not repeated. The sides must not cross.");
}

template <class Visitor>
void describe(Visitor& v, mesh::Line& l) {
  v.key("name", l.name, plain().required().example(R"("crest")"), "Name for boundary conditions and tractions.");
  v.key("points", l.points, quantity("m").required().example("[[0, 15], [12, 15]]"),
        "Points of the polyline. In 3D it is the trace of a wall that is extruded with the section.");
}

struct GeometryBlock {
  mesh::Plan& plan;
};

template <class Visitor>
void describe(Visitor& v, GeometryBlock& g) {
  mesh::Plan& plan = g.plan;
  const bool has_file = !plan.file.empty();
  v.key("dimension", plan.dimension, plain().at_least(2).at_most(3),
        "2: plane strain, per metre of thickness. 3: the section is extruded along z.");
  Corners box{plan.box_min, plan.box_max};
  v.key("box", box,
        quantity("m").needed_without("mesh.file", has_file).by_methods({"mpm"}).example("[[0, 0], [44, 17]]"),
        "The background box: the room in which the soil may move. Its sides are named left, right, bottom and top. "
        "Where no material points move and it is not given, it just holds the polygons.");
  v.key("thickness", plan.thickness, quantity("m").above(0).needed_with("dimension", plan.dimension, 3).example("5"),
        "Length of the extrusion along z, from the side front (z = 0) to the side back (z = thickness).");
  v.tables("polygon", plan.polygons, 1,
           "A region of soil at the start. Regions may share edges, or one may lie inside another and replace it "
           "there; they must not overlap otherwise. What no polygon covers is empty.");
  v.tables("line", plan.lines, 0, "A named line that element sides follow.");
}

}  // namespace talus::input
