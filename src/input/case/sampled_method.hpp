// SPDX-License-Identifier: MIT
#pragma once
// The method of [analysis] that a sampling study asks for.

#include "base/methods.hpp"
#include "input/case/sampling.hpp"

namespace talus::input {

constexpr Method find_method(SampledMethod sampled) {
  return sampled == SampledMethod::lem ? Method::lem : sampled == SampledMethod::fem ? Method::fem : Method::mpm;
}

}  // namespace talus::input
