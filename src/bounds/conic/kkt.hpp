// SPDX-License-Identifier: MIT
#pragma once
// The linear (KKT) system of a step of the interior point method. Its pattern is determined once; its values change
// with the scalings.

#include <memory>
#include <vector>

#include "bounds/conic/cones.hpp"

namespace talus::bounds {

/// Accuracy with which a system is solved.
struct KktAccuracy {
  /// Added to the diagonal, with the sign of each block, of a program whose entries are about one. A quasi-definite
  /// matrix can be factorised without pivoting (Vanderbei 1995); the refinement removes the effect of the shift.
  /// Variables in no cone, and equations, have nothing else on the diagonal: the product of the two shifts must exceed
  /// the rounding of one.
  double shift = 0;
  double left_over = 0;  ///< residual over the right-hand side at which the refinement ends
};
/// The first one is fast; the second, with more refinement, is used where the iteration stalls with the first.
inline constexpr KktAccuracy quick_accuracy{1e-9, 1e-8}, careful_accuracy{1e-7, 1e-14};

/// The system [0 Aᵀ; A −H] [x; z] = [f; g] with H = 0 in the rows of equations and W² in those of a cone. The rows of
/// cones are eliminated, then the variables that occur in few cones (the stresses at a corner), each small group by its
/// own dense factors. The remainder is made quasi-definite by a small diagonal, factorised as L D Lᵀ, and refined
/// against the original system.
class Kkt {
 public:
  Kkt(const ConicProgram& program, const KktAccuracy& accuracy);
  ~Kkt();

  /// Factorises with the scaling of each cone. Returns false if the factors are not finite.
  bool factorise(const std::vector<Scaling>& scalings);
  /// Solves for x and z with the last factors. Returns false if they are not finite.
  bool solve(const std::vector<double>& f, const std::vector<double>& g, std::vector<double>& x,
             std::vector<double>& z) const;

 private:
  struct Library;
  /// The columns that occur in the rows of a cone, its entries there, and the places where the products of pairs of
  /// columns are added.
  struct Block {
    int first_row = 0, rows = 0;
    std::vector<int> columns;
    std::vector<double> values;  ///< row by row of the block
    std::vector<int> places;  ///< of the lower triangle, row by row: index in the matrix, or −1 − the index in `dense_`
  };
  /// Variables that are eliminated together (k of them), and the unknowns of the rest that they are coupled with (q).
  struct Group {
    std::vector<int> variables, neighbours;
    std::size_t own = 0;       ///< index in `dense_` of the k × k matrix, row by row, later of its factor
    std::size_t coupling = 0;  ///< index in `dense_` of the k × q matrix, row by row, later of L⁻¹ times it
    std::vector<int> places;   ///< in the matrix: of the lower triangle of the products of the neighbours, row by row
  };
  void find_blocks();
  void find_groups();
  void list_neighbours();
  void find_pattern();
  int find_place(std::size_t column, std::size_t row) const;
  void place_products(Block& block) const;
  void add_products(const Block& block, const Scaling& scaling, std::vector<double>& scaled);
  /// Returns false if the matrix of the group has no factor.
  bool eliminate(const Group& group);
  /// Computes f − Aᵀz and g − A x + H z, in place.
  void find_residual(const std::vector<double>& x, const std::vector<double>& z, std::vector<double>& f,
                     std::vector<double>& g) const;
  /// Solves by the factors alone, without refinement.
  bool solve_reduced(const std::vector<double>& f, const std::vector<double>& g, std::vector<double>& x,
                     std::vector<double>& z) const;
  /// Adds corrections to x and z until the norm of the residual, which starts as left_f and left_g, is at most `asked`.
  bool correct(double asked, const std::vector<double>& left_f, const std::vector<double>& left_g,
               std::vector<double>& x, std::vector<double>& z) const;
  void reduce_right(const Group& group, std::vector<double>& x, double* right) const;
  void recover(const Group& group, const double* rest, std::vector<double>& x) const;
  void apply_inverse(const Block& block, const Scaling& scaling, const double* u, double* out) const;

  const ConicProgram& program_;
  KktAccuracy accuracy_;
  std::vector<Block> blocks_;
  std::vector<Group> groups_;
  std::vector<int> group_of_, rank_of_;  ///< its group and its index there; else −1 and that in the rest
  int globals_ = 0;                      ///< number of variables in no group, which are the first unknowns of the rest
  std::vector<double> dense_, fixed_dense_;
  const std::vector<Scaling>* scalings_ = nullptr;
  std::unique_ptr<Library> library_;
};

}  // namespace talus::bounds
