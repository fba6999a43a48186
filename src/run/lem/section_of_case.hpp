// SPDX-License-Identifier: MIT
#pragma once
// The section of a case for LEM: ground, soils, water and loads.

#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "lem/section/section.hpp"
#include "mesh/mesh.hpp"
#include "site/seepage_results.hpp"

namespace talus::run {

struct SectionOfCase {
  lem::Section section;
  std::vector<std::string> notes;  ///< sentences on what LEM does not take from the case
  site::WaterResult water;         ///< origin of the pore pressures
};

/// Makes ground, soils, water and loads of a plane case. Pore pressures of steady seepage are computed on the mesh of
/// the case. Throws Error (wrong_input) if the case is not plane or has no polygons, if the ground has gaps or
/// overhangs, or if a soil has no friction angle and cohesion; and what find_initial_water() throws.
SectionOfCase make_section(const input::Case& data);

/// Sets the pore pressures of a section to those at the nodes of `mesh`, positive in tension [Pa], with the water
/// standing on the ground at `time` [s] and the unit weights that follow.
void set_pressures(const input::Case& data, const mesh::Mesh<2>& mesh, const std::vector<double>& pressure, double time,
                   lem::Section& section);

}  // namespace talus::run
