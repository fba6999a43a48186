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
  double settlement = 0;               ///< largest, downwards [m]
  double heave = 0;                    ///< largest, upwards [m]
  double lateral = 0;                  ///< largest horizontal displacement [m]
  double excess = 0;                   ///< largest pore pressure above that of steady flow [Pa]
  std::optional<double> least_excess;  ///< least pore pressure over that of steady flow, ≤ 0 [Pa]; nullopt: dry
};
void describe(Visitor& v, ConstructionStep& r);

/// A measured quantity of a monitor, in SI, and how far the computed one is from it.
struct MeasuredCurve {
  std::vector<double> time;   ///< [s]
  std::vector<double> value;  ///< in SI
  std::optional<double> rms;  ///< root mean square difference at its times within the stages; nullopt: none is there
};
void describe(Visitor& v, MeasuredCurve& r);

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
void describe(Visitor& v, ConstructionMonitor& r);

/// Values along a section line at the end of a stage; NaN where no soil is.
struct ConstructionProfile {
  std::string stage;
  std::vector<double> displacement_x, displacement_y;  ///< [m]
  std::vector<double> pressure, excess;                ///< compression positive [Pa]
};
void describe(Visitor& v, ConstructionProfile& r);

/// A line of [[output.section]].
struct ConstructionLine {
  std::string name;
  std::vector<double> from, to;  ///< [m]
  std::vector<double> distance;  ///< of its places from `from` [m]
  std::vector<ConstructionProfile> profiles;
};
void describe(Visitor& v, ConstructionLine& r);

/// Forces of a support at the end of a stage, per metre of slope; tension is positive.
struct ConstructionSupport {
  std::string support;                       ///< name in the case
  std::optional<int> row;                    ///< from the top of the pattern, or number of the head
  std::vector<double> place;                 ///< distance from the head [m]
  std::vector<double> force, moment, shear;  ///< there [N/m], [N m/m], [N/m]; the latter two empty without bending
  double largest_force = 0;                  ///< [N/m]; of the largest absolute value, with its sign
  double largest_moment = 0;                 ///< [N m/m]; largest absolute value
  double largest_shear = 0;                  ///< [N/m]; largest absolute value
  double head_force = 0;                     ///< of plate, facing or connection [N/m]
  /// Displacement of walls since they were placed, towards the left of the way from head to toe [m], and its places.
  std::optional<std::vector<double>> deflection_place, deflection;
  std::optional<double> largest_deflection;   ///< of the largest absolute value, with its sign [m]
  std::optional<std::vector<double>> struts;  ///< of walls with struts: compression, from the head [N/m]
};
void describe(Visitor& v, ConstructionSupport& r);

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
void describe(Visitor& v, StageFactor& r);

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
void describe(Visitor& v, ConstructionStage& r);

/// Fields on the corner nodes at the end of a stage.
struct ConstructionFields {
  std::string stage;
  std::vector<int> elements;                           ///< those with soil, by number
  std::vector<double> displacement_x, displacement_y;  ///< per node [m]
  std::vector<double> pressure, excess;                ///< per node, compression positive [Pa]
  std::vector<double> yields;  ///< fraction of the points of an element that have yielded, as `elements`
};
void describe(Visitor& v, ConstructionFields& r);

/// construction.json: mesh and fields.
struct ConstructionFile {
  std::string input_hash;
  std::vector<std::array<double, 2>> nodes;  ///< [m]
  std::vector<std::array<int, 3>> elements;
  std::vector<ConstructionFields> stages;
};
void describe(Visitor& v, ConstructionFile& r);

struct Construction {
  std::vector<ConstructionStage> stages;
  std::vector<ConstructionMonitor> monitors;
  std::vector<ConstructionLine> lines;
  std::optional<double> least;  ///< least factor of safety at the end of a stage
  std::optional<std::string> least_stage;
  int elements = 0, unknowns = 0;
  double seconds = 0;  ///< of the stages, without the factors
};
void describe(Visitor& v, Construction& r);

}  // namespace talus::results
