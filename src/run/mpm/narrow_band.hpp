// SPDX-License-Identifier: MIT
#pragma once
// What a stage says of a band in which soil has softened: where it is as thick as an element, the mesh decides.

#include <optional>
#include <string>

#include "run/mpm/stage.hpp"

namespace talus::run {

/// How many elements the band is thick in which soil that softens has sheared and dilated most; nothing where none has.
template <int D>
std::optional<double> find_soft_band(const mpm::Body<D>& body);

/// The same hooks, with a look at the band at each output: the thinnest of the stage stands in its state.
template <int D>
StageHooks<D> watch_bands(const mpm::Body<D>& body, StageHooks<D> hooks);

/// "soil that softens ('loess') sheared in a band of 1.4 elements …", with what to do. `band`: the thinnest of a stage;
/// `length`: mesh.softening_length [m]. Nothing where the band was thicker.
template <int D>
std::optional<std::string> describe_narrow_band(const mpm::Body<D>& body, std::optional<double> band,
                                                std::optional<double> length);

}  // namespace talus::run
