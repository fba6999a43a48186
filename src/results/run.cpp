// SPDX-License-Identifier: MIT
#include "results/run.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, Project& r) {
  v.key("title", r.title, {"", "title of the case"});
  v.key("project", r.project, {"", "project"});
  v.key("client", r.client, {"", "client"});
  v.key("author", r.author, {"", "author"});
  v.key("checked_by", r.checked_by, {"", "checked by"});
  v.key("revision", r.revision, {"", "revision"});
  v.key("notes", r.notes, {"", "notes"});
}

void describe(Visitor& v, Provenance& r) {
  v.key("program", r.program, {"", "program"});
  v.key("version", r.version, {"", "version"});
  v.key("commit", r.commit, {"", "commit"});
  v.key("compiler", r.compiler, {"", "compiler"});
  v.key("build_type", r.build_type, {"", "kind of build"});
  v.key("architecture", r.architecture, {"", "instruction set that was compiled for"});
  v.key("level", r.level, {"", "level of the instruction set: packages of one level give bitwise identical results"});
  v.key("lane_width", r.lane_width, {"", "doubles in a pack"});
  v.key("machine", r.machine, {"", "machine"});
  v.key("threads", r.threads, {"", "threads"});
  v.key("device", r.device, {"", "the device that took the points through their steps; empty: the processor did"});
  v.key("started", r.started, {"", "when the run began, UTC"});
  v.key("case_file", r.case_file, {"", "case file"});
  v.key("input_hash", r.input_hash, {"", "hash of what the results depend on"});
}

void describe(Visitor& v, DisplayUnits& r) {
  v.key("length", r.length, {"", "unit of lengths"});
  v.key("displacement", r.displacement, {"", "unit of displacements"});
  v.key("stress", r.stress, {"", "unit of stresses"});
}

void describe(Visitor& v, TimedPart& r) {
  v.key("name", r.name, {"", "part"});
  v.key("title", r.title, {"", "what it does"});
  v.key("seconds", r.seconds, {"s", "seconds of all threads"});
}

void describe(Visitor& v, StepSeconds& r) {
  v.key("solve_momentum", r.solve_momentum, {"s", "momentum balance at the nodes"});
  v.key("remap_momentum", r.remap_momentum, {"s", "remapping of the momentum"});
  v.key("smooth_strain", r.smooth_strain, {"s", "smoothing of the strain"});
  v.key("advance_points", r.advance_points, {"s", "material points: motion, strain, stress"});
  v.key("relocate", r.relocate, {"s", "points that changed their element"});
}

void describe(Visitor& v, Timing& r) {
  v.key("wall", r.wall, {"s", "wall time"});
  v.maybe("cpu", r.cpu, {"s", "processor time"});
  v.maybe("stage_steps", r.stage_steps, {"", "seconds of the stages by part of the step"});
  v.maybe("parts", r.parts, {"", "seconds by part"});
}

void describe(Visitor& v, Mesh& r) {
  v.key("dimension", r.dimension, {"", "dimension"});
  v.key("critical_time_step", r.critical_time_step, {"s", "critical time step of the mesh"});
  v.key("points", r.points, {"", "material points"});
  v.key("soil_elements", r.soil_elements, {"", "elements with soil"});
  v.key("nodes", r.nodes, {"", "nodes"});
  v.key("elements", r.elements, {"", "elements"});
  v.key("smallest_altitude", r.smallest_altitude, {"m", "smallest altitude of an element"});
  v.key("mean_altitude", r.mean_altitude, {"m", "mean altitude of the elements"});
  v.key("smallest_altitude_at", r.smallest_altitude_at, {"m", "where the altitude is smallest"});
  v.key("mean_size", r.mean_size, {"m", "mean size of the elements"});
  v.key("smallest_angle", r.smallest_angle, {"deg", "smallest angle"});
}

void describe(Visitor& v, LostPoint& r) {
  v.key("id", r.id, {"", "number of the point"});
  v.key("time", r.time, {"s", "when"});
  v.key("position", r.position, {"m", "where"});
}

void describe(Visitor& v, LostPoints& r) {
  v.key("points", r.points, {"", "points that left the grid"});
  v.key("mass", r.mass, {"kg", "their mass"});
  v.key("momentum", r.momentum, {"kg m/s", "their momentum"});
  v.key("first", r.first, {"", "the first of them"});
}

void describe(Visitor& v, Budgets& r) {
  v.key("mass", r.mass, {"kg", "mass"});
  v.key("points", r.points, {"", "points"});
  v.key("kinetic_energy", r.kinetic_energy, {"J", "kinetic energy"});
  v.key("potential_energy", r.potential_energy, {"J", "potential energy"});
  v.key("elastic_energy", r.elastic_energy, {"J", "elastic energy"});
  v.key("plastic_work", r.plastic_work, {"J", "plastic work"});
  v.key("damping_work", r.damping_work, {"J", "work of the damping"});
  v.key("wall_work", r.wall_work, {"J", "work of walls: friction, and what they stop"});
  v.key("mapping_loss", r.mapping_loss, {"J", "energy lost between points and nodes"});
  v.key("drag_work", r.drag_work, {"J", "work of the drag between water and grains"});
  v.key("pore_water_work", r.pore_water_work, {"J", "work done on the pore water"});
  v.maybe("support_work", r.support_work, {"J", "work done on the supports"});
  v.key("external_work", r.external_work, {"J", "external work"});
  v.key("momentum", r.momentum, {"kg m/s", "momentum"});
  v.key("lost", r.lost, {"", "points that left the grid"});
}

void describe(Visitor& v, Origin& r) {
  v.key("result", r.result, {"", "folder of the result"});
  v.key("hash", r.hash, {"", "hash of its state"});
  v.key("title", r.title, {"", "its title"});
  v.key("input_hash", r.input_hash, {"", "hash of its input"});
  v.key("time", r.time, {"s", "time at its end"});
}

void describe(Visitor& v, StressStart& r) {
  v.key("factor", r.factor, {"", "what the strength was divided by; below 1 where the soil does not stand"});
  v.key("force_residual", r.force_residual, {"", "unbalanced force over the loads"});
  v.key("elements", r.elements, {"", "finite elements"});
}

void describe(Visitor& v, RankWork& r) {
  v.key("ranks", r.ranks, {"", "ranks"});
  v.key("bytes", r.bytes, {"", "bytes that the first rank has sent"});
  v.key("seconds", r.seconds, {"s", "seconds that it spent with it, waiting for others too"});
  v.key("hand_overs", r.hand_overs, {"", "rebalancings: times that soil migrated between ranks"});
}

void describe(Visitor& v, RunResult& r) {
  v.key("format", r.format, {"", "version of this file"});
  v.key("title", r.title, {"", "title of the case"});
  v.key("project", r.project, {"", "title block"});
  v.key("provenance", r.provenance, {"", "program, machine and input"});
  v.key("units", r.units, {"", "units of display"});
  v.key("outlines", r.outlines, {"m", "outlines of the soils"});
  v.key("input", r.input, {"", "every key of the case, with its unit and whether it was given"});
  v.key("status", r.status, {"", "how the run went"});
  v.maybe("error", r.error, {"", "why it did not finish"});
  v.key("warnings", r.warnings, {"", "what must be known before the results are used"});
  v.maybe("slope_height", r.slope_height, {"m", "height of the slope"});
  v.maybe("lem", r.slices, {"", "limit equilibrium (LEM)"});
  v.maybe("fem", r.elements, {"", "strength reduction by FEM"});
  v.maybe("bounds", r.bounds, {"", "limit analysis"});
  v.maybe("timeline", r.timeline, {"", "the factor of safety in time"});
  v.maybe("construction", r.construction, {"", "stages of construction by FEM"});
  v.maybe("flow", r.flow, {"", "flow of water by the method \"seepage\""});
  v.maybe("mesh", r.mesh, {"", "mesh and material points"});
  v.maybe("stages", r.stages, {"", "stages"});
  v.maybe("start", r.start, {"", "result that it started from"});
  v.maybe("stress_start", r.stress_start, {"", "FEM equilibrium that gave the initial stress of MPM"});
  v.maybe("factor_of_safety", r.factor_of_safety, {"", "factors of safety by MPM"});
  v.maybe("curve", r.curve, {"", "displacement over the strength reduction factor"});
  v.maybe("runouts", r.runouts, {"", "trials that continued until rest"});
  v.maybe("runout", r.runout, {"", "how far the soil ran"});
  v.maybe("failure_time", r.failure_time, {"s", "time of failure"});
  v.maybe("clock", r.clock, {"", "clock of onset, sections and pictures"});
  v.maybe("motion", r.motion, {"", "movement of the monitored places"});
  v.maybe("sections", r.sections, {"", "lines along which fields were taken"});
  v.maybe("budgets", r.budgets, {"", "energy, momentum and mass"});
  v.maybe("supports", r.supports, {"", "supports in MPM at the end of the stages"});
  v.maybe("water", r.water, {"", "budget of the pore water"});
  v.maybe("seepage", r.seepage, {"", "steady seepage"});
  v.maybe("season", r.season, {"", "rain and transpiration before the run"});
  v.maybe("water_states", r.water_states, {"", "where the water stood, up to the state that the methods began with"});
  v.maybe("methods", r.methods, {"", "the methods beside one another"});
  v.derived("main_factor", find_main_factor(r), {"", "main factor of safety"});
  v.derived("disagreement", find_disagreement(r),
            {"", "two factors of which neither may be used, as they lie too far apart; null: there are none"});
  v.key("results", r.results, {"", "results by name"});
  v.key("comparisons", r.comparisons, {"", "results beside what the case expects"});
  v.maybe("timing", r.timing, {"", "seconds"});
  v.maybe("ranks", r.ranks, {"", "processes that calculated together"});
}

}  // namespace talus::results
