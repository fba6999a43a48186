// SPDX-License-Identifier: MIT
// Emulated device: GPU kernels on the CPU, for tests.
#include "mpm/backend/emulated.hpp"

#include "mpm/backend/device_body.hpp"
#include "mpm/backend/timed_grid.hpp"

namespace talus::mpm {

template <int D>
std::unique_ptr<Device<D>> make_emulated_device(const Emulation& how) {
  using Grid = device::TimedGrid<device::HostGrid>;
  return std::make_unique<device::DeviceBody<Grid, D>>(Grid(device::HostGrid(how)));
}

template std::unique_ptr<Device<2>> make_emulated_device<2>(const Emulation&);
template std::unique_ptr<Device<3>> make_emulated_device<3>(const Emulation&);

}  // namespace talus::mpm
