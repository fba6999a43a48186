// SPDX-License-Identifier: MIT
#include "results/trial.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, Preconsolidation& r) {
  v.key("points", r.points, {"", "points"});
  v.key("smallest", r.smallest, {"Pa", "smallest preconsolidation pressure"});
  v.key("largest", r.largest, {"Pa", "largest preconsolidation pressure"});
  v.key("points_beyond_yield_surface", r.beyond, {"", "points whose stress was beyond the yield surface"});
}

void describe(Visitor& v, Retry& r) {
  v.key("time", r.time, {"s", "when it became unstable"});
  v.key("back_to", r.back_to, {"s", "where it resumed"});
  v.key("courant", r.courant, {"", "Courant number from there on"});
  v.key("smoothing", r.smoothing, {"", "smoothing from there on"});
  v.key("reason", r.reason, {"", "what was unstable"});
}

void describe(Visitor& v, MovingSoil& r) {
  v.key("speed", r.speed, {"m/s", "largest nodal speed"});
  v.key("place", r.place, {"m", "where"});
  v.key("material", r.material, {"", "material there"});
  v.key("share", r.share, {"", "share of the mass that moves at a tenth of that speed or more"});
}

void describe(Visitor& v, Stage& r) {
  v.key("name", r.name, {"", "name of the stage"});
  v.key("end", r.end, {"", "what ended it"});
  v.key("start", r.start, {"s", "start"});
  v.key("time", r.time, {"s", "simulated time at the end"});
  v.key("steps", r.steps, {"", "time steps"});
  v.key("time_step", r.time_step, {"s", "last time step"});
  v.key("displacement", r.displacement, {"m", "largest displacement at the end"});
  v.key("force_ratio", r.force_ratio, {"", "unbalanced force over the external force"});
  v.key("nodal_speed", r.speed, {"m/s", "largest nodal speed"});
  v.key("wall", r.wall, {"s", "wall time"});
  v.maybe("preconsolidation", r.preconsolidation, {"", "preconsolidation that was set at its end"});
  v.maybe("moving", r.moving, {"", "what still moved at its end, though it was to end at rest"});
  v.maybe("setbacks", r.setbacks, {"", "where it became unstable and was calculated again"});
}

void describe(Visitor& v, StageRecord& r) {
  v.key("stages", r.stages, {"", "stages that are done"});
  v.key("warnings", r.warnings, {"", "warnings"});
}

void describe(Visitor& v, SlipLine& r) {
  v.key("srf", r.factor, {"", "strength reduction factor"});
  v.key("points", r.points, {"m", "its points"});
  v.maybe("sides", r.sides, {"", "the line of each side, where the soil moves to both"});
}

void describe(Visitor& v, Trial& r) {
  v.key("srf", r.factor, {"", "strength reduction factor"});
  v.key("end", r.end, {"", "what ended it"});
  v.key("displacement", r.displacement, {"m", "largest displacement"});
  v.key("time", r.time, {"s", "simulated time"});
  v.key("steps", r.steps, {"", "time steps"});
  v.key("force_ratio", r.force_ratio, {"", "unbalanced force over the external force"});
  v.key("nodal_speed", r.speed, {"m/s", "largest nodal speed at the end"});
  v.key("largest_nodal_speed", r.largest_speed, {"m/s", "largest nodal speed"});
  v.maybe("setbacks", r.setbacks, {"", "where it became unstable and was calculated again"});
}

void describe(Visitor& v, RunoutTrial& r) {
  describe(v, r.trial);
  v.key("runout", r.runout, {"", "how far the soil ran"});
  v.key("profile", r.profile, {"", "the ground at the end"});
  v.maybe("failure_time", r.failure_time, {"s", "time of failure"});
}

void describe(Visitor& v, TrialOutcome& r) {
  v.key("trial", r.trial, {"", "how it ended"});
  v.maybe("runout", r.runout, {"", "continued until rest"});
  v.maybe("slip_line", r.slip_line, {"", "of one that failed at frozen geometry"});
}

void describe(Visitor& v, Criterion& r) {
  v.key("name", r.kind, {"", "criterion"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("lower", r.lower, {"", "computed factor below it"});
  v.key("upper", r.upper, {"", "computed factor above it"});
  v.key("note", r.note, {"", "why there is none, or what to know"});
}

void describe(Visitor& v, Branch& r) {
  v.key("slope", r.slope, {"m", "slope over the factor"});
  v.key("intercept", r.intercept, {"m", "displacement at factor zero"});
  v.key("points", r.factors, {"", "factors that it was fitted to"});
}

void describe(Visitor& v, BilinearLines& r) {
  v.key("factor", r.factor, {"", "where the lines meet"});
  v.key("first", r.first, {"", "first line"});
  v.key("second", r.second, {"", "second line"});
}

void describe(Visitor& v, DisplacementCurve& r) {
  v.key("points", r.points, {"", "trials by factor"});
  v.key("criteria", r.criteria, {"", "factors by every criterion"});
  v.maybe("bilinear", r.bilinear, {"", "the two lines"});
}

void describe(Visitor& v, MeshFactor& r) {
  v.key("size", r.size, {"m", "size of the elements"});
  v.key("points", r.points, {"", "material points"});
  v.derived("factor", r.factor(), {"", "factor of safety on this mesh"});
  v.key("lower", r.lower, {"", "largest factor that came to rest"});
  v.key("upper", r.upper, {"", "smallest factor that ran away"});
  v.key("undecided", r.undecided, {"", "whether a trial neither rested nor ran away"});
  v.key("trials", r.trials, {"", "trials by factor"});
}

void describe(Visitor& v, FrozenFactor& r) {
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("note", r.note, {"", "why there is none"});
  v.key("uncertainty", r.uncertainty,
        {"", "half the width of the interval of brackets and mesh; nothing from one mesh"});
  v.key("bracket", r.bracket, {"", "half the width of the brackets, as the extrapolation passes them on"});
  v.maybe("mesh_effect", r.mesh_effect, {"", "what the mesh does to the factor"});
  v.key("extrapolated", r.extrapolated, {"", "factor extrapolated to elements of no size"});
  v.key("meshes", r.meshes, {"", "factors by mesh"});
  v.maybe("coarser", r.coarser, {"", "factor on a mesh of twice the coarse size, for the extrapolation"});
  v.maybe("other", r.other, {"", "factor on the coarse mesh of another mesher"});
  v.key("dilatancy_angle_min", r.dilatancy_angle_min, {"deg", "smallest dilatancy angle"});
  v.key("dilatancy_angle_max", r.dilatancy_angle_max, {"deg", "largest dilatancy angle"});
}

void describe(Visitor& v, PointFactors& r) {
  v.maybe("value", r.value, {"", "factor of safety"});
  v.maybe("frozen", r.frozen, {"", "rest or run-away at frozen geometry"});
  v.maybe("criteria", r.criteria, {"", "constructions on the displacement curve"});
}

}  // namespace talus::results
