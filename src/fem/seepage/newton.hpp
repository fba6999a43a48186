// SPDX-License-Identifier: MIT
#pragma once
// Newton's method for the nodal equations of seepage, with the active set of the face nodes. Internal to fem/.

#include "fem/seepage/system.hpp"
#include "fem/sparse_solver.hpp"

namespace talus::fem {

/// Heads and states of the face nodes, per unknown.
struct SeepageState {
  std::vector<double> head;  ///< [m]
  std::vector<FaceState> face;
};

/// Slope of k_r in the Jacobian.
enum class Slopes {
  tangent,  ///< derivative of the law: converges fastest near the solution
  chord     ///< secant over the last change of suction: more robust at kinks and steep ends
};

template <int D>
class SeepageNewton {
 public:
  SeepageNewton(const SeepageSystem<D>& system, const SeepageOptions& options);

  /// Solves from the given state. Returns false if it does not converge; the state is then undefined.
  bool solve(SeepageState& state, const std::vector<NodeCondition>& conditions, StepInput input,
             Slopes slopes = Slopes::tangent);

  int solves() const { return solves_; }           ///< number of linear systems solved
  int undecided() const { return undecided_; }     ///< SeepageResult::undecided of the last solution
  const NodalSums& sums() const { return sums_; }  ///< at the last solution

 private:
  bool is_held(const SeepageState& state, std::size_t u) const;
  void evaluate(const SeepageState& state);
  bool switch_faces(SeepageState& state, bool balanced);
  bool take_step(SeepageState& state, double& largest);
  bool search_line(SeepageState& state, const std::vector<double>& direction, double& largest);
  double find_merit(const NodalSums& sums, const SeepageState& state) const;
  double find_residual(const NodalSums& sums, const SeepageState& state, std::size_t u) const;

  const SeepageSystem<D>& system_;
  SeepageOptions options_;
  SparseSolver solver_;
  const std::vector<NodeCondition>* conditions_ = nullptr;
  StepInput input_;
  NodalSums sums_;
  std::vector<int> switches_;     ///< number of changes of state per node
  std::vector<double> recent_;    ///< merits of the last steps
  std::vector<double> weight_;    ///< scale of each equation in the merit
  double fault_ = 0, limit_ = 0;  ///< sum of the absolute residuals, and its limit [m³/s]
  double height_ = 1;             ///< height of the soil [m]
  int undecided_ = 0;
  int solves_ = 0;
};

}  // namespace talus::fem
