// SPDX-License-Identifier: MIT
#pragma once
// The equations of equilibrium of a model: unknowns, loads, pattern of the matrix, and assembly. Internal to fem/.

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "fem/solid/shape.hpp"
#include "fem/solid/solid.hpp"
#include "fem/solid/springs.hpp"
#include "material/law.hpp"

namespace talus::fem {

/// The unknowns of a node: its displacement is Σ axes[k]·q[unknown[k]] over the free ones.
template <int D>
struct NodeUnknowns {
  std::array<int, D> unknown;  ///< -1: fixed, or a node without soil
  std::array<Vec<D>, D> axes;  ///< orthonormal; the coordinate axes unless `turned`
  bool turned = false;
};

template <int D>
struct SolidSystem {
  using Q = Quadratic<D>;
  static constexpr std::size_t locals = Q::nodes * D;  ///< degrees of freedom of an element

  /// Throws Error (wrong_input) for a model without soil or support, with an inverted element, or with a load on no
  /// soil.
  explicit SolidSystem(const SolidModel<D>& model);

  const SolidModel<D>& model;
  QuadraticMesh<D> mesh;
  std::vector<NodeUnknowns<D>> nodes;
  SpringSet springs;  ///< of the bars, whose unknowns follow those of the nodes
  int unknowns = 0;
  std::vector<std::array<Vec<D>, D + 1>> gradients;  ///< of the barycentric coordinates, per element
  std::vector<std::array<double, Q::points>> pore;   ///< χ p at the integration points [Pa]
  std::vector<double> load;                          ///< f_ext, per unknown [N]
  std::vector<int> column_start, row;
  std::vector<std::array<int, locals * locals>> slots;  ///< index of each entry in the global matrix; -1: fixed
  std::vector<char> turned;                             ///< per element: one of its nodes has turned axes

  int region(std::size_t k) const {
    return model.mesh->element_region[static_cast<std::size_t>(mesh.linear_element[k])];
  }
  /// Convert displacements from unknowns to nodes, and nodal vectors to unknowns.
  void to_nodes(const std::vector<double>& q, std::vector<Vec<D>>& u) const;
  void to_unknowns(const std::vector<Vec<D>>& f, std::vector<double>& q) const;

 private:
  void make_pattern();
};

/// Returns the fixed directions of each node of the quadratic mesh, orthonormal.
template <int D>
std::vector<std::vector<Vec<D>>> find_held_directions(const SolidModel<D>& model, const QuadraticMesh<D>& mesh);

/// Returns the nodal forces of weight and surface loads [N].
template <int D>
std::vector<Vec<D>> find_loads(const SolidModel<D>& model, const QuadraticMesh<D>& mesh);

/// Look-up of the nodes of sides of the linear mesh.
template <int D>
class EdgeMiddles {
 public:
  explicit EdgeMiddles(const QuadraticMesh<D>& mesh);
  /// Returns the nodes of a side of the linear mesh: its corners, and the middles of its edges (0-1; in 3D 0-1, 1-2,
  /// 2-0). Empty if no soil has that side.
  std::vector<int> find_side(const std::array<int, D>& side) const;

 private:
  using Edge = std::array<int, 5>;  ///< corners of the linear mesh a < b, middle, nodes at a and b
  const Edge* find(int a, int b) const;
  std::vector<Edge> edges_;  ///< sorted
};

/// Look-up of the edges along which walls separate the soil.
class CutSet {
 public:
  explicit CutSet(const Cuts& cuts) {
    for (const auto& [a, b] : cuts) edges_.insert(std::minmax(a, b));
  }
  bool contains(int a, int b) const { return edges_.contains(std::minmax(a, b)); }

 private:
  std::set<std::pair<int, int>> edges_;
};

// Sums over the elements: internal forces and tangent. Internal to fem/.

/// Sums over the elements.
struct SolidSums {
  std::vector<double> force;   ///< f_int per unknown [N]
  std::vector<double> matrix;  ///< ∂f_int/∂q in the pattern of the system, if requested
  bool symmetric = true;       ///< of the matrix
  int yielding = 0;            ///< number of yielding integration points
};

template <int D>
class SolidAssembly {
 public:
  static constexpr int strains = static_cast<int>(Quadratic<D>::strains);

  /// `laws` per region.
  SolidAssembly(const SolidSystem<D>& system, std::vector<material::Law> laws, int threads,
                const SpringStage& stage = {});
  ~SolidAssembly();
  SolidAssembly(const SolidAssembly&) = delete;
  SolidAssembly& operator=(const SolidAssembly&) = delete;

  /// Number of state variables per point.
  int state_size() const { return state_size_; }
  const material::Law& get_law(std::size_t k) const;
  /// Returns the initial state: stress and state variables of the model.
  SolidState<D> make_start() const;

  /// Computes stress and state in `end` after the change `q` of the unknowns since `start`, and the sums.
  void evaluate(const SolidState<D>& start, const std::vector<double>& q, bool with_matrix, SolidState<D>& end,
                SolidSums& sums) const;
  /// Computes the elastic stiffness matrix at a state.
  void find_elastic_matrix(const SolidState<D>& at, std::vector<double>& matrix) const;
  /// Throws Error (unstable) if an external model reported a failure.
  void throw_failure() const;

 private:
  struct Element;
  void evaluate_element(std::size_t k, const SolidState<D>& start, const std::vector<Vec<D>>& u, bool with_matrix,
                        SolidState<D>& end, Element& sum) const;
  void add(std::size_t k, const Element& sum, bool with_matrix, SolidSums& sums) const;
  void turn(std::size_t k, bool with_matrix, Element& sum) const;
  void evaluate_springs(const SolidState<D>& start, const std::vector<double>& q, bool with_matrix, SolidState<D>& end,
                        SolidSums& sums) const;
  template <class Work>
  void for_batches(bool with_matrix, Work&& work, SolidSums& sums) const;

  const SolidSystem<D>& system_;
  std::vector<material::Law> laws_;
  int threads_;
  SpringStage stage_;
  int state_size_ = 1;
};

// One integration point: stress, state and consistent tangent after a strain increment. Internal to fem/.

/// Outcome of an update beside stress and state.
struct PointAnswer {
  bool yields = false;    ///< plastic in this increment
  bool symmetric = true;  ///< of the tangent
};

/// Updates stress and state (NS and state_size numbers) by the increment `d_epsilon`. If `tangent` (NS × NS, by rows)
/// is given, also computes ∂σ/∂Δε (T19.3): by automatic differentiation of the law, or by differences for external
/// models. Soil that softens keeps its softening strain, and so its strength.
template <int NS>
PointAnswer update_point(const material::Law& law, double saturation, const double* d_epsilon, double* sigma,
                         double* state, double* tangent);

/// Computes the elastic stiffness of a law at a stress and state (NS × NS, by rows).
template <int NS>
void find_elastic_stiffness(const material::Law& law, const double* sigma, const double* state, double* stiffness);

}  // namespace talus::fem
