// SPDX-License-Identifier: MIT
#include "reference/plain_two_phase_limits.hpp"

namespace talus::reference {

double critical_step(const CoupledSoil& soil, double length, double beta, Drag drag) {
  const Eigen::Vector2d m = soil.mass();
  const Eigen::Matrix2d k = soil.stiffness();
  const double a = drag == Drag::implicit_at_nodes ? 0.0 : soil.drag() * (1 / m[0] + 1 / m[1]) / beta;  // (2.86)
  const double b = 4 / (length * length) * (k(0, 0) / m[0] + k(1, 1) / m[1]) / beta;                    // (2.87)
  const double c = 16 / std::pow(length, 4) * k.determinant() / (m[0] * m[1]) / (beta * beta);          // (2.88)
  const double x = b + std::sqrt(b * b - 4 * c);
  return (-2 * a + std::sqrt(4 * a * a + 8 * x)) / x;
}

double exact_critical_step(const CoupledSoil& soil, double length, double beta, Drag drag) {
  const auto smallest_eigenvalue = [&](double dt) {
    Eigen::Matrix2d c;
    c << 1, -1, -1, 1;
    c *= soil.drag() * 2 * dt * (drag == Drag::implicit_at_nodes ? 1 : -1);
    const Eigen::Matrix2d m = 4 * beta * soil.mass().asDiagonal().toDenseMatrix();
    const Eigen::Matrix2d s = m - dt * dt * 4 / (length * length) * soil.stiffness() + c;
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(s).eigenvalues()[0];
  };
  double low = 0, high = 1e-12;
  while (smallest_eigenvalue(high) > 0) low = high, high *= 1.5;
  for (int i = 0; i < 80; ++i) (smallest_eigenvalue((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  return low;
}

}  // namespace talus::reference
