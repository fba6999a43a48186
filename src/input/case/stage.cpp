// SPDX-License-Identifier: MIT
#include "input/case/stage.hpp"

#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, StepSettings& s) {
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

void describe(Visitor& v, Stage& s) {
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

void describe(Visitor& v, RestCriterion& r) {
  v.key("force_ratio", r.force_ratio, plain().above(0), "Largest out-of-balance force over the external force.");
  v.key("speed_ratio", r.speed_ratio, plain().above(0),
        "Largest nodal speed over √(gH), H being the relief of the ground (of the soil when it is level).");
  v.key("energy_ratio", r.energy_ratio, plain().above(0), "Largest kinetic energy over the external work.");
  v.key("hold", r.hold, quantity("s").at_least(0),
        "How long all must hold (the energy is not asked for at frozen geometry).");
}

}  // namespace talus::input
