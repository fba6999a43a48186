// SPDX-License-Identifier: MIT
#pragma once
// Newton's method for the nodal equations of seepage, with the active set of the face nodes. Internal to fem/.

#include "fem/seepage/system.hpp"
#include "mesh/mesh.hpp"
#include "sparse/solver.hpp"

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
  sparse::SparseSolver<> solver_;
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

// Results of seepage from the heads of a solution. Internal to fem/.

// The contour of zero pore pressure in a plane field.

/// Returns polylines [m] along which the nodal pressure (linear in elements of soil) changes from at most zero to above
/// it. Open lines start at their end with the smaller x; closed ones repeat their first point.
std::vector<std::vector<std::array<double, 2>>> find_water_table(const mesh::Mesh<2>& mesh,
                                                                 const std::vector<double>& pressure);

/// Returns the flow through boundaries, roots and stores, without the fields. `sums` belong to the solution,
/// `conditions` and `input` to the solve.
template <int D>
SeepageResult<D> make_flow_result(const SeepageSystem<D>& system, const SeepageState& state, const NodalSums& sums,
                                  const std::vector<NodeCondition>& conditions, double time, const StepInput& input);

/// Adds heads, pressures, saturations, velocities, wet faces and water table of the solution.
template <int D>
void add_fields(const SeepageSystem<D>& system, const SeepageState& state, const StepInput& input,
                SeepageResult<D>& result);

/// Convert heads per node to heads per unknown, and back; nodes without soil get their elevation.
template <int D>
std::vector<double> to_unknowns(const SeepageSystem<D>& system, const std::vector<double>& node_heads);
template <int D>
std::vector<double> to_nodes(const SeepageSystem<D>& system, const std::vector<double>& heads);

// Rain that does not infiltrate: it stands on the ground up to a depth, and the rest runs down to where it infiltrates,
// or leaves the model. Internal to fem/; docs/theory/13-seepage.md.

/// The ground as nodes, each of which drains to its steepest neighbour below. The travel time is zero.
template <int D>
class Runoff {
 public:
  explicit Runoff(const SeepageSystem<D>& system);

  /// Returns true if any boundary uses it.
  bool is_used() const { return used_; }
  /// Adds run-on and standing water to the rain supplied in a step of `dt` [s].
  void offer(double dt, std::vector<NodeCondition>& conditions) const;
  /// Routes the water that did not infiltrate in a solution with the `conditions` from offer(). Returns true if the
  /// run-on of every node agrees with its supply.
  bool route(double dt, const std::vector<NodeCondition>& conditions, const SeepageState& state, const NodalSums& sums);
  /// Ends a step: stores the standing water for the next one, and writes its growth into `result`.
  void end_step(double dt, const std::vector<NodeCondition>& conditions, SeepageResult<D>& result);

 private:
  const SeepageSystem<D>& system_;
  bool used_ = false;
  std::vector<int> receiver_;           ///< by unknown; -1: the water leaves the ground
  std::vector<int> order_;              ///< unknowns of the ground, each before its receiver
  std::vector<double> capacity_;        ///< limit of the standing water, by unknown [m³]
  std::vector<double> standing_, now_;  ///< standing water at the start and at the end of the step [m³]
  std::vector<double> run_on_, next_;   ///< run-on as supplied, and as routed [m³/s]
};

}  // namespace talus::fem
