// SPDX-License-Identifier: MIT
#include "mesh/bisect.hpp"

#include <cmath>

namespace talus::mesh {

EdgeKey Bisector::find_longest(const std::array<int, 3>& triangle) const {
  EdgeKey longest{-1, -1};
  double length = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const int from = triangle[i], to = triangle[(i + 1) % 3];
    const auto &a = get(from), &b = get(to);
    const double own = std::hypot(b[0] - a[0], b[1] - a[1]);
    const EdgeKey key = make_edge_key(from, to);
    if (own > length * (1 + 1e-12) || (own > length * (1 - 1e-12) && key < longest))
      length = std::max(own, length), longest = key;
  }
  return longest;
}

Bisection Bisector::run(bool keeps_shape) {
  for (bool grows = keeps_shape; grows;) {
    grows = false;
    for (const auto& t : triangles_) {
      const bool touched = to_.middles.count(make_edge_key(t[0], t[1])) ||
                           to_.middles.count(make_edge_key(t[1], t[2])) || to_.middles.count(make_edge_key(t[2], t[0]));
      if (touched && to_.middles.try_emplace(find_longest(t), -1).second) grows = true;
    }
  }
  for (auto& [key, node] : to_.middles) {
    node = static_cast<int>(to_.nodes.size());
    const auto a = get(key.first), b = get(key.second);
    to_.nodes.push_back({0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])});
  }
  for (std::size_t e = 0; e < triangles_.size(); ++e) split(triangles_[e], {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, e);
  return std::move(to_);
}

void Bisector::split(const std::array<int, 3>& t, const Weights& w, std::size_t parent) {
  std::size_t side = 3;
  double length = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const EdgeKey key = make_edge_key(t[i], t[(i + 1) % 3]);
    if (!to_.middles.count(key)) continue;
    const auto &a = get(t[i]), &b = get(t[(i + 1) % 3]);
    const double own = std::hypot(b[0] - a[0], b[1] - a[1]);
    const bool is_longest = key == find_longest(t);
    if (is_longest || own > length) length = is_longest ? 1e300 : own, side = i;
  }
  if (side == 3) {
    to_.triangles.push_back(t);
    to_.parent.push_back(parent);
    to_.weights.push_back(w);
    return;
  }
  const std::size_t a = side, b = (side + 1) % 3, c = (side + 2) % 3;
  const int middle = to_.middles.at(make_edge_key(t[a], t[b]));
  std::array<double, 3> half{};
  for (std::size_t k = 0; k < 3; ++k) half[k] = 0.5 * (w[a][k] + w[b][k]);
  split({t[a], middle, t[c]}, {w[a], half, w[c]}, parent);
  split({middle, t[b], t[c]}, {half, w[b], w[c]}, parent);
}

Mesh<2> refine(const Mesh<2>& mesh, const std::vector<bool>& marked) {
  Bisector bisector(mesh.nodes, mesh.elements);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto& t = mesh.elements[e];
    if (!marked[e]) continue;
    for (std::size_t i = 0; i < 3; ++i) bisector.mark(make_edge_key(t[i], t[(i + 1) % 3]));
  }
  Bisection parts = bisector.run(true);
  Mesh<2> finer;
  finer.nodes = std::move(parts.nodes);
  finer.elements = std::move(parts.triangles);
  for (const std::size_t e : parts.parent) finer.element_region.push_back(mesh.element_region[e]);
  finer.region_names = mesh.region_names;
  for (const auto& [name, sides] : mesh.sides) {
    auto& own = finer.sides[name];
    for (const auto& [from, to] : sides) {
      const auto found = parts.middles.find(make_edge_key(from, to));
      const bool is_bisected = found != parts.middles.end();
      if (is_bisected) own.push_back({from, found->second});
      own.push_back({is_bisected ? found->second : from, to});
    }
  }
  finish(finer);
  return finer;
}

}  // namespace talus::mesh
