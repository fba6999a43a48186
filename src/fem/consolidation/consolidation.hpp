// SPDX-License-Identifier: MIT
#pragma once
// Consolidation of elastic-plastic soil after Biot (1941): equilibrium on quadratic triangles coupled with the flow of
// pore water on their corners (Taylor–Hood elements), saturated or unsaturated, over one stage of construction.
// docs/theory/26-consolidation.md has the equations.
//
// Stress and pore pressure are positive in tension, as in solid/ and seepage/; heads are levels [m].

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "fem/seepage/seepage.hpp"
#include "fem/solid/solid.hpp"

namespace talus::fem {

/// Vertical drains in an element as distributed line sinks, after Hansbo (1981).
struct DrainSink {
  double rate = 0;  ///< 8 k_h / (μ D_e²): water drawn per volume of soil and head above that in the drain [1/(m s)]
  double head = 0;  ///< in the drain [m]
};

/// How pore water moves during a stage.
enum class StageDrainage {
  consolidating,  ///< it flows and bears load
  undrained,      ///< none flows; the load compresses water and skeleton
  drained         ///< pressures follow from `steady_head`, which is reached at the end of the stage
};

/// The soil of one stage.
template <int D>
struct ConsolidationModel {
  const SolidModel<D>* solid = nullptr;   ///< its pore_stress is constant, and added to that of the flow
  const SeepageModel<D>* flow = nullptr;  ///< on a mesh with the same elements, of which some may be empty
  /// χ s [Pa] of a region of the flow at a suction s > 0, and its derivative by s; empty: S_w s.
  std::function<material::CurvePoint<double>(int region, double suction)> suction_stress{};
  std::vector<DrainSink> drains{};  ///< by element of the flow; empty: none
  StageDrainage drainage = StageDrainage::consolidating;
  std::vector<double> steady_head{};  ///< per node [m], for drained stages
  double strength_factor = 1;         ///< strength reduction factor of the soils
  bool is_jacking = false;            ///< bars and struts with a prestress keep it during the stage
};

template <int D>
struct ConsolidationState {
  SolidState<D> solid;
  std::vector<double> head;  ///< per node of the linear mesh [m]; the elevation at nodes without wet soil
};

struct ConsolidationSchedule {
  double start = 0;               ///< [s]
  double duration = 0;            ///< [s]; 0: the change acts at once, in `load_steps`
  std::vector<double> outputs{};  ///< increasing times within the stage [s]; its end is always one
  double tolerance = 2e-3;        ///< error of a step, over the largest change of pore pressure so far (T26.6) [-]
  double first_step = 0;          ///< [s]; 0: a thousandth of the duration
  double largest_step = std::numeric_limits<double>::infinity();  ///< [s]
  int load_steps = 4;                                             ///< of a change at once
  int most_halvings = 12;                                         ///< of a step that does not converge
  int most_iterations = 25;                                       ///< of a step
  double force_tolerance = 1e-6;                                  ///< out-of-balance force over the loads [-]
  int threads = 0;                                                ///< 0: all of the machine
  /// Largest displacement of a node since the start of the stage [m]; a step beyond it does not count as equilibrium:
  /// the equations are those of small displacements.
  double most_displacement = std::numeric_limits<double>::infinity();
};

/// One accepted step.
struct ConsolidationStep {
  double time = 0;      ///< at its end [s]
  double length = 0;    ///< [s]
  double error = 0;     ///< estimate (T26.6), over the largest change of pore pressure so far [-]
  double residual = 0;  ///< out-of-balance force over the loads [-]
  int iterations = 0;   ///< number of linear systems
  int yielding = 0;     ///< integration points
};

template <int D>
struct ConsolidationOutput {
  double time = 0;  ///< [s]
  ConsolidationState<D> at;
};

template <int D>
struct ConsolidationResult {
  std::vector<ConsolidationOutput<D>> outputs;  ///< the last one: the end, or where the stage stopped
  std::vector<ConsolidationStep> steps;
  bool converged = false;  ///< the end is reached in equilibrium
  double reached = 0;      ///< fraction of the change of the stage that is in equilibrium [-]
  int rejected = 0, factorisations = 0, unknowns = 0;
  double start_imbalance = 0;  ///< out-of-balance force that the change makes, over the loads [-]
};

/// Receives each accepted step with the state at its end: that of the solid, and heads per node [m].
template <int D>
using StepReport =
    std::function<void(const ConsolidationStep&, const SolidState<D>& solid, const std::vector<double>& head)>;

/// Computes one stage. The out-of-balance force at its start, of weights, loads, removed and placed soil, is applied
/// linearly over its duration, so that none is dropped. `start` is a state of this model's meshes, see carry_state().
/// `report` is called after each step. Throws Error (wrong_input) as SolidSystem, SeepageSystem and for a model whose
/// meshes differ.
template <int D>
ConsolidationResult<D> run_stage(const ConsolidationModel<D>& model, const ConsolidationState<D>& start,
                                 const ConsolidationSchedule& schedule, const StepReport<D>& report = {});

/// Returns the state at the start of a model without history: stresses of the solid model, heads per node [m].
template <int D>
ConsolidationState<D> make_first_state(const ConsolidationModel<D>& model, std::vector<double> head);

/// Carries a state to the model of another stage on the same linear mesh: soil that is in both keeps stress, state and
/// displacement; placed soil is free of stress and has not moved. Heads keep their values where the old stage had
/// water; elsewhere `placed_head` gives them [m].
template <int D>
ConsolidationState<D> carry_state(const ConsolidationModel<D>& old_model, const ConsolidationState<D>& state,
                                  const ConsolidationModel<D>& model, const std::vector<double>& placed_head);

/// Returns χp at the corners of each element of the solid mesh [Pa], positive in tension, from heads per node; zero
/// where no water acts.
template <int D>
std::vector<std::array<double, D + 1>> find_corner_stress(const ConsolidationModel<D>& model,
                                                          const std::vector<double>& head);

/// Heads of steady flow, from which excess pressures are counted and to which drained stages lead.
template <int D>
struct SteadyHeads {
  std::vector<double> head;  ///< per node [m]
  bool is_given = true;      ///< the conditions of every body of soil have one steady state
  bool is_lowered = false;   ///< heads that were kept fell to a face at which water leaves
};

/// Returns the heads of steady flow with the boundary values at `time` [s]. A body of soil to which no condition gives
/// a head, and which no water enters, keeps `kept` (heads per node [m]), but none above its lowest face at which water
/// would leave (T26.8). `guess` (heads per node) may be empty. Throws as solve_steady_seepage().
template <int D>
SteadyHeads<D> find_steady_heads(const SeepageModel<D>& flow, const std::vector<double>& kept, double time,
                                 const std::vector<double>& guess = {});

/// Returns the excess pore pressure [Pa], compression positive as both arguments: the difference from that of steady
/// flow. Suction that is less than the steady one is no excess.
double find_excess(double pressure, double steady);

/// Excess pore pressures, compression positive [Pa].
struct ExcessRange {
  double least = 0, largest = 0;  ///< at most and at least zero
};

/// Returns the range of the excess pore pressures over `steady`; both are heads per node [m].
template <int D>
ExcessRange find_excess_range(const ConsolidationModel<D>& model, const std::vector<double>& head,
                              const std::vector<double>& steady);

}  // namespace talus::fem
