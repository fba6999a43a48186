// SPDX-License-Identifier: MIT
#include "input/case/case.hpp"

#include <algorithm>

namespace talus::input {

bool uses(const Case& data, Method method) {
  return std::find(data.methods.begin(), data.methods.end(), method) != data.methods.end();
}

Case::Case() = default;
Case::Case(const Case&) = default;
Case::Case(Case&&) noexcept = default;
Case& Case::operator=(const Case&) = default;
Case& Case::operator=(Case&&) noexcept = default;
Case::~Case() = default;

}  // namespace talus::input
