// SPDX-License-Identifier: MIT
#pragma once
// How rows of time are joined.

#include <array>

#include "input/language/spec.hpp"

namespace talus::input {

enum class SeriesShape { linear, steps };

template <>
inline constexpr auto choices<SeriesShape> = std::array{
    Choice{SeriesShape::linear, "linear", "straight lines between the rows; two rows at one time are a jump"},
    Choice{SeriesShape::steps, "steps", "each value holds until the time of the next row, as in a hyetograph"},
};

}  // namespace talus::input
