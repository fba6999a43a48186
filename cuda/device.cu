// SPDX-License-Identifier: MIT
// The module that --device gpu loads: the engine's kernels (src/mpm/device/) on a GPU.

#include "cuda_grid.hpp"
#include "mpm/device/device_body.hpp"

namespace talus::mpm {
namespace {

class CudaMaker : public DeviceMaker {
 public:
  std::unique_ptr<Device<2>> make_2d() override {
    return std::make_unique<device::DeviceBody<device::CudaGrid, 2>>(device::CudaGrid());
  }
  std::unique_ptr<Device<3>> make_3d() override {
    return std::make_unique<device::DeviceBody<device::CudaGrid, 3>>(device::CudaGrid());
  }
};

}  // namespace
}  // namespace talus::mpm

extern "C" talus::mpm::DeviceMaker* talus_make_devices() {
  static talus::mpm::CudaMaker maker;
  return &maker;
}
