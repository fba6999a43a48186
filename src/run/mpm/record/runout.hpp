// SPDX-License-Identifier: MIT
#pragma once
// Runout: front, crest, moved volume and deposit, between two states of a body.

#include <filesystem>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "mpm/state/body.hpp"
#include "results/runout.hpp"

namespace talus::run {

/// Returns the ground profile from the points: in each bin the highest point plus half the size of its volume. The bins
/// divide the box evenly and are about `bin` [m] wide.
template <int D>
results::Profile find_profile(const mpm::Body<D>& body, double bin);

/// Relief of the ground [m]: highest minus lowest level of the profile. It is H of the displacement criteria; for
/// level ground it is the height of the soil.
template <int D>
double find_slope_height(const mpm::Body<D>& body, const input::Gravity& gravity);

/// The start of a runout.
struct RunoutStart {
  results::Profile initial;  ///< the ground at the start of the calculation; its bins are those of the measures
  double threshold = 0;      ///< points with a smaller displacement count as not moved [m]
  /// Volume over mass at the start, by material [m³/kg]; empty: volumes are those of the points now.
  std::vector<double> specific_volumes = {};
};

/// Returns the volume over the mass of the points of each material [m³/kg]; 0 for a material without points.
template <int D>
std::vector<double> find_specific_volumes(const mpm::Body<D>& body);

/// Compares the body, along x and y whatever the direction of gravity, with its reference positions
/// (mpm::reset_displacements), which also give the old ground (docs/theory/10-runout.md).
template <int D>
results::Runout find_runout(const mpm::Body<D>& body, const RunoutStart& from);

/// Returns a warning if an end of the box stopped the front; empty otherwise.
std::string describe_limits(const results::Runout& runout);

/// Writes profile.csv, the ground before and after. Throws Error (cannot_write).
void write_profiles(const std::filesystem::path& path, const results::Profile& before, const results::Profile& after);

}  // namespace talus::run
