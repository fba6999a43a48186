#include "analysis/conditions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "mpm/observe.hpp"

namespace talus::analysis {
namespace {

/// Sides whose normals differ by less than this are one smooth line: a node between them gets their mean.
const double smooth_cosine = std::cos(20 * 3.14159265358979 / 180);

template <int D>
const std::vector<typename mesh::Mesh<D>::Side>& find_sides(const mesh::Mesh<D>& mesh, const std::string& name) {
  const auto found = mesh.sides.find(name);
  if (found != mesh.sides.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, sides] : mesh.sides) names.push_back(known);
  throw Error(ExitCode::wrong_input, fmt::format("the mesh has no side '{}'; it has {}", name, fmt::join(names, ", ")));
}

/// Elements at a side: those that contain all its nodes, with the local node that lies opposite.
struct SideElement {
  int element, opposite;
};

template <int D>
using SideMap = std::map<std::array<int, D>, std::vector<SideElement>>;

template <int D>
SideMap<D> map_sides(const mesh::Mesh<D>& mesh, const std::vector<typename mesh::Mesh<D>::Side>& wanted) {
  SideMap<D> found;
  for (auto side : wanted) {
    std::sort(side.begin(), side.end());
    found[side];
  }
  for (int e = 0; e < mesh.element_count(); ++e) {
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

/// Unit normal of the element's side opposite local node k, out of the element; and the side's area [m, m²].
template <int D>
std::pair<Vec<D>, double> find_outward_normal(const mesh::Mesh<D>& mesh, int e, int k) {
  // ∇N_k points from the side into the element, and |∇N_k| = 1/altitude.
  Vec<D> n{};
  for (int d = 0; d < D; ++d) {
    if (k > 0) {
      n[d] = -mesh.gradients[e][(k - 1) * D + d];
    } else {
      for (int j = 0; j < D; ++j) n[d] += mesh.gradients[e][j * D + d];
    }
  }
  const double steepness = norm(n);
  for (double& c : n) c /= steepness;
  return {n, D * mesh.volumes[e] * steepness};
}

/// Normal of a wall, out of the soil: away from the element that holds soil, or else along gravity.
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

/// Normals at each node of the named sides, those of one smooth line averaged.
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
mpm::Constraint<D>& get_constraint(mpm::Conditions<D>& conditions, int node) {
  int& index = conditions.constraint_of_node[node];
  if (index < 0) {
    index = static_cast<int>(conditions.constraints.size());
    conditions.constraints.emplace_back();
  }
  return conditions.constraints[index];
}

/// Adds a direction to those that are fixed, orthonormal to them; nothing when it lies among them already.
template <int D>
void fix_direction(mpm::Constraint<D>& c, std::type_identity_t<Vec<D>> n) {
  for (int k = 0; k < c.fixed_count; ++k) {
    const double along = dot(n, c.fixed[k]);
    for (std::size_t d = 0; d < D; ++d) n[d] -= along * c.fixed[k][d];
  }
  const double rest = norm(n);
  if (rest < 1e-6 || c.fixed_count == D) return;
  for (double& x : n) x /= rest;
  c.fixed[c.fixed_count++] = n;
}

template <int D>
Vec<D> truncate(const std::array<double, 3>& v) {
  Vec<D> r;
  for (std::size_t d = 0; d < D; ++d) r[d] = v[d];
  return r;
}

template <int D>
void apply_boundary(mpm::Body<D>& body, const model::Boundary& boundary, const std::type_identity_t<Vec<D>>& gravity) {
  const auto& sides = find_sides(body.mesh(), boundary.on);
  mpm::Conditions<D>& conditions = body.conditions;
  if (boundary.fix == model::Fix::velocity)
    conditions.prescribed.push_back({truncate<D>(boundary.velocity), boundary.factor});
  for (const auto& [node, normals] : find_node_normals(body, sides, gravity)) {
    mpm::Constraint<D>& c = get_constraint(conditions, node);
    switch (boundary.fix) {
      case model::Fix::full:
        for (std::size_t d = 0; d < D; ++d) {
          Vec<D> axis{};
          axis[d] = 1;
          fix_direction(c, axis);
        }
        break;
      case model::Fix::normal:
        for (const Vec<D>& n : normals) fix_direction(c, n);
        break;
      case model::Fix::plane:
        fix_direction(c, truncate<D>(boundary.normal));
        break;
      case model::Fix::friction:
        c.has_wall = true;
        c.wall_normal = normals.front();
        c.friction = boundary.friction;
        break;
      case model::Fix::velocity:
        c.prescribed = static_cast<int>(conditions.prescribed.size()) - 1;
        break;
    }
  }
}

template <int D>
void apply_traction(mpm::Body<D>& body, const model::Traction& traction) {
  const auto& mesh = body.mesh();
  mpm::Load<D> load;
  load.on_points = traction.carrier == model::Carrier::points;
  load.factor = traction.factor;
  const Vec<D> t = truncate<D>(traction.traction);
  for (const auto& [side, elements] : map_sides<D>(mesh, find_sides(mesh, traction.on))) {
    if (elements.empty()) continue;
    const double area = find_outward_normal(mesh, elements.front().element, elements.front().opposite).second;
    Vec<D> force;
    if (!load.on_points) {
      for (std::size_t d = 0; d < D; ++d) force[d] = t[d] * area / D;
      for (int node : side) load.entries.push_back({node, force});
      continue;
    }
    for (const SideElement& s : elements) {
      if (body.points.count[s.element] == 0) continue;
      // The points nearest to the side carry it (2.32): smallest shape function of the opposite node.
      std::vector<std::pair<double, int>> near;
      const int block = s.element / lane_width;
      for (int k = 0; k < static_cast<int>(body.points.count[s.element]); ++k) {
        const int id = body.points.id[static_cast<std::size_t>((body.points.block_start[block] + k) * lane_width +
                                                               s.element % lane_width)];
        const auto xi = mesh::to_local(mesh, s.element, mpm::view_point(body, id).position);
        double shape = 1;
        for (double x : xi) shape -= x;
        if (s.opposite > 0) shape = xi[s.opposite - 1];
        near.emplace_back(shape, id);
      }
      const double nearest = std::min_element(near.begin(), near.end())->first;
      std::erase_if(near, [&](const auto& n) { return n.first > nearest + 1e-6; });
      for (std::size_t d = 0; d < D; ++d) force[d] = t[d] * area / static_cast<double>(near.size());
      for (const auto& [shape, id] : near) load.entries.push_back({id, force});
      break;
    }
  }
  body.conditions.loads.push_back(std::move(load));
}

}  // namespace

template <int D>
void resolve_conditions(mpm::Body<D>& body, const model::Case& data) {
  body.conditions = {};
  body.conditions.constraint_of_node.assign(body.mesh().nodes.size(), -1);
  Vec<D> gravity = truncate<D>(data.gravity.direction);
  for (const model::Boundary& boundary : data.boundaries) apply_boundary(body, boundary, gravity);
  for (const model::Traction& traction : data.tractions) apply_traction(body, traction);
}

template void resolve_conditions<2>(mpm::Body<2>&, const model::Case&);
template void resolve_conditions<3>(mpm::Body<3>&, const model::Case&);

}  // namespace talus::analysis
