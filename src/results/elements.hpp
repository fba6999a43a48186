// SPDX-License-Identifier: MIT
#pragma once
// Results of the strength reduction by FEM: factors, trials, slip line, and the fields at failure.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "results/about.hpp"
#include "results/bounds.hpp"
#include "results/water.hpp"

namespace talus::results {

enum class Flow { as_given, associated };
template <>
inline constexpr auto words<Flow> = std::array{"as_given", "associated"};

/// Strengths of Davis (1968) that replace ψ < φ, by the angles that give their share.
enum class Davis { a, b, c };
template <>
inline constexpr auto words<Davis> = std::array{"a", "b", "c"};

struct ElementTrial {
  double factor = 0;
  bool converged = false;
  int iterations = 0;
  double force_residual = 0, displacement_residual = 0;
  double displacement = 0;  ///< largest [m]
  double seconds = 0;
};
void describe(auto& v, As<ElementTrial> auto& r) {
  v.key("factor", r.factor, {"", "factor that the strength is divided by"});
  v.key("converged", r.converged, {"", "whether there is equilibrium"});
  v.key("iterations", r.iterations, {"", "iterations"});
  v.key("force_residual", r.force_residual, {"", "unbalanced force over the external force"});
  v.key("displacement_residual", r.displacement_residual, {"", "last change of the displacement over itself"});
  v.key("displacement", r.displacement, {"m", "largest displacement"});
  v.key("seconds", r.seconds, {"s", "seconds"});
}

/// Factor of safety on one of two meshes.
struct ElementMeshFactor {
  double size = 0;  ///< mean element size [m]
  double factor = 0, stable = 0, failed = 0;
  std::optional<double> flowing;  ///< nullopt if all failed trials reached the iteration limit
};
void describe(auto& v, As<ElementMeshFactor> auto& r) {
  v.key("size", r.size, {"m", "mean size of the elements"});
  v.key("factor", r.factor, {"", "factor of safety on this mesh"});
  v.key("stable", r.stable, {"", "largest factor with equilibrium"});
  v.key("failed", r.failed, {"", "smallest factor without equilibrium"});
  v.maybe("flowing", r.flowing, {"", "smallest factor at which the soil flows"});
}

/// Interval of a factor from two meshes: discretisation error, brackets of both searches, and undecided trials.
struct ElementInterval {
  double lower = 0, upper = 0;
};
void describe(auto& v, As<ElementInterval> auto& r) {
  v.key("lower", r.lower, {"", "lower end of the interval of mesh and search"});
  v.key("upper", r.upper, {"", "upper end of the interval of mesh and search"});
}

/// Limit of a support that is reached at failure.
enum class ElementBarLimit { none, tension, pull_out, stripping, bending, shear };
template <>
inline constexpr auto words<ElementBarLimit> =
    std::array{"none", "tension", "pull_out", "stripping", "bending", "shear"};

/// Stress between a wall and the soil on one of its sides at failure.
struct ElementFace {
  std::vector<double> place;          ///< distance from the head [m]
  std::vector<double> normal, shear;  ///< effective compression; shear on the wall towards its toe [Pa]
};
void describe(auto& v, As<ElementFace> auto& r) {
  v.key("place", r.place, {"m", "distances from the head"});
  v.key("normal", r.normal, {"Pa", "effective normal stress on the wall there, positive in compression"});
  v.key("shear", r.shear, {"Pa", "shear stress of the soil on the wall there, towards its toe"});
}

/// Displacement of a wall across its line at full strength of the soil.
struct ElementDeflection {
  std::vector<double> place;  ///< distance from the head [m]
  std::vector<double> value;  ///< towards the left of the way from head to toe [m]
};
void describe(auto& v, As<ElementDeflection> auto& r) {
  v.key("place", r.place, {"m", "distances from the head"});
  v.key("value", r.value, {"m", "displacement there, towards the left of the way from head to toe"});
}

/// Forces of a support along its length, per metre of slope; tension is positive.
struct ElementBar {
  std::string support;                  ///< name in the case
  std::string kind;                     ///< word of the case
  int row = 1;                          ///< from the top of the pattern
  Point head{}, end{};                  ///< [m]
  std::vector<double> place;            ///< distance from the head [m]
  std::vector<double> force, at_start;  ///< axial at failure, and at full strength [N/m]
  double largest = 0;                   ///< of `force` [N/m]
  double plate = 0;                     ///< force of plate, facing or connection at failure [N/m]
  double moment = 0;                    ///< largest at failure [N m/m]; piles
  /// Force over its limit at failure: tensile strength; bond behind the largest force; bond and plate in front of it;
  /// plastic moment; shear strength. nullopt: there is no such limit.
  std::optional<double> tension, pull_out, stripping, bending, shear;
  ElementBarLimit limit = ElementBarLimit::none;
  // Piles and walls, at `place`:
  std::optional<std::vector<double>> moments, shears;                    ///< at failure [N m/m], [N/m]
  std::optional<std::vector<double>> moments_at_start, shears_at_start;  ///< at full strength of the soil
  std::optional<std::string> on_wall;  ///< wall on which the head presses; nullopt: it presses on soil
  // Walls alone:
  std::optional<std::vector<Point>> line;     ///< from head to toe [m]
  std::optional<ElementFace> left, right;     ///< soil beside the way from head to toe; nullopt: none
  std::optional<std::vector<double>> struts;  ///< compression at failure, from the head [N/m]
  std::optional<double> sliding;              ///< fraction of the interfaces that slips at failure
  std::optional<ElementDeflection> deflection;
};
void describe(auto& v, As<ElementBar> auto& r) {
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

/// Strength reduction with one flow rule.
struct ElementRun {
  Flow flow = Flow::as_given;
  std::optional<Davis> davis;   ///< replaces ψ < φ; nullopt: the flow rule is as it says
  std::array<double, 2> psi{};  ///< smallest and largest ψ [rad]
  double factor = 0, stable = 0, failed = 0;
  std::optional<double> by_displacement;  ///< factor at the sharp rise of displacement
  std::vector<ElementTrial> trials;
  std::vector<Point> slip_line;                ///< of the fastest soil [m]; empty if there is no shear band
  std::optional<std::vector<SideLine>> sides;  ///< smaller x first; nullopt if the soil moves in one direction
  double seconds = 0;
  std::vector<std::string> warnings;
  std::optional<std::vector<ElementMeshFactor>> meshes;  ///< coarse to fine; if set, `factor` is extrapolated from them
  std::optional<EarthquakeSide> earthquake;  ///< nullopt without earthquake or if the case gives its direction
  std::optional<ElementInterval> interval;   ///< nullopt if the discretisation error is unknown, as with one mesh
  std::optional<Verdict> verdict;            ///< by bounds for the soil with ψ = φ; nullopt if none apply
  std::optional<std::vector<ElementBar>> supports;  ///< on the fine mesh; nullopt in a case without supports
};
void describe(auto& v, As<ElementRun> auto& r) {
  v.key("flow", r.flow, {"", "flow rule"});
  v.maybe("davis", r.davis, {"", "strength of Davis in place of ψ < φ"});
  v.key("psi", r.psi, {"rad", "least and greatest dilatancy angle"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("stable", r.stable, {"", "largest factor with equilibrium"});
  v.key("failed", r.failed, {"", "smallest factor without equilibrium"});
  v.maybe("meshes", r.meshes, {"", "factors on two meshes, from which the factor is extrapolated"});
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

/// Returns "ψ = φ", "ψ as given" or "Davis B".
inline std::string name_flow(const ElementRun& run) {
  if (run.davis) return std::string("Davis ") + "ABC"[static_cast<int>(*run.davis)];
  return run.flow == Flow::associated ? "ψ = φ" : "ψ as given";
}

/// "fem" of summary.json.
struct ElementResult {
  std::optional<std::string> error;  ///< why FEM gave no result
  std::vector<std::string> warnings;
  std::size_t elements = 0, nodes = 0;
  int unknowns = 0;
  double size = 0;      ///< mean element size [m]
  std::string element;  ///< such as "T6"
  std::vector<ElementRun> runs;
  std::string fields_file;
  std::optional<Seepage> seepage;
  std::optional<double> seconds;
};
void describe(auto& v, As<ElementResult> auto& r) {
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

struct ElementFields {
  Flow flow = Flow::as_given;
  std::vector<std::vector<double>> displacement;  ///< nodal [m]
  std::vector<double> shear_strain;               ///< nodal
  std::vector<int> yields;                        ///< by element: 1 if most of its integration points yield
};
void describe(auto& v, As<ElementFields> auto& r) {
  v.key("flow", r.flow, {"", "flow rule"});
  v.key("displacement", r.displacement, {"m", "displacement of the nodes"});
  v.key("shear_strain", r.shear_strain, {"", "shear strain at the nodes"});
  v.key("yields", r.yields, {"", "whether an element yields"});
}

struct ElementMesh {
  std::vector<std::vector<double>> nodes;  ///< [m]
  std::vector<std::vector<int>> elements;  ///< node numbers
  std::vector<ElementFields> runs;
};
void describe(auto& v, As<ElementMesh> auto& r) {
  v.key("nodes", r.nodes, {"m", "nodes"});
  v.key("elements", r.elements, {"", "nodes of the elements"});
  v.key("runs", r.runs, {"", "fields by flow rule"});
}

/// fem.json: the results that a resumed run reads instead of computing them again, and the fields for the report.
struct ElementFile {
  std::string input_hash;
  ElementResult summary;
  ElementMesh mesh;
};
void describe(auto& v, As<ElementFile> auto& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("summary", r.summary, {"", "FEM"});
  describe(v, r.mesh);
}

}  // namespace talus::results
