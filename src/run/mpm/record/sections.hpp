// SPDX-License-Identifier: MIT
#pragma once
// Sections: the fields of the stored frames along a line, as tables.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "mpm/body/body.hpp"
#include "output/files/frame.hpp"
#include "results/bounds.hpp"
#include "results/runout.hpp"
#include "results/trial.hpp"

namespace talus::run {

/// A column of a section's table.
struct SectionColumn {
  std::string name;  ///< "stress_xx"
  std::string unit;  ///< SI
};

/// One part of the line.
struct SectionRow {
  double distance = 0;               ///< from `from`, mean of its points weighted by volume [m]
  std::array<double, 3> position{};  ///< on the line [m]
  int points = 0;
  std::vector<double> values;  ///< [column]; NaN where no point has a value
};

/// Every component of every point field of a frame, without those that a plane has not.
std::vector<SectionColumn> list_section_columns(const output::Frame& frame, int dimension);

/// The line is cut into parts of length `width`; each has the means, weighted by volume, of the points that lie within
/// half a width from it [m]. Parts without points have no row.
std::vector<SectionRow> cut_section(const output::Frame& frame, const input::SectionLine& section, int dimension,
                                    double width);

/// sections/NAME.csv in `folder` for every section of the case: all stored frames, of two at one time the later one.
/// `size`: width of sections that state none [m]. Where displacements are counted from the start of the clock, those of
/// the frame at that time, which is from before they were set to zero, are zero. Returns what was written; empty when
/// there are no sections or no frames.
std::vector<results::SectionLine> write_sections(const input::Case& data, const std::vector<results::Stage>& stages,
                                                 double size, const std::filesystem::path& folder);

// The slip line of material points: the lower limit of the soil that moved.

/// Share of the largest displacement that soil of a slide has moved at least [-].
inline constexpr double moved_share = 0.25;

/// A section as its points lay before the motion, and how far they moved.
struct MovedSection {
  std::vector<std::array<double, 2>> positions;  ///< [m]
  std::vector<double> displacement;              ///< its length [m]
  std::vector<double> across;                    ///< its part towards larger x [m]
  double spacing = 0;                            ///< mean distance of the points [m]
};

/// The lower limit of the soil that moved.
struct MovedLimit {
  std::vector<std::array<double, 2>>
      line;                              ///< from left to right [m]; empty: none. Of two sides the one with more soil
  std::vector<results::SideLine> sides;  ///< to smaller and to larger x; empty: the soil moves one way
};

/// The lower limit of the soil that moved by more than `threshold` [m], from left to right: for each column the height
/// that separates best the moved soil from the rest, with the fewest points on the wrong side; the longest stretch of
/// such columns, smoothed. Empty where fewer than six stand side by side. Where the soil moves to both sides
/// (find_divide()), each has a limit of its own. Of sides that move apart it goes on from the divide to the ground, as
/// steep as an active wedge.
MovedLimit find_moved_limit(const MovedSection& section, double threshold);

/// The same of a body at frozen geometry, whose points have not moved in space; soil that moved by moved_share of the
/// largest displacement.
MovedLimit find_frozen_limit(const mpm::Body<2>& body);

}  // namespace talus::run
