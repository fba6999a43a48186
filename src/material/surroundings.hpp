// SPDX-License-Identifier: MIT
#pragma once
// What a law may know of a point beside its stress and state.

#include <limits>
#include <string>

#include "base/lane.hpp"

namespace talus::material {

/// What is known of the gaps of soil that comes apart (separation.hpp).
enum class Gaps {
  ignored,  ///< the soil keeps none: its volume grows as if it flowed
  none,     ///< none of these points has one yet; the state of gaps is not read
  kept,     ///< a gap closes before the soil bears load again
};

/// Softening over a length (theory 23), of laws whose traits soften.
template <class T>
struct Softening {
  T lent{0.0};  ///< plastic dilation of the neighbourhood beside the soil's own, which softens it [-]
  T softened{
      0.0};  ///< the law's answer: the soil's own of this step, in all directions, above zero where it dilates [-]
};

/// The rest of a point at the end of the step whose strain increment is given. Laws that need none of it ignore it.
template <class T>
struct Surroundings {
  T saturation{1.0};            ///< S_w of the pore water [-]; 1 in soil without pore water
  const int* points = nullptr;  ///< number of each lane's point, -1 where there is none; nullptr: not known
  double time = 0, dt = 0;      ///< start of the step and its length [s]
  Gaps gaps = Gaps::ignored;
  Softening<T>* softening = nullptr;  ///< of soil that softens over a length; nullptr: as its own point does
};

/// A quantity that a law has beside stress, for results.
struct StateField {
  std::string name;  ///< as stored, e.g. `void_ratio`
  std::string unit;  ///< SI
  /// What soil of laws without it shows: roots are absent from soil without roots; other quantities are no number
  /// there.
  double elsewhere = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace talus::material
