// SPDX-License-Identifier: MIT
#pragma once
// What a stage says of a band in which soil has softened: where it is as thick as an element, the mesh decides.

#include <optional>
#include <string>

#include "run/mpm/stage.hpp"

namespace talus::run {

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

}  // namespace talus::run
