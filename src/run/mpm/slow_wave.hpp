// SPDX-License-Identifier: MIT
#pragma once
// Warnings of a stage on its inertia and its water: mass scaling that delays the motion, a Darcy (u–p) formulation
// where the inertia of the water matters, and excess pore pressure that carries the weight.

#include <optional>
#include <string>

#include "run/mpm/stage.hpp"

namespace talus::run {

/// Times of a stage that mass scaling must leave apart (theory 5).
struct DrainedWave {
  double crossing = 0;  ///< of the soil's height by a compression wave of drained soil, H √(βρ/E_c) [s]
  std::optional<double> drainage{};  ///< H²/c_v of the soil that drains fastest, where water flows [s]
};

/// Of the body as it stands at the start of the stage.
template <int D>
DrainedWave find_drained_wave(const mpm::Body<D>& body, const StagePlan<D>& plan);

/// "stage 'rain': with mass_scaling = 1e+08 …", with the mass scaling that would do; nothing where the soil keeps up.
template <int D>
std::optional<std::string> describe_slow_wave(const mpm::Body<D>& body, const StagePlan<D>& plan);

/// "stage 'rain': water = "seeps" leaves …"; nothing where no soil is so open that its water has an inertia of its own.
template <int D>
std::optional<std::string> describe_fast_water(const mpm::Body<D>& body, const StagePlan<D>& plan);

/// What pore water and grains carry, as means over the volume of the wet points, positive in compression [Pa].
struct CarriedWeight {
  double water = 0;   ///< pore pressure
  double grains = 0;  ///< vertical effective stress
};

template <int D>
CarriedWeight find_carried_weight(const mpm::Body<D>& body);

/// "stage 'gravity': …" where water carries a noticeable part of the weight that the stage brought on: soil at rest
/// that is not in its effective stresses. `before`: at the start of the stage. Nothing where the weight is drained.
template <int D>
std::optional<std::string> describe_undrained_weight(const mpm::Body<D>& body, const std::string& stage,
                                                     const CarriedWeight& before);

}  // namespace talus::run
