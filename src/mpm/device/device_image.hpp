// SPDX-License-Identifier: MIT
#pragma once
// Between a body and the arrays that a device has.

#include "mpm/body/body.hpp"
#include "mpm/device/device.hpp"
#include "mpm/device/thread_body.hpp"

namespace talus::mpm {

// The pore water of a body in the layout of a device, and back.

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

template <int D>
DeviceImage<D> make_device_image(const Body<D>& body, int threads);

/// Memory that a device needs for it, with what its steps work on [bytes].
template <int D>
std::size_t count_bytes(const DeviceImage<D>& image);

/// What changed on the device, into the body that the image was made of. Its work, time and losses are the caller's.
template <int D>
void read_device_image(const DeviceImage<D>& image, int threads, Body<D>& body);

}  // namespace talus::mpm
