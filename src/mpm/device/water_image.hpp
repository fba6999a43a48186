// SPDX-License-Identifier: MIT
#pragma once
// The pore water of a body in the layout of a device, and back.

#include "mpm/body/body.hpp"
#include "mpm/device/thread_water.hpp"

namespace talus::mpm {

/// Of water that seeps; the node graph of the mixture must be there. Views of the body's lists; nothing for a body
/// without water.
template <int D>
WaterImage<D> make_water_image(const Body<D>& body);

/// What has changed, into the body.
template <int D>
void read_water_image(const WaterImage<D>& image, Body<D>& body);

/// What the water takes on a device [bytes].
template <int D>
std::size_t count_bytes(const WaterImage<D>& image);

/// The conditions at the start of a step.
template <int D>
std::vector<DeviceSurface> find_device_surfaces(const Body<D>& body);

}  // namespace talus::mpm
