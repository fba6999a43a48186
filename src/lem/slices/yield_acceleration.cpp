// SPDX-License-Identifier: MIT
// The horizontal acceleration that brings a surface to F = 1.

#include <cmath>

#include "lem/surface/mass.hpp"

namespace talus::lem {

std::optional<double> find_yield_acceleration(const Slope& slope, const CutSurface& cut, Method method,
                                              const Checks& checks) {
  if (slope.before() != nullptr) return std::nullopt;
  CutSurface copy = cut;
  Checks lenient = checks;
  lenient.reject = false;
  const auto excess = [&](double k) {
    const Solution solution = solve_with(slope, copy, method, lenient, false, k);
    return solution.factor > 0 ? solution.factor - 1 : std::nan("");
  };
  double a = 0, fa = excess(0);
  if (!(fa >= 0)) return std::nullopt;
  double b = 0.1, fb = excess(b);
  while (fb > 0 && b < 4) {
    a = b;
    fa = fb;
    b *= 1.5;
    fb = excess(b);
  }
  if (!(fb <= 0)) return std::nullopt;
  // Regula falsi with halving (Illinois).
  for (int i = 0; i < 100 && fb != 0; ++i) {
    const double middle = b - fb * (b - a) / (fb - fa), f = excess(middle), moved = std::abs(middle - b);
    if (std::isnan(f)) return std::nullopt;
    if ((f < 0) != (fb < 0)) {
      a = b;
      fa = fb;
    } else {
      fa *= 0.5;
    }
    b = middle;
    fb = f;
    if (moved < 1e-12) break;
  }
  return b;
}

}  // namespace talus::lem
