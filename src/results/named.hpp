#pragma once
// Results by the names that [[compare]], studies and Python call them by: "runout[1.75].front_advance".

#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"

namespace talus::results {

/// A result that a run came to [SI].
struct NamedValue {
  std::string name;
  double value = 0;
};

/// All results that the run came to, but the displacements of single trials.
std::vector<NamedValue> list_values(const RunResult& run);

/// The displacement at a factor of the curve, interpolated between its neighbours where no trial has that factor.
struct CurveValue {
  std::optional<double> displacement;  ///< [m]
  std::string note;                    ///< between which trials it was interpolated; empty: it was calculated
};
CurveValue find_displacement(const RunResult& run, double factor);

}  // namespace talus::results
