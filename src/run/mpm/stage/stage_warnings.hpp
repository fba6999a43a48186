// SPDX-License-Identifier: MIT
#pragma once
// Warnings of a stage: motion at its end, retries, thin softening bands, mass scaling that delays the motion, the
// Darcy (u–p) formulation where the inertia of the water matters, and excess pore pressure that carries the weight.

#include <optional>
#include <string>

#include "input/case/case.hpp"
#include "mpm/state/body.hpp"
#include "results/trial.hpp"
#include "run/mpm/stage/stage.hpp"

namespace talus::run {

/// Returns the material of the point nearest to `x` [m]; "unknown" if no point is left.
template <int D>
std::string find_nearest_material(const mpm::Body<D>& body, const std::type_identity_t<Vec<D>>& x);

/// Returns the moving soil in the last monitored step.
template <int D>
results::MovingSoil find_moving_soil(const mpm::Body<D>& body);

/// "stage 'slide' did not come to rest within 40 s: …", with a remedy.
std::string describe_restless(const input::Stage& stage, const results::Stage& report, const ShownUnits& units);

/// "stage 'slide' became unstable at t = 3 s: …", with the settings of the retry and a remedy. `what`: "stage
/// 'slide'".
std::string describe_setback(const std::string& what, const results::Retry& setback);

/// Band in which softening soil has sheared and dilated most. If it is as thick as an element, the result depends on
/// the mesh.
struct SoftBand {
  double thickness = 0;  ///< in elements
  double size = 0;  ///< size of these elements: side of the square filled by two triangles, or of the cube filled by
                    ///< six tetrahedra [m]
};

/// Returns nullopt if no softening soil has sheared.
template <int D>
std::optional<SoftBand> find_soft_band(const mpm::Body<D>& body);

/// Returns the hooks with a check of the band at each output, which stores the smallest thickness of the stage and the
/// largest elements in its state.
template <int D>
StageHooks<D> watch_bands(const mpm::Body<D>& body, StageHooks<D> hooks);

/// "soil that softens ('loess') sheared in a band of 1.4 elements …", with a remedy. `length`: mesh.softening_length
/// [m]. Returns nullopt if the band is thicker than the mesh makes it or, with a nonlocal length, if the elements are
/// at most half as large as that.
template <int D>
std::optional<std::string> describe_narrow_band(const mpm::Body<D>& body, const StageState& state,
                                                std::optional<double> length, const ShownUnits& units);

/// Time scales of a stage that mass scaling must keep apart (theory 5).
struct DrainedWave {
  double crossing = 0;  ///< time of a compression wave of drained soil to cross the soil height, H √(βρ/E_c) [s]
  std::optional<double> drainage{};  ///< H²/c_v of the soil that drains fastest, if pore water flows [s]
};

/// Evaluates the body at the start of the stage.
template <int D>
DrainedWave find_drained_wave(const mpm::Body<D>& body, const StagePlan<D>& plan);

/// "stage 'rain': with mass_scaling = 1e+08 …", with an adequate mass scaling; nullopt if the waves are fast enough.
template <int D>
std::optional<std::string> describe_slow_wave(const mpm::Body<D>& body, const StagePlan<D>& plan);

/// "stage 'rain': water = "seeps" leaves …"; nullopt if no soil is so permeable that the inertia of its water matters.
template <int D>
std::optional<std::string> describe_fast_water(const mpm::Body<D>& body, const StagePlan<D>& plan);

/// Pore pressure and effective stress, averaged over the volume of the wet points, positive in compression [Pa].
struct CarriedWeight {
  double water = 0;   ///< pore pressure
  double grains = 0;  ///< vertical effective stress
};

template <int D>
CarriedWeight find_carried_weight(const mpm::Body<D>& body);

/// "stage 'gravity': …" if excess pore pressure carries a noticeable part of the weight applied in the stage: the soil
/// is at rest, but its effective stresses lack that part. `before`: at the start of the stage. Returns nullopt if the
/// weight is drained.
template <int D>
std::optional<std::string> describe_undrained_weight(const mpm::Body<D>& body, const std::string& stage,
                                                     const CarriedWeight& before, const ShownUnits& units);

}  // namespace talus::run
