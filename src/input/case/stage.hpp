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

void describe(auto& v, StepSettings& s) {
  v.key("damping", s.damping, plain().at_least(0).below(1),
        "Local damping: this share of the out-of-balance force acts against the motion.");
  v.key("mass_scaling", s.mass_scaling, plain().at_least(1),
        "The inertia is multiplied by it, for larger time steps in quasi-static stages.");
  v.key("integration", s.integration, plain(), "Where the internal forces are integrated.");
  v.key("smoothing", s.smoothing, plain(), "Against volumetric locking.");
  v.key("geometry", s.geometry, plain(),
        "Whether the soil changes its place. Default of a weight stage of wet soil (see `water`): \"frozen\".");
  v.key("objective_rate", s.objective_rate, plain(), "Rotate the stress with the soil.");
  v.key("fade_unseen", s.filter_null_modes, plain(),
        "Filter null modes, velocities of points without momentum at any node; false keeps them, as the textbook step "
        "does.");
  v.key("courant", s.courant, plain().above(0).at_most(1), "Time step over the largest stable one.");
  v.key(
      "water", s.water, plain(),
      "Whether pore water moves. A weight stage is a first stage with until = \"rest\" that brings the weight on soil "
      "with a water table or seepage and without initial stress; where it names neither `water` nor `geometry`, its "
      "pore pressures are held, so that the weight is drained. With moving water the water would carry it first.");
  v.key("drag", s.drag, plain(), "How the drag between water and grains is integrated.");
  v.key("water_damping", s.water_damping, plain().at_least(0).below(1), "Local damping of the water.");
  v.key("damped_force", s.damped_force, plain(), "The force on which the damping of the water acts.");
  v.key("pressure_smoothing", s.pressure_smoothing, plain(), "Average pore pressures over the nodes.");
  v.key("water_exchange", s.water_exchange, plain(),
        "Let neighbouring elements exchange water where their pressures differ by more than the flow explains.");
  v.key("conductivity_factor", s.conductivity_factor, plain().above(0),
        "Multiplies every conductivity, to reach a steady flow sooner.");
}

void describe(auto& v, Stage& s) {
  v.key("name", s.name, plain().required().example(R"("gravity")"), "Name of the stage in the results.");
  v.key("duration", s.duration, quantity("s").above(0).required().example("10"),
        "Simulated time; with until = \"rest\" the longest time allowed.");
  v.key("until", s.until, plain(), "What ends the stage.");
  describe(v, s.step);
  v.key("gravity_ramp", s.gravity_ramp, quantity("s").at_least(0),
        "Gravity grows linearly from its value before the stage (zero before the first) over this time; 0: at once.");
  v.key("cohesion", s.cohesion, quantity("kPa").at_least(0).example("100"),
        "Replaces the cohesion of every Mohr–Coulomb material in this stage; if not given, the materials keep theirs.");
  v.key("strength_factor", s.strength_factor, plain().above(0).example("1.2"),
        "Divides c, tan φ and the cohesion of roots in this stage, and in Cam-clay soils tan φ of the critical state; "
        "if not given, the strength is whole.");
  v.key("reset_displacement", s.reset_displacement, plain(), "Count displacements from the start of this stage.");
}

void describe(auto& v, RestCriterion& r) {
  v.key("force_ratio", r.force_ratio, plain().above(0), "Largest out-of-balance force over the external force.");
  v.key("speed_ratio", r.speed_ratio, plain().above(0),
        "Largest nodal speed over √(gH), H being the relief of the ground (of the soil when it is level).");
  v.key("energy_ratio", r.energy_ratio, plain().above(0), "Largest kinetic energy over the external work.");
  v.key("hold", r.hold, quantity("s").at_least(0),
        "How long all must hold (the energy is not asked for at frozen geometry).");
}

}  // namespace talus::input
