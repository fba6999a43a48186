// SPDX-License-Identifier: MIT
#pragma once
// [mesh]: the background mesh and the material points in it.

#include <array>
#include <optional>

#include "input/language/spec.hpp"
#include "mesh/plan.hpp"

namespace talus::input {

template <>
inline constexpr auto choices<mesh::Algorithm> = std::array{
    Choice{mesh::Algorithm::frontal, "frontal", "the most regular elements; regular patterns lock in some directions"},
    Choice{mesh::Algorithm::delaunay, "delaunay", "irregular; the best agreement with published curves"},
    Choice{mesh::Algorithm::meshadapt, "meshadapt", "irregular; locks least, for the factor of safety"},
};

template <class Visitor>
void describe(Visitor& v, mesh::Refinement& r) {
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

template <class Visitor>
void describe(Visitor& v, MeshBlock& m) {
  mesh::Plan& plan = m.plan;
  v.key("file", plan.file, plain().example(R"("ready.msh")"),
        "A ready mesh in Gmsh's format (.msh, version 4) instead of polygons; its path is relative to the case file. "
        "Physical groups of elements are regions (\"empty\" is the empty one), groups of sides are sides.");
  const bool has_file = !plan.file.empty();
  v.key("size", plan.size, quantity("m").above(0).needed_without("file", has_file).by_methods({"mpm"}).example("0.75"),
        "General size of an element: the length of its sides. Finite elements and seepage without material points need "
        "it as well, or `size` in [fem].");
  v.key("algorithm", plan.algorithm, plain().allowed_without("file", has_file), "Gmsh's algorithm for the triangles.");
  v.key("points_per_element", m.points_per_element, plain().at_least(1).at_most(12),
        "Material points in each element filled with soil: 1, 3, 6 or 12 in 2D; 1, 4, 8 or 10 in 3D (where the "
        "default is 4).");
  v.key("softening_length", m.softening_length, quantity("m").above(0).by_methods({"mpm"}).example("0.3"),
        "Length over which soil softens that dilates: its plastic volume is a mean over this neighbourhood. At least "
        "twice the size of the elements where a band forms. If not given, bands are as thick as the elements, and what "
        "softens depends on their size.");
  v.tables("refine", plan.refinements, 0, "Smaller elements near a point or a polyline.");
}

}  // namespace talus::input
