// SPDX-License-Identifier: MIT
#pragma once
// Results so far of a run in progress, in a folder of its own within that of the run: summary.json and the files of
// the method that is being calculated. The folder is removed when the run ends.

#include <optional>
#include <string>
#include <vector>

#include "results/elements.hpp"

namespace talus::results {

inline constexpr const char* present_folder = "present";
inline constexpr const char* present_reduction_file = "present/fem.json";
inline constexpr const char* present_bounds_file = "present/bounds.json";
inline constexpr const char* present_summary_file = "present/summary.json";

/// The strength reduction in progress, with the fields of its last trial.
struct PresentReduction {
  std::string title;                     ///< such as "ψ as given, coarse mesh"
  std::optional<double> stable, failed;  ///< nullopt: no such trial yet
  std::vector<ElementTrial> trials;      ///< in their sequence
  ElementMesh mesh;
};
void describe(Visitor& v, PresentReduction& r);

}  // namespace talus::results
