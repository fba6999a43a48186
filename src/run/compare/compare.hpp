// SPDX-License-Identifier: MIT
#pragma once
// Comparison of the methods: factors, surfaces, and surfaces of one method evaluated by another.

#include <filesystem>

#include "input/case/case.hpp"
#include "lem/section/slope.hpp"
#include "results/run.hpp"

namespace talus::run {

/// Compares the results of the methods in `run`. `slope` evaluates surfaces by LEM; it may be nullptr. `folder` has
/// the results of MPM.
results::MethodComparison compare_methods(const input::Case& data, const lem::Slope* slope,
                                          const results::RunResult& run, const std::filesystem::path& folder,
                                          int threads);

/// Name of the surface along the shear band: "fem.band", "fem.associated.band".
const char* name_band(results::Flow flow);

/// "ψ = φ", "ψ = 0°", "ψ as given" of a strength reduction by FEM.
std::string describe_flow(const results::ElementRun& run);

}  // namespace talus::run
