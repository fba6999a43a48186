// SPDX-License-Identifier: MIT
// Verification of stress and velocity fields, from nodes, stresses and velocities alone.
#include "bounds/check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "bounds/flow_rule.hpp"
#include "bounds/problem.hpp"
#include "bounds/wall_check.hpp"

namespace talus::bounds {

namespace {

Vec<2> find_traction(const Stress& effective, double pore, const Vec<2>& n) {
  return {(effective[0] - pore) * n[0] + effective[2] * n[1], effective[2] * n[0] + (effective[1] - pore) * n[1]};
}

Vec<2> find_direction(const Vec<2>& from, const Vec<2>& to) {
  const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
  return {(to[0] - from[0]) / length, (to[1] - from[1]) / length};
}

const Side* find_side(const Problem& problem, const std::map<EdgeKey, std::size_t>& sides, const Edge& edge) {
  const auto found = sides.find(make_key(edge.from, edge.to));
  return edge.other < 0 && found != sides.end() ? &problem.sides[found->second] : nullptr;
}

std::map<EdgeKey, std::size_t> index_sides(const Problem& problem) {
  std::map<EdgeKey, std::size_t> sides;
  for (std::size_t s = 0; s < problem.sides.size(); ++s)
    sides[make_key(problem.sides[s].from, problem.sides[s].to)] = s;
  return sides;
}

}  // namespace

Strength raise_to(Strength soil, double least) {
  soil.cohesion = std::max(soil.cohesion, least);
  if (soil.tension) soil.tension = std::max(*soil.tension, least);
  if (soil.planes && soil.planes->cohesion < least) {
    WeakPlanes planes = *soil.planes;
    planes.cohesion = least;
    soil.planes = std::make_shared<const WeakPlanes>(planes);
  }
  return soil;
}

StaticCheck check(const Problem& problem, const StressField& field) {
  const Units units = find_units(problem);
  StaticCheck found{std::numeric_limits<double>::infinity(), 0, false};
  // NaN proves nothing: it is reported as infinity, and comparisons are written so that they fail for NaN.
  auto note = [&](double imbalance) {
    found.imbalance = std::isnan(imbalance) ? std::numeric_limits<double>::infinity()
                                            : std::max(found.imbalance, std::abs(imbalance));
  };
  const auto node = [&](int n) -> const Vec<2>& { return problem.nodes[static_cast<std::size_t>(n)]; };
  for (std::size_t e = 0; e < problem.size(); ++e) {
    const Triangle& t = problem.triangles[e];
    // Gradient of a linear field from the differences along two edges.
    const Vec<2>&a = node(t[0]), &b = node(t[1]), &c = node(t[2]);
    const double x1 = b[0] - a[0], y1 = b[1] - a[1], x2 = c[0] - a[0], y2 = c[1] - a[1], twice = x1 * y2 - x2 * y1;
    auto total = [&](std::size_t i, std::size_t d) {
      return field.stress[e][i][d] - (d < 2 ? problem.pore_pressure[e][i] : 0);
    };
    auto slope = [&](std::size_t d) {
      const double p = total(1, d) - total(0, d), q = total(2, d) - total(0, d);
      return Vec<2>{(p * y2 - q * y1) / twice, (q * x1 - p * x2) / twice};
    };
    const Vec<2> xx = slope(0), yy = slope(1), xy = slope(2);
    note((xx[0] + xy[1] + problem.body_force[e][0]) * units.length);
    note((xy[0] + yy[1] + problem.body_force[e][1]) * units.length);
    for (std::size_t i = 0; i < 3; ++i) {
      const Strength soil = raise_to(problem.strength[e][i], least_strength * units.stress);
      found.factor = std::min(found.factor, find_factor(soil, field.stress[e][i]));
    }
  }
  const auto sides = index_sides(problem);
  std::map<EdgeKey, Vec<2>> of_supports;
  for (const LineForce& force : list_line_forces(problem)) {
    Vec<2>& sum = of_supports[make_key(force.from, force.to)];
    for (std::size_t d = 0; d < 2; ++d)
      sum[d] += field.bars.at(force.bar) * force.traction[d] / force.find_divisor(field.factor);
    if (force.is_reduced) found.factor = std::min(found.factor, field.factor);
  }
  const WallKeys walls(problem);
  for (const Edge& edge : list_edges(problem.triangles)) {
    if (walls.contains(edge.from, edge.to)) continue;
    const auto support = of_supports.find(make_key(edge.from, edge.to));
    const Vec<2> along = find_direction(node(edge.from), node(edge.to)), n{along[1], -along[0]};
    const Side* side = find_side(problem, sides, edge);
    for (const int at : {edge.from, edge.to}) {
      auto traction = [&](int triangle) {
        const auto e = static_cast<std::size_t>(triangle);
        const std::size_t i = find_corner(problem.triangles[e], at);
        return find_traction(field.stress[e][i], problem.pore_pressure[e][i], n);
      };
      Vec<2> left = traction(edge.triangle);
      Vec<2> other{0, 0};
      if (edge.other >= 0) {
        other = traction(edge.other);
      } else if (side) {
        other = side->traction[at == side->from ? 0 : 1];
      }
      if (support != of_supports.end())
        for (std::size_t d = 0; d < 2; ++d) other[d] += support->second[d];
      for (std::size_t d = 0; d < 2; ++d) left[d] -= other[d];
      if (!side || !side->holds_normal) note(dot(left, n));
      if (!side || !side->holds_along) note(dot(left, along));
    }
  }
  const WallStatics of_walls = check_walls(problem, field, units.length, least_strength * units.stress);
  note(of_walls.imbalance);
  found.factor = std::min(found.factor, of_walls.factor);
  const bool are_borne =
      std::all_of(field.bars.begin(), field.bars.end(), [](double share) { return share >= 0 && share <= 1; });
  found.holds = found.imbalance <= rounding * units.stress && of_walls.holds && are_borne;
  return found;
}

namespace {

/// Sums work over triangles and sides, and then evaluates flow rule and dissipation.
class KinematicSum {
 public:
  KinematicSum(const Problem& problem, const VelocityField& field) : problem_(problem), field_(field) {}

  KinematicCheck run() {
    for (std::size_t e = 0; e < problem_.size(); ++e) add_triangle(e);
    list_edge_nodes();
    add_sides();
    add_bars();
    walls_ = check_walls(problem_, field_);
    found_.work += walls_.work;
    active_ += walls_.dissipation;
    return judge();
  }

 private:
  /// Strain rates and strength at a corner of a triangle.
  struct Corner {
    double weight = 0;  ///< a third of the area [m²]
    Strain strain;
    /// Its cohesion and tension are three times the mean over the triangle of theirs times the shape function of this
    /// corner. The dissipation per unit of strength is convex and the strength linear, so that the sum over corners is
    /// an upper bound.
    Strength strength;
  };

  const Vec<2>& get_node(int n) const { return problem_.nodes[static_cast<std::size_t>(n)]; }
  const Vec<2>& get_velocity(int n) const { return field_.velocity[static_cast<std::size_t>(n)]; }

  void add_triangle(std::size_t e) {
    const auto& t = field_.mesh.triangles[e];
    const Triangle& corner_of = problem_.triangles[e];
    const Vec<2>&a = get_node(corner_of[0]), &b = get_node(corner_of[1]), &c = get_node(corner_of[2]);
    const double area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
    std::array<double, 3> opening{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const std::array<Vec<2>, 2> u = find_slopes(e, i);
      opening[i] = u[0][0] + u[1][1];
      const Strain strain{opening[i], u[0][0] - u[1][1], u[0][1] + u[1][0]};
      const auto& soil = problem_.strength[e];
      Corner corner{area / 3, strain, soil[i]};
      corner.strength.cohesion = (2 * soil[i].cohesion + soil[j].cohesion + soil[k].cohesion) / 4;
      if (soil[i].tension) corner.strength.tension = (2 * *soil[i].tension + *soil[j].tension + *soil[k].tension) / 4;
      corners_.push_back(corner);
      largest_ = std::max({largest_, std::abs(strain.opening), strain.find_shear()});
    }
    // ∫ p div u of two linear fields, and ∫ b·u, where the integral of a quadratic field follows from the middles of
    // the edges.
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j)
        found_.work += area * (i == j ? 2 : 1) / 12 * problem_.pore_pressure[e][i] * opening[j];
      found_.work += area / 3 * dot(problem_.body_force[e], get_velocity(t[3 + i]));
    }
  }

  /// Returns the gradients of both velocity components at corner i. The derivative of a quadratic along an edge is −3 u
  /// + 4 u_middle − u_end.
  std::array<Vec<2>, 2> find_slopes(std::size_t e, std::size_t i) const {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Triangle& corner_of = problem_.triangles[e];
    const std::array<int, 6>& t = field_.mesh.triangles[e];
    const Vec<2>&at = get_node(corner_of[i]), &to = get_node(corner_of[j]), &other = get_node(corner_of[k]);
    const double px = to[0] - at[0], py = to[1] - at[1], qx = other[0] - at[0], qy = other[1] - at[1];
    const double det = px * qy - qx * py;
    std::array<Vec<2>, 2> slopes;
    for (std::size_t d = 0; d < 2; ++d) {
      const double p = -3 * get_velocity(t[i])[d] + 4 * get_velocity(t[3 + i])[d] - get_velocity(t[j])[d];
      const double q = -3 * get_velocity(t[i])[d] + 4 * get_velocity(t[3 + k])[d] - get_velocity(t[k])[d];
      slopes[d] = {(p * qy - q * py) / det, (q * px - p * qx) / det};
    }
    return slopes;
  }

  /// Lists the nodes of the edges. The velocity is continuous if both triangles of an edge, other than that of a wall,
  /// have the same three.
  void list_edge_nodes() {
    const WallKeys walls(problem_);
    for (std::size_t e = 0; e < problem_.size(); ++e)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const auto& t = field_.mesh.triangles[e];
        const int a = problem_.triangles[e][i], b = problem_.triangles[e][j];
        const std::array<int, 3> own = a < b ? std::array{t[i], t[3 + i], t[j]} : std::array{t[j], t[3 + i], t[i]};
        const auto [at, is_new] = edges_.try_emplace(make_key(a, b), own);
        if (!is_new && at->second != own && !walls.contains(a, b)) is_continuous_ = false;
      }
  }
  std::array<int, 3> find_edge_nodes(int from, int to) const {
    const std::array<int, 3>& own = edges_.at(make_key(from, to));
    return from < to ? own : std::array{own[2], own[1], own[0]};
  }

  void add_sides() {
    const WallKeys walls(problem_);
    for (const Side& s : problem_.sides) {
      if (walls.contains(s.from, s.to)) continue;
      const Vec<2>&a = get_node(s.from), &b = get_node(s.to), along = find_direction(a, b), n{along[1], -along[0]};
      const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
      const std::array<int, 3> nodes = find_edge_nodes(s.from, s.to);
      // Simpson's rule is exact for a quadratic times a linear function.
      const std::array<double, 3> simpson{length / 6, 4 * length / 6, length / 6};
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec<2>& v = get_velocity(nodes[k]);
        Vec<2> traction;
        for (std::size_t d = 0; d < 2; ++d)
          traction[d] = s.traction[0][d] + 0.5 * static_cast<double>(k) * (s.traction[1][d] - s.traction[0][d]);
        if (s.holds_normal) held_ = std::max(held_, std::abs(dot(v, n)));
        if (s.holds_along) held_ = std::max(held_, std::abs(dot(v, along)));
        if (!s.holds_normal) found_.work += simpson[k] * dot(traction, n) * dot(v, n);
        if (!s.holds_along) found_.work += simpson[k] * dot(traction, along) * dot(v, along);
      }
    }
  }

  /// Dissipation of supports: at most their largest tension times their elongation, whose positive part is not above
  /// the line between those of its ends.
  void add_bars() {
    for (const BarEdge& bar : problem_.bars) {
      const Vec<2>&a = get_node(bar.from), &b = get_node(bar.to), e = find_direction(a, b);
      const std::array<int, 3> nodes = find_edge_nodes(bar.from, bar.to);
      const double first = dot(get_velocity(nodes[0]), e), middle = dot(get_velocity(nodes[1]), e),
                   last = dot(get_velocity(nodes[2]), e);
      // The elongation is that of a quadratic velocity, per length and times the length.
      const double start = std::max(0.0, -3 * first + 4 * middle - last),
                   end = std::max(0.0, first - 4 * middle + 3 * last);
      const auto& n = bar.force;
      double dissipation = (n[0] * (2 * start + end) + n[1] * (start + 2 * end)) / 6;
      // Soil on both sides of a wall may part where the bar passes through it.
      if (const auto above = find_bar_above(problem_, bar)) {
        const int before = find_edge_nodes(above->from, above->to)[2];
        if (before != nodes[0]) dissipation += n[0] * std::max(0.0, first - dot(get_velocity(before), e));
      }
      (bar.is_reduced ? passive_ : active_) += dissipation;
    }
    // Between a head and the end of its bar there is no more tension either.
    for (const BarHead& head : problem_.heads) {
      double mean = 0, width = 0;
      if (head.wall) {
        const Vec<2> own =
            find_wall_velocity(field_, *head.wall, find_wall_node(problem_.walls[*head.wall], head.node));
        mean = dot(own, head.direction), width = 1;
      }
      for (const auto& [from, to] : head.sides) {
        const Vec<2>&a = get_node(from), &b = get_node(to);
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        width += length;
        const std::array<int, 3> nodes = find_edge_nodes(from, to);
        for (std::size_t k = 0; k < 3; ++k)
          mean += (k == 1 ? 4 : 1) * length / 6 * dot(get_velocity(nodes[k]), head.direction);
      }
      (head.is_reduced ? passive_ : active_) +=
          head.force * std::max(0.0, dot(get_velocity(find_bar_node(head)), head.direction) - mean / width);
    }
  }

  /// Returns the node at which the bar of a head begins.
  int find_bar_node(const BarHead& head) const {
    for (const BarEdge& bar : problem_.bars)
      if (bar.from == head.node && bar.bar == head.bar) return find_edge_nodes(bar.from, bar.to)[0];
    return head.node;
  }

  /// Returns true if the flow rule for this factor is satisfied at every corner and contact.
  bool flows(double factor) const {
    for (const ContactMotion& c : walls_.contacts)
      if (!(c.opening + rounding_of_velocity * c.weight * fastest_ >=
            c.strength.tan_friction / factor * std::abs(c.slip)))
        return false;
    return std::all_of(corners_.begin(), corners_.end(), [&](const Corner& c) {
      if (c.strength.tan_friction == 0 && !c.strength.tension)
        return std::abs(c.strain.opening) <= no_opening * largest_;
      return find_lack(c.strength, factor, c.strain) <= 0;
    });
  }

  double find_dissipation(double factor) const {
    double sum = active_ + passive_ / factor;
    for (const Corner& c : corners_) sum += c.weight * bounds::find_dissipation(c.strength, factor, c.strain);
    for (const ContactMotion& c : walls_.contacts) sum += c.strength.cohesion / factor * std::abs(c.slip);
    return sum;
  }

  /// Bisects for the smallest factor at which the flow rule holds and the work exceeds the dissipation (both are
  /// monotonic in the factor), and returns the upper end of the bracket.
  KinematicCheck judge() {
    bool is_finite = std::isfinite(walls_.work) && std::isfinite(walls_.dissipation) && std::isfinite(walls_.held);
    for (const Vec<2>& v : field_.velocity) {
      fastest_ = std::max(fastest_, norm(v));
      is_finite = is_finite && std::isfinite(norm(v));
    }
    held_ = std::max(held_, walls_.held);
    // Blocks that slide on walls do not strain.
    largest_ = std::max(largest_, fastest_ / find_units(problem_).length);
    // The strain rates of a rigid triangle are rounding errors and are set to zero.
    for (Corner& c : corners_)
      if (std::max(std::abs(c.strain.opening), c.strain.find_shear()) < no_rate * largest_) c.strain = {};
    const auto moves = [&](double factor) { return flows(factor) && find_dissipation(factor) < found_.work; };
    double low = smallest_factor, high = largest_factor;
    found_.factor = std::numeric_limits<double>::infinity();
    if (!walls_.is_sound || !is_finite || !is_continuous_ || held_ > rounding_of_velocity * fastest_ || !moves(high))
      return found_;
    while (high > low * (1 + 1e-12)) {
      const double middle = std::sqrt(low * high);
      (moves(middle) ? high : low) = middle;
    }
    found_.factor = high;
    found_.dissipation = find_dissipation(high);
    found_.holds = true;
    return found_;
  }

  /// Rounding limits of sums of a few products, over the largest velocity, and over the largest strain rate.
  static constexpr double rounding_of_velocity = 1e-12;
  static constexpr double no_opening = 1e-11, no_rate = 1e-13;
  static constexpr double smallest_factor = 1e-6, largest_factor = 1e6;
  const Problem& problem_;
  const VelocityField& field_;
  std::vector<Corner> corners_;
  KinematicCheck found_;
  std::map<EdgeKey, std::array<int, 3>> edges_;  ///< velocity nodes of each edge, from its smaller node
  WallKinematics walls_;
  double held_ = 0, largest_ = 0, fastest_ = 0;
  double active_ = 0, passive_ = 0;  ///< dissipation of supports whose forces F does not divide, and divides [W/m]
  bool is_continuous_ = true;
};

}  // namespace

KinematicCheck check(const Problem& problem, const VelocityField& field) {
  return KinematicSum(problem, field).run();
}

}  // namespace talus::bounds
