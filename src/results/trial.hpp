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
void describe(Visitor& v, Preconsolidation& r);

/// A retry after instability: the stage returned to an earlier state and was repeated with other settings.
struct Retry {
  double time = 0, back_to = 0;  ///< [s]
  double courant = 0;            ///< Courant number of the retry
  std::string smoothing;         ///< `smoothing` of the retry, as in the case file
  std::string reason;            ///< what exceeded the limit of speed, and where
};
void describe(Visitor& v, Retry& r);

/// Remaining movement at the end of a stage that did not reach rest.
struct MovingSoil {
  double speed = 0;           ///< of the fastest node [m/s]
  std::vector<double> place;  ///< of the fastest node [m]
  std::string material;       ///< soil at the fastest node
  double share = 0;           ///< fraction of the mass that moves with at least a tenth of that speed
};
void describe(Visitor& v, MovingSoil& r);

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
void describe(Visitor& v, Stage& r);

/// stages.json: the stages of an unfinished run.
struct StageRecord {
  std::vector<Stage> stages;
  std::vector<std::string> warnings;
};
void describe(Visitor& v, StageRecord& r);

/// slip_line.json: the slip line at the smallest factor that failed on a mesh.
struct SlipLine {
  double factor = 0;
  std::vector<Point> points;                   ///< of the side on which more soil moves [m]
  std::optional<std::vector<SideLine>> sides;  ///< smaller x first; nullopt if the soil moves in one direction
};
void describe(Visitor& v, SlipLine& r);

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
void describe(Visitor& v, Trial& r);

/// A trial of the displacement curve that was continued until rest.
struct RunoutTrial {
  Trial trial;  ///< outcome; time, steps and largest speed of the whole trial
  Runout runout;
  Profile profile;                     ///< at the end
  std::optional<double> failure_time;  ///< from the start of the trial [s]
};
void describe(Visitor& v, RunoutTrial& r);

/// Results of a trial that other ranks computed.
struct TrialOutcome {
  Trial trial;
  std::optional<RunoutTrial> runout;
  std::optional<SlipLine> slip_line;
};
void describe(Visitor& v, TrialOutcome& r);

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
void describe(Visitor& v, Criterion& r);

/// Branch of the displacement curve: u = slope·SRF + intercept, fitted to the listed factors.
struct Branch {
  double slope = 0, intercept = 0;  ///< [m]
  std::vector<double> factors;
};
void describe(Visitor& v, Branch& r);

/// Bilinear construction of Feng and Xu (2021): lines fitted to the first and the last branch, and their intersection.
struct BilinearLines {
  double factor = 0;
  Branch first, second;
};
void describe(Visitor& v, BilinearLines& r);

/// Displacement over strength reduction factor on moving geometry, with all its criteria.
struct DisplacementCurve {
  std::vector<Trial> points;
  std::vector<Criterion> criteria;
  std::optional<BilinearLines> bilinear;
};
void describe(Visitor& v, DisplacementCurve& r);

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
void describe(Visitor& v, MeshFactor& r);

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
void describe(Visitor& v, FrozenFactor& r);

/// Factors of safety of MPM.
struct PointFactors {
  std::optional<double> value;  ///< that at frozen geometry
  std::optional<FrozenFactor> frozen;
  std::optional<std::vector<Criterion>> criteria;  ///< of the displacement curve
};
void describe(Visitor& v, PointFactors& r);

}  // namespace talus::results
