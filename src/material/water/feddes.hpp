// SPDX-License-Identifier: MIT
#pragma once
// Reduction of root water uptake by suction after Feddes, Kowalik and Zaradny (1978): actual over potential uptake.

#include <array>

#include "material/water/monotone_table.hpp"

namespace talus::material {

/// α [-] over suction [Pa]: 0 up to suctions[0] (lack of oxygen), 1 from [1] to [2], 0 from [3] (wilting point); linear
/// between. suctions[0] = suctions[1]: wet soil does not reduce the uptake.
struct Feddes {
  std::array<double, 4> suctions{1e3, 2.5e3, 40e3, 1.5e6};  ///< [Pa], non-decreasing; the last two differ

  /// Returns α and dα/ds [1/Pa], for a Pack or a double. At a corner the slope is that of the flat side.
  template <class T>
  TALUS_KERNEL CurvePoint<T> evaluate(T suction) const {
    const bool lacks_air = suctions[1] > suctions[0];
    const double wet = lacks_air ? 1 / (suctions[1] - suctions[0]) : 0, dry = 1 / (suctions[3] - suctions[2]);
    const T rise = lacks_air ? (suction - T(suctions[0])) * wet : T(1.0), fall = (T(suctions[3]) - suction) * dry;
    const T line = lane_min(rise, fall);
    const auto bends = line > T(0.0) && line < T(1.0);
    return {lane_max(T(0.0), lane_min(T(1.0), line)), select(bends, select(rise < fall, T(wet), T(-dry)), T(0.0))};
  }
};

}  // namespace talus::material
