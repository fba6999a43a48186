// SPDX-License-Identifier: MIT
#include "results/elements.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, ElementTrial& r) {
  v.key("factor", r.factor, {"", "factor that the strength is divided by"});
  v.key("converged", r.converged, {"", "whether there is equilibrium"});
  v.key("iterations", r.iterations, {"", "iterations"});
  v.key("force_residual", r.force_residual, {"", "unbalanced force over the external force"});
  v.key("displacement_residual", r.displacement_residual, {"", "last change of the displacement over itself"});
  v.key("displacement", r.displacement, {"m", "largest displacement"});
  v.key("seconds", r.seconds, {"s", "seconds"});
}

void describe(Visitor& v, ElementMeshFactor& r) {
  v.key("size", r.size, {"m", "mean size of the elements"});
  v.key("factor", r.factor, {"", "factor of safety on this mesh"});
  v.key("stable", r.stable, {"", "largest factor with equilibrium"});
  v.key("failed", r.failed, {"", "smallest factor without equilibrium"});
  v.maybe("flowing", r.flowing, {"", "smallest factor at which the soil flows"});
}

void describe(Visitor& v, ElementInterval& r) {
  v.key("lower", r.lower, {"", "lower end of the interval of mesh and search"});
  v.key("upper", r.upper, {"", "upper end of the interval of mesh and search"});
}

void describe(Visitor& v, ElementFace& r) {
  v.key("place", r.place, {"m", "distances from the head"});
  v.key("normal", r.normal, {"Pa", "effective normal stress on the wall there, positive in compression"});
  v.key("shear", r.shear, {"Pa", "shear stress of the soil on the wall there, towards its toe"});
}

void describe(Visitor& v, ElementDeflection& r) {
  v.key("place", r.place, {"m", "distances from the head"});
  v.key("value", r.value, {"m", "displacement there, towards the left of the way from head to toe"});
}

void describe(Visitor& v, ElementBar& r) {
  v.key("support", r.support, {"", "name of the support"});
  v.key("kind", r.kind, {"", "kind of the support"});
  v.key("row", r.row, {"", "row from the top of the pattern"});
  v.key("head", r.head, {"m", "head of the bar"});
  v.key("end", r.end, {"m", "end of the bar"});
  v.key("place", r.place, {"m", "distances from the head"});
  v.key("force", r.force, {"N/m", "axial force there at failure, per metre of slope"});
  v.key("at_start", r.at_start, {"N/m", "axial force there at full strength of the soil"});
  v.key("largest", r.largest, {"N/m", "largest axial force at failure"});
  v.key("plate", r.plate, {"N/m", "force of plate, facing or connection at failure"});
  v.key("moment", r.moment, {"N.m/m", "largest bending moment at failure"});
  v.maybe("tension", r.tension, {"", "largest force over tensile strength"});
  v.maybe("pull_out", r.pull_out, {"", "utilisation of the bond behind the largest force"});
  v.maybe("stripping", r.stripping, {"", "utilisation of plate and bond in front of the largest force"});
  v.maybe("bending", r.bending, {"", "largest moment over plastic moment, which axial force reduces in walls"});
  v.maybe("shear", r.shear, {"", "largest shear force over shear strength"});
  v.key("limit", r.limit, {"", "which limit is reached at failure"});
  v.maybe("moments", r.moments, {"N.m/m", "bending moment there at failure"});
  v.maybe("shears", r.shears, {"N/m", "shear force there at failure"});
  v.maybe("moments_at_start", r.moments_at_start, {"N.m/m", "bending moment there at full strength of the soil"});
  v.maybe("shears_at_start", r.shears_at_start, {"N/m", "shear force there at full strength of the soil"});
  v.maybe("on_wall", r.on_wall, {"", "wall on which the head presses"});
  v.maybe("line", r.line, {"m", "a wall from its head to its toe"});
  v.maybe("left", r.left, {"", "soil at the left of the way from head to toe"});
  v.maybe("right", r.right, {"", "soil at its right"});
  v.maybe("struts", r.struts, {"N/m", "compression of the struts at failure"});
  v.maybe("sliding", r.sliding, {"", "fraction of the interfaces that slips at failure"});
  v.maybe("deflection", r.deflection, {"", "displacement of a wall across its line at full strength of the soil"});
}

void describe(Visitor& v, ElementRun& r) {
  v.key("flow", r.flow, {"", "flow rule"});
  v.maybe("davis", r.davis, {"", "strength of Davis in place of ψ < φ"});
  v.key("psi", r.psi, {"rad", "least and greatest dilatancy angle"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("stable", r.stable, {"", "largest factor with equilibrium"});
  v.key("failed", r.failed, {"", "smallest factor without equilibrium"});
  v.maybe("meshes", r.meshes, {"", "factors by mesh, coarse to fine; the factor is extrapolated from the last two"});
  v.maybe("interval", r.interval, {"", "interval of the factor: mesh and search; left out where there is one mesh"});
  v.maybe("earthquake", r.earthquake, {"", "direction of the earthquake that governs"});
  v.maybe("verdict", r.verdict, {"", "what limit analysis proves of the factor"});
  v.maybe("supports", r.supports, {"", "forces of the supports"});
  v.key("by_displacement", r.by_displacement, {"", "factor where displacements run away"});
  v.key("trials", r.trials, {"", "trials"});
  v.key("slip_line", r.slip_line, {"m", "line along the band of shear strain"});
  v.maybe("sides", r.sides, {"", "the line of each side, where the soil moves to both"});
  v.key("seconds", r.seconds, {"s", "seconds"});
  v.key("warnings", r.warnings, {"", "warnings"});
}

void describe(Visitor& v, ElementResult& r) {
  v.maybe("error", r.error, {"", "why there is no answer"});
  v.key("warnings", r.warnings, {"", "warnings"});
  v.key("elements", r.elements, {"", "elements"});
  v.key("nodes", r.nodes, {"", "nodes"});
  v.key("unknowns", r.unknowns, {"", "unknowns"});
  v.key("size", r.size, {"m", "mean size of the elements"});
  v.key("element", r.element, {"", "kind of element"});
  v.key("runs", r.runs, {"", "strength reductions by flow rule"});
  v.key("fields_file", r.fields_file, {"", "file of the fields"});
  v.maybe("seepage", r.seepage, {"", "steady seepage on this mesh"});
  v.maybe("seconds", r.seconds, {"s", "seconds"});
}

void describe(Visitor& v, ElementFields& r) {
  v.key("flow", r.flow, {"", "flow rule"});
  v.key("displacement", r.displacement, {"m", "displacement of the nodes"});
  v.key("shear_strain", r.shear_strain, {"", "shear strain at the nodes"});
  v.key("yields", r.yields, {"", "whether an element yields"});
}

void describe(Visitor& v, ElementMesh& r) {
  v.key("nodes", r.nodes, {"m", "nodes"});
  v.key("elements", r.elements, {"", "nodes of the elements"});
  v.key("runs", r.runs, {"", "fields by flow rule"});
}

void describe(Visitor& v, ElementFile& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("summary", r.summary, {"", "FEM"});
  describe(v, r.mesh);
}

}  // namespace talus::results
