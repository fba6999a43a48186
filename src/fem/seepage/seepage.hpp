// SPDX-License-Identifier: MIT
#pragma once
// Flow of water through saturated and unsaturated soil that does not move: Richards' equation on the project's linear
// triangles and tetrahedra, steady or in time. docs/theory/13-seepage.md has the equations, decision 0016 the reasons.
//
// Unknown: the total head H = y - p/γ_w [m] at the nodes; pore pressure p, positive in tension, is the suction.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "fem/seepage/hydraulic_boundary.hpp"
#include "material/water/conductivity.hpp"
#include "mesh/mesh.hpp"

namespace talus::fem {

template <int D>
struct HydraulicSoil {
  std::string name;
  double porosity = 0;                 ///< n [-]
  std::array<double, D> conductivity;  ///< saturated, along the axes [m/s]
  material::Retention retention = material::ConstantSaturation{};
  material::Conductivity relative = material::ConstantConductivity{};
  double water_modulus = std::numeric_limits<double>::infinity();  ///< K_w [Pa]
  double skeleton_compressibility = 0;                             ///< 1/E_c, where saturated [1/Pa]
};

template <int D>
struct SeepageModel {
  const mesh::Mesh<D>* mesh = nullptr;  ///< finished; elements of empty_region take no part
  std::vector<HydraulicSoil<D>> soils;  ///< by element_region
  std::vector<HydraulicBoundary<D>> boundaries;
  double unit_weight = 9810;      ///< γ_w [N/m³]
  int up = 1;                     ///< the axis against gravity
  std::vector<RootSink> sinks{};  ///< water that plants draw, in steady flow too
  /// Weight of the pools over every node at a time [Pa]; what changes of it compresses saturated soil. Empty: none
  /// does.
  std::function<std::vector<double>(double time)> pool_weight{};
};

struct SeepageOptions {
  double tolerance = 1e-11;             ///< imbalance at the nodes, as a share of the flow [-]
  double smallest_conductivity = 1e-9;  ///< k_r is not taken below this [-]; keeps dry soil solvable
  int most_iterations = 60;             ///< of Newton between changes of face nodes; then a smaller step is tried
};

/// What a node of a face does.
enum class FaceState : char {
  none,  ///< no node of a face
  open,  ///< unsaturated; all that is offered enters
  wet,   ///< zero pressure: water leaves, or not all of the rain enters
  dry    ///< at the suction limit: less than the potential evaporates
};

/// Water through one boundary [m³/s] (per metre of thickness in 2D); for a time range [m³].
struct Discharge {
  std::string name;
  double inflow = 0;
  double outflow = 0;
  double runoff = 0;    ///< rain that did not enter, here or where it ran to
  double standing = 0;  ///< growth of the water that stands on the ground
};

/// Where a face is wet, in 2D and 3D.
template <int D>
struct FaceExtent {
  std::string name;
  std::array<double, D> highest;  ///< the highest wet node [m]: the exit point of the water table
  std::array<double, D> lowest;   ///< the lowest wet node [m]
};

template <int D>
struct SeepageResult {
  double time = 0;                              ///< [s]; 0 when steady
  std::vector<double> head;                     ///< per node [m]; the elevation where no soil is
  std::vector<double> pressure;                 ///< per node, positive in tension [Pa]
  std::vector<double> saturation;               ///< per element, its mean [-]
  std::vector<std::array<double, D>> velocity;  ///< per element, Darcy's, of the whole area [m/s]
  std::vector<FaceState> face;                  ///< per node
  std::vector<Discharge> discharges;            ///< per boundary, from the consistent nodal fluxes
  double inflow = 0, outflow = 0;               ///< their sums [m³/s]
  std::vector<Uptake> uptakes;                  ///< per sink
  double transpired = 0;                        ///< their sum [m³/s]
  double storage_rate = 0;                      ///< growth of the stored water [m³/s]
  double balance_error = 0;                     ///< inflow - outflow - transpired - storage_rate [m³/s]
  std::vector<FaceExtent<D>> exits;             ///< faces that are wet somewhere
  std::vector<std::vector<std::array<double, D>>> water_table;  ///< 2D: polylines p = 0 [m]; 3D: empty
  int undecided = 0;   ///< face nodes that fit neither state exactly, on meshes far coarser than the capillary fringe
  int iterations = 0;  ///< linear systems solved
};

/// The steady state, boundary values taken at `time` [s]. `guess` (heads per node) may be empty.
/// Throws Error (wrong_input) when the model has a fault, Error (unstable) when no solution is found.
template <int D>
SeepageResult<D> solve_steady_seepage(const SeepageModel<D>& model, const SeepageOptions& options = {},
                                      const std::vector<double>& guess = {}, double time = 0);

struct SeepageSchedule {
  double start = 0;                                               ///< [s]
  std::vector<double> outputs;                                    ///< increasing times [s]; the last one is the end
  double first_step = 0;                                          ///< [s]; 0: a thousandth of the first output's time
  double smallest_step = 0;                                       ///< [s]; 0: 1e-9 of the whole time
  double largest_step = std::numeric_limits<double>::infinity();  ///< [s]
  double head_tolerance = 1e-3;  ///< error of a step by its difference from a prediction [m]
};

template <int D>
struct SeepageHistory {
  std::vector<SeepageResult<D>> states;         ///< at the outputs
  std::vector<std::vector<Discharge>> volumes;  ///< through each boundary from the start to each output [m³]
  std::vector<std::vector<Uptake>> uptakes;     ///< drawn by each sink from the start to each output [m³]
  std::vector<double> stored;                   ///< growth of the stored water since the start [m³]
  double largest_error = 0;                     ///< of a step, by its prediction; the first after a corner has none [m]
  int steps = 0, rejected = 0, iterations = 0;
};

/// Flow in time from the heads `initial` (per node) on: implicit Euler in the mixed form, which conserves water, with
/// steps that follow the error. Same errors.
template <int D>
SeepageHistory<D> solve_transient_seepage(const SeepageModel<D>& model, const std::vector<double>& initial,
                                          const SeepageSchedule& schedule, const SeepageOptions& options = {});

/// Water in the soil [m³] at the heads `head`.
template <int D>
double find_stored_water(const SeepageModel<D>& model, const std::vector<double>& head);

// Faults of a seepage model, as sentences for the user.

/// Throws Error (wrong_input) with the first fault of the soils and boundaries.
template <int D>
void check_model(const SeepageModel<D>& model);

/// Throws Error (wrong_input) when a body of soil can store no change of water and no pressure is given, so that time
/// has no meaning: a curve without slope while the water cannot be compressed.
template <int D>
void check_storage(const SeepageModel<D>& model);

template <int D>
std::string describe_inner_side(const mesh::Mesh<D>& mesh, const std::string& boundary,
                                const typename mesh::Mesh<D>::Side& side);

template <int D>
std::string describe_contradiction(const mesh::Mesh<D>& mesh, int node, const std::string& one, double one_head,
                                   const std::string& other, double other_head);

}  // namespace talus::fem
