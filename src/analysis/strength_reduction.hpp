#pragma once
// The factor of safety of a case by every criterion that it asks for.

#include <vector>

#include "analysis/leg.hpp"
#include "analysis/summary.hpp"

namespace talus::analysis {

/// Frozen-geometry factor on the case's mesh and one of half its size: stages and trials at frozen geometry.
/// `base` is the case's own mesh. Adds to `warnings` what the user must know.
template <int D>
FrozenResult compute_frozen_factor(const model::Case& data, const mesh::Mesh<D>& base, const TrialContext& context,
                                   int threads, std::vector<std::string>& warnings);

/// Runs what [strength_reduction] asks for and puts curve, criteria, runouts and the frozen factor into `summary`.
/// `state` is the body after the stages; it is not needed, and may be empty, when the curve is not asked for.
template <int D>
void reduce_strength(const mpm::Body<D>& state, const TrialContext& context, double slope_height, int threads,
                     nlohmann::json& summary, std::vector<std::string>& warnings);

}  // namespace talus::analysis
