// SPDX-License-Identifier: MIT
#include "base/vec.hpp"

#include <Eigen/Cholesky>

namespace talus {

std::optional<std::vector<double>> factorise(const std::vector<double>& symmetric, int size) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::MatrixXd matrix = Eigen::Map<const Rows>(symmetric.data(), size, size);
  const Eigen::LLT<Eigen::MatrixXd> factors(matrix);
  if (factors.info() != Eigen::Success) return std::nullopt;
  std::vector<double> lower(symmetric.size());
  Eigen::Map<Rows>(lower.data(), size, size) = factors.matrixL();
  return lower;
}

}  // namespace talus
