// SPDX-License-Identifier: MIT
// Validation of the points of a table and computation of its cubic pieces.
#include "material/water/monotone_table.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace talus::material {

namespace {

/// Returns the slope at an interior point: the weighted harmonic mean of the adjacent secants, zero at an extremum or
/// plateau.
double find_inner_slope(double h0, double h1, double m0, double m1) {
  if (m0 * m1 <= 0) return 0;
  const double w0 = 2 * h1 + h0, w1 = h1 + 2 * h0;
  return (w0 + w1) / (w0 / m0 + w1 / m1);
}

void check(const std::vector<std::array<double, 2>>& points, const std::string& what) {
  const auto fail = [&](const std::string& sentence) { fail_input(what + " " + sentence); };
  if (points.size() < 2 || points.size() > MonotoneTable::capacity)
    fail(fmt::format("has {} points; 2 to {} are needed.", points.size(), MonotoneTable::capacity));
  double direction = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!(points[i][0] > points[i - 1][0]))
      fail(fmt::format("must have increasing suctions, but {:g} comes after {:g}.", points[i][0], points[i - 1][0]));
    const double step = points[i][1] - points[i - 1][1];
    if (step * direction < 0) fail(fmt::format("must only fall or only rise, but turns at {:g}.", points[i - 1][0]));
    if (step != 0) direction = step;
  }
}

}  // namespace

MonotoneTable make_table(const std::vector<std::array<double, 2>>& points, Interpolation interpolation,
                         const std::string& what) {
  check(points, what);
  MonotoneTable t;
  const std::size_t n = points.size();
  t.size = static_cast<int>(n);
  std::array<double, MonotoneTable::capacity> h{}, m{}, d{};
  for (std::size_t i = 0; i < n; ++i) {
    t.x[i] = points[i][0];
    t.c[0][i] = points[i][1];
  }
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = t.x[i + 1] - t.x[i];
    m[i] = (t.c[0][i + 1] - t.c[0][i]) / h[i];
  }
  for (std::size_t i = 1; i + 1 < n; ++i) d[i] = find_inner_slope(h[i - 1], h[i], m[i - 1], m[i]);
  // The curve is constant outside the table, so the slope is zero at both ends.
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (interpolation == Interpolation::linear) {
      t.c[1][i] = m[i];
    } else {
      t.c[1][i] = d[i];
      t.c[2][i] = (3 * m[i] - 2 * d[i] - d[i + 1]) / h[i];
      t.c[3][i] = (d[i] + d[i + 1] - 2 * m[i]) / (h[i] * h[i]);
    }
  }
  return t;
}

}  // namespace talus::material
