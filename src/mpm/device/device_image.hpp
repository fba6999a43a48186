// SPDX-License-Identifier: MIT
#pragma once
// Between a body and the arrays that a device has.

#include "mpm/device/device.hpp"

namespace talus::mpm {

template <int D>
DeviceImage<D> make_device_image(const Body<D>& body, int threads);

/// Memory that a device needs for it, with what its steps work on [bytes].
template <int D>
std::size_t count_bytes(const DeviceImage<D>& image);

/// What changed on the device, into the body that the image was made of. Its work, time and losses are the caller's.
template <int D>
void read_device_image(const DeviceImage<D>& image, int threads, Body<D>& body);

}  // namespace talus::mpm
