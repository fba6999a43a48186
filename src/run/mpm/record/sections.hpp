// SPDX-License-Identifier: MIT
#pragma once
// Sections: fields of the stored frames along a line, as tables; and the slip line of an MPM run, which is the lower
// limit of the soil that moved.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "mpm/state/body.hpp"
#include "output/files/frame.hpp"
#include "results/bounds.hpp"
#include "results/runout.hpp"
#include "results/trial.hpp"

namespace talus::run {

struct SectionColumn {
  std::string name;  ///< "stress_xx"
  std::string unit;  ///< SI
};

/// One interval of the line.
struct SectionRow {
  double distance = 0;               ///< from `from`, mean of its points weighted by volume [m]
  std::array<double, 3> position{};  ///< on the line [m]
  int points = 0;
  std::vector<double> values;  ///< [column]; NaN where no point has a value
};

/// Lists every component of every point field of a frame, without the out-of-plane components of plane strain.
std::vector<SectionColumn> list_section_columns(const output::Frame& frame, int dimension);

/// Averages the points along a line, which is divided into intervals of length `width` [m]. Each row has the means,
/// weighted by volume, of the points within half a width of the line. Intervals without points have no row.
std::vector<SectionRow> cut_section(const output::Frame& frame, const input::SectionLine& section, int dimension,
                                    double width);

/// Writes sections/NAME.csv in `folder` for every section of the case: all stored frames, of two at the same time the
/// later one. `size`: width of sections that have none [m]. If displacements are relative to the start of the clock,
/// those of the frame at that time, which was written before they were set to zero, are zero. Returns the sections
/// written; empty without sections or frames.
std::vector<results::SectionLine> write_sections(const input::Case& data, const std::vector<results::Stage>& stages,
                                                 double size, const std::filesystem::path& folder);

/// Least displacement of the sliding soil, as a fraction of the largest displacement [-].
inline constexpr double moved_share = 0.25;

/// A section by the positions of its points before the motion, and their displacements.
struct MovedSection {
  std::vector<std::array<double, 2>> positions;  ///< [m]
  std::vector<double> displacement;              ///< magnitude [m]
  std::vector<double> across;                    ///< component towards larger x [m]
  double spacing = 0;                            ///< mean distance of the points [m]
};

struct MovedLimit {
  std::vector<std::array<double, 2>>
      line;  ///< from left to right [m]; empty: none. With two sides, that of the side with more soil
  std::vector<results::SideLine> sides;  ///< towards smaller and larger x; empty: the soil moves to one side
};

/// Returns the slip line from left to right, the lower limit of the soil that moved by more than `threshold` [m]. In
/// each column it is the height that best separates moved from unmoved soil, with the fewest points on the wrong side;
/// of these columns the longest stretch is smoothed. Empty if fewer than six columns are adjacent. If the soil moves
/// to both sides (find_divide()), each side has its own limit. If the sides move apart, the limit continues from the
/// divide up to the ground at the inclination of an active wedge.
MovedLimit find_moved_limit(const MovedSection& section, double threshold);

/// Returns the same limit of a body at frozen geometry, whose points keep their positions, for the soil that moved by
/// moved_share of the largest displacement.
MovedLimit find_frozen_limit(const mpm::Body<2>& body);

}  // namespace talus::run
