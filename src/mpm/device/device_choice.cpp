// SPDX-License-Identifier: MIT
#include "mpm/device/device_choice.hpp"

#include "base/error.hpp"
#include "base/modules.hpp"

namespace talus::mpm {
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

struct Choice {
  std::shared_ptr<DeviceMaker> maker;
  std::string name;
};
Choice& current() {
  static Choice choice;
  return choice;
}

}  // namespace

void use_gpu() {
  std::string why;
  void* function = load_module("libtalus_cuda.so", "talus_make_devices", false, why);
  if (function == nullptr)
    throw Error(ExitCode::wrong_input,
                "--device gpu: this program was built without CUDA: build it with -DTALUS_CUDA=ON (" + why + ")");
  std::shared_ptr<DeviceMaker> maker(reinterpret_cast<DeviceMaker* (*)(std::size_t)>(function)(device_layout));
  if (!maker) throw Error(ExitCode::wrong_input, "--device gpu: libtalus_cuda.so is of another build than the program");
  const std::string name = maker->find_name(why);
  if (name.empty())
    throw Error(ExitCode::wrong_input, "--device gpu: there is no GPU here that CUDA can use (" + why +
                                           "); without --device the case is calculated on the processor");
  current() = {std::move(maker), name};
}

void use_emulated_device(const Emulation& how) {
  current() = {std::make_shared<Emulator>(how), "emulated"};
}

void use_no_device() {
  current() = {};
}

const std::string& get_device_name() {
  return current().name;
}

template <>
std::unique_ptr<Device<2>> make_device<2>() {
  return current().maker ? current().maker->make_2d() : nullptr;
}
template <>
std::unique_ptr<Device<3>> make_device<3>() {
  return current().maker ? current().maker->make_3d() : nullptr;
}

}  // namespace talus::mpm
