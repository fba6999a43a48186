// SPDX-License-Identifier: MIT
#pragma once
// The data of the plain two-velocity step (2.3, 3.2): one set of points for both phases, nodes with two velocities, and
// the hydraulic parameters of the soil. The equations are in docs/theory/14-two-phase.md.

#include <Eigen/Dense>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "mesh/mesh.hpp"
#include "reference/plain_body.hpp"
#include "reference/plain_material.hpp"

namespace talus::reference {

/// The pore water of one soil. Pressure is positive in tension: p > 0 is suction. The default is a saturated soil.
struct PoreWater {
  double density = 1000;        ///< ρ_w at zero pressure [kg/m³]
  double bulk_modulus = 2.2e9;  ///< K_w [Pa]
  double conductivity = 1e-5;   ///< k of the saturated soil [m/s]
  double drag_gravity = 9.81;   ///< the g that turns k into a drag coefficient: k is measured at 1 g [m/s²]
  std::function<double(double)> saturation = [](double) { return 1.0; };             ///< S(p)
  std::function<double(double)> saturation_slope = [](double) { return 0.0; };       ///< dS/dp <= 0 at p [1/Pa]
  std::function<double(double)> relative_conductivity = [](double) { return 1.0; };  ///< k_r(S)
  double chi_air_entry = 0;  ///< s_e of Khalili and Khabbaz's χ [Pa]; 0: χ = S
};

struct Soil {
  Material skeleton;
  double grain_density = 2650;  ///< ρ_s [kg/m³]
  bool wet = true;              ///< false: no pore water, `water` is not used
  PoreWater water;
};

/// Point::mass is the solid mass m_s, Point::v the solid velocity, Point::sigma the effective stress.
template <int D>
struct WetPoint : Point<D> {
  Vector<D> w = Vector<D>::Zero();  ///< velocity of the water [m/s]
  double water_mass = 0;            ///< m_w = n S ρ_w V [kg]
  double pressure = 0;              ///< p, tension positive [Pa]
};

enum class Drag { implicit_at_nodes, explicit_as_source };

/// Force to which the local damping factor applies.
enum class DampedForce {
  without_drag,  ///< the source: the unbalanced force of each phase without drag (2.5.1)
  net            ///< what is left with drag and with the skin of the surface: zero in steady flow
};

struct WetSettings {
  double time_step = 0;  ///< Δt [s]
  Drag drag = Drag::implicit_at_nodes;
  double damping = 0;        ///< α of the solid (2.89) [-]
  double water_damping = 0;  ///< α of the water [-]
  DampedForce damped_force = DampedForce::without_drag;
  double mass_scaling = 1;                ///< β of (2.91), both phases [-]
  bool mixed = true;                      ///< full elements are integrated as one Gauss point (2.92)
  Smoothing smoothing = Smoothing::none;  ///< of the volumetric strain increments of both phases (2.94, 2.95)
  bool smooth_pressure = false;           ///< (2.96, 2.97)
  bool exchange_water = false;            ///< (T14.9)
  bool objective = true;                  ///< rotate the stress with the soil
  bool frozen = false;                    ///< points and volumes stay as they are
};

/// The nodal fields of one step.
template <int D>
struct WetNode {
  double solid_mass = 0;     ///< M_s [kg]
  double water_mass = 0;     ///< M̄_w of (2.69): the water that is there [kg]
  double whole_mass = 0;     ///< M_w of (2.70): water in the whole volume of the wet points [kg]
  double resistance = 0;     ///< Σ N ρ_w g/k V, k saturated: resistance to Darcy's flux θ(w−v) (2.75) [kg/s]
  double volume = 0;         ///< Σ N V of wet points [m³]
  double mobile_volume = 0;  ///< Σ N V k_r [m³]
  bool drinks = false;       ///< a wet surface that takes less water than there is outside: conducts as saturated
  Vector<D> solid_momentum = Vector<D>::Zero();  ///< at the start of the step [kg m/s]
  Vector<D> water_momentum = Vector<D>::Zero();
  Vector<D> force = Vector<D>::Zero();               ///< of the mixture, external minus internal (2.66) [N]
  Vector<D> water_force = Vector<D>::Zero();         ///< of (2.67), external minus internal, without drag [N]
  Vector<D> solid_acceleration = Vector<D>::Zero();  ///< [m/s²]
  Vector<D> water_acceleration = Vector<D>::Zero();
  Vector<D> v = Vector<D>::Zero();        ///< of the solid, after the remap [m/s]
  Vector<D> w = Vector<D>::Zero();        ///< of the water, after the remap [m/s]
  Vector<D> outside = Vector<D>::Zero();  ///< Σ V ∇N over wet points, V as integrated: where water leaves [m²]
  double outside_scale = 0;               ///< Σ V (|∂N/∂x| + |∂N/∂y| + …) [m²]
  double suction = 0;  ///< mean over the touching elements with an open side of their mean pressure [Pa]
  Vector<D> surface = Vector<D>::Zero();  ///< the part of `outside` that is free surface; zero: none [m²]

  /// n S of the node, M̄_w/M_w [-].
  double water_content() const { return whole_mass > 0 ? water_mass / whole_mass : 0.0; }
  /// D, the force per relative velocity w − v [kg/s].
  double drag() const {
    if (water_content() <= 0) return 0.0;
    return water_content() * resistance * (drinks ? 1.0 : volume / mobile_volume);
  }
};

/// Hydraulic condition at nodes on a free surface of the wet soil.
enum class SurfaceKind {
  open,     ///< p = 0, water may leave and enter
  seepage,  ///< p = 0 where water leaves; none enters
  rain,     ///< as seepage, but up to the rain enters; or evaporation draws water out
  flux,     ///< just the given inflow
  closed,   ///< flux 0, an impervious skin that moves with the soil
  head,     ///< under standing water of the given level; above it a seepage face
  pressure  ///< the given pressure; water may leave and enter
};

template <int D>
struct SurfaceCondition {
  SurfaceKind kind = SurfaceKind::open;
  Vector<D> rain = Vector<D>::Zero();  ///< q̂, the rain as a vector: intensity on the plane normal to it [m/s]
  double normal_rain = 0;              ///< intensity on the surface itself [m/s]
  double evaporation = 0;              ///< out of the surface itself, of kind rain [m/s]
  double suction_limit = INFINITY;     ///< suction at which evaporation ends; it decreases over the last tenth [Pa]
  double inflow = 0;                   ///< of kind flux, into the soil [m/s]
  double head = 0;                     ///< level of the standing water, along component 1 [m]
  double pressure = 0;                 ///< of kind pressure, tension positive [Pa]
};

/// Mass of water [kg] that has passed, since the start.
struct WaterBudget {
  double entered = 0, left = 0;     ///< through free surfaces, by node and step
  double lost_between = 0;          ///< through nodes on none, where a full element meets one that is not [kg]
  double supplied = 0, runoff = 0;  ///< rain on surface nodes, and the part of it that did not enter

  WaterBudget& operator+=(const WaterBudget& other) {
    entered += other.entered, left += other.left, lost_between += other.lost_between;
    supplied += other.supplied, runoff += other.runoff;
    return *this;
  }
};

struct WetCell : Cell {
  bool wet = false;            ///< holds a point with pore water
  double stretch = 1;          ///< what V_p is multiplied with where the element is integrated: V_e/Σ V_p when full
  double flux_divergence = 0;  ///< div(θ(w−v)), smoothed with smoothing on [1/s]
  double surplus = 0;          ///< what (2.96) adds to the increment of water volume per volume [-]
};

template <int D>
struct WetBody {
  mesh::Mesh<D> mesh;
  std::vector<Soil> soils;
  std::vector<Constraint<D>> solid_constraints, water_constraints;  ///< one per node each
  std::vector<SurfaceCondition<D>> surface;                         ///< one per node; none: all open
  std::vector<Vector<D>> tractions;        ///< nodal forces on the mixture [N], one per node; empty: none
  std::vector<Vector<D>> water_tractions;  ///< ∫ N p̂ n dS on the water [N], one per node; empty: none
  Vector<D> gravity = Vector<D>::Zero();   ///< [m/s²]
  std::vector<WetPoint<D>> points;
  int left = 0;                   ///< points that have left the mesh and were removed
  std::vector<WetNode<D>> nodes;  ///< of the last step, to be looked at
  std::vector<WetCell> cells;     ///< of the last step, one per element
  // By element, of the last step; empty before the first.
  std::vector<double> plastic_dilation;  ///< mean over the points [-]
  std::vector<double> rough;             ///< what averaging took from the elastic increment [-]
  WaterBudget budget;
  int steps = 0;
  std::vector<WaterBudget> node_budgets;  ///< the same by node
};

template <int D>
const Soil& soil_of(const WetBody<D>& body, const WetPoint<D>& point) {
  return body.soils[static_cast<std::size_t>(point.material)];
}

/// Volume of the pores: grains do not change theirs, so the porosity is 1 − m_s/(ρ_s V), which is (2.50) summed up.
template <int D>
double pore_volume(const WetBody<D>& body, const WetPoint<D>& point) {
  return point.volume - point.mass / soil_of(body, point).grain_density;
}
template <int D>
double porosity(const WetBody<D>& body, const WetPoint<D>& point) {
  return pore_volume(body, point) / point.volume;
}

}  // namespace talus::reference
