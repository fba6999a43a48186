// SPDX-License-Identifier: MIT
#pragma once
// The data of the plain material point method: points, nodes, elements and settings as plain structs, and the linear
// shape functions. The storage follows the theory: global coordinates, full tensors.

#include <Eigen/Dense>
#include <array>
#include <cstddef>
#include <vector>

#include "mesh/mesh.hpp"
#include "reference/plain_material.hpp"

namespace talus::reference {

template <int D>
using Vector = Eigen::Matrix<double, D, 1>;
template <int D>
using Weights = Eigen::Matrix<double, D + 1, 1>;  ///< N_i of an element's nodes [-]
template <int D>
using Gradients = Eigen::Matrix<double, D + 1, D>;  ///< ∇N_i of an element's nodes as rows [1/m]

template <int D>
struct Point {
  static constexpr int dimension = D;
  int id = 0;                       ///< stays with the point when others are removed
  int element = 0;                  ///< the element that contains x
  int material = 0;                 ///< index into Body::materials
  Vector<D> x = Vector<D>::Zero();  ///< [m]
  Vector<D> v = Vector<D>::Zero();  ///< [m/s]
  Tensor sigma = Tensor::Zero();    ///< tension positive; in plane strain with its own σ_zz [Pa]
  Tensor strain = Tensor::Zero();   ///< sum of the increments [-]
  double plastic_strain = 0;        ///< accumulated sqrt(2/3 e^p:e^p) [-]
  double gap = 0;                   ///< volumetric strain of the gap in separated soil [-]
  double volume = 0;                ///< V_p [m³], in 2D per metre of thickness
  double mass = 0;                  ///< m_p [kg]
  bool at_surface = false;          ///< for Settings::surface_points
};

/// Constraints of a node. The fixed components are removed first, then the motion along `normal` (zero: none).
template <int D>
struct Constraint {
  std::array<bool, D> fixed{};
  Vector<D> normal = Vector<D>::Zero();  ///< unit vector
  Vector<D> drive = Vector<D>::Zero();   ///< velocity of what holds the node, along what it holds [m/s]

  /// Returns the constrained velocity of the node for the trial velocity `wanted`.
  Vector<D> hold(const Vector<D>& wanted) const { return apply(wanted) + drive; }

  Vector<D> apply(Vector<D> vector) const {
    for (int d = 0; d < D; ++d)
      if (fixed[static_cast<std::size_t>(d)]) vector[d] = 0;
    return vector - normal.dot(vector) * normal;
  }
};

enum class Smoothing { none, strain, stable };

struct Settings {
  double time_step = 0;     ///< Δt [s]
  double damping = 0;       ///< α of (2.89) [-]
  double mass_scaling = 1;  ///< β of (2.91) [-]
  bool mixed = true;        ///< full elements are integrated as one Gauss point (2.92)
  Smoothing smoothing = Smoothing::none;
  bool objective = true;  ///< rotate the stress with the soil
  bool frozen = false;    ///< points and volumes stay as they are
  // Rules of other codes in the place of those of the engine (bench/plain_runout.cpp).
  bool fixed_nodes_brake = true;  ///< points take the speed of what holds a node; false: keep theirs beside it
  bool separates = true;          ///< soil that separates keeps a gap
  bool surface_points = false;    ///< an element is at the free surface where it holds a marked point
  bool smooths_three = false;     ///< smoothing changes ε_zz in plane strain too
};

/// The nodal fields of one step.
template <int D>
struct Node {
  double mass = 0;                               ///< m_i, without β [kg]
  Vector<D> momentum = Vector<D>::Zero();        ///< p_i at the start of the step [kg m/s]
  Vector<D> internal_force = Vector<D>::Zero();  ///< [N]
  Vector<D> external_force = Vector<D>::Zero();  ///< gravity and tractions [N]
  Vector<D> acceleration = Vector<D>::Zero();    ///< [m/s²]
  Vector<D> velocity = Vector<D>::Zero();        ///< after the remap [m/s]
};

/// Element quantities of one step.
struct Cell {
  std::vector<std::size_t> points;           ///< indices into Body::points
  bool full = false;                         ///< one Gauss point with the mean stress and the whole volume
  bool apart = false;                        ///< a point keeps a gap: takes no part in averages over the nodes
  Tensor gradient = Tensor::Zero();          ///< L = Σ v_i ⊗ ∇N_i [1/s]
  Tensor strain_increment = Tensor::Zero();  ///< Δε, smoothed with smoothing on [-]

  bool is_active() const { return !points.empty(); }
};

template <int D>
struct Body {
  mesh::Mesh<D> mesh;
  std::vector<Material> materials;
  std::vector<Constraint<D>> constraints;  ///< one per node
  std::vector<Vector<D>> tractions;        ///< nodal forces [N], one per node; empty: none
  Vector<D> gravity = Vector<D>::Zero();   ///< [m/s²]
  std::vector<Point<D>> points;
  int left = 0;                ///< points that have left the mesh and were removed
  std::vector<Node<D>> nodes;  ///< of the last step, to be looked at
  std::vector<Cell> cells;     ///< of the last step, one per element
  // By element, of the last step; empty before the first.
  std::vector<double> plastic_dilation;  ///< mean over the points [-]
  std::vector<double> rough;             ///< what averaging took from the elastic increment [-]
};

/// container[index] without the casts that an int index would need everywhere.
template <class Container>
auto& at(Container& container, int index) {
  return container[static_cast<std::size_t>(index)];
}

/// Number of the element's local node `i`.
template <int D>
int node_of(const mesh::Mesh<D>& mesh, int element, int i) {
  return at(at(mesh.elements, element), i);
}

/// N_i(x) of the element's nodes, Σ N_i = 1; N_i is the distance to the side opposite node i over its altitude.
template <int D>
Weights<D> shape_functions(const mesh::Mesh<D>& mesh, int element, const Vector<D>& x) {
  const auto& origin = at(mesh.nodes, node_of(mesh, element, 0));
  Weights<D> n = Weights<D>::Zero();
  for (int k = 0; k < D; ++k)
    for (int d = 0; d < D; ++d) n[k + 1] += at(at(mesh.gradients, element), k * D + d) * (x[d] - at(origin, d));
  n[0] = 1 - n.sum();
  return n;
}

template <int D>
Gradients<D> shape_gradients(const mesh::Mesh<D>& mesh, int element) {
  Gradients<D> b = Gradients<D>::Zero();
  for (int k = 0; k < D; ++k)
    for (int d = 0; d < D; ++d) b(k + 1, d) = at(at(mesh.gradients, element), k * D + d);
  b.row(0) = -b.colwise().sum();
  return b;
}

/// σ̄_e of (2.93) [Pa].
template <int D>
Tensor average_stress(const Body<D>& body, const Cell& cell) {
  Tensor sum = Tensor::Zero();
  double volume = 0;
  for (std::size_t p : cell.points) {
    sum += body.points[p].volume * body.points[p].sigma;
    volume += body.points[p].volume;
  }
  return sum / volume;
}

}  // namespace talus::reference
