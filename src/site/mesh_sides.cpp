// SPDX-License-Identifier: MIT
// Elements and normals at named sides, and the search of the nearest side by bounding balls.
#include "site/mesh_sides.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "mesh/mesh.hpp"

namespace talus::site {

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

#define TALUS_INSTANTIATE(D)                                                                                \
  template const std::vector<mesh::Mesh<D>::Side>& find_sides<D>(const mesh::Mesh<D>&, const std::string&); \
  template SideMap<D> map_sides<D>(const mesh::Mesh<D>&, const std::vector<mesh::Mesh<D>::Side>&);          \
  template std::pair<Vec<D>, double> find_outward_normal<D>(const mesh::Mesh<D>&, int, int);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

namespace {

template <int D>
Vec<D> subtract(const Vec<D>& a, const Vec<D>& b) {
  Vec<D> r;
  for (std::size_t d = 0; d < D; ++d) r[d] = a[d] - b[d];
  return r;
}

/// Returns the distance of x from the segment a-b, in any number of dimensions.
template <int D>
double find_segment_distance(const Vec<D>& a, const Vec<D>& b, const Vec<D>& x) {
  const Vec<D> along = subtract<D>(b, a);
  Vec<D> rest = subtract<D>(x, a);
  const double share = std::clamp(dot(rest, along) / dot(along, along), 0.0, 1.0);
  for (std::size_t d = 0; d < D; ++d) rest[d] -= share * along[d];
  return norm(rest);
}

constexpr std::size_t group_size = 32;

/// Returns true if something in the ball may be nearer to `x` than `distance`.
template <int D>
bool is_in_reach(const Ball<D>& ball, const Vec<D>& x, double distance) {
  const Vec<D> away = subtract<D>(x, ball.centre);
  const double reach = distance + ball.radius;
  return dot(away, away) <= reach * reach;
}

}  // namespace

template <int D>
LabelledSide<D> make_labelled_side(const std::array<Vec<D>, D>& corners, int label) {
  LabelledSide<D> side{corners, label, {}};
  for (const Vec<D>& c : corners) {
    for (std::size_t d = 0; d < D; ++d) side.ball.centre[d] += c[d] / D;
  }
  for (const Vec<D>& c : corners) side.ball.radius = std::max(side.ball.radius, norm(subtract<D>(c, side.ball.centre)));
  return side;
}

template <>
double find_distance<2>(const std::array<Vec<2>, 2>& corners, const Vec<2>& x) {
  return find_segment_distance<2>(corners[0], corners[1], x);
}

template <>
double find_distance<3>(const std::array<Vec<3>, 3>& corners, const Vec<3>& x) {
  const Vec<3> u = subtract<3>(corners[1], corners[0]), v = subtract<3>(corners[2], corners[0]),
               r = subtract<3>(x, corners[0]);
  // Barycentric coordinates of the foot of the perpendicular; outside the triangle an edge is nearest.
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), ur = dot(u, r), vr = dot(v, r);
  const double area = uu * vv - uv * uv, s = (vv * ur - uv * vr) / area, t = (uu * vr - uv * ur) / area;
  if (s >= 0 && t >= 0 && s + t <= 1) {
    Vec<3> rest = r;
    for (std::size_t d = 0; d < 3; ++d) rest[d] -= s * u[d] + t * v[d];
    return norm(rest);
  }
  return std::min({find_segment_distance<3>(corners[0], corners[1], x),
                   find_segment_distance<3>(corners[1], corners[2], x),
                   find_segment_distance<3>(corners[2], corners[0], x)});
}

template <int D>
SideSet<D>::SideSet(std::vector<LabelledSide<D>> sides) : sides_(std::move(sides)) {
  for (std::size_t first = 0; first < sides_.size(); first += group_size) {
    const std::size_t end = std::min(first + group_size, sides_.size());
    Ball<D> group{sides_[first + (end - first) / 2].ball.centre, 0};
    for (std::size_t i = first; i < end; ++i) {
      const Ball<D>& ball = sides_[i].ball;
      group.radius = std::max(group.radius, norm(subtract<D>(ball.centre, group.centre)) + ball.radius);
    }
    groups_.push_back(group);
  }
}

template <int D>
NearestSides SideSet<D>::find_nearest(const Vec<D>& x, double tolerance, std::size_t& guess) const {
  const std::size_t first = guess;
  NearestSides nearest{find_distance<D>(sides_[first].corners, x), {sides_[first].label}};
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (!is_in_reach<D>(groups_[g], x, nearest.distance + tolerance)) continue;
    for (std::size_t i = g * group_size; i < std::min((g + 1) * group_size, sides_.size()); ++i) {
      if (i == first || !is_in_reach<D>(sides_[i].ball, x, nearest.distance + tolerance)) continue;
      const double distance = find_distance<D>(sides_[i].corners, x);
      if (distance > nearest.distance + tolerance) continue;
      if (distance < nearest.distance - tolerance) {
        nearest.labels.clear();
        guess = i;
      }
      nearest.distance = std::min(nearest.distance, distance);
      nearest.labels.push_back(sides_[i].label);
    }
  }
  return nearest;
}

template <int D>
std::vector<int> SideSet<D>::find_on_line(const Vec<D>& x, std::size_t axis) const {
  const auto meets = [&](const Ball<D>& ball) {
    Vec<D> on_line = x;
    on_line[axis] = ball.centre[axis];
    return is_in_reach<D>(ball, on_line, 0);
  };
  std::vector<int> labels;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (!meets(groups_[g])) continue;
    for (std::size_t i = g * group_size; i < std::min((g + 1) * group_size, sides_.size()); ++i) {
      if (meets(sides_[i].ball)) labels.push_back(sides_[i].label);
    }
  }
  return labels;
}

#define TALUS_INSTANTIATE(D)                                                         \
  template LabelledSide<D> make_labelled_side<D>(const std::array<Vec<D>, D>&, int); \
  template class SideSet<D>;
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::site
