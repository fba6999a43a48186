// SPDX-License-Identifier: MIT
#include "results/bounds.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, Referee& r) {
  v.maybe("why_not", r.why_not, {"", "why limit analysis cannot judge the factors of limit equilibrium"});
  v.key("lower", r.lower, {"", "lower bound by limit analysis, for the soil of LEM"});
  v.key("upper", r.upper, {"", "upper bound by limit analysis, for the soil of LEM"});
  v.key("no_lower", r.no_lower, {"", "why there is no lower bound"});
  v.key("no_upper", r.no_upper, {"", "why there is no upper bound"});
  v.maybe("upper_only", r.upper_only, {"", "why factors below the lower bound are not refused"});
  v.key("triangles", r.triangles, {"", "triangles of the finest mesh"});
  v.key("programs", r.programs, {"", "cone programs"});
  v.key("seconds", r.seconds, {"s", "seconds"});
}

void describe(Visitor& v, SideLine& r) {
  v.key("direction", r.direction, {"", "1: towards larger x, -1: towards smaller x"});
  v.key("points", r.points, {"m", "its points"});
}

void describe(Visitor& v, EarthquakeSide& r) {
  v.key("direction", r.direction,
        {"", "direction of the earthquake that governs: -1 towards smaller x, 1 towards larger x"});
  v.key("other_stable", r.other_stable,
        {"",
         "factor at which the slope is stable in the other direction: with equilibrium on the same mesh, or by the "
         "lower bound theorem"});
}

void describe(Visitor& v, BoundsMesh& r) {
  v.key("triangles", r.triangles, {"", "triangles"});
  v.key("lower", r.lower, {"", "largest lower bound up to this mesh"});
  v.key("upper", r.upper, {"", "smallest upper bound up to this mesh"});
  v.key("programs", r.programs, {"", "cone programs"});
  v.key("iterations", r.iterations, {"", "iterations of their solver"});
  v.key("seconds", r.seconds, {"s", "seconds since the first mesh"});
}

void describe(Visitor& v, BoundsResult& r) {
  v.maybe("error", r.error, {"", "why there is no answer"});
  v.key("warnings", r.warnings, {"", "warnings"});
  v.key("lower", r.lower, {"", "lower bound of the factor of safety"});
  v.key("upper", r.upper, {"", "upper bound of the factor of safety"});
  v.key("no_lower", r.no_lower, {"", "why there is no lower bound"});
  v.key("no_upper", r.no_upper, {"", "why there is no upper bound"});
  v.key("asked_gap", r.asked_gap, {"", "width of the interval over its middle that was asked for"});
  v.key("is_davis", r.is_davis, {"", "whether it is of soil with the strength of Davis for ψ < φ"});
  v.key("takes_tension", r.takes_tension, {"", "whether soils bear no more tension than given"});
  v.key("imbalance", r.imbalance, {"", "largest imbalance of the stress field over the largest load or overburden"});
  v.key("meshes", r.meshes, {"", "nested meshes"});
  v.maybe("sides", r.sides, {"", "lines along which the mechanism slides"});
  v.maybe("earthquake", r.earthquake, {"", "direction of the earthquake that governs"});
  v.key("fields_file", r.fields_file, {"", "file of the fields"});
  v.maybe("seepage", r.seepage, {"", "steady seepage on the first mesh"});
  v.maybe("seconds", r.seconds, {"s", "seconds"});
}

void describe(Visitor& v, HoldingField& r) {
  v.key("nodes", r.nodes, {"m", "nodes"});
  v.key("triangles", r.triangles, {"", "nodes of the triangles"});
  v.key("stress", r.stress, {"Pa", "effective stress xx, yy, xy at the three corners"});
  v.maybe("pressure", r.pressure, {"Pa", "pore pressure at the three corners, not below that of the case"});
  v.key("utilisation", r.utilisation, {"", "how much of the strength is used"});
}

void describe(Visitor& v, MovingField& r) {
  v.key("nodes", r.nodes, {"m", "nodes"});
  v.key("triangles", r.triangles, {"", "nodes of the triangles: corners, then middles"});
  v.key("velocity", r.velocity, {"", "velocity of the nodes; the fastest has 1"});
  v.key("shear_rate", r.shear_rate, {"", "shear strain rate of the triangles; the largest is 1"});
}

void describe(Visitor& v, BoundsFile& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("summary", r.summary, {"", "limit analysis"});
  v.key("holds", r.holds, {"", "stresses of the lower bound"});
  v.key("moves", r.moves, {"", "velocities of the upper bound"});
}

}  // namespace talus::results
