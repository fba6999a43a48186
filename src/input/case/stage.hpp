// SPDX-License-Identifier: MIT
#pragma once
// [[stage]] and [rest]: stages of a calculation with MPM, their settings, and the criterion of rest.

#include <array>
#include <optional>
#include <string>

#include "input/language/spec.hpp"

namespace talus::input {

enum class Until { time, rest };
enum class Integration { points, mixed };
enum class Smoothing { none, strain, stable };
enum class Geometry { moving, frozen };
enum class Drag { implicit_at_nodes, explicit_at_nodes };
enum class DampedForce { net, without_drag };
enum class WaterMotion { flows, seeps, held };

/// Settings of the time steps, shared by stages and by the trials of the strength reduction.
struct StepSettings {
  double damping = 0;       ///< α of (2.89) [-]
  double mass_scaling = 1;  ///< β of (2.91) [-]
  Integration integration = Integration::mixed;
  Smoothing smoothing = Smoothing::none;
  Geometry geometry = Geometry::moving;
  bool objective_rate = true;     ///< rotate the stress with the material (Hughes and Winget)
  bool filter_null_modes = true;  ///< filter null modes of the point velocities
  double courant = 0.9;           ///< fraction of (2.84) [-]
  // Only for soil with pore water:
  WaterMotion water = WaterMotion::seeps;
  Drag drag = Drag::implicit_at_nodes;
  double water_damping = 0;                     ///< α of the water (2.89) [-]
  DampedForce damped_force = DampedForce::net;  ///< force to which damping applies (docs/theory/14)
  bool pressure_smoothing = false;              ///< (2.96-2.97)
  bool water_exchange = true;                   ///< stabilises the pore pressure (T14.9)
  double conductivity_factor = 1;               ///< multiplies every conductivity [-]
};

struct RestCriterion {
  double force_ratio = 1e-3;   ///< ‖F_ext+G-F_int‖/‖F_ext+G‖ [-]
  double speed_ratio = 1e-4;   ///< largest nodal speed over √(gH) [-], H: height of the soil
  double energy_ratio = 1e-2;  ///< kinetic energy over external work [-]
  double hold = 0.5;           ///< time over which all criteria must hold [s]
};

struct Stage {
  std::string name;
  double duration = 0;  ///< [s]; with until = rest the longest time
  Until until = Until::time;
  StepSettings step;
  double gravity_ramp = 0;                ///< linear ramp of gravity from its last value over this time [s]
  std::optional<double> cohesion;         ///< replaces the cohesion of every Mohr–Coulomb material in this stage [Pa]
  std::optional<double> strength_factor;  ///< divides c and tanφ, (3.14-3.15), in this stage [-]
  bool reset_displacement = false;        ///< measure displacements from the start of this stage
};

template <>
inline constexpr auto choices<Until> = std::array{
    Choice{Until::time, "time", "the whole duration"},
    Choice{Until::rest, "rest", "until the soil is at rest as [rest] says, at most the duration"},
};
template <>
inline constexpr auto choices<Integration> = std::array{
    Choice{Integration::mixed, "mixed", "one stress for an element that is full, the points' own stresses elsewhere"},
    Choice{Integration::points, "points", "the points' own stresses everywhere"},
};
template <>
inline constexpr auto choices<Smoothing> = std::array{
    Choice{Smoothing::none, "none", "no smoothing"},
    Choice{Smoothing::strain, "strain", "volumetric strain increments averaged over the nodes"},
    Choice{Smoothing::stable, "stable", "the same, in the form that stays stable at rest"},
};
template <>
inline constexpr auto choices<Geometry> = std::array{
    Choice{Geometry::moving, "moving", "the points move through the mesh"},
    Choice{Geometry::frozen, "frozen", "small strains: the points keep their places"},
};

/// Returns true if pore pressures change.
constexpr bool moves(WaterMotion water) {
  return water != WaterMotion::held;
}

template <>
inline constexpr auto choices<WaterMotion> = std::array{
    Choice{WaterMotion::seeps, "seeps", "by Darcy's law through soil that moves, with pressures at the nodes"},
    Choice{WaterMotion::flows, "flows", "water and soil have velocities of their own: waves in the water, gravel"},
    Choice{WaterMotion::held, "held", "pore pressures stay as they are (drained); frozen geometry only"},
};
template <>
inline constexpr auto choices<Drag> = std::array{
    Choice{Drag::implicit_at_nodes, "implicit", "solved at the nodes; low conductivities do not shorten the time step"},
    Choice{Drag::explicit_at_nodes, "explicit", "from the last velocities; the time step shortens with conductivity"},
};
template <>
inline constexpr auto choices<DampedForce> = std::array{
    Choice{DampedForce::net, "net", "what is out of balance, drag included: nothing in steady flow"},
    Choice{DampedForce::without_drag, "without_drag",
           "the force without drag; in steady flow this acts like a lower conductivity"},
};

void describe(Visitor& v, StepSettings& s);

void describe(Visitor& v, Stage& s);

void describe(Visitor& v, RestCriterion& r);

}  // namespace talus::input
