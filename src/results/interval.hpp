// SPDX-License-Identifier: MIT
#pragma once
// The interval of a named result, and the method whose factor governs a run.

#include <optional>
#include <string>

#include "results/run.hpp"

namespace talus::results {

struct ResultInterval {
  std::optional<double> lower, upper;
  double resolution = 0;  ///< smaller differences between runs are not significant; 0: unknown
  std::string source;     ///< such as "limit analysis"; empty without an interval
};

/// Returns the interval of the result `name`, as in `methods.table` of summary.json: bounds of limit analysis, which
/// also hold for factors of LEM by a search; mesh and search for FEM and MPM. Empty if the run has none.
ResultInterval find_interval(const RunResult& run, const std::string& name);

/// A factor of FEM extrapolated from two meshes by more than `most_extrapolated`.
struct FarExtrapolation {
  double fraction = 0;          ///< of the factor on the finer mesh [-]
  double size = 0;              ///< of the finer elements [m]
  double lower = 0, upper = 0;  ///< interval of the factor
};

/// Returns it if FEM has the main factor: its interval then is the result, not the factor.
std::optional<FarExtrapolation> find_far_extrapolation(const RunResult& run);

/// Returns the method of the main factor, such as "lem.spencer" or "upper bound"; empty without a factor.
std::string name_main_method(const RunResult& run);

}  // namespace talus::results
