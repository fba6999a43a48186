#pragma once
// The methods beside one another: factors, surfaces, surfaces of one method handed to another.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "input/case/case.hpp"
#include "lem/section/slope.hpp"

namespace talus::run {

/// "methods" of summary.json, from what the methods have written into it (lem, fem, factor_of_safety, curve, timing).
/// `slope`: for surfaces that are handed to slices; may be nullptr. `folder`: results of material points.
nlohmann::json compare_methods(const input::Case& data, const lem::Slope* slope, const nlohmann::json& summary,
                               const std::filesystem::path& folder, int threads);

/// The factor that stands for the case: that of material points, else of finite elements (ψ as given), else the
/// smallest of the rigorous methods of slices, else of any. 0: none.
double find_main_factor(const nlohmann::json& summary);

}  // namespace talus::run
