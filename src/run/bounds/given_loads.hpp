// SPDX-License-Identifier: MIT
#pragma once
// The loads of a limit analysis against those of the case: a certificate of another problem proves nothing.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "ground/plane_water.hpp"
#include "input/case/case.hpp"

namespace talus::run {

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
