// SPDX-License-Identifier: MIT
#include "sparse/gmres.hpp"

#include <Eigen/Dense>

namespace talus::sparse {

bool solve_by_gmres(const LinearMap& apply, const LinearMap& invert, const std::vector<double>& b, double tolerance,
                    int most, std::vector<double>& x) {
  const auto n = static_cast<Eigen::Index>(b.size());
  std::vector<Eigen::VectorXd> basis{Eigen::Map<const Eigen::VectorXd>(b.data(), n)}, changes;
  const double norm = basis[0].norm();
  x.assign(b.size(), 0);
  if (norm == 0) return true;
  basis[0] /= norm;
  Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(most + 1, most);
  Eigen::VectorXd first = Eigen::VectorXd::Zero(most + 1);
  first[0] = norm;
  for (int k = 0; k < most; ++k) {
    std::vector<double> product(basis[k].begin(), basis[k].end());
    if (!invert(product)) return false;
    changes.emplace_back(Eigen::Map<Eigen::VectorXd>(product.data(), n));
    if (!apply(product)) return false;
    Eigen::VectorXd vector = Eigen::Map<Eigen::VectorXd>(product.data(), n);
    for (int j = 0; j <= k; ++j) {
      hessenberg(j, k) = basis[j].dot(vector);
      vector -= hessenberg(j, k) * basis[j];
    }
    hessenberg(k + 1, k) = vector.norm();
    const auto used = hessenberg.topLeftCorner(k + 2, k + 1);
    const Eigen::VectorXd factors = used.householderQr().solve(first.head(k + 2));
    if ((first.head(k + 2) - used * factors).norm() <= tolerance * norm) {
      Eigen::Map<Eigen::VectorXd> solution(x.data(), n);
      for (int j = 0; j <= k; ++j) solution += factors[j] * changes[j];
      return solution.allFinite();
    }
    if (!(hessenberg(k + 1, k) > 0)) return false;
    basis.emplace_back(vector / hessenberg(k + 1, k));
  }
  return false;
}

}  // namespace talus::sparse
