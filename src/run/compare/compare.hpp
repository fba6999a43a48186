// SPDX-License-Identifier: MIT
#pragma once
// The results of the methods side by side: table, slip surfaces of one method evaluated by another, sentences on the
// differences, and warnings on strong disagreement.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "lem/section/slope.hpp"
#include "results/run.hpp"

namespace talus::run {

// Comparison of the methods: factors, surfaces, and surfaces of one method evaluated by another.

/// Compares the results of the methods in `run`. `slope` evaluates surfaces by LEM; it may be nullptr. `folder` has
/// the results of MPM.
results::MethodComparison compare_methods(const input::Case& data, const lem::Slope* slope,
                                          const results::RunResult& run, const std::filesystem::path& folder,
                                          int threads);

/// Name of the surface along the shear band: "fem.band", "fem.associated.band".
const char* name_band(results::Flow flow);

/// "ψ = φ", "ψ = 0°", "ψ as given" of a strength reduction by FEM.
std::string describe_flow(const results::ElementRun& run);

// Sentences on the differences between the methods.

/// Returns sentences that each state a measurement of this case; causes are named only if the numbers show them. The
/// sources are the results of the methods in `run`, and their table, surfaces and exchanged surfaces in `methods`.
std::vector<results::Remark> read_differences(const input::Case& data, const results::RunResult& run,
                                              const results::MethodComparison& methods);

/// Returns true if a soil with friction has ψ < φ, for which the bound theorems do not hold.
bool is_nonassociated(const input::Case& data);

/// Returns why factors outside the interval of limit analysis are not judged, as a clause; nullopt: they are.
std::optional<std::string> find_judging_obstacle(const input::Case& data);

// Warnings on large differences between factors: of circles and polylines, of the methods, and of the criteria of one
// method; and sentences on the referee of LEM.

/// Returns warnings, the most important first; each names the factors, their likely cause and a remedy. `methods`: the
/// comparison of `run`.
std::vector<std::string> warn_of_disagreement(const input::Case& data, const results::RunResult& run,
                                              const results::MethodComparison& methods);

/// Returns sentences on the interval of limit analysis and on LEM factors outside it; empty without LEM. `governing`:
/// the factor of the governing surface.
std::vector<std::string> read_referee(const input::Case& data, const results::RunResult& run,
                                      std::optional<double> governing);

}  // namespace talus::run
