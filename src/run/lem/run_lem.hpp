// SPDX-License-Identifier: MIT
#pragma once
// Limit equilibrium on a case: the search, and surfaces of the user's choice.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ground/seepage_results.hpp"
#include "input/case/case.hpp"
#include "lem/search/search.hpp"
#include "results/slices.hpp"

namespace talus::run {

/// The slope of a case, ready for any surface.
struct PreparedSlope {
  std::shared_ptr<const lem::Slope> slope;
  std::vector<std::string> notes;  ///< of make_section()
  ground::WaterResult water;       ///< likewise
};
/// Throws what make_section() and lem::Slope do.
PreparedSlope prepare_slope(const input::Case& data);

/// The settings of [lem] for the search.
lem::SearchOptions make_search_options(const input::LimitEquilibrium& settings, int threads);

/// A surface of [[lem.surface]]. Throws Error (wrong_input) when it does not cut the ground, naming it.
lem::Surface make_surface(const lem::Slope& slope, const input::SlipSurface& given);

/// A surface by one method with its forces. Where the checks refuse it, the factor is kept and the reason is a warning;
/// the factor is 0 only where there is none.
lem::Critical solve_surface(const lem::Slope& slope, const lem::Surface& surface, lem::Method method,
                            const lem::SearchOptions& options);

/// What slices found, and the trials of the search where there was one.
struct SliceOutcome {
  results::SliceResult result;
  std::optional<results::SliceTrials> trials;
};

/// Throws Error (wrong_input) when no surface is admissible.
SliceOutcome run_lem(const input::Case& data, const PreparedSlope& prepared, int threads);

/// The direction of an earthquake in which the least circle by Bishop's method slides; nothing where there is no
/// section or no admissible circle.
std::optional<input::EarthquakeDirection> find_weaker_direction(const input::Case& data, int threads);

}  // namespace talus::run
