// SPDX-License-Identifier: MIT
#pragma once
// What a run will need, before it begins: elements, points, memory, steps and time by each method.

#include <optional>
#include <string>
#include <vector>

#include "input/read.hpp"

namespace talus::run {

/// What one method needs, at most. Zero where it is not known.
struct MethodForecast {
  input::Method method = input::Method::mpm;
  double elements = 0;  ///< of its largest mesh
  double points = 0;    ///< material points on it
  double surfaces = 0;  ///< trial surfaces of slices
  double bytes = 0;
  double steps = 0;         ///< time steps of all stages and trials
  double seconds = 0;       ///< on this machine, as such cases usually take
  double most_seconds = 0;  ///< where no stage or trial ends early, or no mesh is good enough before the last
  double times = 0;         ///< of a timeline
  double size = 0;          ///< general element size of that mesh [m]
  int dimension = 2;
};

/// One for each method of the case. Of material points steps and time follow from stepping them for a moment, if
/// `with_time`.
std::vector<MethodForecast> forecast(const input::Case& data, bool with_time);

/// "about 18,000 circles, a second".
std::string describe(const MethodForecast& forecast);

/// "a second", "12 minutes".
std::string write_time(double seconds);

/// Seconds of a sample by slices, on the surfaces that are kept for all samples.
double find_sample_seconds(const input::LimitEquilibrium& lem);

/// The smallest element size, to two digits, with which a method needs no more than `free` bytes [m]: `size` in [fem]
/// for finite elements that have their own, else in [mesh]. Nothing where refinements alone need more.
std::optional<double> find_size_that_fits(const input::Case& data, input::Method method, double free);

/// Throws InputError, at the key of the element size, where a mesh needs more memory than is free, with the size that
/// fits.
void refuse_above_memory(const input::LoadedCase& loaded);

}  // namespace talus::run
