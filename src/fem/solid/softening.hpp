// SPDX-License-Identifier: MIT
#pragma once
// Soil that softens (T19.13, T19.14): equilibrium with constant strengths and the fall of the strengths by the plastic
// strain of that equilibrium alternate until the strengths no longer fall. Internal to fem/.

#include "fem/solid/newton.hpp"

namespace talus::fem {

/// Outcome of a load step or trial.
struct SofteningOutcome : NewtonOutcome {
  int softenings = 0;  ///< number of times that strengths were lowered
};

template <int D>
class SolidSoftening {
 public:
  SolidSoftening(const SolidSystem<D>& system, const SolidOptions& options);

  /// Computes the equilibrium as SolidNewton::solve(), with strengths that belong to its plastic strains. It has failed
  /// if an equilibrium with constant strengths has: strengths do not rise again.
  SofteningOutcome solve(SolidNewton<D>& newton, const SolidAssembly<D>& assembly, const SolidState<D>& start,
                         const std::vector<double>& target, SolidState<D>& end);

 private:
  /// Fall of the strengths, over that from peak to residual.
  struct Fall {
    double largest = 0, mean = 0;
  };
  /// Sets the softening strain of all points from their plastic strains.
  Fall lower_strengths(const SolidAssembly<D>& assembly, SolidState<D>& state);
  void find_neighbours();
  double average(std::size_t k) const;

  const SolidSystem<D>& system_;
  int most_;
  double tolerance_;
  // Neighbours of element k of the quadratic mesh: start_[k] to start_[k + 1]; empty without a nonlocal length.
  std::vector<std::size_t> start_;
  std::vector<int> neighbour_;
  std::vector<double> weight_;
  std::vector<double> strain_, volume_;  ///< per element: mean plastic strain, and volume of soil that softens
};

// Steps that equilibrium and strength reduction have in common.

/// Returns the laws of all regions at a factor, with a placeholder for regions without elements.
template <int D>
std::vector<material::Law> make_laws(const SolidModel<D>& model, double factor);

/// Applies the loads of the model from `start` in load steps.
template <int D>
SolidResult<D> apply_loads(const SolidSystem<D>& system, SolidNewton<D>& newton, SolidSoftening<D>& softening,
                           const SolidAssembly<D>& assembly, const SolidOptions& options, const SolidState<D>& start);

}  // namespace talus::fem
