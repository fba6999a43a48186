// SPDX-License-Identifier: MIT
#pragma once
// Results of runouts: onset of movement at the monitors, sections, ground profiles, and runout distances with their
// discretisation error.

#include <array>
#include <optional>
#include <string>
#include <vector>

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

/// Runout of the soil that moves in one direction.
struct RunoutSide {
  double moved_volume = 0;          ///< of points displaced by more than the threshold [m³ or m³/m]
  int direction = 1;                ///< +1: towards larger x, -1: towards smaller x
  double front_advance = 0;         ///< advance of the front that encloses 99 % of the moved mass [m]
  double farthest_advance = 0;      ///< advance of the farthest point, which may be a detached one [m]
  double toe = 0;                   ///< x of the front at the end [m]
  double initial_toe = 0;           ///< x of the toe at the start, where the ground meets its lower level [m]
  double toe_distance = 0;          ///< distance of the front beyond the initial toe, at least 0 [m]
  double crest_retreat = 0;         ///< distance of the rear end of the moved soil behind the initial crest [m]
  double crest = 0;                 ///< x of the crest at the start [m]
  double centre_advance = 0;        ///< horizontal advance of the centre of mass of the moved soil [m]
  double centre_drop = 0;           ///< drop of the centre of mass of the moved soil [m]
  double largest_displacement = 0;  ///< [m]
  std::optional<BoxLimit> limits;   ///< nullopt if the moved soil does not reach the ends of the box
};
void describe(Visitor& v, RunoutSide& r);

/// Runout on elements of twice the size.
struct CoarserRunout {
  double size = 0;  ///< mean element size [m]
  double front_advance = 0, toe_distance = 0, crest_retreat = 0, moved_volume = 0,
         highest_ground = 0;  ///< as in Runout
};
void describe(Visitor& v, CoarserRunout& r);

/// Returns the discretisation error of a result from two meshes whose element sizes differ by a factor of two: three
/// times the difference. This is the grid convergence index of two meshes with the safety factor 3 and first-order
/// convergence (Roache 1994, J. Fluids Eng. 116, 405–413).
constexpr double find_mesh_uncertainty(double value, double coarser) {
  return 3 * (value < coarser ? coarser - value : value - coarser);
}

/// Runout of all moved soil. Where soil moves to both sides, the volume and the largest displacement are totals, and
/// all other members are those of the side whose front advanced farther beyond its toe.
struct Runout : RunoutSide {
  double threshold = 0;                          ///< displacement above which a point counts as moved [m]
  double highest_ground = 0;                     ///< y of the highest ground at the end [m]
  std::optional<CoarserRunout> coarser_mesh;     ///< nullopt if the runout was computed on one mesh only
  std::optional<std::vector<RunoutSide>> sides;  ///< smaller x first; nullopt if the soil moves in one direction
};
void describe(Visitor& v, Runout& r);

/// Discretisation errors of a runout; all are nullopt if it was computed on one mesh only.
struct RunoutUncertainty {
  std::optional<double> front_advance, toe_distance, crest_retreat, moved_volume, highest_ground;
  explicit RunoutUncertainty(const Runout& r) {
    if (!r.coarser_mesh) return;
    const CoarserRunout& c = *r.coarser_mesh;
    front_advance = find_mesh_uncertainty(r.front_advance, c.front_advance);
    toe_distance = find_mesh_uncertainty(r.toe_distance, c.toe_distance);
    crest_retreat = find_mesh_uncertainty(r.crest_retreat, c.crest_retreat);
    moved_volume = find_mesh_uncertainty(r.moved_volume, c.moved_volume);
    highest_ground = find_mesh_uncertainty(r.highest_ground, c.highest_ground);
  }
};

}  // namespace talus::results
