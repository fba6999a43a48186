// SPDX-License-Identifier: MIT
#pragma once
// Results of the stages and trials of MPM, the displacement curve, and the factors of safety by its criteria.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "results/bounds.hpp"
#include "results/runout.hpp"

namespace talus::results {

enum class StageEnd { time, rest, failed };
template <>
inline constexpr auto words<StageEnd> = std::array{"time", "rest", "failed"};

/// Preconsolidation pressures set from R₀ at the end of a stage.
struct Preconsolidation {
  int points = 0;                    ///< number of points whose preconsolidation pressure was set
  double smallest = 0, largest = 0;  ///< of p'_c, the parts of suction and roots included [Pa]
  int beyond = 0;                    ///< number of these whose stress lies outside the resulting yield surface
};
void describe(auto& v, As<Preconsolidation> auto& r) {
  v.key("points", r.points, {"", "points"});
  v.key("smallest", r.smallest, {"Pa", "smallest preconsolidation pressure"});
  v.key("largest", r.largest, {"Pa", "largest preconsolidation pressure"});
  v.key("points_beyond_yield_surface", r.beyond, {"", "points whose stress was beyond the yield surface"});
}

/// A retry after instability: the stage returned to an earlier state and was repeated with other settings.
struct Retry {
  double time = 0, back_to = 0;  ///< [s]
  double courant = 0;            ///< Courant number of the retry
  std::string smoothing;         ///< `smoothing` of the retry, as in the case file
  std::string reason;            ///< what exceeded the limit of speed, and where
};
void describe(auto& v, As<Retry> auto& r) {
  v.key("time", r.time, {"s", "when it became unstable"});
  v.key("back_to", r.back_to, {"s", "where it resumed"});
  v.key("courant", r.courant, {"", "Courant number from there on"});
  v.key("smoothing", r.smoothing, {"", "smoothing from there on"});
  v.key("reason", r.reason, {"", "what was unstable"});
}

/// Remaining movement at the end of a stage that did not reach rest.
struct MovingSoil {
  double speed = 0;           ///< of the fastest node [m/s]
  std::vector<double> place;  ///< of the fastest node [m]
  std::string material;       ///< soil at the fastest node
  double share = 0;           ///< fraction of the mass that moves with at least a tenth of that speed
};
void describe(auto& v, As<MovingSoil> auto& r) {
  v.key("speed", r.speed, {"m/s", "largest nodal speed"});
  v.key("place", r.place, {"m", "where"});
  v.key("material", r.material, {"", "material there"});
  v.key("share", r.share, {"", "share of the mass that moves at a tenth of that speed or more"});
}

/// Outcome of a stage.
struct Stage {
  std::string name;
  StageEnd end = StageEnd::time;
  double start = 0, time = 0;  ///< [s]
  std::int64_t steps = 0;
  double time_step = 0;     ///< last time step [s]
  double displacement = 0;  ///< largest displacement of a point at the end [m]
  double force_ratio = 0, speed = 0;
  double wall = 0;  ///< [s]
  std::optional<Preconsolidation> preconsolidation;
  std::optional<MovingSoil> moving;            ///< set if the stage was to end at rest but did not
  std::optional<std::vector<Retry>> setbacks;  ///< in order of occurrence
};
void describe(auto& v, As<Stage> auto& r) {
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

/// stages.json: the stages of an unfinished run.
struct StageRecord {
  std::vector<Stage> stages;
  std::vector<std::string> warnings;
};
void describe(auto& v, As<StageRecord> auto& r) {
  v.key("stages", r.stages, {"", "stages that are done"});
  v.key("warnings", r.warnings, {"", "warnings"});
}

/// slip_line.json: the slip line at the smallest factor that failed on a mesh.
struct SlipLine {
  double factor = 0;
  std::vector<Point> points;                   ///< of the side on which more soil moves [m]
  std::optional<std::vector<SideLine>> sides;  ///< smaller x first; nullopt if the soil moves in one direction
};
void describe(auto& v, As<SlipLine> auto& r) {
  v.key("srf", r.factor, {"", "strength reduction factor"});
  v.key("points", r.points, {"m", "its points"});
  v.maybe("sides", r.sides, {"", "the line of each side, where the soil moves to both"});
}

struct Trial {
  double factor = 0;  ///< strength reduction factor (SRF)
  StageEnd end = StageEnd::time;
  double displacement = 0;  ///< largest displacement of a point during the trial [m]
  double time = 0;          ///< simulated [s]
  std::int64_t steps = 0;
  double force_ratio = 0;    ///< ‖F_ext+G-F_int‖/‖F_ext+G‖ at the end
  double speed = 0;          ///< largest nodal speed at the end [m/s]
  double largest_speed = 0;  ///< largest nodal speed during the trial [m/s]
  std::optional<std::vector<Retry>> setbacks;
};
void describe(auto& v, As<Trial> auto& r) {
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

/// A trial of the displacement curve that was continued until rest.
struct RunoutTrial {
  Trial trial;  ///< outcome; time, steps and largest speed of the whole trial
  Runout runout;
  Profile profile;                     ///< at the end
  std::optional<double> failure_time;  ///< from the start of the trial [s]
};
void describe(auto& v, As<RunoutTrial> auto& r) {
  describe(v, r.trial);
  v.key("runout", r.runout, {"", "how far the soil ran"});
  v.key("profile", r.profile, {"", "the ground at the end"});
  v.maybe("failure_time", r.failure_time, {"s", "time of failure"});
}

/// Results of a trial that other ranks computed.
struct TrialOutcome {
  Trial trial;
  std::optional<RunoutTrial> runout;
  std::optional<SlipLine> slip_line;
};
void describe(auto& v, As<TrialOutcome> auto& r) {
  v.key("trial", r.trial, {"", "how it ended"});
  v.maybe("runout", r.runout, {"", "continued until rest"});
  v.maybe("slip_line", r.slip_line, {"", "of one that failed at frozen geometry"});
}

/// Criterion of a factor of safety of MPM.
enum class CriterionKind { frozen, bilinear, displacement, jump };
template <>
inline constexpr auto words<CriterionKind> = std::array{"frozen", "bilinear", "displacement", "jump"};

/// A factor of safety and the nearest computed factors on either side of it.
struct Criterion {
  CriterionKind kind = CriterionKind::bilinear;
  std::optional<double> factor, lower, upper;  ///< nullopt if the curve does not contain the factor
  std::string note;                            ///< why there is no factor, or a remark
};
void describe(auto& v, As<Criterion> auto& r) {
  v.key("name", r.kind, {"", "criterion"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("lower", r.lower, {"", "computed factor below it"});
  v.key("upper", r.upper, {"", "computed factor above it"});
  v.key("note", r.note, {"", "why there is none, or what to know"});
}

/// Branch of the displacement curve: u = slope·SRF + intercept, fitted to the listed factors.
struct Branch {
  double slope = 0, intercept = 0;  ///< [m]
  std::vector<double> factors;
};
void describe(auto& v, As<Branch> auto& r) {
  v.key("slope", r.slope, {"m", "slope over the factor"});
  v.key("intercept", r.intercept, {"m", "displacement at factor zero"});
  v.key("points", r.factors, {"", "factors that it was fitted to"});
}

/// Bilinear construction of Feng and Xu (2021): lines fitted to the first and the last branch, and their intersection.
struct BilinearLines {
  double factor = 0;
  Branch first, second;
};
void describe(auto& v, As<BilinearLines> auto& r) {
  v.key("factor", r.factor, {"", "where the lines meet"});
  v.key("first", r.first, {"", "first line"});
  v.key("second", r.second, {"", "second line"});
}

/// Displacement over strength reduction factor on moving geometry, with all its criteria.
struct DisplacementCurve {
  std::vector<Trial> points;
  std::vector<Criterion> criteria;
  std::optional<BilinearLines> bilinear;
};
void describe(auto& v, As<DisplacementCurve> auto& r) {
  v.key("points", r.points, {"", "trials by factor"});
  v.key("criteria", r.criteria, {"", "factors by every criterion"});
  v.maybe("bilinear", r.bilinear, {"", "the two lines"});
}

/// Factor of safety on one mesh at frozen geometry.
struct MeshFactor {
  double size = 0;  ///< element size h [m]
  int points = 0;
  std::optional<double> lower;  ///< largest factor that came to rest; nullopt if none did
  std::optional<double> upper;  ///< smallest factor that did not come to rest; nullopt if all did
  bool undecided = false;       ///< a trial neither came to rest nor failed; it counts as failed
  std::vector<Trial> trials;    ///< in order of the factor
  /// Returns the midpoint of the bracket, or nullopt if one of its ends is missing.
  std::optional<double> factor() const {
    return lower && upper ? std::optional(0.5 * (*lower + *upper)) : std::nullopt;
  }
};
void describe(auto& v, As<MeshFactor> auto& r) {
  v.key("size", r.size, {"m", "size of the elements"});
  v.key("points", r.points, {"", "material points"});
  v.derived("factor", r.factor(), {"", "factor of safety on this mesh"});
  v.key("lower", r.lower, {"", "largest factor that came to rest"});
  v.key("upper", r.upper, {"", "smallest factor that ran away"});
  v.key("undecided", r.undecided, {"", "whether a trial neither rested nor ran away"});
  v.key("trials", r.trials, {"", "trials by factor"});
}

/// Factor of safety at frozen geometry, where each trial comes to rest or fails.
struct FrozenFactor {
  std::optional<double> factor;  ///< nullopt if a mesh gave no factor
  std::string note;              ///< why there is no factor
  /// Half the width of the interval: the brackets and the discretisation error. With one mesh it is nullopt: the
  /// bracket of the search has no information on the discretisation error.
  std::optional<double> uncertainty;
  double bracket = 0;                  ///< its part from the brackets: half widths, weighted as in the extrapolation
  std::optional<double> mesh_effect;   ///< its part from the mesh; nullopt if not estimated
  std::optional<double> extrapolated;  ///< factor extrapolated to h = 0
  std::vector<MeshFactor> meshes;      ///< coarse to fine
  std::optional<MeshFactor> coarser;   ///< mesh of twice the coarsest size, used for the extrapolation only
  std::optional<MeshFactor> other;     ///< coarse mesh by another mesh algorithm
  double dilatancy_angle_min = 0, dilatancy_angle_max = 0;  ///< [deg]
  /// Returns the meshes that have a factor, coarse to fine.
  std::vector<const MeshFactor*> list_found() const {
    std::vector<const MeshFactor*> found;
    if (coarser && coarser->factor()) found.push_back(&*coarser);
    for (const MeshFactor& mesh : meshes)
      if (mesh.factor()) found.push_back(&mesh);
    return found;
  }
  std::optional<double> lower() const {
    return factor && uncertainty && mesh_effect ? std::optional(*factor - *uncertainty) : std::nullopt;
  }
  std::optional<double> upper() const {
    return factor && uncertainty && mesh_effect ? std::optional(*factor + *uncertainty) : std::nullopt;
  }
};
void describe(auto& v, As<FrozenFactor> auto& r) {
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

/// Factors of safety of MPM.
struct PointFactors {
  std::optional<double> value;  ///< that at frozen geometry
  std::optional<FrozenFactor> frozen;
  std::optional<std::vector<Criterion>> criteria;  ///< of the displacement curve
};
void describe(auto& v, As<PointFactors> auto& r) {
  v.maybe("value", r.value, {"", "factor of safety"});
  v.maybe("frozen", r.frozen, {"", "rest or run-away at frozen geometry"});
  v.maybe("criteria", r.criteria, {"", "constructions on the displacement curve"});
}

}  // namespace talus::results
