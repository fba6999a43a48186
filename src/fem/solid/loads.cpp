// SPDX-License-Identifier: MIT
// Nodal forces of weight and of surface tractions, integrated exactly; directions fixed by supports; edges of the mesh.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "fem/solid/system.hpp"

namespace talus::fem {

namespace {

/// Nodal fractions of a weight or a uniform traction: of a corner and of a mid-side node of a triangle or tetrahedron.
template <int D>
inline constexpr double corner_share = D == 2 ? 0.0 : -1.0 / 20;
template <int D>
inline constexpr double middle_share = D == 2 ? 1.0 / 3 : 1.0 / 5;

double find_size(const mesh::Mesh<2>& mesh, const std::array<int, 2>& side) {
  const auto &a = mesh.nodes[static_cast<std::size_t>(side[0])], &b = mesh.nodes[static_cast<std::size_t>(side[1])];
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}
double find_size(const mesh::Mesh<3>& mesh, const std::array<int, 3>& side) {
  const auto &a = mesh.nodes[static_cast<std::size_t>(side[0])], &b = mesh.nodes[static_cast<std::size_t>(side[1])],
             &c = mesh.nodes[static_cast<std::size_t>(side[2])];
  const Vec<3> p{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, q{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return norm(Vec<3>{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]}) / 2;
}

/// Returns ∫N_i L_j over a side of unit size, for i over its corners and mid-side nodes and j over its corners.
template <int D>
double find_side_weight(std::size_t i, std::size_t j) {
  if constexpr (D == 2) {
    if (i == 2) return 1.0 / 3;
    return i == j ? 1.0 / 6 : 0;
  } else {
    if (i < 3) return i == j ? 1.0 / 30 : -1.0 / 60;
    const std::size_t a = i - 3, b = (i - 2) % 3;  // corners of the edge
    return j == a || j == b ? 2.0 / 15 : 1.0 / 15;
  }
}

}  // namespace

template <int D>
std::vector<Vec<D>> find_loads(const SolidModel<D>& model, const QuadraticMesh<D>& mesh) {
  using Q = Quadratic<D>;
  std::vector<Vec<D>> f(mesh.nodes.size(), Vec<D>{});
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    const double weight =
        model.unit_weight[static_cast<std::size_t>(mesh.linear_element[k])] * Q::points * mesh.weights[k * Q::points];
    for (std::size_t i = 0; i < Q::nodes; ++i) {
      const double share = i < Q::corners ? corner_share<D> : middle_share<D>;
      auto& at = f[static_cast<std::size_t>(mesh.elements[k][i])];
      for (std::size_t d = 0; d < D; ++d) at[d] += weight * share * model.direction[d];
    }
  }
  const EdgeMiddles<D> middles(mesh);
  const CutSet on_walls(list_cuts(model));
  for (const SurfaceLoad<D>& load : model.loads) {
    for (std::size_t s = 0; s < load.sides.size(); ++s) {
      if (on_walls.contains(load.sides[s][0], load.sides[s][1])) continue;  // the wall carries it
      const auto nodes = middles.find_side(load.sides[s]);
      if (nodes.empty())
        fail_input("the load '{}' acts on a side at {}, where there is no soil", load.name,
                   format_place(model.mesh->nodes[static_cast<std::size_t>(load.sides[s][0])], model.units.length));
      const double size = find_size(*model.mesh, load.sides[s]);
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t j = 0; j < D; ++j)
          for (std::size_t d = 0; d < D; ++d)
            f[static_cast<std::size_t>(nodes[i])][d] += size * find_side_weight<D>(i, j) * load.traction[s][j][d];
    }
  }
  return f;
}

template std::vector<Vec<2>> find_loads<2>(const SolidModel<2>&, const QuadraticMesh<2>&);
template std::vector<Vec<3>> find_loads<3>(const SolidModel<3>&, const QuadraticMesh<3>&);

// Directions that supports fix at the nodes, and the edges of the quadratic mesh by their corners.

namespace {

constexpr double same_wall = 0.9;     ///< cosine of the largest angle between sides of one curved wall
constexpr double independent = 1e-6;  ///< sine of the smallest angle at which a direction counts as independent

/// Returns the unit normal of a side, of either sign, times the size of the side.
Vec<2> find_normal(const mesh::Mesh<2>& mesh, const std::array<int, 2>& side) {
  const auto &a = mesh.nodes[static_cast<std::size_t>(side[0])], &b = mesh.nodes[static_cast<std::size_t>(side[1])];
  return {b[1] - a[1], a[0] - b[0]};
}
Vec<3> find_normal(const mesh::Mesh<3>& mesh, const std::array<int, 3>& side) {
  const auto &a = mesh.nodes[static_cast<std::size_t>(side[0])], &b = mesh.nodes[static_cast<std::size_t>(side[1])],
             &c = mesh.nodes[static_cast<std::size_t>(side[2])];
  const Vec<3> p{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, q{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

/// Adds the component of `v` that is not fixed yet.
template <int D>
void hold(std::vector<Vec<D>>& held, Vec<D> v) {
  const double length = norm(v);
  if (!(length > 0) || held.size() == D) return;
  for (double& x : v) x /= length;
  for (const Vec<D>& h : held) {
    const double along = dot(v, h);
    for (std::size_t d = 0; d < D; ++d) v[d] -= along * h[d];
  }
  const double rest = norm(v);
  if (rest < independent) return;
  for (double& x : v) x /= rest;
  held.push_back(v);
}

}  // namespace

template <int D>
EdgeMiddles<D>::EdgeMiddles(const QuadraticMesh<D>& mesh) {
  using Q = Quadratic<D>;
  for (const auto& element : mesh.elements)
    for (std::size_t i = 0; i < Q::edges.size(); ++i) {
      const int a = element[Q::edges[i][0]], b = element[Q::edges[i][1]], middle = element[Q::corners + i];
      const int first = mesh.find_original(a), second = mesh.find_original(b);
      edges_.push_back(first < second ? Edge{first, second, middle, a, b} : Edge{second, first, middle, b, a});
    }
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
}

template <int D>
auto EdgeMiddles<D>::find(int a, int b) const -> const Edge* {
  const Edge wanted{std::min(a, b), std::max(a, b), -1, -1, -1};
  const auto it = std::lower_bound(edges_.begin(), edges_.end(), wanted);
  return it != edges_.end() && (*it)[0] == wanted[0] && (*it)[1] == wanted[1] ? &*it : nullptr;
}

template <int D>
std::vector<int> EdgeMiddles<D>::find_side(const std::array<int, D>& side) const {
  std::vector<int> nodes(side.begin(), side.end());
  for (std::size_t i = 0; i < (D == 2 ? 1 : D); ++i) {
    const std::size_t j = (i + 1) % D;
    const Edge* edge = find(side[i], side[j]);
    if (!edge) return {};
    // A wall may have doubled the corners.
    nodes[i] = (*edge)[side[i] < side[j] ? 3 : 4];
    nodes[j] = (*edge)[side[i] < side[j] ? 4 : 3];
    nodes.push_back((*edge)[2]);
  }
  return nodes;
}

template <int D>
std::vector<std::vector<Vec<D>>> find_held_directions(const SolidModel<D>& model, const QuadraticMesh<D>& mesh) {
  const EdgeMiddles<D> middles(mesh);
  std::vector<std::vector<Vec<D>>> held(mesh.nodes.size());
  for (const Support<D>& support : model.supports) {
    std::vector<std::vector<Vec<D>>> walls(support.along_normal ? mesh.nodes.size() : 0);
    for (const auto& side : support.sides) {
      for (int node : middles.find_side(side)) {
        const auto n = static_cast<std::size_t>(node);
        if (!support.along_normal) {
          for (std::size_t d = 0; d < D; ++d) {
            Vec<D> axis{};
            axis[d] = 1;
            if (support.fixed[d]) hold<D>(held[n], axis);
          }
          continue;
        }
        // Sides of similar direction form a curved wall and fix its mean normal; others meet in a corner.
        Vec<D> normal = find_normal(*model.mesh, side);
        bool found = false;
        for (Vec<D>& wall : walls[n]) {
          const double cosine = dot(wall, normal) / (norm(wall) * norm(normal));
          if (std::abs(cosine) < same_wall) continue;
          for (std::size_t d = 0; d < D; ++d) wall[d] += cosine > 0 ? normal[d] : -normal[d];
          found = true;
          break;
        }
        if (!found) walls[n].push_back(normal);
      }
    }
    for (std::size_t n = 0; n < walls.size(); ++n)
      for (const Vec<D>& wall : walls[n]) hold<D>(held[n], wall);
  }
  return held;
}

template class EdgeMiddles<2>;
template class EdgeMiddles<3>;
template std::vector<std::vector<Vec<2>>> find_held_directions<2>(const SolidModel<2>&, const QuadraticMesh<2>&);
template std::vector<std::vector<Vec<3>>> find_held_directions<3>(const SolidModel<3>&, const QuadraticMesh<3>&);

}  // namespace talus::fem
