// SPDX-License-Identifier: MIT
// Local minima in the lattice of trial circles.

#include "lem/search/local_minima.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus::lem {

std::array<double, 2> find_ends(const Surface& surface) {
  if (surface.circle) return {surface.from, surface.to};
  return {surface.line.front()[0], surface.line.back()[0]};
}

bool falls_left(const Slope& slope, const Surface& surface) {
  const auto [left, right] = find_ends(surface);
  return slope.ground(left) <= slope.ground(right);
}

double find_elevation(const Slope& slope, const Surface& surface, double x) {
  if (surface.circle) {
    const Circle& c = *surface.circle;
    const double off = std::min(std::abs(x - c.centre[0]), c.radius);
    const double y = c.centre[1] - std::sqrt(c.radius * c.radius - off * off);
    return std::max(y, slope.section().base);  // a composite circle is level there
  }
  const auto& line = surface.line;
  auto q = std::upper_bound(line.begin(), line.end(), x, [](double v, const Point& p) { return v < p[0]; });
  if (q == line.begin()) return line.front()[1];
  if (q == line.end()) return line.back()[1];
  const Point &a = *(q - 1), &b = *q;
  return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
}

double measure_overlap(const Slope& slope, const Surface& a, const Surface& b) {
  const auto ea = find_ends(a), eb = find_ends(b);
  const double left = std::min(ea[0], eb[0]), right = std::max(ea[1], eb[1]);
  if (ea[1] <= eb[0] || eb[1] <= ea[0]) return 0;
  constexpr int samples = 100;
  double common = 0, together = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = left + (right - left) * (i + 0.5) / samples, top = slope.ground(x);
    const double da = x > ea[0] && x < ea[1] ? std::max(0.0, top - find_elevation(slope, a, x)) : 0;
    const double db = x > eb[0] && x < eb[1] ? std::max(0.0, top - find_elevation(slope, b, x)) : 0;
    common += std::min(da, db), together += std::max(da, db);
  }
  return together > 0 ? common / together : 1;
}

std::vector<int> find_local_minima(const Slope& slope, const TrialCircles& circles, const std::vector<float>& factors,
                                   int count, double most_overlap) {
  const auto [ni, nj, nk] = circles.size;
  constexpr float none = std::numeric_limits<float>::infinity();
  auto factor_of = [&](int s) {
    const float f = factors[static_cast<std::size_t>(s)];
    return f > 0 ? f : none;
  };
  auto cell_of = [nj = static_cast<std::size_t>(nj), nk = static_cast<std::size_t>(nk)](int i, int j, int k) {
    return (static_cast<std::size_t>(i) * nj + static_cast<std::size_t>(j)) * nk + static_cast<std::size_t>(k);
  };
  std::vector<int> minima;
  for (int i = 0; i < ni; ++i)
    for (int j = 0; j < nj; ++j)
      for (int k = 0; k < nk; ++k)
        for (int s = circles.first[cell_of(i, j, k)]; s < circles.first[cell_of(i, j, k) + 1]; ++s) {
          const float own = factor_of(s);
          if (own == none) continue;
          const Surface& surface = circles.surfaces[static_cast<std::size_t>(s)];
          bool smallest = true;
          for (int n = 0; n < 27 && smallest; ++n) {
            const int a = i + n / 9 - 1, b = j + n / 3 % 3 - 1, c = k + n % 3 - 1;
            if (n == 13 || a < 0 || b < 0 || c < 0 || a >= ni || b >= nj || c >= nk) continue;
            for (int t = circles.first[cell_of(a, b, c)]; t < circles.first[cell_of(a, b, c) + 1]; ++t) {
              const Surface& other = circles.surfaces[static_cast<std::size_t>(t)];
              if (other.to <= surface.from || other.from >= surface.to) continue;  // another face
              // Of equals the first counts.
              if (factor_of(t) < own || (factor_of(t) == own && t < s)) smallest = false;
            }
          }
          if (smallest) minima.push_back(s);
        }
  std::stable_sort(minima.begin(), minima.end(), [&](int a, int b) { return factor_of(a) < factor_of(b); });
  // A surface with more than twice the smallest factor is no second mechanism.
  constexpr float most_ratio = 2;
  std::vector<int> kept;
  for (int s : minima) {
    if (static_cast<int>(kept.size()) >= count || factor_of(s) > most_ratio * factor_of(minima.front())) break;
    const bool separate = std::none_of(kept.begin(), kept.end(), [&](int other) {
      return measure_overlap(slope, circles.surfaces[static_cast<std::size_t>(s)],
                             circles.surfaces[static_cast<std::size_t>(other)]) > most_overlap;
    });
    if (separate) kept.push_back(s);
  }
  return kept;
}

}  // namespace talus::lem
