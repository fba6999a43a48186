// SPDX-License-Identifier: MIT
// Which directions the supports hold at which nodes, and the edges of the quadratic mesh by their corners.

#include <algorithm>
#include <cmath>

#include "fem/solid/system.hpp"

namespace talus::fem {
namespace {

constexpr double same_wall = 0.9;     ///< cosine of the angle up to which sides of one support are one curved wall
constexpr double independent = 1e-6;  ///< sine of the angle from which a direction counts as a further one

/// The unit normal of a side, of either sign, times the side's size.
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

/// Adds what of `v` is not held yet.
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
      const int a = element[Q::edges[i][0]], b = element[Q::edges[i][1]];
      edges_.push_back({std::min(a, b), std::max(a, b), element[Q::corners + i]});
    }
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
}

template <int D>
int EdgeMiddles<D>::find(int a, int b) const {
  const std::array<int, 3> wanted{std::min(a, b), std::max(a, b), -1};
  const auto it = std::lower_bound(edges_.begin(), edges_.end(), wanted);
  return it != edges_.end() && (*it)[0] == wanted[0] && (*it)[1] == wanted[1] ? (*it)[2] : -1;
}

template <int D>
std::vector<int> EdgeMiddles<D>::find_side(const std::array<int, D>& side) const {
  std::vector<int> nodes(side.begin(), side.end());
  for (std::size_t i = 0; i < (D == 2 ? 1 : D); ++i) {
    const int middle = find(side[i], side[(i + 1) % D]);
    if (middle < 0) return {};
    nodes.push_back(middle);
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
        // Sides of nearly one direction are a curved wall: their mean normal counts. Others meet in a corner.
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
