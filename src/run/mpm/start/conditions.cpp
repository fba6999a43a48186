// SPDX-License-Identifier: MIT
#include "run/mpm/start/conditions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "mpm/body/observe.hpp"

namespace talus::run {
namespace {

template <int D>
mpm::Constraint<D>& get_constraint(mpm::Conditions<D>& conditions, int node) {
  int& index = conditions.constraint_of_node[node];
  if (index < 0) {
    index = static_cast<int>(conditions.constraints.size());
    conditions.constraints.emplace_back();
  }
  return conditions.constraints[index];
}

template <int D>
Vec<D> truncate(const std::array<double, 3>& v) {
  Vec<D> r;
  for (std::size_t d = 0; d < D; ++d) r[d] = v[d];
  return r;
}

/// Along `normal` the node moves with `velocity` [m/s], as far as what came before says nothing of that.
template <int D>
void hold(mpm::Constraint<D>& c, const std::type_identity_t<Vec<D>>& normal,
          const std::type_identity_t<Vec<D>>& velocity) {
  const int before = c.fixed_count;
  ground::add_direction<D>(c.fixed, c.fixed_count, normal);
  if (c.fixed_count == before) return;
  const Vec<D>& rest = c.fixed[before];  // of the normal, without the directions before it
  const double speed = (dot(velocity, normal) - dot(c.drive, normal)) / dot(rest, normal);
  for (std::size_t d = 0; d < D; ++d) c.drive[d] += speed * rest[d];
}

template <int D>
void hold_all(mpm::Constraint<D>& c, const std::type_identity_t<Vec<D>>& velocity) {
  for (std::size_t d = 0; d < D; ++d) {
    Vec<D> axis{};
    axis[d] = 1;
    hold(c, axis, velocity);
  }
}

/// Index of a factor among those of boundaries that move.
template <int D>
int add_factor(mpm::Conditions<D>& conditions, const input::TimeTable& factor) {
  auto& all = conditions.factors;
  const auto same = std::find_if(all.begin(), all.end(), [&](const input::TimeTable& f) {
    return f.time == factor.time && f.value == factor.value;
  });
  if (same != all.end()) return static_cast<int>(same - all.begin());
  all.push_back(factor);
  return static_cast<int>(all.size()) - 1;
}

template <int D>
void move_along(mpm::Constraint<D>& c, const input::Boundary& boundary, int factor) {
  if (c.factor >= 0 && c.factor != factor && c.fixed_count < D)
    throw Error(ExitCode::wrong_input,
                fmt::format("the boundary '{}' meets another one that moves, and their velocities have different "
                            "factors: give both the same 'factor' in [[boundary]]",
                            boundary.on));
  if (c.factor < 0) c.factor = factor;
}

template <int D>
void apply_boundary(mpm::Body<D>& body, const input::Boundary& boundary, const std::type_identity_t<Vec<D>>& gravity) {
  const auto& sides = ground::find_sides(body.mesh(), boundary.on);
  mpm::Conditions<D>& conditions = body.conditions;
  const Vec<D> velocity = truncate<D>(boundary.velocity);
  const int factor = boundary.fix == input::Fix::velocity ? add_factor(conditions, boundary.factor) : -1;
  for (const auto& [node, normals] : ground::find_node_normals(body, sides, gravity)) {
    mpm::Constraint<D>& c = get_constraint(conditions, node);
    switch (boundary.fix) {
      case input::Fix::full:
        hold_all(c, {});
        break;
      case input::Fix::normal:
        for (const Vec<D>& n : normals) hold(c, n, {});
        break;
      case input::Fix::plane:
        hold(c, truncate<D>(boundary.normal), {});
        break;
      case input::Fix::friction:
        c.has_wall = true;
        c.wall_normal = normals.front();
        c.friction = boundary.friction;
        break;
      case input::Fix::velocity:
        move_along(c, boundary, factor);
        if (boundary.smooth)
          for (const Vec<D>& n : normals) hold(c, n, velocity);
        else
          hold_all(c, velocity);
        break;
    }
  }
}

template <int D>
void apply_traction(mpm::Body<D>& body, const input::Traction& traction) {
  const auto& mesh = body.mesh();
  mpm::Load<D> load;
  load.on_points = traction.carrier == input::Carrier::points;
  load.factor = traction.factor;
  const Vec<D> t = truncate<D>(traction.traction);
  for (const auto& [side, elements] : ground::map_sides<D>(mesh, ground::find_sides(mesh, traction.on))) {
    if (elements.empty()) continue;
    const double area = ground::find_outward_normal(mesh, elements.front().element, elements.front().opposite).second;
    Vec<D> force;
    if (!load.on_points) {
      for (std::size_t d = 0; d < D; ++d) force[d] = t[d] * area / D;
      for (int node : side) load.entries.push_back({node, force});
      continue;
    }
    for (const ground::SideElement& s : elements) {
      if (body.points.count[s.element] == 0) continue;
      for (std::size_t d = 0; d < D; ++d) force[d] = t[d] * area;
      load_nearest_points(body, s, force, load);
      break;
    }
  }
  body.conditions.loads.push_back(std::move(load));
}

}  // namespace

template <int D>
void load_nearest_points(const mpm::Body<D>& body, const ground::SideElement& side,
                         const std::type_identity_t<Vec<D>>& force, mpm::Load<D>& load) {
  // Nearest: smallest shape function of the opposite node.
  std::vector<std::pair<double, int>> near;
  const int block = side.element / lane_width;
  for (int k = 0; k < static_cast<int>(body.points.count[side.element]); ++k) {
    const int id = body.points.id[static_cast<std::size_t>((body.points.block_start[block] + k) * lane_width +
                                                           side.element % lane_width)];
    const auto xi = mesh::to_local(body.mesh(), side.element, mpm::view_point(body, id).position);
    double shape = 1;
    for (double x : xi) shape -= x;
    if (side.opposite > 0) shape = xi[side.opposite - 1];
    near.emplace_back(shape, id);
  }
  const double nearest = std::min_element(near.begin(), near.end())->first;
  std::erase_if(near, [&](const auto& n) { return n.first > nearest + 1e-6; });
  Vec<D> share = force;
  for (double& f : share) f /= static_cast<double>(near.size());
  for (const auto& [shape, id] : near) load.entries.push_back({id, share});
}

template <int D>
void resolve_conditions(mpm::Body<D>& body, const input::Case& data) {
  body.conditions = {};
  body.conditions.constraint_of_node.assign(body.mesh().nodes.size(), -1);
  Vec<D> gravity = truncate<D>(data.gravity.direction);
  // What moves first: where it meets what stands, its nodes move.
  for (const bool moves : {true, false})
    for (const input::Boundary& boundary : data.boundaries)
      if ((boundary.fix == input::Fix::velocity) == moves) apply_boundary(body, boundary, gravity);
  for (const input::Traction& traction : data.tractions) apply_traction(body, traction);
}

template void resolve_conditions<2>(mpm::Body<2>&, const input::Case&);
template void resolve_conditions<3>(mpm::Body<3>&, const input::Case&);
template void load_nearest_points<2>(const mpm::Body<2>&, const ground::SideElement&, const Vec<2>&, mpm::Load<2>&);
template void load_nearest_points<3>(const mpm::Body<3>&, const ground::SideElement&, const Vec<3>&, mpm::Load<3>&);

}  // namespace talus::run
