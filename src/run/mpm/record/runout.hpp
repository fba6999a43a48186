// SPDX-License-Identifier: MIT
#pragma once
// How far the soil has run: front, crest, moved volume and deposit, between two states of a body.

#include <filesystem>
#include <string>

#include "input/case/case.hpp"
#include "mpm/body/body.hpp"
#include "results/runout.hpp"

namespace talus::run {

/// The ground as the points show it: per bin the highest point plus half the size of its volume.
template <int D>
results::Profile find_profile(const mpm::Body<D>& body, double bin);

/// Relief of the ground: highest minus lowest level of the profile [m]. This is H of the displacement criteria; a
/// level ground has the height of the soil itself.
template <int D>
double find_slope_height(const mpm::Body<D>& body, const input::Gravity& gravity);

/// A runout is measured from there.
struct RunoutStart {
  results::Profile initial;  ///< the ground at the start
  double threshold = 0;      ///< points that moved less are at rest [m]
};

/// Compares the body now, along x and y whatever the direction of gravity, with its reference positions
/// (mpm::reset_displacements).
template <int D>
results::Runout find_runout(const mpm::Body<D>& body, const RunoutStart& from);

/// Whether an end of the box stopped the front, as a warning; empty: none did.
std::string describe_limits(const results::Runout& runout);

/// profile.csv: the ground before and after. Throws Error (cannot_write).
void write_profiles(const std::filesystem::path& path, const results::Profile& before, const results::Profile& after);

}  // namespace talus::run
