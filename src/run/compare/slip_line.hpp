// SPDX-License-Identifier: MIT
#pragma once
// Slip lines of finite elements and material points as surfaces for slices.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ground/ground_line.hpp"
#include "input/case/case.hpp"
#include "lem/section/slope.hpp"
#include "lem/surface/surface.hpp"
#include "results/run.hpp"

namespace talus::run {

/// The slip line of a run by material points, and where it is from.
struct PointsSlipLine {
  ground::Polyline line;                 ///< empty: none
  std::vector<results::SideLine> sides;  ///< where the soil moves to both: their lines; empty: it moves one way
  double factor = 0;                     ///< that the strength was divided by
  std::string source;
};

/// From the trial at frozen geometry that failed with the smallest factor; else from the trial of the displacement
/// curve whose largest displacement first reaches the share of the slope's height that counts as failure; of a run
/// without strength reduction from its last frame.
PointsSlipLine find_points_slip_line(const input::Case& data, const results::RunResult& run,
                                     const std::filesystem::path& folder);

/// A line made into a surface: from left to right without turning back, its ends extended to the ground, with
/// few vertices. Nothing when it does not enclose soil.
std::optional<lem::Surface> make_surface(const lem::Slope& slope, const ground::Polyline& line);

/// Largest distance of a point of `a` from the line `b` and the other way round [m].
double find_distance(const ground::Polyline& a, const ground::Polyline& b);
/// Mean of the same over the shorter one [m].
double find_mean_distance(const ground::Polyline& a, const ground::Polyline& b);

}  // namespace talus::run
