// SPDX-License-Identifier: MIT
// The module that --device gpu loads: the kernels of the MPM engine (src/mpm/backend/) on a GPU.

#include "cuda_grid.hpp"
#include "mpm/backend/device_body.hpp"
#include "mpm/backend/timed_grid.hpp"

namespace talus::mpm {
namespace device {

struct Nothing {
  TALUS_PORTABLE void operator()(int) const {}
};

}  // namespace device
namespace {

class CudaMaker : public DeviceMaker {
  using Grid = device::TimedGrid<device::CudaGrid>;

 public:
  std::string find_name(std::string& why) override {
    int count = 0;
    cudaDeviceProp properties{};
    cudaError_t code = cudaGetDeviceCount(&count);
    if (code == cudaSuccess && count > 0) code = cudaGetDeviceProperties(&properties, 0);
    // The first kernel fails if this module was not compiled for the architecture of the device.
    if (code == cudaSuccess && count > 0) {
      device::run_kernel<<<1, 1>>>(device::Nothing{}, 1);
      code = cudaGetLastError();
      if (code == cudaSuccess) code = cudaDeviceSynchronize();
    }
    if (code == cudaSuccess && count > 0) return properties.name;
    why = code == cudaSuccess ? "it sees none" : cudaGetErrorString(code);
    return "";
  }
  std::unique_ptr<Device<2>> make_2d() override {
    return std::make_unique<device::DeviceBody<Grid, 2>>(Grid(device::CudaGrid()));
  }
  std::unique_ptr<Device<3>> make_3d() override {
    return std::make_unique<device::DeviceBody<Grid, 3>>(Grid(device::CudaGrid()));
  }
};

}  // namespace
}  // namespace talus::mpm

/// Returns nullptr if the program was built with another layout of the exchanged data.
extern "C" talus::mpm::DeviceMaker* talus_make_devices(std::size_t layout) {
  return layout == talus::mpm::device_layout ? new talus::mpm::CudaMaker : nullptr;
}
