// SPDX-License-Identifier: MIT
#pragma once
// The methods beside one another: factors, surfaces, surfaces of one method handed to another.

#include <filesystem>

#include "input/case/case.hpp"
#include "lem/section/slope.hpp"
#include "results/run.hpp"

namespace talus::run {

/// From the results of the methods in `run`. `slope`: for surfaces that are handed to slices; may be nullptr.
/// `folder`: results of material points.
results::MethodComparison compare_methods(const input::Case& data, const lem::Slope* slope,
                                          const results::RunResult& run, const std::filesystem::path& folder,
                                          int threads);

/// Name of the surface along the band of shear strain: "fem.band", "fem.associated.band".
const char* name_band(results::Flow flow);

/// "ψ = φ", "ψ = 0°", "ψ as given" of a strength reduction by finite elements.
std::string describe_flow(const results::ElementRun& run);

}  // namespace talus::run
