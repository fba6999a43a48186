// SPDX-License-Identifier: MIT
#pragma once
// Small bodies for the plain step and for the comparison of the MPM step with it: jittered meshes of a box, filled up
// to a profile, with rollers and K0 stresses. y is upwards in 2D and 3D.

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
                       unsigned seed = 1);

/// An empty body of one material on the mesh, all nodes free.
template <int D>
Body<D> make_body(const mesh::Mesh<D>& mesh, const Material& material);

/// Fixes component `component` of every node whose coordinate `axis` is `value` [m].
template <int D>
void fix_face(Body<D>& body, int axis, double value, int component);

/// Rollers on the box from 0 to `size` [m]: the bottom (y = 0) is fixed fully, the other faces but the top normally.
template <int D>
void fix_box(Body<D>& body, const typename mesh::Mesh<D>::Point& size);

/// The face x = 0 is pushed in at 0.5 m/s, smooth but where it is fixed upwards: there it moves up as well.
template <int D>
void push_left_wall(const mesh::Mesh<D>& mesh, std::vector<Constraint<D>>& constraints) {
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    if (mesh.nodes[i][0] > 1e-9) continue;
    constraints[i].fixed[0] = true;
    constraints[i].drive[0] = 0.5;
    if (constraints[i].fixed[1]) constraints[i].drive[1] = 0.1;
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
void set_k0_stress(Body<D>& body, const Slope& slope, double gravity, double k0);

/// A steep slope 3 m high that fails within a second: it yields in compression and tension, moves through many elements
/// and leaves elements partly filled. Box 8 m × 5 m (× 2 m).
template <int D>
Body<D> make_slope(unsigned seed = 1);

}  // namespace talus::reference
