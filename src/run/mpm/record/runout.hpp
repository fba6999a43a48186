#pragma once
// How far the soil has run: front, crest, moved volume and deposit, between two states of a body.

#include <vector>

#include "input/case/case.hpp"
#include "mpm/body/body.hpp"

namespace talus::run {

/// Height of the ground over the horizontal coordinate x, in bins [m]. Empty bins have no entry.
struct Profile {
  double bin = 0;                 ///< width [m]
  std::vector<double> x, height;  ///< bin centres and ground level [m]
};

/// The ground as the points show it: per bin the highest point plus half the size of its volume.
template <int D>
Profile find_profile(const mpm::Body<D>& body, double bin);

/// Relief of the ground: highest minus lowest level of the profile [m]. This is H of the displacement criteria; a
/// level ground has the height of the soil itself.
template <int D>
double find_slope_height(const mpm::Body<D>& body, const input::Gravity& gravity);

struct Runout {
  double moved_volume = 0;          ///< of points displaced by more than the threshold [m³ or m³/m]
  double threshold = 0;             ///< [m]
  int direction = 1;                ///< +1: the soil moved towards larger x
  double front_advance = 0;         ///< front that holds 99 % of the moved mass: how far it went [m]
  double farthest_advance = 0;      ///< the same for the farthest point; a few detached points are not the front [m]
  double toe = 0;                   ///< where the front is now, x [m]
  double initial_toe = 0;           ///< where the ground met its lower level at the start, x [m]
  double toe_distance = 0;          ///< how far the front is beyond that [m]; 0 while it has not passed it
  double crest_retreat = 0;         ///< how far behind the initial crest the moved soil begins, against the motion [m]
  double crest = 0;                 ///< x of the crest at the start [m]
  double centre_advance = 0;        ///< of the centre of mass of the moved soil, along x [m]
  double centre_drop = 0;           ///< and downwards [m]
  double largest_displacement = 0;  ///< [m]
};

/// Compares the body now, along x and y whatever the direction of gravity, with its reference positions
/// (mpm::reset_displacements). `initial` is the profile then. Points that moved less than `threshold` [m] are at rest.
template <int D>
Runout find_runout(const mpm::Body<D>& body, const Profile& initial, double threshold);

}  // namespace talus::run
