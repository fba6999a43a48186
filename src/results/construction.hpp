// SPDX-License-Identifier: MIT
#pragma once
// Stages of construction by FEM: settlements and pore pressures in time, and the factors of safety at their ends.

#include <optional>
#include <string>
#include <vector>

#include "base/methods.hpp"
#include "results/about.hpp"
#include "results/comparison.hpp"
#include "results/timeline.hpp"

namespace talus::results {

/// One time step.
struct ConstructionStep {
  double time = 0;      ///< at its end [s]
  double length = 0;    ///< [s]
  double error = 0;     ///< estimate of its error over the largest change of pore pressure [-]
  double residual = 0;  ///< out-of-balance force over the loads [-]
  int iterations = 0;
  double settlement = 0;  ///< largest, downwards [m]
  double heave = 0;       ///< largest, upwards [m]
  double lateral = 0;     ///< largest horizontal displacement [m]
  double excess = 0;      ///< largest pore pressure above that at the start of the stages [Pa]
};
void describe(auto& v, As<ConstructionStep> auto& r) {
  v.key("time", r.time, {"s", "end of the step"});
  v.key("length", r.length, {"s", "length of the step"});
  v.key("error", r.error, {"", "estimated error over the largest change of pore pressure"});
  v.key("residual", r.residual, {"", "out-of-balance force over the loads"});
  v.key("iterations", r.iterations, {"", "linear systems"});
  v.key("settlement", r.settlement, {"m", "largest settlement"});
  v.key("heave", r.heave, {"m", "largest heave"});
  v.key("lateral", r.lateral, {"m", "largest horizontal displacement"});
  v.key("excess", r.excess, {"Pa", "largest pore pressure above that at the start of the stages"});
}

/// A measured quantity of a monitor, in SI, and how far the computed one is from it.
struct MeasuredCurve {
  std::vector<double> time;   ///< [s]
  std::vector<double> value;  ///< in SI
  std::optional<double> rms;  ///< root mean square difference at its times within the stages; nullopt: none is there
};
void describe(auto& v, As<MeasuredCurve> auto& r) {
  v.key("time", r.time, {"s", "times of the measurements"});
  v.key("value", r.value, {"", "measured values, in SI"});
  v.key("rms", r.rms, {"", "root mean square difference of the computed curve at these times, in SI"});
}

/// A monitored place, at the times of the steps.
struct ConstructionMonitor {
  std::string name;
  std::vector<double> at;                              ///< [m]
  std::vector<double> displacement_x, displacement_y;  ///< [m]
  std::vector<double> pressure;                        ///< pore pressure, compression positive [Pa]
  std::vector<double> mean, deviator;                  ///< effective mean stress, compression positive, and q [Pa]
  std::optional<MeasuredCurve> measured_settlement;    ///< downwards [m]
  std::optional<MeasuredCurve> measured_lateral;       ///< along x [m]
  std::optional<MeasuredCurve> measured_pressure;      ///< pore pressure, compression positive [Pa]
};
void describe(auto& v, As<ConstructionMonitor> auto& r) {
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

/// Values along a section line at the end of a stage; NaN where no soil is.
struct ConstructionProfile {
  std::string stage;
  std::vector<double> displacement_x, displacement_y;  ///< [m]
  std::vector<double> pressure, excess;                ///< compression positive [Pa]
};
void describe(auto& v, As<ConstructionProfile> auto& r) {
  v.key("stage", r.stage, {"", "name of the stage"});
  v.key("displacement_x", r.displacement_x, {"m", "displacement along x", can_be_nan});
  v.key("displacement_y", r.displacement_y, {"m", "displacement along y", can_be_nan});
  v.key("pressure", r.pressure, {"Pa", "pore pressure, compression positive", can_be_nan});
  v.key("excess", r.excess, {"Pa", "pore pressure above that at the start of the stages", can_be_nan});
}

/// A line of [[output.section]].
struct ConstructionLine {
  std::string name;
  std::vector<double> from, to;  ///< [m]
  std::vector<double> distance;  ///< of its places from `from` [m]
  std::vector<ConstructionProfile> profiles;
};
void describe(auto& v, As<ConstructionLine> auto& r) {
  v.key("name", r.name, {"", "name of the section line"});
  v.key("from", r.from, {"m", "where it begins"});
  v.key("to", r.to, {"m", "where it ends"});
  v.key("distance", r.distance, {"m", "distances of its places from there"});
  v.key("profiles", r.profiles, {"", "values at the ends of the stages"});
}

/// Forces of a support at the end of a stage, per metre of slope; tension is positive.
struct ConstructionSupport {
  std::string support;                       ///< name in the case
  std::vector<double> place;                 ///< distance from the head [m]
  std::vector<double> force, moment, shear;  ///< there [N/m], [N m/m], [N/m]; the latter two empty without bending
  double largest_force = 0;                  ///< [N/m]; of the largest absolute value, with its sign
  double largest_moment = 0;                 ///< [N m/m]; largest absolute value
  double largest_shear = 0;                  ///< [N/m]; largest absolute value
  double head_force = 0;                     ///< of plate, facing or connection [N/m]
};
void describe(auto& v, As<ConstructionSupport> auto& r) {
  v.key("support", r.support, {"", "name of the support"});
  v.key("place", r.place, {"m", "distances from the head"});
  v.key("force", r.force, {"N/m", "axial force there, per metre of slope"});
  v.key("moment", r.moment, {"N.m/m", "bending moment there; empty for bars without bending stiffness"});
  v.key("shear", r.shear, {"N/m", "shear force there, likewise"});
  v.key("largest_force", r.largest_force, {"N/m", "axial force of the largest absolute value"});
  v.key("largest_moment", r.largest_moment, {"N.m/m", "largest absolute bending moment"});
  v.key("largest_shear", r.largest_shear, {"N/m", "largest absolute shear force"});
  v.key("head_force", r.head_force, {"N/m", "force of plate, facing or connection"});
}

/// The factor of safety by one method at the end of a stage.
struct StageFactor {
  Method method = Method::lem;
  std::string title;                   ///< "LEM, Spencer, critical circle"
  std::optional<double> factor;        ///< nullopt: none, see `error`
  std::optional<double> lower, upper;  ///< interval of FEM or limit analysis
  std::optional<std::string> error;
  std::optional<bool>
      undrained{};  ///< true: of a failure without drainage; nullopt: at the pore pressures of that time
};
void describe(auto& v, As<StageFactor> auto& r) {
  v.key("method", r.method, {"", "method"});
  v.key("title", r.title, {"", "method and what governs"});
  v.key("factor", r.factor, {"", "factor of safety at the end of the stage"});
  v.maybe("lower", r.lower, {"", "lower end of its interval"});
  v.maybe("upper", r.upper, {"", "upper end of its interval"});
  v.maybe("error", r.error, {"", "why there is none"});
  v.maybe("undrained", r.undrained,
          {"", "true: failure without drainage; otherwise at the pore pressures of that time"});
}

struct ConstructionStage {
  std::string name;
  double from = 0, to = 0;  ///< [s]
  std::vector<std::string> added, removed;
  bool converged = false;      ///< its end is reached in equilibrium
  double reached = 0;          ///< fraction of its change that is in equilibrium [-]
  double start_imbalance = 0;  ///< out-of-balance force of its change over the loads [-]
  int rejected = 0;            ///< steps
  std::vector<ConstructionStep> steps;
  std::vector<StageFactor> factors;
  std::optional<double> least;                ///< least of its factors
  std::vector<ConstructionSupport> supports;  ///< forces at its end
  std::optional<Release> release;             ///< MPM from its end; nullopt: none
  std::string folder;                         ///< of the methods at its end, within that of the run; empty: none
  std::optional<std::string> error;
};
void describe(auto& v, As<ConstructionStage> auto& r) {
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

/// Fields on the corner nodes at the end of a stage.
struct ConstructionFields {
  std::string stage;
  std::vector<int> elements;                           ///< those with soil, by number
  std::vector<double> displacement_x, displacement_y;  ///< per node [m]
  std::vector<double> pressure, excess;                ///< per node, compression positive [Pa]
  std::vector<double> yields;  ///< fraction of the points of an element that have yielded, as `elements`
};
void describe(auto& v, As<ConstructionFields> auto& r) {
  v.key("stage", r.stage, {"", "name of the stage"});
  v.key("elements", r.elements, {"", "numbers of the elements with soil"});
  v.key("displacement_x", r.displacement_x, {"m", "displacement along x, per node"});
  v.key("displacement_y", r.displacement_y, {"m", "displacement along y, per node"});
  v.key("pressure", r.pressure, {"Pa", "pore pressure, compression positive, per node"});
  v.key("excess", r.excess, {"Pa", "pore pressure above that at the start, per node"});
  v.key("yields", r.yields, {"", "fraction of an element that has yielded"});
}

/// construction.json: mesh and fields.
struct ConstructionFile {
  std::string input_hash;
  std::vector<std::array<double, 2>> nodes;  ///< [m]
  std::vector<std::array<int, 3>> elements;
  std::vector<ConstructionFields> stages;
};
void describe(auto& v, As<ConstructionFile> auto& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("nodes", r.nodes, {"m", "nodes"});
  v.key("elements", r.elements, {"", "nodes of each element"});
  v.key("stages", r.stages, {"", "fields at the ends of the stages"});
}

struct Construction {
  std::vector<ConstructionStage> stages;
  std::vector<ConstructionMonitor> monitors;
  std::vector<ConstructionLine> lines;
  std::optional<double> least;  ///< least factor of safety at the end of a stage
  std::optional<std::string> least_stage;
  int elements = 0, unknowns = 0;
  double seconds = 0;  ///< of the stages, without the factors
};
void describe(auto& v, As<Construction> auto& r) {
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
