// SPDX-License-Identifier: MIT
#pragma once
// Lines along which strength or pore pressure of a soil bends or jumps: levels of strengths, water tables, the
// verticals below the vertices of these, and depths of roots.

#include <vector>

#include "mesh/plan.hpp"
#include "mesh/planar.hpp"
#include "site/site.hpp"

namespace talus::run {

/// Lines for a mesh leave out what does not repay its triangles: bends of less than 5 %, arcs but for a few chords, and
/// vertices of a dense water table. `every` leaves out nothing.
enum class KinkDetail { meshed, every };

/// Returns the lines of a soil, some beyond its regions, without the breaks of σ'_v that SoilColumns lists. `plan`:
/// box, named lines and element size of the mesh.
std::vector<mesh::Polyline> list_kinks(const site::Site& site, const mesh::Plan& plan, const input::Material& soil,
                                       KinkDetail detail);

}  // namespace talus::run
