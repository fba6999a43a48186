// SPDX-License-Identifier: MIT
#include "ground/side_normals.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mesh/shape_gradient.hpp"

namespace talus::ground {
namespace {

/// Sides whose normals differ by less than this are one smooth line: a node between them gets their mean.
const double smooth_cosine = std::cos(20 * 3.14159265358979 / 180);

}  // namespace

template <int D>
const std::vector<typename mesh::Mesh<D>::Side>& find_sides(const mesh::Mesh<D>& mesh, const std::string& name) {
  const auto found = mesh.sides.find(name);
  if (found != mesh.sides.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, sides] : mesh.sides) names.push_back(known);
  throw Error(ExitCode::wrong_input, fmt::format("the mesh has no side '{}'; it has {}", name, fmt::join(names, ", ")));
}

template <int D>
SideMap<D> map_sides(const mesh::Mesh<D>& mesh, const std::vector<typename mesh::Mesh<D>::Side>& wanted) {
  SideMap<D> found;
  std::vector<char> on_side(mesh.nodes.size(), 0);
  for (auto side : wanted) {
    std::sort(side.begin(), side.end());
    found[side];
    for (int node : side) on_side[node] = 1;
  }
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto& nodes = mesh.elements[e];
    if (std::count_if(nodes.begin(), nodes.end(), [&](int i) { return on_side[i] != 0; }) < D) continue;
    for (int k = 0; k <= D; ++k) {
      std::array<int, D> side;
      std::size_t n = 0;
      for (int j = 0; j <= D; ++j) {
        if (j != k) side[n++] = mesh.elements[e][j];
      }
      std::sort(side.begin(), side.end());
      const auto at = found.find(side);
      if (at != found.end()) at->second.push_back({e, k});
    }
  }
  return found;
}

template <int D>
std::pair<Vec<D>, double> find_outward_normal(const mesh::Mesh<D>& mesh, int e, int k) {
  // ∇N_k points from the side into the element, and |∇N_k| = 1/altitude.
  Vec<D> n = mesh::find_shape_gradient(mesh, e, k);
  const double steepness = norm(n);
  for (double& c : n) c /= -steepness;
  return {n, D * mesh.volumes[e] * steepness};
}

template <int D>
Vec<D> find_wall_normal(const mpm::Body<D>& body, const std::vector<SideElement>& elements,
                        const std::type_identity_t<Vec<D>>& gravity) {
  for (const SideElement& s : elements) {
    if (elements.size() == 1 || body.points.count[s.element] > 0)
      return find_outward_normal(body.mesh(), s.element, s.opposite).first;
  }
  Vec<D> n = find_outward_normal(body.mesh(), elements.front().element, elements.front().opposite).first;
  if (dot(n, gravity) < 0) {
    for (double& c : n) c = -c;
  }
  return n;
}

template <int D>
std::map<int, std::vector<Vec<D>>> find_node_normals(const mpm::Body<D>& body,
                                                     const std::vector<typename mesh::Mesh<D>::Side>& sides,
                                                     const std::type_identity_t<Vec<D>>& gravity) {
  std::map<int, std::vector<Vec<D>>> sums;
  for (const auto& [side, elements] : map_sides<D>(body.mesh(), sides)) {
    if (elements.empty()) continue;
    const Vec<D> n = find_wall_normal(body, elements, gravity);
    for (int node : side) {
      auto& list = sums[node];
      const auto same =
          std::find_if(list.begin(), list.end(), [&](const Vec<D>& s) { return dot(s, n) > smooth_cosine * norm(s); });
      if (same == list.end())
        list.push_back(n);
      else
        for (std::size_t d = 0; d < D; ++d) (*same)[d] += n[d];
    }
  }
  for (auto& [node, list] : sums) {
    for (Vec<D>& n : list) {
      const double length = norm(n);
      for (double& c : n) c /= length;
    }
  }
  return sums;
}

template <int D>
void add_direction(Vec<D> (&fixed)[D], int& count, std::type_identity_t<Vec<D>> n) {
  for (int k = 0; k < count; ++k) {
    const double along = dot(n, fixed[k]);
    for (std::size_t d = 0; d < D; ++d) n[d] -= along * fixed[k][d];
  }
  const double rest = norm(n);
  if (rest < 1e-6 || count == D) return;
  for (double& x : n) x /= rest;
  fixed[count++] = n;
}

#define TALUS_INSTANTIATE(D)                                                                                \
  template const std::vector<mesh::Mesh<D>::Side>& find_sides<D>(const mesh::Mesh<D>&, const std::string&); \
  template SideMap<D> map_sides<D>(const mesh::Mesh<D>&, const std::vector<mesh::Mesh<D>::Side>&);          \
  template std::pair<Vec<D>, double> find_outward_normal<D>(const mesh::Mesh<D>&, int, int);                \
  template Vec<D> find_wall_normal<D>(const mpm::Body<D>&, const std::vector<SideElement>&, const Vec<D>&); \
  template std::map<int, std::vector<Vec<D>>> find_node_normals<D>(                                         \
      const mpm::Body<D>&, const std::vector<mesh::Mesh<D>::Side>&, const Vec<D>&);                         \
  template void add_direction<D>(Vec<D>(&)[D], int&, Vec<D>);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::ground
