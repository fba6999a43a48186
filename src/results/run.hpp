// SPDX-License-Identifier: MIT
#pragma once
// The result of a run, summary.json, and the parts of it that belong to no method: title block, provenance, timing,
// mesh, budgets, and the work of the ranks.

#include <optional>
#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "base/shown_units.hpp"
#include "results/about.hpp"
#include "results/bars.hpp"
#include "results/bounds.hpp"
#include "results/comparison.hpp"
#include "results/construction.hpp"
#include "results/disagreement.hpp"
#include "results/elements.hpp"
#include "results/flow.hpp"
#include "results/runout.hpp"
#include "results/slices.hpp"
#include "results/timeline.hpp"
#include "results/trial.hpp"
#include "results/water.hpp"

namespace talus::results {

/// Title block of a report.
struct Project {
  std::string title, project, client, author, checked_by, revision, notes;
};
void describe(auto& v, As<Project> auto& r) {
  v.key("title", r.title, {"", "title of the case"});
  v.key("project", r.project, {"", "project"});
  v.key("client", r.client, {"", "client"});
  v.key("author", r.author, {"", "author"});
  v.key("checked_by", r.checked_by, {"", "checked by"});
  v.key("revision", r.revision, {"", "revision"});
  v.key("notes", r.notes, {"", "notes"});
}

/// Program, build, machine and input of a run.
struct Provenance {
  std::string program, version, commit, compiler, build_type, architecture, level, machine, started, case_file,
      input_hash;
  int lane_width = 0, threads = 0;
  std::string device;  ///< GPU of the MPM steps; empty if they ran on the processor
};
void describe(auto& v, As<Provenance> auto& r) {
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

/// Units of display for lengths, displacements and stresses.
struct DisplayUnits {
  std::string length = "m", displacement = "mm", stress = "kPa";
};
void describe(auto& v, As<DisplayUnits> auto& r) {
  v.key("length", r.length, {"", "unit of lengths"});
  v.key("displacement", r.displacement, {"", "unit of displacements"});
  v.key("stress", r.stress, {"", "unit of stresses"});
}

enum class Status { unfinished, finished, interrupted, unstable, failed };
template <>
inline constexpr auto words<Status> = std::array{"unfinished", "finished", "interrupted", "unstable", "failed"};

/// Time in a part of the calculation, summed over all threads [s].
struct TimedPart {
  std::string name, title;
  double seconds = 0;
};
void describe(auto& v, As<TimedPart> auto& r) {
  v.key("name", r.name, {"", "part"});
  v.key("title", r.title, {"", "what it does"});
  v.key("seconds", r.seconds, {"s", "seconds of all threads"});
}

/// Time in the phases of the MPM step [s].
struct StepSeconds {
  double solve_momentum = 0, remap_momentum = 0, smooth_strain = 0, advance_points = 0, relocate = 0;
};
void describe(auto& v, As<StepSeconds> auto& r) {
  v.key("solve_momentum", r.solve_momentum, {"s", "momentum balance at the nodes"});
  v.key("remap_momentum", r.remap_momentum, {"s", "remapping of the momentum"});
  v.key("smooth_strain", r.smooth_strain, {"s", "smoothing of the strain"});
  v.key("advance_points", r.advance_points, {"s", "material points: motion, strain, stress"});
  v.key("relocate", r.relocate, {"s", "points that changed their element"});
}

struct Timing {
  double wall = 0;            ///< [s]
  std::optional<double> cpu;  ///< summed over all threads [s]
  std::optional<StepSeconds> stage_steps;
  std::optional<std::vector<TimedPart>> parts;
};
void describe(auto& v, As<Timing> auto& r) {
  v.key("wall", r.wall, {"s", "wall time"});
  v.maybe("cpu", r.cpu, {"s", "processor time"});
  v.maybe("stage_steps", r.stage_steps, {"", "seconds of the stages by part of the step"});
  v.maybe("parts", r.parts, {"", "seconds by part"});
}

/// Mesh and material points at the start of the run.
struct Mesh {
  int dimension = 2;
  int nodes = 0, elements = 0, soil_elements = 0;
  int points = 0;
  double smallest_altitude = 0, mean_altitude = 0;  ///< [m]
  std::vector<double> smallest_altitude_at;         ///< [m]
  double mean_size = 0;                             ///< [m]
  double smallest_angle = 0;                        ///< [deg]
  double critical_time_step = 0;                    ///< [s]
};
void describe(auto& v, As<Mesh> auto& r) {
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

/// A material point that left the grid.
struct LostPoint {
  int id = 0;
  double time = 0;               ///< [s]
  std::vector<double> position;  ///< [m]
};
void describe(auto& v, As<LostPoint> auto& r) {
  v.key("id", r.id, {"", "number of the point"});
  v.key("time", r.time, {"s", "when"});
  v.key("position", r.position, {"m", "where"});
}

struct LostPoints {
  std::size_t points = 0;
  double mass = 0;               ///< [kg]
  std::vector<double> momentum;  ///< [kg m/s]
  std::vector<LostPoint> first;  ///< the first ones, at most 100
};
void describe(auto& v, As<LostPoints> auto& r) {
  v.key("points", r.points, {"", "points that left the grid"});
  v.key("mass", r.mass, {"kg", "their mass"});
  v.key("momentum", r.momentum, {"kg m/s", "their momentum"});
  v.key("first", r.first, {"", "the first of them"});
}

/// Budgets of energy, momentum and mass of MPM.
struct Budgets {
  double mass = 0;  ///< [kg]
  int points = 0;
  double kinetic_energy = 0, potential_energy = 0, elastic_energy = 0;  ///< [J]
  double plastic_work = 0, damping_work = 0, external_work = 0;         ///< [J]
  double wall_work = 0, mapping_loss = 0;                               ///< [J]
  std::optional<double> drag_work, pore_water_work;                     ///< with pore water only [J]
  std::optional<double> support_work;                                   ///< with supports only [J]
  std::vector<double> momentum;                                         ///< [kg m/s]
  LostPoints lost;
};
void describe(auto& v, As<Budgets> auto& r) {
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

/// The earlier result that a run started from.
struct Origin {
  std::string result, hash, title, input_hash;
  double time = 0;  ///< simulated time at its end [s]
};
void describe(auto& v, As<Origin> auto& r) {
  v.key("result", r.result, {"", "folder of the result"});
  v.key("hash", r.hash, {"", "hash of its state"});
  v.key("title", r.title, {"", "its title"});
  v.key("input_hash", r.input_hash, {"", "hash of its input"});
  v.key("time", r.time, {"s", "time at its end"});
}

/// FEM equilibrium that gives the initial stress of MPM.
struct StressStart {
  double factor = 1;          ///< strength reduction factor; below 1 if there is no equilibrium at 1
  double force_residual = 0;  ///< unbalanced force over the loads
  int elements = 0;
};
void describe(auto& v, As<StressStart> auto& r) {
  v.key("factor", r.factor, {"", "what the strength was divided by; below 1 where the soil does not stand"});
  v.key("force_residual", r.force_residual, {"", "unbalanced force over the loads"});
  v.key("elements", r.elements, {"", "finite elements"});
}

/// Communication between the ranks of a run.
struct RankWork {
  int ranks = 1;
  double bytes = 0;    ///< sent by rank 0
  double seconds = 0;  ///< time that rank 0 spent in communication, waiting included [s]
  int hand_overs = 0;  ///< number of load rebalances between ranks
};
void describe(auto& v, As<RankWork> auto& r) {
  v.key("ranks", r.ranks, {"", "ranks"});
  v.key("bytes", r.bytes, {"", "bytes that the first rank has sent"});
  v.key("seconds", r.seconds, {"s", "seconds that it spent with it, waiting for others too"});
  v.key("hand_overs", r.hand_overs, {"", "rebalancings: times that soil migrated between ranks"});
}

struct RunResult {
  // Out of line, so that the members of their many members are not compiled in every source.
  RunResult();
  RunResult(const RunResult&);
  RunResult(RunResult&&) noexcept;
  RunResult& operator=(const RunResult&);
  RunResult& operator=(RunResult&&) noexcept;
  ~RunResult();

  int format = result_format;
  std::string title;
  Project project;
  Provenance provenance;
  DisplayUnits units;
  std::vector<std::vector<Point>> outlines;  ///< polygons of the soils [m]
  JsonTree input;                            ///< echo of the case; empty if unknown
  Status status = Status::unfinished;
  std::optional<std::string> error;
  std::vector<std::string> warnings;
  std::optional<double> slope_height;  ///< [m]

  std::optional<SliceResult> slices;
  std::optional<ElementResult> elements;
  std::optional<BoundsResult> bounds;
  std::optional<Timeline> timeline;
  std::optional<Construction> construction;
  std::optional<FlowResult> flow;
  // Results of MPM.
  std::optional<Mesh> mesh;
  std::optional<std::vector<Stage>> stages;
  std::optional<Origin> start;
  std::optional<StressStart> stress_start;
  std::optional<PointFactors> factor_of_safety;
  std::optional<DisplacementCurve> curve;
  std::optional<std::vector<RunoutTrial>> runouts;
  std::optional<Runout> runout;
  std::optional<double> failure_time;  ///< [s]
  std::optional<Clock> clock;
  std::optional<Motion> motion;
  std::optional<std::vector<SectionLine>> sections;
  std::optional<Budgets> budgets;
  std::optional<std::vector<PointBar>> supports;
  std::optional<WaterBudget> water;
  std::optional<Seepage> seepage;
  std::optional<Season> season;
  /// In order of time; the last is the initial state of the methods or, after a rapid drawdown, the lowered state.
  std::optional<std::vector<WaterState>> water_states;

  std::optional<MethodComparison> methods;
  std::vector<NamedResult> results;
  std::vector<Comparison> comparisons;
  std::optional<Timing> timing;
  std::optional<RankWork> ranks;
};

/// Returns the units of display of the run, with the derived ones.
inline ShownUnits read_units(const RunResult& run) {
  return make_shown_units(run.units.length, run.units.displacement, run.units.stress);
}

/// Returns the main factor of the run: the smallest of the factors of LEM, FEM and MPM, each selected by the rules of
/// results/governing.hpp, of the factors of a timeline, and of the upper bound of limit analysis. With limit analysis
/// alone it is the lower bound. Returns nullopt if no method found a factor.
std::optional<double> find_main_factor(const RunResult& run);

void describe(auto& v, As<RunResult> auto& r) {
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
