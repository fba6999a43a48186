// SPDX-License-Identifier: MIT
#pragma once
// The section of a run or of a case as a drawing: soils, ground, water, and the slip surfaces of all methods.

#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "input/case/case.hpp"
#include "report/folder/result_folder.hpp"

namespace talus::exports {

struct SectionDrawing {
  drawing::NewDrawing drawing;
  std::vector<std::string> remarks;  ///< what the section does not have
};

/// Draws a run in `unit` of length; empty: that of its results. Every soil has a layer with the outlines of its
/// regions and their names. Throws Error (wrong_input) for a study, for element tests, in 3D, and without polygons.
SectionDrawing draw_run(const report::ResultFolder& folder, const std::string& unit);

/// Draws soils, ground, and water at rest of a case. Throws as draw_run().
SectionDrawing draw_case(const input::Case& data, const std::string& name, const std::string& unit);

}  // namespace talus::exports
