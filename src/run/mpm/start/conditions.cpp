// SPDX-License-Identifier: MIT
#include "run/mpm/start/conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/error.hpp"
#include "mpm/solver/observe.hpp"
#include "run/mpm/start/prepare.hpp"
#include "site/mesh_sides.hpp"
#include "site/roots.hpp"
#include "site/seepage_model.hpp"

namespace talus::run {

namespace {

/// Sides whose normals differ by a smaller angle form a smooth line: nodes between them get the mean normal.
const double smooth_cosine = std::cos(20 * 3.14159265358979 / 180);

/// Returns the normal of a wall, out of the soil: away from the element with soil, or else in the direction of gravity.
template <int D>
Vec<D> find_wall_normal(const mpm::Body<D>& body, const std::vector<site::SideElement>& elements,
                        const std::type_identity_t<Vec<D>>& gravity) {
  for (const site::SideElement& s : elements) {
    if (elements.size() == 1 || body.points.count[s.element] > 0)
      return site::find_outward_normal(body.mesh(), s.element, s.opposite).first;
  }
  Vec<D> n = site::find_outward_normal(body.mesh(), elements.front().element, elements.front().opposite).first;
  if (dot(n, gravity) < 0) {
    for (double& c : n) c = -c;
  }
  return n;
}

/// Returns the normals at each node of the named sides, averaged along smooth lines.
template <int D>
std::map<int, std::vector<Vec<D>>> find_node_normals(const mpm::Body<D>& body,
                                                     const std::vector<typename mesh::Mesh<D>::Side>& sides,
                                                     const std::type_identity_t<Vec<D>>& gravity) {
  std::map<int, std::vector<Vec<D>>> sums;
  for (const auto& [side, elements] : site::map_sides<D>(body.mesh(), sides)) {
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

/// Adds a direction to the fixed ones (`count` of them, orthonormal) unless it lies in their span.
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

/// Prescribes `velocity` [m/s] along `normal`, in so far as earlier conditions leave that direction free.
template <int D>
void hold(mpm::Constraint<D>& c, const std::type_identity_t<Vec<D>>& normal,
          const std::type_identity_t<Vec<D>>& velocity) {
  const int before = c.fixed_count;
  add_direction<D>(c.fixed, c.fixed_count, normal);
  if (c.fixed_count == before) return;
  const Vec<D>& rest = c.fixed[before];  // component of the normal orthogonal to the earlier directions
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

/// Returns the index of `factor` in the list of time factors of moving boundaries.
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
  const auto& sides = site::find_sides(body.mesh(), boundary.on);
  mpm::Conditions<D>& conditions = body.conditions;
  const Vec<D> velocity = truncate<D>(boundary.velocity);
  const int factor = boundary.fix == input::Fix::velocity ? add_factor(conditions, boundary.factor) : -1;
  for (const auto& [node, normals] : find_node_normals(body, sides, gravity)) {
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
  for (const auto& [side, elements] : site::map_sides<D>(mesh, site::find_sides(mesh, traction.on))) {
    if (elements.empty()) continue;
    const double area = site::find_outward_normal(mesh, elements.front().element, elements.front().opposite).second;
    Vec<D> force;
    if (!load.on_points) {
      for (std::size_t d = 0; d < D; ++d) force[d] = t[d] * area / D;
      for (int node : side) load.entries.push_back({node, force});
      continue;
    }
    for (const site::SideElement& s : elements) {
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
void load_nearest_points(const mpm::Body<D>& body, const site::SideElement& side,
                         const std::type_identity_t<Vec<D>>& force, mpm::Load<D>& load) {
  // The points nearest to the side have the smallest shape function of the opposite node.
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
  // Moving boundaries come first, so that they prescribe the velocity of nodes shared with fixed ones.
  for (const bool moves : {true, false})
    for (const input::Boundary& boundary : data.boundaries)
      if ((boundary.fix == input::Fix::velocity) == moves) apply_boundary(body, boundary, gravity);
  for (const input::Traction& traction : data.tractions) apply_traction(body, traction);
}

template void resolve_conditions<2>(mpm::Body<2>&, const input::Case&);
template void resolve_conditions<3>(mpm::Body<3>&, const input::Case&);
template void load_nearest_points<2>(const mpm::Body<2>&, const site::SideElement&, const Vec<2>&, mpm::Load<2>&);
template void load_nearest_points<3>(const mpm::Body<3>&, const site::SideElement&, const Vec<3>&, mpm::Load<3>&);

namespace {

/// Nodes nearer to a side than this fraction of the smallest altitude lie on it.
constexpr double on_side = 1e-6;
/// Cosine between the normals of two elements on opposite sides of one line, which point against each other.
constexpr double opposite_cosine = -0.9397;

template <int D>
mpm::WaterConstraint<D>& get_constraint(mpm::Water<D>& water, int node) {
  int& index = water.constraint_of_node[node];
  if (index < 0) {
    index = static_cast<int>(water.constraints.size());
    water.constraints.emplace_back();
  }
  return water.constraints[index];
}

/// Merges opposite normals: inside the soil the normal of a line may come from either of its sides.
template <int D>
std::vector<Vec<D>> join_opposite(const std::vector<Vec<D>>& normals) {
  std::vector<Vec<D>> joined;
  for (const Vec<D>& n : normals) {
    const auto other =
        std::find_if(joined.begin(), joined.end(), [&](const Vec<D>& m) { return dot(m, n) < opposite_cosine; });
    if (other == joined.end()) {
      joined.push_back(n);
      continue;
    }
    for (std::size_t d = 0; d < D; ++d) (*other)[d] -= n[d];
    const double length = norm(*other);
    for (double& c : *other) c /= length;
  }
  return joined;
}

/// Returns the nodes at which impermeable sides form a bend. Their fixed direction is the mean of the normals, which
/// is neither normal.
template <int D>
std::set<int> find_kinks(const mpm::Body<D>& body, const site::WaterSides<D>& sides, const Vec<D>& gravity) {
  constexpr double straight = 1e-9;
  std::set<int> kinks;
  for (const auto& held : sides.held) {
    for (const auto& [side, elements] : site::map_sides<D>(body.mesh(), held)) {
      if (elements.empty()) continue;
      const Vec<D> normal = find_wall_normal(body, elements, gravity);
      for (int node : side) {
        const mpm::WaterConstraint<D>& c = body.water.constraints[body.water.constraint_of_node[node]];
        Vec<D> rest = normal;
        for (int k = 0; k < c.fixed_count; ++k) {
          const double along = dot(normal, c.fixed[k]);
          for (std::size_t d = 0; d < D; ++d) rest[d] -= along * c.fixed[k][d];
        }
        if (norm(rest) > straight) kinks.insert(node);
      }
    }
  }
  return kinks;
}

/// Assigns a hydraulic condition to each node.
template <int D>
class NodeConditions {
 public:
  NodeConditions(const mesh::Mesh<D>& mesh, const site::WaterSides<D>& sides)
      : mesh_(mesh), sides_(sides), free_(collect_free()) {
    tolerance_ = on_side * *std::min_element(mesh.altitudes.begin(), mesh.altitudes.end());
  }

  /// Returns the condition of each node. Nodes of `skins` have the last condition unless they lie on a side with
  /// another.
  std::vector<int> find(const std::set<int>& skins) const {
    std::vector<int> condition(mesh_.nodes.size(), 0);
    std::vector<std::vector<int>> at_wall(mesh_.nodes.size());
    for (const auto& [node, number] : sides_.reserved) at_wall[node].push_back(number);
    for (const site::WaterSide<D>& s : sides_.open) {
      if (!s.is_wall) continue;
      for (int node : s.nodes) at_wall[node].push_back(s.condition);
    }
    // The inner node of an element at a wall may also get a part of the surface.
    std::vector<std::vector<const site::WaterSide<D>*>> behind_wall(mesh_.nodes.size());
    for (const site::WaterSide<D>& s : sides_.open) {
      if (s.is_wall) behind_wall[s.opposite].push_back(&s);
    }
    std::size_t guess = 0;
    for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) {
      site::NearestSides nearest{-1, {}};
      if (!free_.is_empty()) nearest = free_.find_nearest(mesh_.nodes[i], tolerance_, guess);
      if (!at_wall[i].empty()) {
        if (free_.is_empty() || nearest.distance > tolerance_) nearest.labels.clear();
        nearest.labels.insert(nearest.labels.end(), at_wall[i].begin(), at_wall[i].end());
      } else if (skins.contains(static_cast<int>(i)) && !(nearest.distance >= 0 && nearest.distance <= tolerance_)) {
        nearest.labels = {static_cast<int>(sides_.surfaces.size()) - 1};
      } else {
        for (const site::WaterSide<D>* s : behind_wall[i]) {
          const double distance = site::find_distance<D>(get_corners(*s), mesh_.nodes[i]);
          if (nearest.distance >= 0 && distance >= nearest.distance) continue;
          nearest = {distance, {s->condition}};
        }
      }
      condition[i] = choose(nearest.labels, mesh_.nodes[i][1]);
    }
    return condition;
  }

 private:
  site::SideSet<D> collect_free() const {
    std::vector<site::LabelledSide<D>> free;
    for (const site::WaterSide<D>& s : sides_.open) {
      if (!s.is_wall) free.push_back(site::make_labelled_side<D>(get_corners(s), s.condition));
    }
    return site::SideSet<D>(std::move(free));
  }
  std::array<Vec<D>, D> get_corners(const site::WaterSide<D>& s) const {
    std::array<Vec<D>, D> corners;
    for (std::size_t c = 0; c < D; ++c) corners[c] = mesh_.nodes[s.nodes[c]];
    return corners;
  }
  /// Returns the condition of highest rank; 0 if there is none.
  int choose(const std::vector<int>& numbers, double y) const {
    const auto rank = [&](int n) { return std::pair(site::find_rank(sides_.surfaces[n], y, n > 0), n); };
    const auto first =
        std::min_element(numbers.begin(), numbers.end(), [&](int a, int b) { return rank(a) < rank(b); });
    return first == numbers.end() ? 0 : *first;
  }

  const mesh::Mesh<D>& mesh_;
  const site::WaterSides<D>& sides_;
  site::SideSet<D> free_;
  double tolerance_ = 0;
};

}  // namespace

template <int D>
void resolve_water_conditions(mpm::Body<D>& body, const input::Case& data) {
  mpm::Water<D>& water = body.water;
  if (!water.is_wet()) return;
  site::WaterSides<D> sides = site::find_water_sides<D>(body.mesh(), data);
  water.constraint_of_node.assign(body.mesh().nodes.size(), -1);
  water.constraints.clear();
  const Vec<D> gravity = find_gravity<D>(data.gravity);
  for (const auto& held : sides.held) {
    for (const auto& [node, normals] : find_node_normals<D>(body, held, gravity)) {
      mpm::WaterConstraint<D>& c = get_constraint(water, node);
      for (const Vec<D>& n : join_opposite<D>(normals)) add_direction<D>(c.fixed, c.fixed_count, n);
    }
  }
  // Elements at a bend count as open, so a no-flow condition closes them.
  const std::set<int> kinks = find_kinks<D>(body, sides, gravity);
  if (!kinks.empty()) sides.surfaces.push_back({"bends of walls", mpm::SurfaceKind::flux, {{0.0}, {0.0}}});
  water.surfaces = sides.surfaces;
  water.budgets.assign(water.surfaces.size(), {});
  water.surface_of_node = NodeConditions<D>(body.mesh(), sides).find(kinks);
  water.surface_is_stale = true;
}

template <int D>
void resolve_root_uptakes(mpm::Body<D>& body, const input::Case& data) {
  body.water.uptakes.clear();
  if (!body.water.is_wet()) return;
  const mpm::Points<D>& points = body.points;
  for (const input::Roots& roots : data.roots) {
    if (!roots.transpiration) continue;
    const site::RootDistribution<D> distribution = site::find_root_distribution<D>(data, roots, body.mesh());
    mpm::RootUptake uptake{roots.ground, site::make_transpiration_rate(*roots.transpiration),
                           site::make_uptake_reduction(roots, data.units().stress),
                           std::vector<double>(static_cast<std::size_t>(points.size()), 0.0)};
    for (int id = 0; id < points.size(); ++id) {
      const int e = points.element[id];
      if (e < 0) continue;
      for (const double w : distribution.weights[e]) uptake.weight[id] += w / points.count[e];
    }
    body.water.uptakes.push_back(std::move(uptake));
  }
}

template <int D>
void hold_surfaces(mpm::Body<D>& body, double time) {
  for (mpm::SurfaceCondition& s : body.water.surfaces) {
    if (!s.value.time.empty()) s.value = {{0.0}, {s.value.at(time)}};
  }
}

template void resolve_root_uptakes<2>(mpm::Body<2>&, const input::Case&);
template void resolve_root_uptakes<3>(mpm::Body<3>&, const input::Case&);
template void hold_surfaces<2>(mpm::Body<2>&, double);
template void hold_surfaces<3>(mpm::Body<3>&, double);
template void resolve_water_conditions<2>(mpm::Body<2>&, const input::Case&);
template void resolve_water_conditions<3>(mpm::Body<3>&, const input::Case&);

}  // namespace talus::run
