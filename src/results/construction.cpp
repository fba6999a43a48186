// SPDX-License-Identifier: MIT
#include "results/construction.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, ConstructionStep& r) {
  v.key("time", r.time, {"s", "end of the step"});
  v.key("length", r.length, {"s", "length of the step"});
  v.key("error", r.error, {"", "estimated error over the largest change of pore pressure"});
  v.key("residual", r.residual, {"", "out-of-balance force over the loads"});
  v.key("iterations", r.iterations, {"", "linear systems"});
  v.key("settlement", r.settlement, {"m", "largest settlement"});
  v.key("heave", r.heave, {"m", "largest heave"});
  v.key("lateral", r.lateral, {"m", "largest horizontal displacement"});
  v.key("excess", r.excess,
        {"Pa", "largest excess pore pressure: above that of steady flow under the conditions of the time"});
  v.maybe("least_excess", r.least_excess,
          {"Pa", "least pore pressure minus that of steady flow under the conditions of the time, zero or negative"});
}

void describe(Visitor& v, MeasuredCurve& r) {
  v.key("time", r.time, {"s", "times of the measurements"});
  v.key("value", r.value, {"", "measured values, in SI"});
  v.key("rms", r.rms, {"", "root mean square difference of the computed curve at these times, in SI"});
}

void describe(Visitor& v, ConstructionMonitor& r) {
  v.key("name", r.name, {"", "name of the monitor"});
  v.key("at", r.at, {"m", "where it is"});
  v.key("displacement_x", r.displacement_x, {"m", "displacement along x", can_be_nan});
  v.key("displacement_y", r.displacement_y, {"m", "displacement along y", can_be_nan});
  v.key("pressure", r.pressure, {"Pa", "pore pressure, compression positive", can_be_nan});
  v.key("mean", r.mean, {"Pa", "effective mean stress p', compression positive", can_be_nan});
  v.key("deviator", r.deviator, {"Pa", "deviatoric stress q", can_be_nan});
  v.maybe("measured_settlement", r.measured_settlement, {"m", "measured settlement"});
  v.maybe("measured_lateral", r.measured_lateral, {"m", "measured displacement along x"});
  v.maybe("measured_pressure", r.measured_pressure, {"Pa", "measured pore pressure"});
}

void describe(Visitor& v, ConstructionProfile& r) {
  v.key("stage", r.stage, {"", "name of the stage"});
  v.key("displacement_x", r.displacement_x, {"m", "displacement along x", can_be_nan});
  v.key("displacement_y", r.displacement_y, {"m", "displacement along y", can_be_nan});
  v.key("pressure", r.pressure, {"Pa", "pore pressure, compression positive", can_be_nan});
  v.key("excess", r.excess,
        {"Pa", "excess pore pressure: above that of steady flow under the conditions of the time", can_be_nan});
}

void describe(Visitor& v, ConstructionLine& r) {
  v.key("name", r.name, {"", "name of the section line"});
  v.key("from", r.from, {"m", "where it begins"});
  v.key("to", r.to, {"m", "where it ends"});
  v.key("distance", r.distance, {"m", "distances of its places from there"});
  v.key("profiles", r.profiles, {"", "values at the ends of the stages"});
}

void describe(Visitor& v, ConstructionSupport& r) {
  v.key("support", r.support, {"", "name of the support"});
  v.maybe("row", r.row, {"", "row from the top of the pattern, or number of its head"});
  v.key("place", r.place, {"m", "distances from the head"});
  v.key("force", r.force, {"N/m", "axial force there, per metre of slope"});
  v.key("moment", r.moment, {"N.m/m", "bending moment there; empty for bars without bending stiffness"});
  v.key("shear", r.shear, {"N/m", "shear force there, likewise"});
  v.key("largest_force", r.largest_force, {"N/m", "axial force of the largest absolute value"});
  v.key("largest_moment", r.largest_moment, {"N.m/m", "largest absolute bending moment"});
  v.key("largest_shear", r.largest_shear, {"N/m", "largest absolute shear force"});
  v.key("head_force", r.head_force, {"N/m", "force of plate, facing or connection"});
  v.maybe("deflection_place", r.deflection_place, {"m", "of a wall: distances of its deflections from the head"});
  v.maybe("deflection", r.deflection,
          {"m", "of a wall: displacement since it was placed, towards the left of the way from its head to its toe"});
  v.maybe("largest_deflection", r.largest_deflection, {"m", "deflection of the largest absolute value"});
  v.maybe("struts", r.struts, {"N/m", "of a wall: compression of its struts, from the head"});
}

void describe(Visitor& v, StageFactor& r) {
  v.key("method", r.method, {"", "method"});
  v.key("title", r.title, {"", "method and what governs"});
  v.key("factor", r.factor, {"", "factor of safety at the end of the stage"});
  v.maybe("lower", r.lower, {"", "lower end of its interval"});
  v.maybe("upper", r.upper, {"", "upper end of its interval"});
  v.maybe("error", r.error, {"", "why there is none"});
  v.maybe("undrained", r.undrained,
          {"", "true: failure without drainage; otherwise at the pore pressures of that time"});
}

void describe(Visitor& v, ConstructionStage& r) {
  v.key("name", r.name, {"", "name of the stage"});
  v.key("from", r.from, {"s", "when it begins"});
  v.key("to", r.to, {"s", "when it ends"});
  v.key("added", r.added, {"", "regions, loads, supports and drains that it adds"});
  v.key("removed", r.removed, {"", "regions, loads and supports that it removes"});
  v.key("converged", r.converged, {"", "whether its end is reached in equilibrium"});
  v.key("reached", r.reached, {"", "fraction of its change that is in equilibrium"});
  v.key("start_imbalance", r.start_imbalance, {"", "out-of-balance force of its change over the loads"});
  v.key("rejected", r.rejected, {"", "steps that were repeated with a shorter length"});
  v.key("steps", r.steps, {"", "time steps"});
  v.key("factors", r.factors, {"", "factors of safety at its end"});
  v.key("least", r.least, {"", "least factor of safety at its end"});
  v.key("supports", r.supports, {"", "forces of the supports at its end"});
  v.maybe("release", r.release, {"", "motion by MPM from its end"});
  v.key("folder", r.folder, {"", "folder of the methods at its end"});
  v.key("error", r.error, {"", "why it did not end"});
}

void describe(Visitor& v, ConstructionFields& r) {
  v.key("stage", r.stage, {"", "name of the stage"});
  v.key("elements", r.elements, {"", "numbers of the elements with soil"});
  v.key("displacement_x", r.displacement_x, {"m", "displacement along x, per node"});
  v.key("displacement_y", r.displacement_y, {"m", "displacement along y, per node"});
  v.key("pressure", r.pressure, {"Pa", "pore pressure, compression positive, per node"});
  v.key("excess", r.excess,
        {"Pa", "excess pore pressure per node: above that of steady flow under the conditions of the time"});
  v.key("yields", r.yields, {"", "fraction of an element that has yielded"});
}

void describe(Visitor& v, ConstructionFile& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("nodes", r.nodes, {"m", "nodes"});
  v.key("elements", r.elements, {"", "nodes of each element"});
  v.key("stages", r.stages, {"", "fields at the ends of the stages"});
}

void describe(Visitor& v, Construction& r) {
  v.key("stages", r.stages, {"", "stages in order of time"});
  v.key("monitors", r.monitors, {"", "monitored places at the times of the steps"});
  v.key("lines", r.lines, {"", "values along section lines at the ends of the stages"});
  v.key("least", r.least, {"", "least factor of safety at the end of a stage"});
  v.key("least_stage", r.least_stage, {"", "stage at whose end it is least"});
  v.key("elements", r.elements, {"", "six-node triangles of the section, with all its regions"});
  v.key("unknowns", r.unknowns, {"", "largest number of unknowns of a stage"});
  v.key("seconds", r.seconds, {"s", "seconds of the stages, without the factors"});
}

}  // namespace talus::results
