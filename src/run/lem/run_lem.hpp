// SPDX-License-Identifier: MIT
#pragma once
// LEM on a case: the search, and given surfaces.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "lem/search/search.hpp"
#include "results/slices.hpp"
#include "site/seepage_results.hpp"

namespace talus::run {

/// The slope of a case, prepared for the evaluation of surfaces.
struct PreparedSlope {
  std::shared_ptr<const lem::Slope> slope;
  std::vector<std::string> notes;  ///< of make_section()
  site::WaterResult water;         ///< of make_section()
};
/// Throws what make_section() and lem::Slope throw.
PreparedSlope prepare_slope(const site::Site& site);

/// Returns the warning of find_uplift() in the units of the section; empty without uplift.
std::string describe_uplift(const lem::Slope& slope);

/// Settings of the search from [lem].
lem::SearchOptions make_search_options(const input::Case& data, int threads);
/// Returns the path along a region, a material or a line of the case; without points if there is none of this name, or
/// its parts have gaps.
lem::Path find_path(const input::Case& data, const std::string& name);
/// Returns what restricts the slip surfaces of the search; nullopt if nothing does.
std::optional<results::SearchRestrictions> make_restrictions(const input::Case& data);
/// Returns the warning that a search is restricted to some surfaces; empty if it is not.
std::string describe_restrictions(const input::LimitEquilibrium& settings);

/// Makes a surface of [[lem.surface]]. Throws Error (wrong_input), with its name, if it does not cut the ground.
lem::Surface make_surface(const lem::Slope& slope, const input::SlipSurface& given);

/// Solves a surface by one method, with its forces. If the surface is rejected, the factor remains and the reason is a
/// warning; the factor is 0 only if there is none.
lem::Critical solve_surface(const lem::Slope& slope, const lem::Surface& surface, lem::Method method,
                            const lem::SearchOptions& options);

/// Results of LEM, and the trials of the search if there was one.
struct SliceOutcome {
  results::SliceResult result;
  std::optional<results::SliceTrials> trials;
};

/// Throws Error (wrong_input) if no surface is admissible.
SliceOutcome run_lem(const input::Case& data, const PreparedSlope& prepared, int threads);

/// Returns the direction of an earthquake for which the critical circle by Bishop's method has the smaller factor;
/// nullopt without a section or an admissible circle.
std::optional<input::EarthquakeDirection> find_weaker_direction(const input::Case& data, int threads);

}  // namespace talus::run
