// SPDX-License-Identifier: MIT
#pragma once
// A case as the methods of slices see it.

#include <string>
#include <vector>

#include "ground/seepage_results.hpp"
#include "input/case/case.hpp"
#include "lem/section/section.hpp"
#include "mesh/mesh.hpp"

namespace talus::run {

struct SectionOfCase {
  lem::Section section;
  std::vector<std::string> notes;  ///< what slices cannot take from the case, in sentences
  ground::WaterResult water;       ///< that pore pressures are from
};

/// Ground, soils, water and loads of a plane case. Pore pressures of steady seepage are calculated on the case's mesh.
/// Throws Error (wrong_input) when the case is not plane or has no polygons, the ground has gaps or overhangs, or a
/// soil has no friction angle and cohesion; what find_initial_water() throws.
SectionOfCase make_section(const input::Case& data);

/// Gives a section the pore pressures of the nodes of `mesh`, positive in tension [Pa], the water that stands on its
/// ground at `time` [s], and the weights that follow.
void set_pressures(const input::Case& data, const mesh::Mesh<2>& mesh, const std::vector<double>& pressure, double time,
                   lem::Section& section);

}  // namespace talus::run
