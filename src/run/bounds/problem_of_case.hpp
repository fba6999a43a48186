// SPDX-License-Identifier: MIT
#pragma once
// A case as limit analysis sees it.

#include <string>
#include <vector>

#include "bounds/problem.hpp"
#include "ground/tell_seepage.hpp"
#include "input/case/case.hpp"

namespace talus::run {

struct ProblemOfCase {
  bounds::Problem problem;
  ground::WaterResult water;         ///< that pore pressures are from
  std::vector<std::string> notes;  ///< what the bounds cannot take from the case as it is, in sentences
};

/// What holds the section.
enum class Supports {
  as_given,   ///< [[boundary]]
  below_soil  ///< base and ends of the section fixed, the ground free: as methods of slices assume
};

/// The first mesh, with strength, weight, pore pressures, loads and supports. Pore pressures of steady seepage are
/// calculated on this mesh. Throws Error (wrong_input) for a material, a boundary or a load that limit analysis does
/// not have; what mesh::generate() and find_held_water() throw.
ProblemOfCase make_bounds_problem(const input::Case& data, Supports supports = Supports::as_given);

/// Throws Error (wrong_input) for what make_bounds_problem() refuses, without a mesh.
void check_bounds(const input::Case& data);

}  // namespace talus::run
