// SPDX-License-Identifier: MIT
#pragma once
// Forecast of a run before it starts: elements, points, memory, steps and time by each method.

#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "input/read.hpp"

namespace talus::run {

// The speed of this machine for a case is measured by a short run on a coarse mesh.

struct StagePace {
  double step = 0;         ///< time step on the mesh of the case [s]
  double point_steps = 0;  ///< steps of one point per second on one thread
};

struct Pace {
  std::vector<StagePace> stages;
  StagePace curve;   ///< of the trials of the displacement curve
  StagePace frozen;  ///< of the trials at frozen geometry on the mesh of the case
};

/// Measures the speed in some tenths of a second. Returns nullopt for a case that cannot be prepared quickly (a
/// result, a season), that runs a user's library, or that has a mesh from a file; and for one that cannot be prepared,
/// for which the run itself reports the reason.
std::optional<Pace> probe(const input::Case& data);

/// Largest requirements of one method; zero if unknown.
struct MethodForecast {
  input::Method method = input::Method::mpm;
  double elements = 0;  ///< of its largest mesh
  double points = 0;    ///< material points on it
  double surfaces = 0;  ///< trial surfaces of LEM
  double bytes = 0;
  double steps = 0;         ///< time steps of all stages and trials
  double seconds = 0;       ///< typical for such cases, on this machine
  double most_seconds = 0;  ///< if no stage or trial ends early, and the last mesh is needed
  double times = 0;         ///< of a timeline
  double size = 0;          ///< general element size of that mesh [m]
  int dimension = 2;
};

/// Returns one forecast for each method of the case. With `with_time`, steps and time of MPM are measured by a short
/// run.
std::vector<MethodForecast> forecast(const input::Case& data, bool with_time);

/// "about 18,000 slip surfaces, a second".
std::string describe(const MethodForecast& forecast);

/// "a second", "12 minutes".
std::string write_time(double seconds);

/// Time of a LEM sample on the surfaces stored for all samples [s].
double find_sample_seconds(const input::LimitEquilibrium& lem);

/// Returns the smallest element size [m], to two digits, for which a method needs at most `free` bytes: `size` in
/// [fem] for FEM with its own size, otherwise in [mesh]. Returns nullopt if refinements alone need more.
std::optional<double> find_size_that_fits(const input::Case& data, input::Method method, double free);

/// Throws InputError, at the key of the element size and with the size that fits, if a mesh needs more memory than is
/// free.
void refuse_above_memory(const input::LoadedCase& loaded);

}  // namespace talus::run
