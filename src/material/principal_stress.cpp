// SPDX-License-Identifier: MIT
#include "material/principal_stress.hpp"

#include <numbers>
#include <vector>

namespace talus::material {

namespace {

using Coefficients = decltype(CosineThird::a);

Coefficients compute_coefficients() {
  constexpr int degree = CosineThird::degree;
  Coefficients a{};
  using Real = long double;
  constexpr int n = degree + 1;
  const Real pi = std::numbers::pi_v<Real>;
  using Polynomial = std::vector<Real>;  // coefficients in ascending order
  const auto angle = [&](int i) { return pi * (static_cast<Real>(i) + 0.5L) / n; };

  Polynomial chebyshev(n);
  for (int k = 0; k < n; ++k) {
    for (int i = 0; i < n; ++i) {
      const Real u = (std::cos(angle(i)) + 1) / 2;
      chebyshev[static_cast<std::size_t>(k)] +=
          std::cos(2 / 3.0L * std::acos(u)) * std::cos(static_cast<Real>(k) * angle(i)) * 2 / n;
    }
  }
  chebyshev[0] /= 2;

  // Evaluates Σ c_k T_k(z), z = 2u-1, by Clenshaw's recurrence on polynomials in u.
  const auto times_z = [](const Polynomial& b) {
    Polynomial r(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) {
      r[i] -= b[i];
      if (i + 1 < b.size()) r[i + 1] += 2 * b[i];
    }
    return r;
  };
  Polynomial b1(n), b2(n);
  for (int k = degree; k >= 1; --k) {
    Polynomial b0 = times_z(b1);
    for (std::size_t i = 0; i < n; ++i) b0[i] = 2 * b0[i] - b2[i];
    b0[0] += chebyshev[static_cast<std::size_t>(k)];
    b2 = b1;
    b1 = b0;
  }
  Polynomial sum = times_z(b1);
  for (std::size_t i = 0; i < n; ++i) sum[i] -= b2[i];
  sum[0] += chebyshev[0];
  for (std::size_t i = 0; i < n; ++i) a[i] = static_cast<double>(sum[i]);
  return a;
}

}  // namespace

CosineThird::CosineThird() {
  static const Coefficients computed = compute_coefficients();
  a = computed;
}

}  // namespace talus::material
