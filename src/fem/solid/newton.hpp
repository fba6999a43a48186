// SPDX-License-Identifier: MIT
#pragma once
// One step of the equations of equilibrium: implicit creep towards rest, each of its steps by Newton's method (T19.6).
// Internal to fem/.

#include "fem/solid/system.hpp"
#include "fem/sparse_solver.hpp"

namespace talus::fem {

/// What a step came to.
struct NewtonOutcome {
  bool converged = false;
  bool flows = false;  ///< ended because the soil moves on at a steady rate, or too far
  int iterations = 0;  ///< linear systems
  double force_residual = 0, displacement_residual = 0;
};

template <int D>
class SolidNewton {
 public:
  SolidNewton(const SolidSystem<D>& system, const SolidOptions& options);

  /// Goes from `start`, whose displacements are added to, to where internal forces are `target`; `end` is the state
  /// there, or the last one.
  NewtonOutcome solve(const SolidAssembly<D>& assembly, const SolidState<D>& start, const std::vector<double>& target,
                      SolidState<D>& end);

  /// Displacements and strains of the last step of creep of solve(); empty where there was none.
  const SolidState<D>& last_motion() const { return last_motion_; }

  int factorisations() const { return solver_.factorisations(); }
  /// Largest displacement of the elastic soil under all loads [m]; known after the first step.
  double elastic_displacement() const { return elastic_displacement_; }

 private:
  /// A place on the way and the forces there.
  struct Place {
    SolidState<D> state;
    SolidSums sums;
    std::vector<double> residual;  ///< target - f_int [N]
    double fault = 0;              ///< its size [N]
  };
  void look(const SolidAssembly<D>& assembly, const SolidState<D>& from, const std::vector<double>& q,
            const std::vector<double>& target, Place& to);
  std::pair<bool, int> creep(const SolidAssembly<D>& assembly, const std::vector<double>& target, const Place& now,
                             double viscosity, Place& next, std::vector<double>& q);
  bool factorise(const SolidSums& sums, double viscosity);
  double find_lack(const Place& at, const std::vector<double>& q, double viscosity);
  bool is_steady(double moved, double fault);
  void find_elastic_displacement();

  const SolidSystem<D>& system_;
  SolidOptions options_;
  SparseSolver solver_;
  double load_size_;  ///< ‖f_ext‖, or where there is none the first residual [N]
  double scale_ = 0;
  double elastic_displacement_ = -1;   ///< negative: not known yet
  std::vector<double> elastic_;        ///< matrix of the elastic soil
  std::vector<double> matrix_, lack_;  ///< work
  std::vector<Vec<D>> u_;
  SolidState<D> last_motion_;
  std::vector<std::array<double, 2>> way_;  ///< displacement and fault of the steps so far
};

}  // namespace talus::fem
