// SPDX-License-Identifier: MIT
#pragma once
// FEM equilibrium of a case under its given strength: whether the slope is stable, and the initial stress of MPM
// ([initial] stress = "elements").

#include <memory>

#include "fem/solid/solid.hpp"
#include "input/case/case.hpp"
#include "results/run.hpp"

namespace talus::run {

/// Tolerances and limits of [fem].
fem::SolidOptions make_solid_options(const input::FiniteElements& settings, int threads);

struct Balance {
  bool stands = false;
  bool undecided = false;  ///< no equilibrium was found, but the iterations ended before the soil flowed
};

/// Returns whether quadratic triangles on the MPM mesh find equilibrium with weight, water and loads of the case and
/// its given strength. Throws what make_solid() throws.
Balance find_balance(const input::Case& data, int threads);

/// Returns stress and plastic strain of that equilibrium. If there is none, the strength is multiplied by the least
/// factor that has one, to 1 %. On the MPM mesh the stress is in equilibrium as well: linear shape functions are a
/// subset of the quadratic ones, and the internal force of a linear triangle depends on its mean stress only. Throws
/// Error (wrong_input) if no strength gives equilibrium, and what make_solid() throws.
std::shared_ptr<const input::KnownStress> find_start_stress(const input::Case& data, int threads,
                                                            results::StressStart& summary);

}  // namespace talus::run
