// SPDX-License-Identifier: MIT
#pragma once
// Quasi-static equilibrium of elastic-plastic soil by finite elements at small strain: quadratic triangles (6 nodes, 3
// points) and tetrahedra (10 nodes, 4 points) on linear meshes, with the consistent tangents of the material models.
// docs/theory/19-finite-elements.md has the equations.
//
// Stress is positive in tension, with the components of material/: xx, yy, zz, xy (2D, plane strain), yz, zx (3D).

#include <functional>
#include <string>
#include <vector>

#include "base/shown_units.hpp"
#include "base/vec.hpp"
#include "fem/solid/bars.hpp"
#include "fem/solid/walls.hpp"
#include "material/law.hpp"
#include "mesh/mesh.hpp"
#include "mesh/split.hpp"

namespace talus::fem {

/// Sides that a support fixes, and the fixed directions.
template <int D>
struct Support {
  std::string name;
  std::vector<std::array<int, D>> sides;  ///< given by nodes of the linear mesh
  std::array<bool, D> fixed{};            ///< per axis; ignored with `along_normal`
  bool along_normal = false;              ///< fixes the displacement normal to the side, whatever its direction
};

/// A traction on sides, given at their corners and linear between them.
template <int D>
struct SurfaceLoad {
  std::string name;
  std::vector<std::array<int, D>> sides;
  std::vector<std::array<Vec<D>, D>> traction;  ///< per side and corner [Pa]
};

/// Elastic deformation of a spring or a joint of a bar or wall in a state, which may be that of another mesh.
struct KnownSpring {
  int bar = 0;       ///< or wall, counted after the bars
  int kind = 0;      ///< SpringKind; −1 and −2: joints at the left and right, −3: sections of a wall
  double place = 0;  ///< distance from the head [m]
  std::array<double, 2> elastic{};
};

/// The model except for the strength, which each trial divides.
template <int D>
struct SolidModel {
  const mesh::Mesh<D>* mesh = nullptr;  ///< finished; elements of empty_region take no part
  /// Returns the law of a region with its strength divided by a factor; called for every trial.
  std::function<material::Law(int region, double factor)> make_law;
  std::vector<double> unit_weight;   ///< per element, with its pore water [N/m³]
  Vec<D> direction{};                ///< of the body force per unit weight: gravity and earthquake [-]
  std::vector<Support<D>> supports;  ///< several on one side fix the directions of all of them
  std::vector<SurfaceLoad<D>> loads;
  std::vector<Bar> bars;    ///< plane strain only
  std::vector<Wall> walls;  ///< plane strain only
  /// Nonlocal length of laws that soften [m]; 0: each point softens by its own plastic strain.
  double softening_length = 0;
  /// χ p at the corners of each element, positive in tension [Pa]; empty: dry.
  std::vector<std::array<double, D + 1>> pore_stress;
  /// S_w per element, for laws that depend on it; empty: 1.
  std::vector<double> saturation;
  /// Initial effective stress per element; empty: zero.
  std::vector<std::array<double, 6>> initial_stress;
  /// The same per integration point, three (in 3D four) for each element of the linear mesh; replaces `initial_stress`.
  std::vector<std::array<double, 6>> point_stress;
  /// Deformations of bars and walls that belong to these stresses; empty: they begin without force.
  std::vector<KnownSpring> known_springs;
  /// Writes the initial state variables of a law at a point of a region; empty: zeros.
  std::function<void(int region, const Vec<D>& x, double* state)> set_state;
  ShownUnits units{};  ///< units of messages
};

struct SolidOptions {
  double force_tolerance = 1e-4;         ///< ‖f_ext - f_int‖ over ‖f_ext‖ at the free degrees of freedom [-]
  double displacement_tolerance = 1e-4;  ///< remaining motion over that of the step (T19.7) [-]; both must hold
  int most_iterations = 400;             ///< linear systems in a load step or trial
  int load_steps = 4;                    ///< of gravity and loads; halved where one does not converge
  int most_halvings = 5;
  double runaway = 50;  ///< displacement, in elastic displacements, at which a step has failed [-]
  int threads = 0;      ///< of the assembly; 0: all of the machine
  /// Remaining fall of any strength, over that from peak to residual, at which soil that softens is in equilibrium [-];
  /// and the largest number of times that strengths are lowered in a load step or trial.
  double softening_tolerance = 1e-3;
  int most_softenings = 400;
};

/// A state of equilibrium, or the last one reached.
template <int D>
struct SolidState {
  std::vector<Vec<D>> displacement;           ///< per node of the quadratic mesh [m]
  std::vector<std::array<double, 6>> stress;  ///< effective, per integration point, element by element [Pa]
  std::vector<double> state;                  ///< state variables; per point the largest number of any law
  std::vector<std::array<double, 6>> strain;  ///< total, per integration point [-]; shear components are γ
  std::vector<char> yields;                   ///< per integration point: has yielded since the start, or in this trial
  /// Elastic deformation of each spring of bars and walls (T19.10), then two of each joint (T19.15).
  std::vector<double> bars;
};

template <int D>
struct SolidResult {
  SolidState<D> at;
  bool converged = false;
  int iterations = 0, factorisations = 0, load_steps = 0;
  double force_residual = 0;         ///< [-]
  double displacement_residual = 0;  ///< [-]
  double largest_displacement = 0;   ///< [m]
  bool flows = false;                ///< not converged because the soil flows at a steady rate, or has moved too far
};

/// One trial of the strength reduction. It starts from the equilibrium at full strength, whatever the order of trials.
struct ReductionTrial {
  double factor = 0;
  bool converged = false;
  bool flows = false;  ///< failed by flow (T19.8); false in a failed trial: the iterations ran out
  int iterations = 0;  ///< number of linear systems
  double force_residual = 0, displacement_residual = 0;
  double displacement = 0;  ///< largest since the equilibrium at full strength [m]
  double seconds = 0;
  int softenings = 0;  ///< number of times that strengths were lowered
};

struct ReductionOptions {
  double from = 1.0, to = 2.0;           ///< first bracket; widened as necessary
  double resolution = 0.005;             ///< width of the last bracket [-]
  double smallest = 0.05, largest = 20;  ///< range of the factors
  double displacement_limit = 1;         ///< of the criterion of displacement, in elastic displacements [-]
  SolidOptions solid;
};

/// The factor of safety by both criteria.
template <int D>
struct ReductionResult {
  double stable = 0;                   ///< largest factor with equilibrium
  double failed = 0;                   ///< smallest factor without equilibrium
  double flowing = 0;                  ///< smallest factor that failed by flow (T19.8), not by iterations; 0: none
  double factor = 0;                   ///< mean of `stable` and `failed`: the criterion of non-convergence
  double by_displacement = 0;          ///< where the displacement exceeds `displacement_limit`; 0: undetermined
  double base_factor = 1;              ///< factor of at_full_strength: 1, or less if there is no equilibrium at 1
  double elastic_displacement = 0;     ///< u_el, largest of the elastic soil under all loads [m]
  std::vector<ReductionTrial> trials;  ///< in the order of the factors
  SolidState<D> at_full_strength;
  SolidState<D> at_failure;  ///< of the trial `failed`; displacements and strains since full strength
  SolidState<D> mechanism;   ///< of the same trial: displacements and strains of its last creep step alone
  int iterations = 0, factorisations = 0;
  double seconds = 0;
  int unknowns = 0;
};

/// The quadratic mesh on a linear one: corner nodes keep their numbers, mid-side nodes follow.
template <int D>
struct QuadraticMesh {
  static constexpr int nodes_per_element = D == 2 ? 6 : 10;
  std::vector<Vec<D>> nodes;                                 ///< [m]
  std::vector<std::array<int, nodes_per_element>> elements;  ///< elements with soil only
  std::vector<int> linear_element;                           ///< index of each element in the linear mesh
  std::vector<Vec<D>> points;                                ///< integration points, element by element [m]
  std::vector<double> weights;                               ///< their volumes [m³; m² per metre]
  std::vector<int> original;  ///< per node, the node that it doubles at a wall, or itself; empty without walls

  int find_original(int node) const { return original.empty() ? node : original[static_cast<std::size_t>(node)]; }
};

/// Edges of the linear mesh along which walls separate the soil.
using mesh::Cuts;

/// Makes the quadratic mesh. Nodes on cuts are doubled, the doubles come last; the ends of a cut inside the soil remain
/// single.
template <int D>
QuadraticMesh<D> make_quadratic(const mesh::Mesh<D>& mesh, const Cuts& cuts = {});

/// Lists the edges of all walls.
template <int D>
Cuts list_cuts(const SolidModel<D>& model);

/// Computes the equilibrium under gravity and loads with strengths divided by `factor`, from `start` (nullptr: from the
/// initial state).
template <int D>
SolidResult<D> find_equilibrium(const SolidModel<D>& model, const SolidOptions& options, double factor = 1,
                                const SolidState<D>* start = nullptr);

/// Receives every trial with its last state, whose displacements and strains are those since full strength.
template <int D>
using ReductionReport = std::function<void(const ReductionTrial&, const SolidState<D>&)>;

/// Reduces the strength by bracketing. Throws Error (wrong_input) if there is no equilibrium at any factor, or if an
/// element is inverted, which the message names.
template <int D>
ReductionResult<D> reduce_strength(const SolidModel<D>& model, const ReductionOptions& options,
                                   const ReductionReport<D>& report = {});

/// Returns true if there is equilibrium with the strengths divided by `factor`. Throws as reduce_strength().
template <int D>
bool is_stable(const SolidModel<D>& model, const ReductionOptions& options, double factor);

/// Returns the forces of each bar, and then of each wall, in a state at a factor.
std::vector<BarForces> compute_bar_forces(const SolidModel<2>& model, const SolidState<2>& state, double factor = 1);

/// Lists the deformations of all springs and joints in a state, for SolidModel::known_springs.
std::vector<KnownSpring> list_known_springs(const SolidModel<2>& model, const SolidState<2>& state);

/// A slip surface as a polyline from crest to toe: the ridge of the shear strain between the moving mass and the rest.
struct SlipLine {
  int direction = 1;                          ///< +1: the mass moves towards larger x
  std::vector<std::array<double, 2>> points;  ///< [m]
};

/// Returns the slip surface of the soil that moves fastest and, if the soil moves to both sides (mesh::find_divide()),
/// that of the other side after it; empty if there is none. `motion`: displacements and strains, preferably those of
/// ReductionResult::mechanism.
std::vector<SlipLine> find_slip_lines(const SolidModel<2>& model, const QuadraticMesh<2>& mesh,
                                      const SolidState<2>& motion);

}  // namespace talus::fem
