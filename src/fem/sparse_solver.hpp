#pragma once
// Direct solution of sparse linear systems with one pattern and many values; the only place that knows the library.

#include <memory>
#include <vector>

namespace talus::fem {

class SparseSolver {
 public:
  /// A square pattern in compressed columns with sorted rows; it must be symmetric and hold the diagonal.
  SparseSolver(const std::vector<int>& column_start, const std::vector<int>& row);
  ~SparseSolver();

  /// Solves A x = b. `symmetric`: A is symmetric and positive definite, which is cheaper. False when A is singular or
  /// the solution is no number.
  bool solve(const std::vector<double>& values, bool symmetric, const std::vector<double>& b, std::vector<double>& x);

 private:
  struct Library;
  std::unique_ptr<Library> library_;
};

}  // namespace talus::fem
