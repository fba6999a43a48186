// SPDX-License-Identifier: MIT
#include "run/mpm/start/water_conditions.hpp"

#include <algorithm>
#include <set>

#include "ground/nearest_side.hpp"
#include "ground/side_normals.hpp"
#include "ground/water_sides.hpp"
#include "run/mpm/start/prepare.hpp"

namespace talus::run {
namespace {

/// Nodes nearer to a side than this share of the smallest altitude lie on it.
constexpr double on_side = 1e-6;
/// Normals of the two sides of one line point against each other.
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

/// Inside the soil the normal may come from either side of a line; those of one line are made one.
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

/// Nodes between held sides that are no straight line: what is held there, the mean, is neither side's normal.
template <int D>
std::set<int> find_kinks(const mpm::Body<D>& body, const ground::WaterSides<D>& sides, const Vec<D>& gravity) {
  constexpr double straight = 1e-9;
  std::set<int> kinks;
  for (const auto& held : sides.held) {
    for (const auto& [side, elements] : ground::map_sides<D>(body.mesh(), held)) {
      if (elements.empty()) continue;
      const Vec<D> normal = ground::find_wall_normal(body, elements, gravity);
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

/// The condition of each node.
template <int D>
class NodeConditions {
 public:
  NodeConditions(const mesh::Mesh<D>& mesh, const ground::WaterSides<D>& sides)
      : mesh_(mesh), sides_(sides), free_(collect_free()) {
    tolerance_ = on_side * *std::min_element(mesh.altitudes.begin(), mesh.altitudes.end());
  }

  /// Nodes of `skins` have the last condition unless they lie on a side with another.
  std::vector<int> find(const std::set<int>& skins) const {
    std::vector<int> condition(mesh_.nodes.size(), 0);
    std::vector<std::vector<int>> at_wall(mesh_.nodes.size());
    for (const auto& [node, number] : sides_.reserved) at_wall[node].push_back(number);
    for (const ground::WaterSide<D>& s : sides_.open) {
      if (!s.is_wall) continue;
      for (int node : s.nodes) at_wall[node].push_back(s.condition);
    }
    // The element at a wall may leave its inner node a part of the surface too.
    std::vector<std::vector<const ground::WaterSide<D>*>> behind_wall(mesh_.nodes.size());
    for (const ground::WaterSide<D>& s : sides_.open) {
      if (s.is_wall) behind_wall[s.opposite].push_back(&s);
    }
    std::size_t guess = 0;
    for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) {
      ground::NearestSides nearest{-1, {}};
      if (!free_.is_empty()) nearest = free_.find_nearest(mesh_.nodes[i], tolerance_, guess);
      if (!at_wall[i].empty()) {
        if (free_.is_empty() || nearest.distance > tolerance_) nearest.labels.clear();
        nearest.labels.insert(nearest.labels.end(), at_wall[i].begin(), at_wall[i].end());
      } else if (skins.contains(static_cast<int>(i)) && !(nearest.distance >= 0 && nearest.distance <= tolerance_)) {
        nearest.labels = {static_cast<int>(sides_.surfaces.size()) - 1};
      } else {
        for (const ground::WaterSide<D>* s : behind_wall[i]) {
          const double distance = ground::find_distance<D>(get_corners(*s), mesh_.nodes[i]);
          if (nearest.distance >= 0 && distance >= nearest.distance) continue;
          nearest = {distance, {s->condition}};
        }
      }
      condition[i] = choose(nearest.labels, mesh_.nodes[i][1]);
    }
    return condition;
  }

 private:
  ground::SideSet<D> collect_free() const {
    std::vector<ground::LabelledSide<D>> free;
    for (const ground::WaterSide<D>& s : sides_.open) {
      if (!s.is_wall) free.push_back(ground::make_labelled_side<D>(get_corners(s), s.condition));
    }
    return ground::SideSet<D>(std::move(free));
  }
  std::array<Vec<D>, D> get_corners(const ground::WaterSide<D>& s) const {
    std::array<Vec<D>, D> corners;
    for (std::size_t c = 0; c < D; ++c) corners[c] = mesh_.nodes[s.nodes[c]];
    return corners;
  }
  /// The first in rank; 0 when there is none.
  int choose(const std::vector<int>& numbers, double y) const {
    const auto rank = [&](int n) { return std::pair(ground::find_rank(sides_.surfaces[n], y, n > 0), n); };
    const auto first =
        std::min_element(numbers.begin(), numbers.end(), [&](int a, int b) { return rank(a) < rank(b); });
    return first == numbers.end() ? 0 : *first;
  }

  const mesh::Mesh<D>& mesh_;
  const ground::WaterSides<D>& sides_;
  ground::SideSet<D> free_;
  double tolerance_ = 0;
};

}  // namespace

template <int D>
void resolve_water_conditions(mpm::Body<D>& body, const input::Case& data) {
  mpm::Water<D>& water = body.water;
  if (!water.is_wet()) return;
  ground::WaterSides<D> sides = ground::find_water_sides<D>(body.mesh(), data);
  water.constraint_of_node.assign(body.mesh().nodes.size(), -1);
  water.constraints.clear();
  const Vec<D> gravity = find_gravity<D>(data.gravity);
  for (const auto& held : sides.held) {
    for (const auto& [node, normals] : ground::find_node_normals<D>(body, held, gravity)) {
      mpm::WaterConstraint<D>& c = get_constraint(water, node);
      for (const Vec<D>& n : join_opposite<D>(normals)) ground::add_direction<D>(c.fixed, c.fixed_count, n);
    }
  }
  // Elements at a bend are open to the engine; a skin closes them.
  const std::set<int> kinks = find_kinks<D>(body, sides, gravity);
  if (!kinks.empty()) sides.surfaces.push_back({"bends of walls", mpm::SurfaceKind::flux, {{0.0}, {0.0}}});
  water.surfaces = sides.surfaces;
  water.budgets.assign(water.surfaces.size(), {});
  water.surface_of_node = NodeConditions<D>(body.mesh(), sides).find(kinks);
  water.surface_is_stale = true;
}

template <int D>
void hold_surfaces(mpm::Body<D>& body, double time) {
  for (mpm::SurfaceCondition& s : body.water.surfaces) {
    if (!s.value.time.empty()) s.value = {{0.0}, {s.value.at(time)}};
  }
}

template void hold_surfaces<2>(mpm::Body<2>&, double);
template void hold_surfaces<3>(mpm::Body<3>&, double);
template void resolve_water_conditions<2>(mpm::Body<2>&, const input::Case&);
template void resolve_water_conditions<3>(mpm::Body<3>&, const input::Case&);

}  // namespace talus::run
