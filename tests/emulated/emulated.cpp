// SPDX-License-Identifier: MIT
// Emulated device: GPU kernels on the CPU, for tests. The program loads this library for --device emulated.
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

namespace {

class Emulator : public DeviceMaker {
 public:
  explicit Emulator(const Emulation& how) : how_(how) {}
  std::string find_name(std::string&) override { return "emulated"; }
  std::unique_ptr<Device<2>> make_2d() override { return make_emulated_device<2>(how_); }
  std::unique_ptr<Device<3>> make_3d() override { return make_emulated_device<3>(how_); }

 private:
  Emulation how_;
};

}  // namespace
}  // namespace talus::mpm

/// Returns nullptr if the program was built with another layout of the exchanged data.
extern "C" talus::mpm::DeviceMaker* talus_make_emulated(std::size_t layout, const talus::mpm::Emulation* how) {
  return layout == talus::mpm::device_layout ? new talus::mpm::Emulator(*how) : nullptr;
}
