// SPDX-License-Identifier: MIT
#pragma once
// Sums over the elements: internal forces and tangents. Internal to fem/.

#include "fem/solid/system.hpp"

namespace talus::fem {

/// What the elements add up to.
struct SolidSums {
  std::vector<double> force;   ///< f_int per unknown [N]
  std::vector<double> matrix;  ///< ∂f_int/∂q in the pattern of the system, where asked for
  bool symmetric = true;       ///< of the matrix
  int yielding = 0;            ///< integration points
};

template <int D>
class SolidAssembly {
 public:
  static constexpr int strains = static_cast<int>(Quadratic<D>::strains);

  /// `laws` by region.
  SolidAssembly(const SolidSystem<D>& system, std::vector<material::Law> laws, int threads);

  /// State variables per point.
  int state_size() const { return state_size_; }
  /// A state that nothing has happened to: the model's initial stress and state.
  SolidState<D> make_start() const;

  /// Stress and state in `end` after the displacement `u` (per node) since `start`, and the sums.
  void evaluate(const SolidState<D>& start, const std::vector<Vec<D>>& u, bool with_matrix, SolidState<D>& end,
                SolidSums& sums) const;
  /// The matrix of elasticity at a state.
  void find_elastic_matrix(const SolidState<D>& at, std::vector<double>& matrix) const;
  /// Throws what an external model could not do.
  void throw_failure() const;

 private:
  struct Element;
  void evaluate_element(std::size_t k, const SolidState<D>& start, const std::vector<Vec<D>>& u, bool with_matrix,
                        SolidState<D>& end, Element& sum) const;
  void add(std::size_t k, const Element& sum, bool with_matrix, SolidSums& sums) const;
  void turn(std::size_t k, bool with_matrix, Element& sum) const;
  template <class Work>
  void for_batches(bool with_matrix, Work&& work, SolidSums& sums) const;

  const SolidSystem<D>& system_;
  std::vector<material::Law> laws_;
  int threads_;
  int state_size_ = 1;
};

}  // namespace talus::fem
