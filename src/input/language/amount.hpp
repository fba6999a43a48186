// SPDX-License-Identifier: MIT
#pragma once
// A number with the unit that the user gave it.

#include <string>

namespace talus::input {

/// A number as the user writes it, with its unit: 1.58, "212 mm", "5 %".
struct Amount {
  double number = 0;
  std::string unit;  ///< empty for a plain number
  std::string text;  ///< as in the file, for people
};

}  // namespace talus::input
