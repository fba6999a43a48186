// SPDX-License-Identifier: MIT
#pragma once
// Flow of water through saturated and unsaturated soil that does not deform: Richards' equation on linear triangles and
// tetrahedra, steady or transient. docs/theory/13-seepage.md has the equations, decision 0016 the reasons.
//
// The unknown is the total head H = y - p/γ_w [m] at the nodes. The pore pressure p is positive in tension; it is the
// suction.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/shown_units.hpp"
#include "fem/seepage/hydraulic_boundary.hpp"
#include "material/water/conductivity.hpp"
#include "mesh/mesh.hpp"

namespace talus::fem {

template <int D>
struct HydraulicSoil {
  std::string name;
  double porosity = 0;                 ///< n [-]
  std::array<double, D> conductivity;  ///< saturated, K_xx, K_yy (and K_zz) [m/s]
  material::Retention retention = material::ConstantSaturation{};
  material::Conductivity relative = material::ConstantConductivity{};
  double water_modulus = std::numeric_limits<double>::infinity();  ///< K_w [Pa]
  double skeleton_compressibility = 0;                             ///< m_v = 1/E_c, where saturated [1/Pa]
  double cross_conductivity = 0;                                   ///< K_xy, of axes inclined in the plane x–y [m/s]
};

template <int D>
struct SeepageModel {
  const mesh::Mesh<D>* mesh = nullptr;  ///< finished; elements of empty_region take no part
  std::vector<HydraulicSoil<D>> soils;  ///< by element_region
  std::vector<HydraulicBoundary<D>> boundaries;
  double unit_weight = 9810;      ///< γ_w [N/m³]
  int up = 1;                     ///< axis opposite to gravity
  std::vector<RootSink> sinks{};  ///< water uptake by roots, in steady flow too
  /// Weight of the pools over every node at a time [Pa], whose changes compress saturated soil. Empty: no such effect.
  std::function<std::vector<double>(double time)> pool_weight{};
  ShownUnits units{};  ///< units of messages
};

struct SeepageOptions {
  double tolerance = 1e-11;             ///< imbalance at the nodes over the flow [-]
  double smallest_conductivity = 1e-9;  ///< lower limit of k_r [-], which keeps dry soil solvable
  int most_iterations = 60;             ///< of Newton between changes of face nodes; then a smaller step
};

/// State of a node on a face (T13.4).
enum class FaceState : char {
  none,  ///< the node is on no face
  open,  ///< unsaturated; all supplied water enters
  wet,   ///< zero pressure: water flows out, or part of the rain runs off
  dry    ///< at the suction limit: less than the potential evaporates
};

/// Flow through one boundary [m³/s] (per metre of thickness in 2D); over a time range [m³].
struct Discharge {
  std::string name;
  double inflow = 0;
  double outflow = 0;
  double runoff = 0;    ///< rain that did not infiltrate, here or where it ran to
  double standing = 0;  ///< increase of the water standing on the ground
};

/// Extent of the wet part of a face, in 2D and 3D.
template <int D>
struct FaceExtent {
  std::string name;
  std::array<double, D> highest;  ///< the highest wet node [m]: the exit point of the water table
  std::array<double, D> lowest;   ///< the lowest wet node [m]
};

template <int D>
struct SeepageResult {
  double time = 0;                              ///< [s]; 0 for steady flow
  std::vector<double> head;                     ///< per node [m]; the elevation at nodes without soil
  std::vector<double> pressure;                 ///< per node, positive in tension [Pa]
  std::vector<double> saturation;               ///< per element, its mean [-]
  std::vector<std::array<double, D>> velocity;  ///< Darcy velocity per element [m/s]
  std::vector<FaceState> face;                  ///< per node
  std::vector<Discharge> discharges;            ///< per boundary, from the consistent nodal fluxes
  double inflow = 0, outflow = 0;               ///< their sums [m³/s]
  std::vector<Uptake> uptakes;                  ///< per sink
  double transpired = 0;                        ///< their sum [m³/s]
  double storage_rate = 0;                      ///< increase of the stored water [m³/s]
  double balance_error = 0;                     ///< inflow - outflow - transpired - storage_rate [m³/s]
  std::vector<FaceExtent<D>> exits;             ///< faces that are partly wet
  std::vector<std::vector<std::array<double, D>>> water_table;  ///< 2D: polylines p = 0 [m]; 3D: empty
  int undecided = 0;   ///< face nodes that satisfy neither state exactly, on meshes far coarser than the capillary
                       ///< fringe
  int iterations = 0;  ///< linear systems solved
};

/// Solves steady flow with the boundary values at `time` [s]. `guess` (heads per node) may be empty. Throws Error
/// (wrong_input) if the model has a fault, Error (unstable) if no solution is found.
template <int D>
SeepageResult<D> solve_steady_seepage(const SeepageModel<D>& model, const SeepageOptions& options = {},
                                      const std::vector<double>& guess = {}, double time = 0);

struct SeepageSchedule {
  double start = 0;                                               ///< [s]
  std::vector<double> outputs;                                    ///< increasing times [s]; the last one is the end
  double first_step = 0;                                          ///< [s]; 0: 0.1 % of the time to the first output
  double smallest_step = 0;                                       ///< [s]; 0: 1e-9 of the total time
  double largest_step = std::numeric_limits<double>::infinity();  ///< [s]
  double head_tolerance = 1e-3;               ///< limit of the error of a step, estimated from a prediction [m]
  std::function<void(double time)> report{};  ///< called after every step; may be empty
};

template <int D>
struct SeepageHistory {
  std::vector<SeepageResult<D>> states;         ///< at the outputs
  std::vector<std::vector<Discharge>> volumes;  ///< through each boundary from the start to each output [m³]
  std::vector<std::vector<Uptake>> uptakes;     ///< by each sink from the start to each output [m³]
  std::vector<double> stored;                   ///< increase of the stored water since the start [m³]
  double largest_error = 0;                     ///< largest estimated error of a step, but the first after a corner [m]
  int steps = 0, rejected = 0, iterations = 0;
};

/// Receives the state of every output as soon as it is known.
template <int D>
using SeepageOutput = std::function<void(const SeepageResult<D>&)>;

/// Solves transient flow from the heads `initial` (per node): implicit Euler in the mixed form, which conserves mass,
/// with error-controlled steps. Throws as solve_steady_seepage().
template <int D>
SeepageHistory<D> solve_transient_seepage(const SeepageModel<D>& model, const std::vector<double>& initial,
                                          const SeepageSchedule& schedule, const SeepageOptions& options = {},
                                          const SeepageOutput<D>& on_output = {});

/// Returns the volume of water in the soil [m³] at the heads `head`.
template <int D>
double find_stored_water(const SeepageModel<D>& model, const std::vector<double>& head);

// Validation of a seepage model.

/// Throws Error (wrong_input) with the first fault of the soils and boundaries.
template <int D>
void check_model(const SeepageModel<D>& model);

/// Throws Error (wrong_input) if a body of soil has no storage (a horizontal retention curve and incompressible water)
/// and no prescribed pressure, so that the transient problem is singular.
template <int D>
void check_storage(const SeepageModel<D>& model);

template <int D>
std::string describe_inner_side(const SeepageModel<D>& model, const std::string& boundary,
                                const typename mesh::Mesh<D>::Side& side);

template <int D>
std::string describe_contradiction(const SeepageModel<D>& model, int node, const std::string& one, double one_head,
                                   const std::string& other, double other_head);

}  // namespace talus::fem
