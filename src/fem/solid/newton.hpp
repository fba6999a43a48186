// SPDX-License-Identifier: MIT
#pragma once
// One step of equilibrium: creep to rest in implicit steps, each solved by Newton's method (T19.6). Internal to fem/.

#include <memory>

#include "fem/solid/creep.hpp"
#include "fem/solid/system.hpp"
#include "sparse/solver.hpp"

namespace talus::fem {

/// Outcome of a step.
struct NewtonOutcome {
  bool converged = false;
  bool flows = false;  ///< ended because the soil flows at a steady rate, or has moved too far
  int iterations = 0;  ///< number of linear systems
  double force_residual = 0, displacement_residual = 0;
};

template <int D>
class SolidNewton {
 public:
  SolidNewton(const SolidSystem<D>& system, const SolidOptions& options);

  /// Integrates from `start`, whose displacements are continued, to the equilibrium of the internal forces with
  /// `target`. `end` is the state of equilibrium, or the last one reached.
  NewtonOutcome solve(const SolidAssembly<D>& assembly, const SolidState<D>& start, const std::vector<double>& target,
                      SolidState<D>& end);

  /// Displacements and strains of the last creep step of solve(); empty if there was none.
  const SolidState<D>& last_motion() const { return last_motion_; }

  int factorisations() const { return factorisations_; }
  /// Largest displacement of the elastic soil under all loads [m]; available after the first step.
  double elastic_displacement() const { return elastic_displacement_; }

 private:
  /// A state on the path and its forces.
  struct Place {
    SolidState<D> state;
    SolidSums sums;
    std::vector<double> residual;  ///< target - f_int [N]
    double fault = 0;              ///< out-of-balance force, the norm of the residual [N]
  };
  void look(const SolidAssembly<D>& assembly, const SolidState<D>& from, const std::vector<double>& q,
            const std::vector<double>& target, Place& to);
  std::pair<bool, int> creep(const SolidAssembly<D>& assembly, const std::vector<double>& target, const Place& now,
                             double viscosity, Place& next, std::vector<double>& q);
  bool find_change(const SolidSums& sums, double viscosity, std::vector<double>& change);
  void for_columns(auto&& work) const;
  bool factorise(bool symmetric);
  bool solve_with_factors(std::vector<double>& x);
  bool solve_in_3d(bool symmetric, double tolerance, const std::vector<double>& b, std::vector<double>& x);
  bool solve_approximately(const std::vector<double>& b, double tolerance, std::vector<double>& x);
  double find_lack(const Place& at, const std::vector<double>& q, double viscosity);
  bool is_steady(double moved, double fault);
  void find_elastic_displacement();

  const SolidSystem<D>& system_;
  SolidOptions options_;
  std::unique_ptr<sparse::SparseSolver<float>> rough_;  ///< in 3D, while its precision suffices
  std::unique_ptr<sparse::SparseSolver<>> solver_;      ///< made when it is needed
  int factorisations_ = 0;
  bool has_factors_ = false;
  double load_size_;  ///< ‖f_ext‖, or without loads the norm of the first residual [N]
  double scale_ = 0;
  double elastic_displacement_ = -1;   ///< negative: not computed yet
  std::vector<double> elastic_;        ///< stiffness matrix of the elastic soil
  std::vector<double> matrix_, lack_;  ///< work arrays
  SolidState<D> last_motion_;
  creep::Way way_;
};

}  // namespace talus::fem
