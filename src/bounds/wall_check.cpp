// SPDX-License-Identifier: MIT
#include "bounds/wall_check.hpp"

#include <algorithm>
#include <cmath>

namespace talus::bounds {
namespace {

double cross(const Vec<2>& a, const Vec<2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// Largest factor of an interface with these effective stresses; 0 if there is none.
double find_factor(InterfaceStrength strength, double normal, double shear, double least) {
  strength.cohesion = std::max(strength.cohesion, least);
  if (!(normal <= least)) return 0;
  const double available = strength.cohesion - std::min(normal, 0.0) * strength.tan_friction;
  return shear == 0 ? unlimited : available / std::abs(shear);
}

/// Integrates one beam from its head to its toe.
class Beam {
 public:
  Beam(const Problem& problem, const StressField& field, std::size_t wall)
      : problem_(problem), field_(field), wall_(problem.walls[wall]), forces_(list_wall_forces(problem)[wall]) {
    if (!wall_.struts.empty()) struts_ = field.struts.at(wall);
  }

  void run(const std::vector<WallEdge>& edges, double least, WallStatics& found) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      push(i);
      advance(edges[i], found);
      for (const std::size_t side : {0, 1}) {
        const auto& face = edges[i].face[side];
        if (!face) continue;
        const Vec<2>&n = edges[i].normal, &t = edges[i].along;
        for (const std::size_t end : {0, 1}) {
          const Stress& s = field_.stress[face->triangle][face->corner[end]];
          const Vec<2> on{s[0] * n[0] + s[2] * n[1], s[2] * n[0] + s[1] * n[1]};
          found.factor = std::min(found.factor, find_factor(wall_.interface[i][side], dot(on, n), dot(on, t), least));
        }
      }
    }
    push(edges.size());
    for (std::size_t s = 0; s < struts_.size(); ++s)
      found.holds = found.holds && struts_[s] >= 0 && struts_[s] <= wall_.struts[s].strength;
  }

  /// Force and moment that are left.
  const Vec<2>& force() const { return force_; }
  double moment() const { return moment_; }

 private:
  /// Subtracts the forces that act at a node.
  void push(std::size_t node) {
    for (std::size_t s = 0; s < struts_.size(); ++s)
      if (find_wall_node(wall_, wall_.struts[s].node) == node) force_[0] += struts_[s] * wall_.struts[s].way;
    for (const WallForce& given : forces_)
      if (given.node == node)
        for (std::size_t d = 0; d < 2; ++d)
          force_[d] -= field_.bars.at(given.bar) * given.force[d] / given.find_divisor(field_.factor);
  }

  Vec<2> find_load(const WallEdge& edge, std::size_t end) const {
    Vec<2> load{wall_.line_load[0] + edge.load[end][0], wall_.line_load[1] + edge.load[end][1]};
    for (const std::size_t side : {0, 1}) {
      const auto& face = edge.face[side];
      if (!face) continue;
      const Stress& s = field_.stress[face->triangle][face->corner[end]];
      const double pore = problem_.pore_pressure[face->triangle][face->corner[end]], sign = side == 0 ? 1 : -1;
      const Vec<2>& n = edge.normal;
      load[0] += sign * ((s[0] - pore) * n[0] + s[2] * n[1]);
      load[1] += sign * (s[2] * n[0] + (s[1] - pore) * n[1]);
    }
    return load;
  }

  /// The force along an edge is quadratic and the moment cubic: both lie between their Bézier points.
  void advance(const WallEdge& edge, WallStatics& found) {
    const double length = edge.length;
    const Vec<2> first = find_load(edge, 0), last = find_load(edge, 1), upper = force_;
    Vec<2> moved{};  // ∫∫ q
    for (std::size_t d = 0; d < 2; ++d) {
      force_[d] -= length / 2 * (first[d] + last[d]);
      moved[d] = length * length * (first[d] / 3 + last[d] / 6);
    }
    const double above = moment_;
    moment_ += length * cross(upper, edge.along) - cross(moved, edge.along);
    const std::array<double, 4> bending{above, above + length / 3 * cross(upper, edge.along),
                                        moment_ - length / 3 * cross(force_, edge.along), moment_};
    const auto find_points = [&](const Vec<2>& direction) {
      return std::array<double, 3>{dot(upper, direction), dot(upper, direction) - length / 2 * dot(first, direction),
                                   dot(force_, direction)};
    };
    const std::array<double, 3> axial = find_points(edge.along);
    const std::array<double, 4> raised{axial[0], (axial[0] + 2 * axial[1]) / 3, (2 * axial[1] + axial[2]) / 3,
                                       axial[2]};
    for (std::size_t i = 0; i < 4; ++i)
      found.holds = found.holds && std::abs(bending[i]) / wall_.moment + std::abs(raised[i]) / wall_.axial <= 1;
    for (const double shear : find_points(edge.normal)) found.holds = found.holds && std::abs(shear) <= wall_.shear;
  }

  const Problem& problem_;
  const StressField& field_;
  const Wall& wall_;
  std::vector<WallForce> forces_;
  std::vector<double> struts_;
  Vec<2> force_{};  ///< of the part below on the part above
  double moment_ = 0;
};

}  // namespace

WallStatics check_walls(const Problem& problem, const StressField& field, double extent, double least) {
  WallStatics found;
  found.holds = are_walls_sound(problem);
  if (!found.holds) return found;
  const auto edges = list_wall_edges(problem);
  for (std::size_t w = 0; w < problem.walls.size(); ++w) {
    Beam beam(problem, field, w);
    beam.run(edges[w], least, found);
    for (const double left : {beam.force()[0] / extent, beam.force()[1] / extent, beam.moment() / (extent * extent)})
      found.imbalance = std::isfinite(left) ? std::max(found.imbalance, std::abs(left)) : unlimited;
  }
  return found;
}

Vec<2> find_wall_velocity(const VelocityField& field, std::size_t wall, std::size_t node) {
  const auto& edges = field.walls[wall];
  return node < edges.size() ? edges[node][0] : edges.back()[1];
}

namespace {

class Motion {
 public:
  Motion(const Problem& problem, const VelocityField& field) : problem_(problem), field_(field) {}

  WallKinematics run() {
    found_.is_sound = are_walls_sound(problem_);
    if (!found_.is_sound) return std::move(found_);
    const auto edges = list_wall_edges(problem_);
    for (std::size_t w = 0; w < problem_.walls.size(); ++w) {
      const Wall& wall = problem_.walls[w];
      for (std::size_t i = 0; i < wall.size(); ++i) {
        add_edge(wall, edges[w][i], field_.walls[w][i]);
        for (const std::size_t side : {0, 1})
          if (edges[w][i].face[side])
            add_face(wall.interface[i][side].find_largest(), edges[w][i], *edges[w][i].face[side], side,
                     field_.walls[w][i]);
        if (i > 0) add_hinge(wall, w, i, edges[w]);
      }
      for (const Strut& strut : wall.struts) {
        const Vec<2> velocity = find_wall_velocity(field_, w, find_wall_node(wall, strut.node));
        yield(std::max(0.0, strut.way * velocity[0]), strut.strength);
      }
    }
    return std::move(found_);
  }

 private:
  /// Adds the dissipation of a velocity that a force resists.
  void yield(double velocity, double strength) {
    if (std::isfinite(strength)) {
      found_.dissipation += strength * std::abs(velocity);
    } else {
      found_.held = std::max(found_.held, std::abs(velocity));
    }
  }

  static double find_rotation(const WallEdge& edge, const std::array<Vec<2>, 2>& ends) {
    return (dot(ends[1], edge.normal) - dot(ends[0], edge.normal)) / edge.length;
  }

  void add_edge(const Wall& wall, const WallEdge& edge, const std::array<Vec<2>, 2>& ends) {
    found_.held = std::max(found_.held, std::abs(dot(ends[1], edge.along) - dot(ends[0], edge.along)));
    for (const std::size_t p : {0, 1})
      for (const std::size_t q : {0, 1})
        for (std::size_t d = 0; d < 2; ++d)
          found_.work += edge.length * (p == q ? 2 : 1) / 6 * (edge.load[q][d] + wall.line_load[d]) * ends[p][d];
  }

  void add_hinge(const Wall& wall, std::size_t w, std::size_t i, const std::vector<WallEdge>& edges) {
    const auto& motion = field_.walls[w];
    const double turn = std::abs(find_rotation(edges[i], motion[i]) - find_rotation(edges[i - 1], motion[i - 1]));
    const Vec<2> jump{motion[i][0][0] - motion[i - 1][1][0], motion[i][0][1] - motion[i - 1][1][1]};
    const double elongation = std::abs(dot(jump, edges[i - 1].along));
    if (std::isfinite(wall.moment) && std::isfinite(wall.axial)) {
      found_.dissipation += std::max(wall.moment * turn, wall.axial * elongation);
    } else {
      yield(elongation, wall.axial);
      if (std::isfinite(wall.moment)) {
        found_.dissipation += wall.moment * turn;
      } else {
        found_.held = std::max(found_.held, turn * edges[i].length);
      }
    }
    yield(dot(jump, edges[i - 1].normal), wall.shear);
  }

  void add_face(const InterfaceStrength& strength, const WallEdge& edge, const WallFace& face, std::size_t side,
                const std::array<Vec<2>, 2>& ends) {
    const auto& t = field_.mesh.triangles[face.triangle];
    const auto [i, j] = face.corner;
    const std::array<int, 3> nodes{t[i], t[3 + ((i + 1) % 3 == j ? i : j)], t[j]};
    std::array<Vec<2>, 3> relative{};  // at the upper end, in the middle, at the lower end
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t d = 0; d < 2; ++d) {
        const double share = 0.5 * static_cast<double>(k);
        relative[k][d] =
            field_.velocity[static_cast<std::size_t>(nodes[k])][d] - (1 - share) * ends[0][d] - share * ends[1][d];
      }
    for (std::size_t d = 0; d < 2; ++d) relative[1][d] = 2 * relative[1][d] - 0.5 * (relative[0][d] + relative[2][d]);
    const double sign = side == 0 ? 1 : -1, weight = edge.length / 3;
    // ∫ p B with the Bernstein polynomials: ¼ and 1/12, 1/6 and 1/6, 1/12 and ¼ of the length.
    const double p = problem_.pore_pressure[face.triangle][i], q = problem_.pore_pressure[face.triangle][j];
    const std::array<double, 3> pressure{p / 4 + q / 12, p / 6 + q / 6, p / 12 + q / 4};
    for (std::size_t k = 0; k < 3; ++k) {
      const double opening = sign * dot(relative[k], edge.normal);
      found_.work += edge.length * pressure[k] * opening;
      found_.contacts.push_back({strength, weight, weight * opening, weight * dot(relative[k], edge.along)});
    }
  }

  const Problem& problem_;
  const VelocityField& field_;
  WallKinematics found_;
};

}  // namespace

WallKinematics check_walls(const Problem& problem, const VelocityField& field) {
  return Motion(problem, field).run();
}

}  // namespace talus::bounds
