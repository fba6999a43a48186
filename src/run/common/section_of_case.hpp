// SPDX-License-Identifier: MIT
#pragma once
// The section of a case for LEM: ground, soils, water and loads.

#include <string>
#include <vector>

#include "lem/section/section.hpp"
#include "mesh/mesh.hpp"
#include "site/seepage_results.hpp"
#include "site/site.hpp"

namespace talus::run {

struct SectionOfCase {
  lem::Section section;
  std::vector<std::string> notes;  ///< sentences on what LEM does not take from the case
  site::WaterResult water;         ///< origin of the pore pressures
};

/// Makes ground, soils, water and loads of a plane case of polygons whose soils LEM accepts. Pore pressures of steady
/// seepage are computed on the mesh of the case. Throws Error (wrong_input) if the ground has gaps or overhangs, and
/// what find_initial_water() throws.
SectionOfCase make_section(const site::Site& site);

/// Sets the pore pressures of a section to those at the nodes of `mesh`, positive in tension [Pa], with the water
/// standing on the ground at `time` [s] and the unit weights that follow.
void set_pressures(const site::Site& site, const mesh::Mesh<2>& mesh, const std::vector<double>& pressure, double time,
                   lem::Section& section);

/// Returns warnings of faults of ground and water that affect every method.
std::vector<std::string> list_ground_warnings(const input::Case& data);

}  // namespace talus::run
