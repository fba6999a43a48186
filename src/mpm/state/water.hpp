// SPDX-License-Identifier: MIT
#pragma once
// Pore water of a body as plain data: what the two-velocity step (two_velocity_step.hpp) stores beside the fields of
// one phase. Symbols and formulas: docs/theory/14-two-phase.md. Pressure p is positive in tension, so suction is a
// positive p.

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "base/aligned.hpp"
#include "base/vec.hpp"
#include "input/language/time_table.hpp"
#include "material/water/conductivity.hpp"
#include "material/water/feddes.hpp"
#include "mpm/state/conditions.hpp"
#include "mpm/state/darcy_water.hpp"

namespace talus::mpm {

/// Suction at which every soil is dry [Pa] (Fredlund and Xing 1994).
inline constexpr double driest = 1e9;

/// Hydraulic properties of one soil. The default is a dry soil.
struct WaterLaw {
  bool wet = false;
  double grain_density = 2650;  ///< ρ_s [kg/m³]
  double density = 1000;        ///< ρ_w at zero pressure [kg/m³]
  double bulk_modulus = 2.2e9;  ///< K_w [Pa]
  double conductivity = 1e-5;   ///< k of the saturated soil [m/s]
  double drag_gravity = 9.81;   ///< the g at which k was measured [m/s²]
  material::Retention retention = material::ConstantSaturation{};
  material::Conductivity relative = material::ConstantConductivity{};
  /// s_e of Khalili and Khabbaz (1998), χ = (s/s_e)^-0.55 above it [Pa]; 0: χ = S (3.12).
  double chi_air_entry = 0;
  // Computed by finish().
  double full = 1;                ///< S of the saturated soil [-]
  double saturated_relative = 1;  ///< k_r there [-]
  bool drains = false;  ///< releases water under suction; otherwise the compressibility of water is the only storage
  double dry = driest / 10;  ///< suction at which all but a thousandth is released, at most 100 MPa [Pa]
};

enum class SurfaceKind {
  open,     ///< p = 0, water may leave and enter
  seepage,  ///< p = 0 where water leaves; none enters
  rain,     ///< as seepage, but inflow up to the rain; negative rain (evaporation) draws water up to a limiting suction
  flux,     ///< given inflow, whatever the pressure; zero: an impervious skin that moves with the soil
  head,     ///< under standing water of the given level; above it a seepage face
  pressure,  ///< the given pressure on the water
};

/// One hydraulic condition, shared by its nodes.
struct SurfaceCondition {
  std::string name;
  SurfaceKind kind = SurfaceKind::seepage;
  input::TimeTable value;  ///< rain, flux [m/s]; head [m]; pressure, positive in tension [Pa]
  bool vertical = true;    ///< rain is measured per horizontal area
  double suction_limit = std::numeric_limits<double>::infinity();  ///< evaporation stops at this suction [Pa]
};

/// Value of the condition at time `t` [s]; zero where none is given.
inline double find_value(const SurfaceCondition& s, double t) {
  return s.value.time.empty() ? 0.0 : s.value.at(t);
}

/// Returns whether the condition is an impervious skin: a flux that is zero at all times.
inline bool lets_nothing_through(const SurfaceCondition& s) {
  const std::vector<double>& flux = s.value.value;
  return s.kind == SurfaceKind::flux && std::all_of(flux.begin(), flux.end(), [](double q) { return q == 0; });
}

/// Water [kg] that has passed one surface condition since the start.
struct SurfaceBudget {
  double entered = 0, left = 0;     ///< summed by node and step
  double supplied = 0, runoff = 0;  ///< rain on its surface nodes, and the part of it that did not enter

  TALUS_PORTABLE void add(const SurfaceBudget& other) {
    entered += other.entered;
    left += other.left;
    supplied += other.supplied;
    runoff += other.runoff;
  }
};

/// Plants that draw water through the points of their root zone. A point loses α(s) T(t) times its weight.
struct RootUptake {
  std::string name;
  input::TimeTable rate;       ///< T, potential per horizontal area of ground [m/s]
  material::Feddes reduction;  ///< α, of the element's mean suction
  /// By point number: horizontal ground area whose transpiration is drawn from the point [m²] (2D: m). It moves with
  /// the point and is lost with it.
  std::vector<double> weight;
};

/// Directions in which the water of a node is fixed in space.
template <int D>
struct WaterConstraint {
  int fixed_count = 0;
  Vec<D> fixed[D]{};  ///< orthonormal
};

/// Orthonormal axes of a node, along each of which a phase is either free or fixed.
template <int D>
struct HeldAxes {
  Vec<D> axis[D]{};
  bool solid[D]{}, water[D]{};
};

/// A side of a wet element behind which there is no wet soil.
template <int D>
struct OpenSide {
  int element = 0, opposite = 0;
  Vec<D> share{};  ///< A n/D: area vector of each node's part of the side [m²]
};

/// Number of doubles in a node row of the two-velocity step.
template <int D>
inline constexpr int wet_sums_stride = D == 2 ? 16 : 24;
template <int D>
inline constexpr int wet_motion_stride = D == 2 ? 8 : 16;

/// Fields of a slot from Water::first_field on: w [m/s], p [Pa], m_w [kg], capacity of PoreState [1/Pa].
template <int D>
struct WaterFields {
  static constexpr int velocity = 0, pressure = D, mass = D + 1, capacity = D + 2, count = D + 3;
};

template <int D>
struct Water {
  std::vector<WaterLaw> laws;   ///< by material number; empty: the body has one phase
  double density = 1000;        ///< ρ_w at zero pressure, the same in all wet soils [kg/m³]
  double bulk_modulus = 2.2e9;  ///< K_w, likewise [Pa]
  int first_field = 0;          ///< index of the point's water in a slot, see WaterFields

  // Conditions.
  std::vector<int> constraint_of_node;  ///< index into constraints, or -1
  std::vector<WaterConstraint<D>> constraints;
  std::vector<HeldAxes<D>> axes;           ///< of the nodes with fixed directions
  std::vector<int> axes_of_node;           ///< index into axes, or -1; computed by gather_nodal_sums()
  std::vector<SurfaceCondition> surfaces;  ///< at least one; the first is the condition of surfaces without a name
  std::vector<int> surface_of_node;        ///< index into surfaces

  // Elements, [block][…][lane].
  AlignedVector<double> moments;          ///< of the water's mass [moment_size] [kg]
  AlignedVector<double> volume;           ///< Σ V_p of wet points after the last pass [m³]
  AlignedVector<double> stretch;          ///< V_e/Σ V_p in full elements, else 1 [-]
  AlignedVector<double> mean_saturation;  ///< Σ V_p S/Σ V_p [-]
  AlignedVector<double> mean_pressure;    ///< Σ V_p p/Σ V_p [Pa]
  AlignedVector<double> mean_bishop;      ///< Σ V_p χp/Σ V_p [Pa]
  AlignedVector<double> mean_resistance;  ///< ρ_w g/k of the element [N s/m⁴]
  AlignedVector<double> surplus;          ///< water per volume that smoothing, exchange and roots remove [-]

  // Nodes, by row.
  AlignedVector<double> sums;      ///< [wet_sums_stride]: see WetColumns
  AlignedVector<double> motion;    ///< [wet_motion_stride]: a_s, a_w [m/s²], v, θ(w-v) [m/s]
  AlignedVector<double> average;   ///< [4]: sums of nodal averages, Σ Δε V_e, Σ V_e, Σ div V̄, Σ V̄
  AlignedVector<double> smoothed;  ///< [4]: nodal averages of Δε, of the divergence, unused, of Δζ (T14.8)

  // The surface.
  std::vector<OpenSide<D>> open_sides;
  std::vector<Vec<D>> facing;      ///< by node: sum of the area vectors of open sides [m²]; zero: no surface
  std::vector<Vec<D>> load;        ///< by node: outside pressure in the equation of the water [N]
  std::vector<Vec<D>> darcy_load;  ///< by node: the same in the equation of the mixture [N]
  std::vector<double> suction;     ///< by node: mean pressure of the elements at the surface; with evaporation only
  std::vector<Vec<D>> still_flux;  ///< by node: θ(w-v) of flow without inertia [m/s]; with exchange only
  bool surface_is_stale = true;    ///< an element has lost its last point or received its first one
  std::vector<int> newly_full;     ///< elements that became full in the last pass

  DarcyWater<D> darcy;  ///< of the Darcy (u-p) formulation

  std::vector<RootUptake> uptakes;  ///< by block of roots

  // Budget.
  std::vector<SurfaceBudget> budgets;  ///< by surface condition
  double transpired = 0;               ///< root uptake [kg]
  double lost_between = 0;             ///< outflow through nodes on no surface: quadrature error [kg]
  double left_grid = 0;                ///< with points that left the grid [kg]
  double pressed_in = 0;               ///< frozen geometry: water that the pores would have pressed out, and kept [kg]

  bool is_wet() const { return !laws.empty(); }
};

}  // namespace talus::mpm
