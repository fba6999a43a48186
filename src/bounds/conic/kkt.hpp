// SPDX-License-Identifier: MIT
#pragma once
// The linear system of a step of the interior point method: its pattern is found once, its values change with the
// scalings.

#include <memory>
#include <vector>

#include "bounds/conic/cones.hpp"

namespace talus::bounds {

/// How nearly a system is solved.
struct KktAccuracy {
  /// Added to the diagonal, with the sign of each block, of a program whose entries are about one. Factors of a
  /// quasi-definite matrix need no pivots (Vanderbei 1995); the refinement removes its effect. A variable in no cone
  /// and an equation have only this: their product must stay above the rounding of one.
  double shift = 0;
  double left_over = 0;  ///< that the refinement may leave, over the right side
};
/// The first is quick; where the iteration stalls with it, the second repeats the refinement more often.
inline constexpr KktAccuracy quick_accuracy{1e-9, 1e-10}, careful_accuracy{1e-7, 1e-14};

/// [0 Aᵀ; A −H] [x; z] = [f; g] with H = 0 in the rows of equations and W² in those of a cone. The rows of cones are
/// eliminated, then the variables that few cones share (the stresses at a corner), each small group by its own dense
/// factors. The rest is quasi-definite by a small diagonal, factorised as L D Lᵀ, and refined against the system as it
/// stands.
class Kkt {
 public:
  Kkt(const ConicProgram& program, const KktAccuracy& accuracy);
  ~Kkt();

  /// `scalings` of each cone. False when the factors are not finite.
  bool factorise(const std::vector<Scaling>& scalings);
  /// x and z of the last factors. False when they are not finite.
  bool solve(const std::vector<double>& f, const std::vector<double>& g, std::vector<double>& x,
             std::vector<double>& z) const;

 private:
  struct Library;
  /// Columns that the rows of a cone name, its rows there, and where the product of each two columns is added.
  struct Block {
    int first_row = 0, rows = 0;
    std::vector<int> columns;
    std::vector<double> values;  ///< row by row of the block
    std::vector<int> places;  ///< of the lower triangle, row by row: in the matrix, or −1 − the place in `dense_`
  };
  /// Variables that are eliminated together, k of them, and what they are coupled with, q unknowns of the rest.
  struct Group {
    std::vector<int> variables, neighbours;
    std::size_t own = 0;       ///< of the k × k matrix in `dense_`, row by row; then its factor
    std::size_t coupling = 0;  ///< of the k × q matrix in `dense_`, row by row; then L⁻¹ times it
    std::vector<int> places;   ///< in the matrix: of the lower triangle of its neighbours' products, row by row
  };
  void find_blocks();
  void find_groups();
  void list_neighbours();
  void find_pattern();
  int find_place(std::size_t column, std::size_t row) const;
  void place_products(Block& block) const;
  void add_products(const Block& block, const Scaling& scaling, std::vector<double>& scaled);
  /// False when the group has no factor.
  bool eliminate(const Group& group);
  /// f − Aᵀz and g − A x + H z, in place.
  void find_residual(const std::vector<double>& x, const std::vector<double>& z, std::vector<double>& f,
                     std::vector<double>& g) const;
  /// By the factors alone.
  bool solve_reduced(const std::vector<double>& f, const std::vector<double>& g, std::vector<double>& x,
                     std::vector<double>& z) const;
  void reduce_right(const Group& group, std::vector<double>& x, double* right) const;
  void recover(const Group& group, const double* rest, std::vector<double>& x) const;
  void apply_inverse(const Block& block, const Scaling& scaling, const double* u, double* out) const;

  const ConicProgram& program_;
  KktAccuracy accuracy_;
  std::vector<Block> blocks_;
  std::vector<Group> groups_;
  std::vector<int> group_of_, rank_of_;  ///< of each variable: its group and its number there; −1 and that in the rest
  int globals_ = 0;                      ///< variables in no group: the first unknowns of the rest
  std::vector<double> dense_, fixed_dense_;
  const std::vector<Scaling>* scalings_ = nullptr;
  std::unique_ptr<Library> library_;
};

}  // namespace talus::bounds
