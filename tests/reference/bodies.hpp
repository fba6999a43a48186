// SPDX-License-Identifier: MIT
#pragma once
// Small bodies for the plain step and for the comparison of the engine with it: jittered meshes of a box, filled up to
// a profile, with rollers and K0 stresses. y is upwards in 2D and 3D.

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "mesh/mesh.hpp"
#include "reference/plain_body.hpp"

namespace talus::reference {

/// The box from 0 to `size` [m] cut into `cells` rectangles and each of these into D! simplices (Kuhn's subdivision,
/// which conforms). Nodes inside the box are moved at random, each coordinate by at most `jitter` cell sizes
/// (< 0.2 keeps every element upright), so that nothing can hide behind the regularity of the mesh.
template <int D>
mesh::Mesh<D> make_box(const std::array<int, D>& cells, const std::array<double, D>& size, double jitter = 0.15,
                       unsigned seed = 1) {
  // mt19937 is the same everywhere; the standard distributions are not, so the number is scaled here.
  std::mt19937 random(seed);
  const auto draw = [&] { return 2 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1; };
  mesh::Mesh<D> mesh;
  std::array<int, D> stride{};
  int node_count = 1;
  for (int d = 0; d < D; ++d) {
    at(stride, d) = node_count;
    node_count *= at(cells, d) + 1;
  }
  for (int i = 0; i < node_count; ++i) {
    std::array<double, D> x{};
    std::array<int, D> index{};
    bool inside = true;
    for (int d = 0; d < D; ++d) {
      at(index, d) = i / at(stride, d) % (at(cells, d) + 1);
      inside = inside && at(index, d) > 0 && at(index, d) < at(cells, d);
    }
    for (int d = 0; d < D; ++d)
      at(x, d) = (at(index, d) + (inside ? jitter * draw() : 0.0)) * at(size, d) / at(cells, d);
    mesh.nodes.push_back(x);
  }
  for (int i = 0; i < node_count; ++i) {
    bool last = false;  // the node at the lower corner of a cell, or one on an upper face
    for (int d = 0; d < D; ++d) last = last || i / at(stride, d) % (at(cells, d) + 1) == at(cells, d);
    if (last) continue;
    std::array<int, D> order{};
    for (int d = 0; d < D; ++d) at(order, d) = d;
    do {  // one simplex for every way along D edges from the lower to the upper corner of the cell
      typename mesh::Mesh<D>::Element element{};
      element[0] = i;
      for (int k = 0; k < D; ++k) at(element, k + 1) = at(element, k) + at(stride, at(order, k));
      mesh.elements.push_back(element);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  mesh.element_region.assign(mesh.elements.size(), mesh::empty_region);
  mesh::finish(mesh);
  return mesh;
}

/// An empty body of one material on the mesh, all nodes free.
template <int D>
Body<D> make_body(const mesh::Mesh<D>& mesh, const Material& material) {
  Body<D> body;
  body.mesh = mesh;
  body.materials = {material};
  body.constraints.assign(mesh.nodes.size(), {});
  return body;
}

/// Fixes component `component` of every node whose coordinate `axis` is `value` [m].
template <int D>
void fix_face(Body<D>& body, int axis, double value, int component) {
  for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i)
    if (std::abs(at(body.mesh.nodes[i], axis) - value) < 1e-12) at(body.constraints[i].fixed, component) = true;
}

/// Rollers on the box from 0 to `size` [m]: the bottom (y = 0) is fixed fully, the other faces but the top normally.
template <int D>
void fix_box(Body<D>& body, const typename mesh::Mesh<D>::Point& size) {
  for (int d = 0; d < D; ++d) {
    fix_face(body, 1, 0.0, d);
    if (d == 1) continue;
    fix_face(body, d, 0.0, d);
    fix_face(body, d, at(size, d), d);
  }
}

/// Places D+1 points of equal volume in every element whose centroid `inside` accepts, near the element's nodes (the
/// points of the second-order Gauss rule).
template <int D, class Inside>
void fill(Body<D>& body, double density, int material, Inside inside) {
  const double near = D == 2 ? 2.0 / 3 : (5 + 3 * std::sqrt(5.0)) / 20;
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    Eigen::Matrix<double, D, D + 1> corners;
    for (int i = 0; i <= D; ++i)
      for (int d = 0; d < D; ++d) corners(d, i) = at(at(body.mesh.nodes, node_of(body.mesh, e, i)), d);
    if (!inside(Vector<D>(corners.rowwise().mean()))) continue;
    for (int i = 0; i <= D; ++i) {
      Weights<D> n = Weights<D>::Constant((1 - near) / D);
      n[i] = near;
      Point<D> point;
      point.id = static_cast<int>(body.points.size());
      point.element = e;
      point.material = material;
      point.x = corners * n;
      point.volume = at(body.mesh.volumes, e) / (D + 1);
      point.mass = density * point.volume;
      body.points.push_back(point);
    }
  }
}

/// A straight slope from (toe_x, toe_y) up to (crest_x, crest_y) between two levels [m].
struct Slope {
  double toe_x, toe_y, crest_x, crest_y;

  /// Height of the surface at `x` [m].
  double surface(double x) const {
    const double share = std::clamp((x - toe_x) / (crest_x - toe_x), 0.0, 1.0);
    return toe_y + share * (crest_y - toe_y);
  }
};

/// σ_yy = −ρ g (surface − y), the other two K0 of it. `gravity` is g in [m/s²].
template <int D>
void set_k0_stress(Body<D>& body, const Slope& slope, double gravity, double k0) {
  for (Point<D>& point : body.points) {
    const double depth = std::max(0.0, slope.surface(point.x[0]) - point.x[1]);
    const double vertical = -point.mass / point.volume * gravity * depth;
    point.sigma = Vector3(k0 * vertical, vertical, k0 * vertical).asDiagonal();
  }
}

/// A steep slope 3 m high that fails within a second: it yields in compression and tension, moves through many elements
/// and leaves elements partly filled. Box 8 m × 5 m (× 2 m).
template <int D>
Body<D> make_slope(unsigned seed = 1) {
  std::array<int, D> cells{};
  std::array<double, D> size{};
  for (int d = 0; d < D; ++d) {
    const int count[] = {D == 2 ? 16 : 8, D == 2 ? 10 : 5, 2};
    const double length[] = {8, 5, 2};
    at(cells, d) = count[d];
    at(size, d) = length[d];
  }
  Material soil;
  soil.young_modulus = 5e6;
  soil.poisson_ratio = 0.3;
  soil.plastic = true;
  soil.cohesion = 300;
  soil.friction_angle = 0.35;
  soil.dilatancy_angle = 0.1;
  soil.tensile_strength = 200;
  const double density = 1700, g = 9.81;
  const Slope slope{6, 1, 3, 4};
  Body<D> body = make_body(make_box<D>(cells, size, 0.15, seed), soil);
  body.gravity[1] = -g;
  fix_box(body, size);
  fill(body, density, 0, [&](const Vector<D>& x) { return x[1] < slope.surface(x[0]); });
  set_k0_stress(body, slope, g, 0.5);
  return body;
}

}  // namespace talus::reference
