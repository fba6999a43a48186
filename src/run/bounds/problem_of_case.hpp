// SPDX-License-Identifier: MIT
#pragma once
// A case as limit analysis sees it.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "bounds/problem.hpp"
#include "ground/initial_water.hpp"
#include "ground/seepage_results.hpp"
#include "input/case/case.hpp"

namespace talus::run {

struct ProblemOfCase {
  bounds::Problem problem;
  ground::WaterResult water;       ///< that pore pressures are from
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

// The loads of a limit analysis against those of the case: a certificate of another problem proves nothing.

/// A side of the ground, and the traction that surcharges and standing water have there in the programs.
struct LoadedSide {
  Vec<2> from{}, to{};               ///< the soil is on the left of the way
  std::array<Vec<2>, 2> traction{};  ///< at both ends, linear between them [Pa]
};

/// Evaluates surcharges and water of the case at places of each side, without the mesh. A sentence with the place where
/// the traction differs most; nothing where all are the same but for rounding.
std::optional<std::string> find_wrong_load(const input::Case& data, const std::vector<ground::Pond>& ponds,
                                           const ground::Polyline& table, const std::vector<LoadedSide>& sides);

}  // namespace talus::run
