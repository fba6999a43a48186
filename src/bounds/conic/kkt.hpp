// SPDX-License-Identifier: MIT
#pragma once
// The linear system of a step of the interior point method: its pattern is found once, its values change with the
// scalings.

#include <memory>
#include <vector>

#include "bounds/conic/cones.hpp"
#include "bounds/conic/program.hpp"

namespace talus::bounds {

/// [0 Aᵀ; A −H] [x; z] = [f; g] with H = 0 in the rows of equations and W² in those of a cone. The rows of cones are
/// eliminated, the rest is made quasi-definite by a small diagonal, factorised as L D Lᵀ, and refined against the
/// system as it stands.
class Kkt {
 public:
  explicit Kkt(const ConicProgram& program);
  ~Kkt();

  /// `scalings` of each cone. False when the factors are not finite.
  bool factorise(const std::vector<Scaling>& scalings);
  /// x and z of the last factors. False when they are not finite.
  bool solve(const std::vector<double>& f, const std::vector<double>& g, std::vector<double>& x,
             std::vector<double>& z) const;

 private:
  struct Library;
  /// Columns that the rows of a cone name, its rows there, and where the product of each two columns stands in the
  /// matrix.
  struct Block {
    int first_row = 0, rows = 0;
    std::vector<int> columns;
    std::vector<double> values;  ///< row by row of the block
    std::vector<int> places;     ///< of the lower triangle, row by row
  };
  void find_blocks();
  void find_pattern();
  /// f − Aᵀz and g − A x + H z, in place.
  void find_residual(const std::vector<double>& x, const std::vector<double>& z, std::vector<double>& f,
                     std::vector<double>& g) const;
  /// By the factors alone.
  bool solve_reduced(const std::vector<double>& f, const std::vector<double>& g, std::vector<double>& x,
                     std::vector<double>& z) const;
  void apply_inverse(const Block& block, const Scaling& scaling, const double* u, double* out) const;

  const ConicProgram& program_;
  std::vector<Block> blocks_;
  const std::vector<Scaling>* scalings_ = nullptr;
  std::unique_ptr<Library> library_;
};

}  // namespace talus::bounds
