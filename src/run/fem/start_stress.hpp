// SPDX-License-Identifier: MIT
#pragma once
// Finite elements in equilibrium: whether a case stands with the strength that it has, and the stress that material
// points begin with ([initial] stress = "elements").

#include <memory>

#include "fem/solid/solid.hpp"
#include "input/case/case.hpp"
#include "results/run.hpp"

namespace talus::run {

/// Tolerances and limits of [fem].
fem::SolidOptions make_solid_options(const input::FiniteElements& settings, int threads);

struct Balance {
  bool stands = false;
  bool undecided = false;  ///< none was found, but the iterations ran out before the soil flowed
};

/// Whether quadratic triangles on the mesh of the material points find equilibrium with weight, water and loads of the
/// case and its strength as given. Throws what make_solid() throws.
Balance find_balance(const input::Case& data, int threads);

/// Stress and plastic strain of that equilibrium. Where there is none, the strength is multiplied by the least factor
/// that has one, to a hundredth. On the points' own mesh the stress is in equilibrium there as well: linear shape
/// functions are among the quadratic ones, and a linear triangle feels the mean stress alone. Throws Error
/// (wrong_input) where no strength gives equilibrium, and what make_solid() throws.
std::shared_ptr<const input::KnownStress> find_start_stress(const input::Case& data, int threads,
                                                            results::StressStart& summary);

}  // namespace talus::run
