// SPDX-License-Identifier: MIT
#pragma once
// Slip lines of FEM and MPM as surfaces for LEM.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "lem/section/slope.hpp"
#include "lem/surface/surface.hpp"
#include "results/run.hpp"
#include "site/ground_line.hpp"

namespace talus::run {

/// The slip line of an MPM run, and its origin.
struct PointsSlipLine {
  site::Polyline line;                   ///< empty: none
  std::vector<results::SideLine> sides;  ///< lines of both sides; empty: the soil moves to one side
  double factor = 0;                     ///< strength reduction factor
  std::string source;
};

/// Returns the slip line of the trial at frozen geometry that failed with the smallest factor; otherwise of the trial
/// of the displacement curve whose largest displacement first reaches the failure criterion; without strength
/// reduction that of the last frame.
PointsSlipLine find_points_slip_line(const input::Case& data, const results::RunResult& run,
                                     const std::filesystem::path& folder);

/// Converts a line into a surface: from left to right without turning back, with its ends extended to the ground, and
/// few vertices. Returns nullopt if it does not enclose soil.
std::optional<lem::Surface> make_surface(const lem::Slope& slope, const site::Polyline& line);

/// Largest distance of a point of `a` from the line `b`, or of `b` from `a` [m].
double find_distance(const site::Polyline& a, const site::Polyline& b);
/// Mean distance of two lines [m]: the larger of the means over the points of `a` and over those of `b`.
double find_mean_distance(const site::Polyline& a, const site::Polyline& b);

}  // namespace talus::run
