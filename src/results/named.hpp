// SPDX-License-Identifier: MIT
#pragma once
// Results under the names that [[compare]], studies and Python use, such as "runout[1.75].front_advance".

#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"

namespace talus::results {

enum class ResultKind { factor, yield_acceleration, over_design, runout, motion, stage, mesh, water, seepage, other };
template <>
inline constexpr auto words<ResultKind> = std::array{
    "factor", "yield_acceleration", "over_design", "runout", "motion", "stage", "mesh", "water", "seepage", "other"};

struct NamedValue {
  std::string name;   ///< "runout[1.75].moved_volume"
  std::string title;  ///< "moved volume, runout at SRF 1.75"
  std::string unit;   ///< SI, as a UDUNITS symbol; empty if dimensionless
  ResultKind kind = ResultKind::other;
  std::string quantity;           ///< "moved_volume"
  std::optional<SliceMethod> by;  ///< method of slices, for factors and yield accelerations of LEM
  double value = 0;               ///< [unit]
  /// of a runout: with the value on a coarser mesh
  std::optional<Estimate> estimate = {};
  bool is_determined() const { return !estimate || estimate->is_determined(); }
};

/// Returns all numbers of `run` in the order of the report, except the displacements of single trials. `dimension` is
/// that of the section; results of a plane section are per metre of thickness.
std::vector<NamedValue> list_values(const RunResult& run, int dimension);

/// Returns true if two names refer to the same result. Times in names of the timeline may be rounded:
/// `timeline.factor[1110093]` matches a time within a relative tolerance of 1e-6.
bool is_same_result(const std::string& known, const std::string& asked);

/// Returns the result `name`, or nullopt if the run did not produce it.
std::optional<NamedValue> find_named(const RunResult& run, const std::string& name);

/// Returns the result `name` [SI], or nullopt if the run did not produce it or does not determine it.
std::optional<double> find_value(const RunResult& run, const std::string& name);

/// Returns why the value is not determined, with its unit in SI; empty if it is.
std::string explain_undetermined(const NamedValue& value);

/// Displacement at a factor of the displacement curve, interpolated linearly if no trial has this factor.
struct CurveValue {
  std::optional<double> displacement;  ///< [m]
  std::string note;                    ///< the trials of the interpolation; empty if a trial has this factor
};
CurveValue find_displacement(const RunResult& run, double factor);

}  // namespace talus::results
