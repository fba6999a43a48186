// SPDX-License-Identifier: MIT
#include "input/case/elements_and_bounds.hpp"

#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, FiniteElements& f) {
  v.key("size", f.size, quantity("m").above(0).example("1.0"),
        "Size of the quadratic elements; if not given, that of [mesh]. With two meshes it is that of the finer one.");
  v.key("algorithm", f.algorithm, plain(), "Gmsh's algorithm for their mesh.");
  v.key("meshes", f.meshes, plain().at_least(1).at_most(2),
        "2: the search is repeated on elements of twice the size, the factor is extrapolated to size zero, and its "
        "interval holds the error of the mesh. 1: one mesh, whose error is not known. If not given, it is 1 in 3D and "
        "for a ready mesh file.");
  v.key(
      "adapt", f.adapt, plain(),
      "true: the mesh has elements of twice the size first and is refined where the soil shears at failure, until the "
      "interval is at most 3 % wide or the mesh has about 1.5 times the elements of one of `size`. The factor is "
      "extrapolated from the last two of at least three meshes, in place of `meshes`. In 3D and with a ready mesh "
      "file, walls, seepage, bedding, stages, soil that softens or two flow rules the mesh is not adapted, and a "
      "warning says why.");
  v.key("flow", f.flow, plain(), "Plastic flow of the trials.");
  v.key(
      "davis", f.davis, plain(),
      "Instead of ψ < φ, associated flow with c and tan φ times β = cos ψ cos φ/(1 − sin ψ sin φ) after Davis (1968), "
      "by these angles. The factor varies less with the mesh. It replaces the trials with ψ as given.");
  v.key("softening", f.softening, plain(),
        "Treatment of soil of the softening models. In a progressive failure the strength of a trial, at every strain, "
        "is that of the case divided by the factor.");
  v.key("from", f.from, plain().above(0), "Lower end of the first bracket; widened when the factor is not in it.");
  v.key("to", f.to, plain().above(0), "Upper end of the first bracket.");
  v.key("resolution", f.resolution, plain().above(0), "Width of the last bracket.");
  v.key("force_tolerance", f.force_tolerance, plain().above(0).below(1),
        "Largest out-of-balance force over the external force in an equilibrium.");
  v.key("displacement_tolerance", f.displacement_tolerance, plain().above(0).below(1),
        "And largest motion still to come over all displacement of the load step; both must hold.");
  v.key("iterations", f.iterations, plain().at_least(1).at_most(10000),
        "Linear systems that are solved in a load step or trial, at most. A trial that runs out of them is undecided: "
        "the search continues below it, a warning says so, and the interval reaches up to the next trial that failed.");
  v.key("load_steps", f.load_steps, plain().at_least(1).at_most(10000),
        "Steps in which weight and loads come on; halved where one does not converge.");
}

void describe(Visitor& v, ProvenBounds& b) {
  v.key(
      "size", b.size, quantity("m").above(0).example("2.0"),
      "Size of the triangles of the first mesh. If not given, a sixth of the section's height, and a twelfth with pore "
      "water.");
  v.key("gap", b.gap, plain().above(0).below(1),
        "The meshes become finer where the bounds lie apart, until the interval is no wider than this share of its "
        "middle.");
  v.key("triangles", b.triangles, plain().at_least(1).at_most(200000),
        "A mesh with as many triangles is the last one, whatever the interval.");
  v.key("tension", b.tension, plain(), "Largest effective tension of the soils.");
  v.key("flow", b.flow, plain(), "Plastic flow of the soils.");
}

}  // namespace talus::input
