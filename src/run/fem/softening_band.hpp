// SPDX-License-Identifier: MIT
#pragma once
// Warnings on progressive failure in FEM: its result depends on the mesh without a nonlocal length, or with elements
// that are too large for it.

#include <optional>
#include <string>

#include "fem/solid/solid.hpp"
#include "input/case/case.hpp"

namespace talus::run {

/// Returns a warning if soil that softens has no nonlocal length, or if its elements in the mechanism are too large for
/// it. `motion`: ReductionResult::mechanism.
template <int D>
std::optional<std::string> describe_soft_band(const input::Case& data, const mesh::Mesh<D>& mesh,
                                              const fem::QuadraticMesh<D>& quadratic, const fem::SolidState<D>& motion);

}  // namespace talus::run
