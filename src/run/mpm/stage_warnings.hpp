// SPDX-License-Identifier: MIT
#pragma once
// What moves at the end of a stage that should have come to rest, and what is said of it and of setbacks.

#include <optional>
#include <string>

#include "input/case/case.hpp"
#include "mpm/body/body.hpp"
#include "results/trial.hpp"
#include "run/mpm/stage.hpp"

namespace talus::run {

/// The material of the point nearest to `x` [m]; "unknown" where no point is left.
template <int D>
std::string find_nearest_material(const mpm::Body<D>& body, const std::type_identity_t<Vec<D>>& x);

/// What moves, from the last step that was monitored.
template <int D>
results::MovingSoil find_moving_soil(const mpm::Body<D>& body);

/// "stage 'slide' did not come to rest within 40 s: …", with what to do.
std::string describe_restless(const input::Stage& stage, const results::Stage& report);

/// "stage 'slide' became unstable at t = 3 s: …", with how it was calculated instead and what to do. `what`: "stage
/// 'slide'".
std::string describe_setback(const std::string& what, const results::Retry& setback);

// What a stage says of a band in which soil has softened: where it is as thick as an element, the mesh decides.

/// Where soil that softens has sheared and dilated most.
struct SoftBand {
  double thickness = 0;  ///< in elements
  double size = 0;       ///< of these: the side of the square that two of them fill, or the cube that six do [m]
};

/// Nothing where no such soil has.
template <int D>
std::optional<SoftBand> find_soft_band(const mpm::Body<D>& body);

/// The same hooks, with a look at the band at each output: its state gets the thinnest band of the stage and its
/// largest elements.
template <int D>
StageHooks<D> watch_bands(const mpm::Body<D>& body, StageHooks<D> hooks);

/// "soil that softens ('loess') sheared in a band of 1.4 elements …", with what to do, of what a stage has seen.
/// `length`: mesh.softening_length [m]. Nothing where the band is thicker than elements make it or, with a length,
/// where these are at most half as large.
template <int D>
std::optional<std::string> describe_narrow_band(const mpm::Body<D>& body, const StageState& state,
                                                std::optional<double> length);

// Warnings of a stage on its inertia and its water: mass scaling that delays the motion, a Darcy (u–p) formulation
// where the inertia of the water matters, and excess pore pressure that carries the weight.

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
