// SPDX-License-Identifier: MIT
// The method of multipliers: alternately a least squares problem with a constant matrix, and projections onto the
// cones.

#include "support/conic_splitting.hpp"

namespace talus::bounds {

Eigen::MatrixXd make_dense(const ConicProgram& program) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(program.rows.count(), program.variables);
  for (int r = 0; r < program.rows.count(); ++r)
    for (int k = program.rows.first[static_cast<std::size_t>(r)];
         k < program.rows.first[static_cast<std::size_t>(r + 1)]; ++k)
      a(r, program.rows.column[static_cast<std::size_t>(k)]) += program.rows.value[static_cast<std::size_t>(k)];
  return a;
}

Eigen::VectorXd project(const ConicProgram& program, const Eigen::VectorXd& s) {
  Eigen::VectorXd p = Eigen::VectorXd::Zero(s.size());
  int row = program.equations;
  for (const int size : program.cones) {
    const double head = s[row], tail = s.segment(row + 1, size - 1).norm();
    if (tail <= head) {
      p.segment(row, size) = s.segment(row, size);
    } else if (tail > -head) {
      p[row] = 0.5 * (head + tail);
      p.segment(row + 1, size - 1) = p[row] / tail * s.segment(row + 1, size - 1);
    }
    row += size;
  }
  return p;
}

Eigen::VectorXd split(const ConicProgram& program, int iterations) {
  const Eigen::MatrixXd a = make_dense(program);
  const Eigen::Map<const Eigen::VectorXd> q(program.cost.data(), program.variables), b(program.right.data(), a.rows());
  const Eigen::LDLT<Eigen::MatrixXd> normal(
      (a.transpose() * a + 1e-9 * Eigen::MatrixXd::Identity(a.cols(), a.cols())).eval());
  Eigen::VectorXd x = Eigen::VectorXd::Zero(a.cols()), s = Eigen::VectorXd::Zero(a.rows()),
                  u = s;  // u: multipliers, scaled
  for (int i = 0; i < iterations; ++i) {
    x = normal.solve(a.transpose() * (b - s - u) - q);
    const Eigen::VectorXd over = 1.6 * (a * x) + (1 - 1.6) * (b - s);
    s = project(program, b - over - u);
    u += over + s - b;
  }
  return x;
}

}  // namespace talus::bounds
