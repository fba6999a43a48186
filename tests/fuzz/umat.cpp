// SPDX-License-Identifier: MIT
// Fuzz target: any numbers in any argument on return from a UMAT. The point keeps its state, or its stress is finite.
#include <dlfcn.h>

#include <cmath>
#include <cstdlib>

#include "support/external_model.hpp"
#include "target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using talus::material::External;
  static const External law = talus::support::open_umat({"given", {}, 3});
  using Give = void (*)(const std::uint8_t*, std::size_t);
  static const auto give =
      reinterpret_cast<Give>(dlsym(dlopen(talus::support::find_umat("given").c_str(), RTLD_NOW), "give"));
  give(data, size);
  talus::fuzz::try_to([&] {
    double stress[4] = {-1e3, -2e3, -1e3, 0}, increment[4] = {1e-6, 0, 0, 1e-6}, state[External::state_size];
    law.set_initial_state(state);
    law.update<4, double>(stress, increment, state, true);
    for (const double number : stress)
      if (!std::isfinite(number)) std::abort();
    for (const double number : state)
      if (!std::isfinite(number)) std::abort();
    law.throw_failure();
  });
  return 0;
}
