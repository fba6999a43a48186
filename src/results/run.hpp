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
void describe(Visitor& v, Project& r);

/// Program, build, machine and input of a run.
struct Provenance {
  std::string program, version, commit, compiler, build_type, architecture, level, machine, started, case_file,
      input_hash;
  int lane_width = 0, threads = 0;
  std::string device;  ///< GPU of the MPM steps; empty if they ran on the processor
};
void describe(Visitor& v, Provenance& r);

/// Units of display for lengths, displacements and stresses.
struct DisplayUnits {
  std::string length = "m", displacement = "mm", stress = "kPa";
};
void describe(Visitor& v, DisplayUnits& r);

enum class Status { unfinished, finished, interrupted, unstable, failed };
template <>
inline constexpr auto words<Status> = std::array{"unfinished", "finished", "interrupted", "unstable", "failed"};

/// Time in a part of the calculation, summed over all threads [s].
struct TimedPart {
  std::string name, title;
  double seconds = 0;
};
void describe(Visitor& v, TimedPart& r);

/// Time in the phases of the MPM step [s].
struct StepSeconds {
  double solve_momentum = 0, remap_momentum = 0, smooth_strain = 0, advance_points = 0, relocate = 0;
};
void describe(Visitor& v, StepSeconds& r);

struct Timing {
  double wall = 0;            ///< [s]
  std::optional<double> cpu;  ///< summed over all threads [s]
  std::optional<StepSeconds> stage_steps;
  std::optional<std::vector<TimedPart>> parts;
};
void describe(Visitor& v, Timing& r);

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
void describe(Visitor& v, Mesh& r);

/// A material point that left the grid.
struct LostPoint {
  int id = 0;
  double time = 0;               ///< [s]
  std::vector<double> position;  ///< [m]
};
void describe(Visitor& v, LostPoint& r);

struct LostPoints {
  std::size_t points = 0;
  double mass = 0;               ///< [kg]
  std::vector<double> momentum;  ///< [kg m/s]
  std::vector<LostPoint> first;  ///< the first ones, at most 100
};
void describe(Visitor& v, LostPoints& r);

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
void describe(Visitor& v, Budgets& r);

/// The earlier result that a run started from.
struct Origin {
  std::string result, hash, title, input_hash;
  double time = 0;  ///< simulated time at its end [s]
};
void describe(Visitor& v, Origin& r);

/// FEM equilibrium that gives the initial stress of MPM.
struct StressStart {
  double factor = 1;          ///< strength reduction factor; below 1 if there is no equilibrium at 1
  double force_residual = 0;  ///< unbalanced force over the loads
  int elements = 0;
};
void describe(Visitor& v, StressStart& r);

/// Communication between the ranks of a run.
struct RankWork {
  int ranks = 1;
  double bytes = 0;    ///< sent by rank 0
  double seconds = 0;  ///< time that rank 0 spent in communication, waiting included [s]
  int hand_overs = 0;  ///< number of load rebalances between ranks
};
void describe(Visitor& v, RankWork& r);

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

void describe(Visitor& v, RunResult& r);

}  // namespace talus::results
