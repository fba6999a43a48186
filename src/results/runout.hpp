// SPDX-License-Identifier: MIT
#pragma once
// Results of runouts: onset of movement at the monitors, sections, ground profiles, and runout distances with their
// discretisation error.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/shown_units.hpp"
#include "results/about.hpp"

namespace talus::results {

/// Clock of onsets, sections and pictures.
struct Clock {
  std::string stage;                ///< stage at whose start the clock is zero
  double start = 0;                 ///< simulated time at the start of that stage [s]
  bool resets = false;              ///< displacements are reset at the start of that stage
  std::vector<double> shown_times;  ///< times of sections and pictures [s]; empty: equally spaced
};
void describe(Visitor& v, Clock& r);

/// Order in which the monitors began to move.
enum class MotionPattern { none, single, together, upwards, downwards, mixed };
template <>
inline constexpr auto words<MotionPattern> = std::array{"none", "single", "together", "upwards", "downwards", "mixed"};

struct MonitorMotion {
  std::string name;
  std::optional<double> onset;         ///< time on the clock [s]; nullopt if the monitor did not move
  std::optional<double> displacement;  ///< at the end [m]; nullopt if the point left the grid
  std::optional<double> settled = {};  ///< largest displacement of an earlier movement that came to rest [m]
};
void describe(Visitor& v, MonitorMotion& r);

struct Motion {
  std::string stage;     ///< stage at whose start the clock is zero
  double start = 0;      ///< simulated time at the start of that stage [s]
  double threshold = 0;  ///< displacement above which a monitor counts as moving [m]
  std::vector<MonitorMotion> monitors;
  std::vector<std::string> order;  ///< names of the monitors that moved, earliest onset first
  MotionPattern pattern = MotionPattern::none;
  std::string sentence;
};
void describe(Visitor& v, Motion& r);

/// Line along which the fields of the frames are sampled; its table is sections/NAME.csv.
struct SectionLine {
  std::string name;
  std::array<double, 3> from{}, to{};  ///< [m]
  double width = 0;                    ///< width of the band of averaging [m]
};
void describe(Visitor& v, SectionLine& r);

/// Ground level over x, in bins. Empty bins are omitted.
struct Profile {
  double bin = 0;                 ///< width of a bin [m]
  std::vector<double> x, height;  ///< bin centres and ground level [m]
};
void describe(Visitor& v, Profile& r);

/// Ends of the box that limit a runout.
struct BoxLimit {
  bool front = false;  ///< moved soil reaches the end of the box in the direction of movement
  bool crest = false;  ///< moved soil reaches the opposite end
};
void describe(Visitor& v, BoxLimit& r);

/// Runout of the soil that moves in one direction (docs/theory/10-runout.md). The deposit is the moved soil that began
/// behind the toe and lies over the old ground.
struct RunoutSide {
  double moved_volume = 0;    ///< at the start, of points displaced by more than the threshold [m³ or m³/m]
  double deposit_volume = 0;  ///< [m³ or m³/m]
  int direction = 1;          ///< +1: towards larger x, -1: towards smaller x
  double front_advance = 0;   ///< from the lower end of the soil that moves to that of the deposit, at least 0 [m]
  double toe = 0;             ///< x of the front at the end: the lower end of the deposit [m]
  double initial_toe = 0;     ///< x of the toe at the start, where the ground meets its lower level [m]
  double toe_distance = 0;    ///< distance of the front beyond the initial toe, at least 0 [m]
  double crest_retreat = 0;   ///< from the initial crest back to the rear end of the ground that sank, at least 0 [m]
  double crest = 0;           ///< x of the crest at the start [m]
  double mass_front = 0;      ///< x behind which 99 % of the moved mass lie [m]
  double mass_front_advance = 0;    ///< of the same points since the start [m]
  double farthest_advance = 0;      ///< advance of the farthest point, which may be a detached one [m]
  double centre_advance = 0;        ///< horizontal advance of the centre of mass of the moved soil [m]
  double centre_drop = 0;           ///< drop of the centre of mass of the moved soil [m]
  double largest_displacement = 0;  ///< [m]
  std::optional<BoxLimit> limits;   ///< nullopt if the moved soil does not reach the ends of the box
};
void describe(Visitor& v, RunoutSide& r);

/// Runout on elements of twice the size.
struct CoarserRunout {
  double size = 0;  ///< mean element size [m]
  double front_advance = 0, toe_distance = 0, crest_retreat = 0, moved_volume = 0, highest_ground = 0,
         deposit_volume = 0;  ///< as in Runout
};
void describe(Visitor& v, CoarserRunout& r);

/// Returns the discretisation error of a result from two meshes whose element sizes differ by a factor of two: three
/// times the difference. This is the grid convergence index of two meshes with the safety factor 3 and first-order
/// convergence (Roache 1994, J. Fluids Eng. 116, 405–413).
constexpr double find_mesh_uncertainty(double value, double coarser) {
  return 3 * (value < coarser ? coarser - value : value - coarser);
}

/// Largest uncertainty of a determined result, as a fraction of it.
inline constexpr double most_uncertain = 0.5;

/// A measure of a runout on one mesh or on two.
struct Estimate {
  double value = 0;                    ///< on the finer mesh
  std::optional<double> coarser = {};  ///< on elements of twice the size; nullopt: one mesh only
  double datum = 0;                    ///< the uncertainty is compared with value - datum
  double resolution = 0;               ///< an uncertainty up to this is small whatever the value

  std::optional<double> uncertainty() const {
    return coarser ? std::optional(find_mesh_uncertainty(value, *coarser)) : std::nullopt;
  }
  /// Returns false if the two meshes leave more than ± 50 % open (T10.4). This alone decides whether a number is shown.
  bool is_determined() const;
};

/// Formats the value with its uncertainty, "1.3 ± 0.4 m"; or "not determined (two meshes: 0.21 m and 0.42 m)".
std::string format_estimate(const Estimate& estimate, const ShownUnit& unit);

/// Runout of all moved soil. Where soil moves to both sides, the volumes and the largest displacement are totals, and
/// all other members are those of the side whose front advanced farther beyond its toe.
struct Runout : RunoutSide {
  double threshold = 0;                       ///< displacement above which a point counts as moved [m]
  double deposit_threshold = 0;               ///< least thickness of a deposit, and least drop of ground that sank [m]
  double lowest_ground = 0;                   ///< y of the lowest ground at the start; of level ground: of its base [m]
  double highest_ground = 0;                  ///< y of the highest ground at the end [m]
  std::optional<CoarserRunout> coarser_mesh;  ///< nullopt if the runout was computed on one mesh only
  std::optional<std::vector<std::string>> undetermined;  ///< keys of measures that the two meshes leave open
  std::optional<std::vector<RunoutSide>> sides;  ///< smaller x first; nullopt if the soil moves in one direction
};
void describe(Visitor& v, Runout& r);

/// The measures of a runout with what its meshes leave open. The side of a divided section that does not represent the
/// whole runout has one mesh.
struct RunoutEstimates {
  Estimate front_advance, toe_distance, crest_retreat, moved_volume, deposit_volume, highest_ground;

  explicit RunoutEstimates(const RunoutSide& side);
  explicit RunoutEstimates(const Runout& r);
  /// Returns the measure with this key; nullptr if it is none of these.
  const Estimate* find(const std::string& key) const;
  /// Returns the keys of the measures that are not determined.
  std::vector<std::string> list_undetermined() const;
};

}  // namespace talus::results
