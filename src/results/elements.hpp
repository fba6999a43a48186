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
void describe(Visitor& v, ElementTrial& r);

/// Factor of safety on one of several meshes.
struct ElementMeshFactor {
  double size = 0;  ///< mean element size, of adapted meshes weighted by the shear work (T19.17) [m]
  double factor = 0, stable = 0, failed = 0;
  std::optional<double> flowing;  ///< nullopt if all failed trials reached the iteration limit
};
void describe(Visitor& v, ElementMeshFactor& r);

/// Interval of a factor from two meshes: discretisation error, brackets of both searches, and undecided trials.
struct ElementInterval {
  double lower = 0, upper = 0;
};
void describe(Visitor& v, ElementInterval& r);

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
void describe(Visitor& v, ElementFace& r);

/// Displacement of a wall across its line at full strength of the soil.
struct ElementDeflection {
  std::vector<double> place;  ///< distance from the head [m]
  std::vector<double> value;  ///< towards the left of the way from head to toe [m]
};
void describe(Visitor& v, ElementDeflection& r);

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
void describe(Visitor& v, ElementBar& r);

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
  std::optional<std::vector<ElementMeshFactor>> meshes;  ///< coarse to fine; `factor` is extrapolated from the last two
  std::optional<EarthquakeSide> earthquake;  ///< nullopt without earthquake or if the case gives its direction
  std::optional<ElementInterval> interval;   ///< nullopt if the discretisation error is unknown, as with one mesh
  std::optional<Verdict> verdict;            ///< by bounds for the soil with ψ = φ; nullopt if none apply
  std::optional<std::vector<ElementBar>> supports;  ///< on the fine mesh; nullopt in a case without supports
};
void describe(Visitor& v, ElementRun& r);

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
void describe(Visitor& v, ElementResult& r);

struct ElementFields {
  Flow flow = Flow::as_given;
  std::vector<std::vector<double>> displacement;  ///< nodal [m]
  std::vector<double> shear_strain;               ///< nodal
  std::vector<int> yields;                        ///< by element: 1 if most of its integration points yield
};
void describe(Visitor& v, ElementFields& r);

struct ElementMesh {
  std::vector<std::vector<double>> nodes;  ///< [m]
  std::vector<std::vector<int>> elements;  ///< node numbers
  std::vector<ElementFields> runs;
};
void describe(Visitor& v, ElementMesh& r);

/// fem.json: the results that a resumed run reads instead of computing them again, and the fields for the report.
struct ElementFile {
  std::string input_hash;
  ElementResult summary;
  ElementMesh mesh;
};
void describe(Visitor& v, ElementFile& r);

}  // namespace talus::results
