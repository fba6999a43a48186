// SPDX-License-Identifier: MIT
#pragma once
// Quasi-static equilibrium of elastic-plastic soil by finite elements at small strain: quadratic triangles (6 nodes, 3
// points) and tetrahedra (10 nodes, 4 points) on the project's linear meshes, Newton's method with the tangents of the
// material models themselves. docs/theory/19-finite-elements.md has the equations.
//
// Stress is positive in tension, components as in material/: xx, yy, zz, xy (2D, plane strain), yz, zx (3D).

#include <functional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "material/law.hpp"
#include "mesh/mesh.hpp"

namespace talus::fem {

/// Nodes of the sides that are held, and in which directions.
template <int D>
struct Support {
  std::string name;
  std::vector<std::array<int, D>> sides;  ///< by the nodes of the linear mesh
  std::array<bool, D> fixed{};            ///< per axis; with `along_normal` ignored
  bool along_normal = false;              ///< no motion across the side, whatever its direction
};

/// A traction on sides, given at their corners and linear between them.
template <int D>
struct SurfaceLoad {
  std::string name;
  std::vector<std::array<int, D>> sides;
  std::vector<std::array<Vec<D>, D>> traction;  ///< per side and corner [Pa]
};

/// Everything about the soil but its strength, which a trial divides.
template <int D>
struct SolidModel {
  const mesh::Mesh<D>* mesh = nullptr;  ///< finished; elements of empty_region take no part
  /// The law of a region with its strength divided by a factor; called for every trial.
  std::function<material::Law(int region, double factor)> make_law;
  std::vector<double> unit_weight;   ///< per element, with its water [N/m³]
  Vec<D> direction{};                ///< of the body force per unit weight: gravity, and what an earthquake adds [-]
  std::vector<Support<D>> supports;  ///< later ones add to earlier ones
  std::vector<SurfaceLoad<D>> loads;
  /// χ p at the corners of each element, positive in tension [Pa]; empty: dry.
  std::vector<std::array<double, D + 1>> pore_stress;
  /// S_w by element for laws that ask; empty: 1.
  std::vector<double> saturation;
  /// Effective stress that an element starts from; empty: none.
  std::vector<std::array<double, 6>> initial_stress;
  /// Writes the state variables that a law starts from at a place of a region; empty: zeros.
  std::function<void(int region, const Vec<D>& x, double* state)> set_state;
};

struct SolidOptions {
  double force_tolerance = 1e-4;         ///< ‖f_ext - f_int‖ over ‖f_ext‖ at the free freedoms [-]
  double displacement_tolerance = 1e-4;  ///< motion still to come over all displacement of the step [-]; both must hold
  int most_iterations = 400;             ///< linear systems in a load step or trial
  int load_steps = 4;                    ///< that gravity and loads come on in; halved where one does not converge
  int most_halvings = 5;
  double runaway = 50;  ///< a step fails that moves the soil by so many elastic displacements [-]
  int threads = 0;      ///< of the assembly; 0: those of the machine
};

/// A state of equilibrium, or the last one tried.
template <int D>
struct SolidState {
  std::vector<Vec<D>> displacement;           ///< per node of the quadratic mesh [m]
  std::vector<std::array<double, 6>> stress;  ///< effective, per integration point, element by element [Pa]
  std::vector<double> state;                  ///< state variables, max of the laws' sizes per point
  std::vector<std::array<double, 6>> strain;  ///< total, per integration point [-]; shear components are γ
  std::vector<char> yields;  ///< per integration point: has been plastic since the start, or in this trial
};

template <int D>
struct SolidResult {
  SolidState<D> at;
  bool converged = false;
  int iterations = 0, factorisations = 0, load_steps = 0;
  double force_residual = 0;         ///< [-]
  double displacement_residual = 0;  ///< [-]
  double largest_displacement = 0;   ///< [m]
  bool flows = false;                ///< not converged because the soil moves on at a steady rate, or too far
};

/// One trial of the strength reduction. It starts from the equilibrium at full strength, whatever was tried before.
struct ReductionTrial {
  double factor = 0;
  bool converged = false;
  bool flows = false;  ///< failed because the soil moves on; false in a failed trial: the iterations ran out
  int iterations = 0;  ///< linear systems
  double force_residual = 0, displacement_residual = 0;
  double displacement = 0;  ///< largest, since the equilibrium at full strength [m]
  double seconds = 0;
};

struct ReductionOptions {
  double from = 1.0, to = 2.0;           ///< first bracket; widened as needed
  double resolution = 0.005;             ///< width of the last bracket [-]
  double smallest = 0.05, largest = 20;  ///< where widening ends
  double displacement_limit = 1;         ///< of the second criterion, in elastic displacements [-]
  SolidOptions solid;
};

/// The factor of safety by both criteria.
template <int D>
struct ReductionResult {
  double stable = 0;           ///< largest factor with equilibrium
  double failed = 0;           ///< smallest factor without
  double flowing = 0;          ///< smallest factor whose trial failed by flow (T19.8), not by its iterations; 0: none
  double factor = 0;           ///< their mean: the criterion of non-convergence
  double by_displacement = 0;  ///< where the displacement since full strength passes `displacement_limit`; 0: not told
  double base_factor = 1;      ///< of at_full_strength: 1, or less where the soil does not stand at 1
  double elastic_displacement = 0;     ///< largest of the elastic soil under all loads: the scale of the criterion [m]
  std::vector<ReductionTrial> trials;  ///< in the order of the factors
  SolidState<D> at_full_strength;
  SolidState<D> at_failure;  ///< of the trial `failed`, displacements and strains since full strength
  SolidState<D> mechanism;   ///< its last motion: displacements and strains of one step, nothing else
  int iterations = 0, factorisations = 0;
  double seconds = 0;
  int unknowns = 0;
};

/// The quadratic mesh on a linear one: corner nodes keep their numbers, mid-side nodes follow.
template <int D>
struct QuadraticMesh {
  static constexpr int nodes_per_element = D == 2 ? 6 : 10;
  std::vector<Vec<D>> nodes;                                 ///< [m]
  std::vector<std::array<int, nodes_per_element>> elements;  ///< of soil only
  std::vector<int> linear_element;                           ///< its number in the linear mesh
  std::vector<Vec<D>> points;                                ///< integration points, element by element [m]
  std::vector<double> weights;                               ///< their volumes [m³; m² per metre]
};
template <int D>
QuadraticMesh<D> make_quadratic(const mesh::Mesh<D>& mesh);

/// Equilibrium under gravity and loads with strength divided by `factor`, from `start` (empty: from nothing).
template <int D>
SolidResult<D> find_equilibrium(const SolidModel<D>& model, const SolidOptions& options, double factor = 1,
                                const SolidState<D>* start = nullptr);

/// Strength reduction by bracketing. Throws Error (wrong_input) when there is no equilibrium at any factor, or an
/// element is inverted; the sentence names it.
template <int D>
ReductionResult<D> reduce_strength(const SolidModel<D>& model, const ReductionOptions& options,
                                   const std::function<void(const ReductionTrial&)>& report = {});

/// Returns true where there is equilibrium with the strength divided by `factor`. Throws as reduce_strength().
template <int D>
bool is_stable(const SolidModel<D>& model, const ReductionOptions& options, double factor);

/// A slip surface as a polyline from crest to toe: the ridge of the shear strain between the moving mass and the rest.
struct SlipLine {
  int direction = 1;                          ///< +1: its soil moves towards larger x
  std::vector<std::array<double, 2>> points;  ///< [m]
};

/// The slip surface of the soil that moves fastest; where the soil moves to both sides (mesh::find_divide()), behind it
/// that of the other side. `motion`: displacements and strains, best those of ReductionResult::mechanism. Empty where
/// there is none.
std::vector<SlipLine> find_slip_lines(const SolidModel<2>& model, const QuadraticMesh<2>& mesh,
                                      const SolidState<2>& motion);

}  // namespace talus::fem
