// SPDX-License-Identifier: MIT
#pragma once
// What a run will need, before it begins: elements, points, memory, steps and time by each method.

#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "input/read.hpp"
#include "mesh/plan.hpp"

namespace talus::run {

// How many elements a mesh will have, before it is made.

struct ElementCount {
  double all = 0, soil = 0;
};

/// Elements of a plan in its box and in its polygons, as the mesher makes them: as many as regular ones of the asked
/// size. Refinements are integrated over a grid of 200 by 200 places. Zero for a ready mesh.
ElementCount count_elements(const mesh::Plan& plan);

/// Smallest element size that the plan asks for [m].
double find_smallest_size(const mesh::Plan& plan);

/// Returns true where a coarse mesh of the section takes about a second. Gmsh takes minutes for thousands of corners
/// that lie nearer together than the elements are large.
bool is_meshed_in_a_moment(const mesh::Plan& plan);

// How fast this machine steps the soil of a case, found by stepping it for a moment on a coarse mesh.

struct StagePace {
  double step = 0;         ///< time step on the case's own mesh [s]
  double point_steps = 0;  ///< steps of one point in a second on one thread
};

struct Pace {
  std::vector<StagePace> stages;
  StagePace curve;   ///< of the trials of the displacement curve
  StagePace frozen;  ///< of those at frozen geometry on the case's mesh
};

/// Takes some tenths of a second. Nothing for a case whose start is not made in a moment (a result, a season), that
/// runs a user's library or that has a ready mesh, and for one that cannot be prepared: the run itself says why.
std::optional<Pace> probe(const input::Case& data);

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
