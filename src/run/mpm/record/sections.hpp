// SPDX-License-Identifier: MIT
#pragma once
// Sections: the fields of the stored frames along a line, as tables.

#include <filesystem>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "output/files/frame.hpp"
#include "results/motion.hpp"
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

}  // namespace talus::run
