// SPDX-License-Identifier: MIT
#include "sparse/gmres.hpp"

#include <Eigen/Dense>
#include <limits>

namespace talus::sparse {

double solve_by_gmres(const LinearMap& apply, const LinearMap& invert, const std::vector<double>& b, double tolerance,
                      int most, std::vector<double>& x) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const auto n = static_cast<Eigen::Index>(b.size());
  std::vector<Eigen::VectorXd> basis{Eigen::Map<const Eigen::VectorXd>(b.data(), n)}, changes;
  const double norm = basis[0].norm();
  x.assign(b.size(), 0);
  if (norm == 0) return 0;
  basis[0] /= norm;
  Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(most + 1, most);
  Eigen::VectorXd first = Eigen::VectorXd::Zero(most + 1), factors;
  first[0] = 1;
  double left = 1;
  for (int k = 0; k < most && left > tolerance; ++k) {
    std::vector<double> product(basis[k].begin(), basis[k].end());
    if (!invert(product)) return none;
    changes.emplace_back(Eigen::Map<Eigen::VectorXd>(product.data(), n));
    if (!apply(product)) return none;
    Eigen::VectorXd vector = Eigen::Map<Eigen::VectorXd>(product.data(), n);
    for (int pass = 0; pass < 2; ++pass)
      for (int j = 0; j <= k; ++j) {
        const double along = basis[j].dot(vector);
        hessenberg(j, k) += along;
        vector -= along * basis[j];
      }
    const double rest = hessenberg(k + 1, k) = vector.norm();
    const auto used = hessenberg.topLeftCorner(k + 2, k + 1);
    factors = used.householderQr().solve(first.head(k + 2));
    left = (first.head(k + 2) - used * factors).norm();
    if (!(rest > 0)) break;
    basis.emplace_back(vector / rest);
  }
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(n);
  for (std::size_t j = 0; j < changes.size(); ++j)
    solution += (norm * factors[static_cast<Eigen::Index>(j)]) * changes[j];
  Eigen::Map<Eigen::VectorXd>(x.data(), n) = solution;
  return solution.allFinite() ? left : none;
}

}  // namespace talus::sparse
