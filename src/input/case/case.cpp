// SPDX-License-Identifier: MIT
#include "input/case/case.hpp"

#include <algorithm>

namespace talus::input {

bool uses(const Case& data, Method method) {
  return std::find(data.methods.begin(), data.methods.end(), method) != data.methods.end();
}

}  // namespace talus::input
