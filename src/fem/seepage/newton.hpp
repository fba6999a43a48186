// SPDX-License-Identifier: MIT
#pragma once
// Newton's method for the nodal equations of seepage, with the states of face nodes found on the way.
// Internal to fem/.

#include "fem/seepage/system.hpp"
#include "fem/sparse_solver.hpp"

namespace talus::fem {

/// Heads and states of the face nodes, per unknown.
struct SeepageState {
  std::vector<double> head;  ///< [m]
  std::vector<FaceState> face;
};

/// Which slope of k_r the Jacobian has.
enum class Slopes {
  tangent,  ///< the law's own: fastest near the solution
  chord     ///< the secant over the last change of suction: more robust at kinks and steep ends
};

template <int D>
class SeepageNewton {
 public:
  SeepageNewton(const SeepageSystem<D>& system, const SeepageOptions& options);

  /// Solves from the given state on. False, with the state spoilt, when it does not converge.
  bool solve(SeepageState& state, const std::vector<NodeCondition>& conditions, StepInput input,
             Slopes slopes = Slopes::tangent);

  int solves() const { return solves_; }           ///< linear systems so far
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
  std::vector<int> switches_;     ///< how often a node has changed its state
  std::vector<double> recent_;    ///< merits of the last steps
  std::vector<double> weight_;    ///< scale of each equation in the merit
  double fault_ = 0, limit_ = 0;  ///< sum of the residuals' magnitudes, and its limit [m³/s]
  double height_ = 1;             ///< of the soil [m]
  int undecided_ = 0;
  int solves_ = 0;
};

}  // namespace talus::fem
