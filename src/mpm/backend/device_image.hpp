// SPDX-License-Identifier: MIT
#pragma once
// Conversion between a body and the arrays of a device (DeviceImage, WaterImage).

#include "mpm/backend/device.hpp"
#include "mpm/backend/thread_body.hpp"
#include "mpm/state/body.hpp"

namespace talus::mpm {

// The pore water of a body in the layout of a device, and back.

/// Image of the pore water (Darcy formulation); the node graph must exist. It contains views of the body's lists. Empty
/// for a body without water.
template <int D>
WaterImage<D> make_water_image(const Body<D>& body);

/// Copies the changed data into the body.
template <int D>
void read_water_image(const WaterImage<D>& image, Body<D>& body);

/// Device memory for the water [bytes].
template <int D>
std::size_t count_bytes(const WaterImage<D>& image);

/// Hydraulic conditions at body.time.
template <int D>
std::vector<DeviceSurface> find_device_surfaces(const Body<D>& body);

template <int D>
DeviceImage<D> make_device_image(const Body<D>& body, int threads);

/// Device memory for the body, with the work arrays of its steps [bytes].
template <int D>
std::size_t count_bytes(const DeviceImage<D>& image);

/// Copies the changed data into the body from which the image was made. The caller updates work, time and lost points.
template <int D>
void read_device_image(const DeviceImage<D>& image, int threads, Body<D>& body);

}  // namespace talus::mpm
