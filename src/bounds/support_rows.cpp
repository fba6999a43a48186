// SPDX-License-Identifier: MIT
#include "bounds/support_rows.hpp"

#include <algorithm>
#include <cmath>

#include "bounds/wall_motion.hpp"

namespace talus::bounds {
namespace {

/// Part of the strength of a beam or strut that the lower bound does not use, so that the residual of the solver does
/// not exceed it.
constexpr double unused = 1e-4;

RowForm make_unknown(int number, double times = 1) {
  return {{{number, times}}, {}, 0, 0};
}

void add(RowForm& sum, const RowForm& form, double times = 1) {
  for (const auto& [number, value] : form.entries) sum.entries.emplace_back(number, times * value);
  for (const auto& [number, value] : form.rates) sum.rates.emplace_back(number, times * value);
  sum.constant += times * form.constant;
  sum.constant_rate += times * form.constant_rate;
}

/// A vector of two forms.
using Pair = std::array<RowForm, 2>;

RowForm multiply(const Pair& vector, const Vec<2>& direction, double times = 1) {
  RowForm out;
  for (std::size_t d = 0; d < 2; ++d) add(out, vector[d], times * direction[d]);
  return out;
}

/// Adds the cone |form| ≤ `strength` (1 − `room`).
void limit(SupportRows& rows, const RowForm& form, double strength, double room) {
  RowForm first, second;
  first.constant = 1 - room;
  add(second, form, 1 / strength);
  rows.cones.push_back({first, second});
}

/// Adds the strengths of a section: |N|/N_p + |M|/M_p ≤ 1, or one of both, and the shear strength.
void limit_section(SupportRows& rows, const Wall& wall, const RowForm* axial, const RowForm* moment, const Units& units,
                   double room) {
  const double force = units.stress * units.length, couple = force * units.length;
  const bool has_axial = std::isfinite(wall.axial), has_moment = std::isfinite(wall.moment);
  if (has_axial && has_moment) {
    for (const double sign : {1, -1}) {
      RowForm sum;
      add(sum, *moment, couple / wall.moment), add(sum, *axial, sign * force / wall.axial);
      limit(rows, sum, 1, room);
    }
  } else if (has_axial) {
    limit(rows, *axial, wall.axial / force, room);
  } else if (has_moment) {
    limit(rows, *moment, wall.moment / couple, room);
  }
}

/// Adds the cones of an interface with its effective normal stress and shear stress, in units of stress. `most`: upper
/// limit of its cohesion.
void limit_contact(SupportRows& rows, const InterfaceStrength& strength, double factor, const Units& units,
                   const RowForm& normal, const RowForm& shear, double most) {
  const double cohesion = strength.cohesion / units.stress / factor, tangent = strength.tan_friction / factor;
  RowForm first = make_unknown(lacking), opening = first;
  add(first, normal, -tangent);
  for (const auto& [number, value] : normal.entries) first.rates.emplace_back(number, value * tangent / factor);
  first.constant += std::min(cohesion, most);
  if (cohesion < most) first.constant_rate -= cohesion / factor;
  add(opening, normal, -1);
  rows.cones.push_back({first, shear});
  rows.cones.push_back({opening});
}

/// Adds the cones of a bar or strut, whose force in units of its strength lies between 0 and 1.
void limit_force(SupportRows& rows, int unknown, double unit, double room) {
  RowForm first = make_unknown(unknown), left = make_unknown(unknown, -unit);
  first.constant = -1e-2 * room;
  left.constant = 1 - room;
  rows.cones.push_back({first});
  if (unit > 0) rows.cones.push_back({left});
}

/// As limit_force(); `units` those of the unknown. A strut without limit has no second cone.
void limit_strut(SupportRows& rows, const Strut& strut, int unknown, const Units& units, double room) {
  limit_force(rows, unknown, units.stress * units.length / strut.strength, room);
}

int find_first(const Problem& problem) {
  return find_bar_unknown(problem, 0);
}

/// Adds the strengths of the bars in the lower bound. Returns the number of the next unknown.
int limit_bars(const Problem& problem, SupportRows& rows) {
  for (std::size_t bar = 0; bar < problem.count_bars(); ++bar)
    limit_force(rows, find_bar_unknown(problem, bar), 1, unused);
  return find_bar_unknown(problem, problem.count_bars());
}

// Lower bound.

class StaticRows {
 public:
  StaticRows(const Problem& problem, double factor, const Units& units)
      : problem_(problem),
        factor_(factor),
        units_(units),
        edges_(list_wall_edges(problem)),
        forces_(list_wall_forces(problem)),
        next_(limit_bars(problem, rows_)) {}

  SupportRows build() {
    for (std::size_t w = 0; w < problem_.walls.size(); ++w) add_wall(w);
    rows_.unknowns = next_ - find_first(problem_);
    return std::move(rows_);
  }

 private:
  void add_wall(std::size_t w) {
    const Wall& wall = problem_.walls[w];
    const std::size_t n = wall.size();
    // Unknowns: forces and moments at the nodes between head and toe, where they are zero, then struts.
    std::vector<Pair> force(n + 1), outer(n + 1);
    std::vector<RowForm> moment(n + 1);
    for (std::size_t k = 1; k < n; ++k) {
      force[k] = {make_unknown(next_), make_unknown(next_ + 1)};
      moment[k] = make_unknown(next_ + 2);
      next_ += 3;
    }
    for (const Strut& strut : wall.struts) {
      add(outer[find_wall_node(wall, strut.node)][0], make_unknown(next_, -strut.way));
      limit_strut(rows_, strut, next_++, units_, unused);
    }
    for (const WallForce& given : forces_[w])
      for (std::size_t d = 0; d < 2; ++d) {
        RowForm& own = outer[given.node][d];
        const double now = given.force[d] / given.find_divisor(factor_) / (units_.stress * units_.length);
        add(own, make_unknown(find_bar_unknown(problem_, given.bar), now));
        if (given.is_reduced) own.rates.emplace_back(find_bar_unknown(problem_, given.bar), -now / factor_);
      }
    force[n] = outer[n];
    for (std::size_t k = 0; k < n; ++k) {
      Pair below = force[k];  // below the forces that act at the node
      for (std::size_t d = 0; d < 2; ++d) add(below[d], outer[k][d], -1);
      const std::size_t before = rows_.cones.size();
      add_edge(wall, edges_[w][k], below, force[k + 1], moment[k], moment[k + 1]);
      for (std::size_t c = before; c < rows_.cones.size(); ++c) rows_.sections.emplace_back(c, w, k);
      for (const std::size_t side : {0, 1}) limit_face(wall, edges_[w][k], k, side);
    }
  }

  /// F' = −q and M' = F × t along an edge from its upper end, with the linear load q of the soil and of surface loads.
  void add_edge(const Wall& wall, const WallEdge& edge, const Pair& upper, const Pair& lower, const RowForm& first,
                const RowForm& last) {
    const double length = edge.length / units_.length;
    const std::array<Pair, 2> load{find_load(wall, edge, 0), find_load(wall, edge, 1)};
    const Vec<2>& t = edge.along;
    const Vec<2> turned{t[1], -t[0]};  // a × t = a · turned
    for (std::size_t d = 0; d < 2; ++d) {
      RowForm& force = rows_.equations.emplace_back(lower[d]);
      add(force, upper[d], -1);
      add(force, load[0][d], length / 2), add(force, load[1][d], length / 2);
    }
    RowForm& moment = rows_.equations.emplace_back(last);
    add(moment, first, -1);
    add(moment, multiply(upper, turned, -length));
    add(moment, multiply(load[0], turned, length * length / 3));
    add(moment, multiply(load[1], turned, length * length / 6));
    std::array<RowForm, 4> bending{first, first, last, last};
    add(bending[1], multiply(upper, turned, length / 3));
    add(bending[2], multiply(lower, turned, -length / 3));
    // Axial and shear force are quadratic: three Bézier points, as four for the axial one.
    const auto find_points = [&](const Vec<2>& direction) {
      std::array<RowForm, 3> p{multiply(upper, direction), multiply(upper, direction), multiply(lower, direction)};
      add(p[1], multiply(load[0], direction, -length / 2));
      return p;
    };
    const std::array<RowForm, 3> axial = find_points(t);
    std::array<RowForm, 4> raised{axial[0], {}, {}, axial[2]};
    add(raised[1], axial[0], 1.0 / 3), add(raised[1], axial[1], 2.0 / 3);
    add(raised[2], axial[1], 2.0 / 3), add(raised[2], axial[2], 1.0 / 3);
    for (std::size_t i = 0; i < 4; ++i) limit_section(rows_, wall, &raised[i], &bending[i], units_, unused);
    if (!std::isfinite(wall.shear)) return;
    for (const RowForm& shear : find_points(edge.normal))
      limit(rows_, shear, wall.shear / (units_.stress * units_.length), unused);
  }

  /// Returns the load on the wall at an end of an edge: tractions of the soil, surface loads, and its own.
  Pair find_load(const Wall& wall, const WallEdge& edge, std::size_t end) const {
    Pair load;
    const Vec<2>& n = edge.normal;
    for (std::size_t d = 0; d < 2; ++d) load[d].constant = (wall.line_load[d] + edge.load[end][d]) / units_.stress;
    for (const std::size_t side : {0, 1}) {
      const auto& face = edge.face[side];
      if (!face) continue;
      const double sign = side == 0 ? 1 : -1;
      add(load[0], find_stress(*face, end, {n[0], 0, n[1]}), sign);
      add(load[1], find_stress(*face, end, {0, n[1], n[0]}), sign);
      const double pore = problem_.pore_pressure[face->triangle][face->corner[end]] / units_.stress;
      for (std::size_t d = 0; d < 2; ++d) load[d].constant -= sign * pore * n[d];
    }
    return load;
  }

  /// Returns a combination of σ'x, σ'y and τxy at an end of a face.
  static RowForm find_stress(const WallFace& face, std::size_t end, const std::array<double, 3>& row) {
    const int at = static_cast<int>(9 * face.triangle + 3 * face.corner[end]);
    return {{{at, row[0] + row[1]}, {at + 1, row[0] - row[1]}, {at + 2, row[2]}}, {}, 0, 0};
  }

  void limit_face(const Wall& wall, const WallEdge& edge, std::size_t k, std::size_t side) {
    if (!edge.face[side]) return;
    const Vec<2>&n = edge.normal, &t = edge.along;
    for (const std::size_t end : {0, 1})
      limit_contact(rows_, wall.interface[k][side], factor_, units_,
                    find_stress(*edge.face[side], end, {n[0] * n[0], n[1] * n[1], 2 * n[0] * n[1]}),
                    find_stress(*edge.face[side], end, {n[0] * t[0], n[1] * t[1], n[0] * t[1] + n[1] * t[0]}),
                    most_strength);
  }

  const Problem& problem_;
  double factor_;
  const Units& units_;
  std::vector<std::vector<WallEdge>> edges_;
  std::vector<std::vector<WallForce>> forces_;
  SupportRows rows_;
  int next_;
};

// Upper bound.

class KinematicRows {
 public:
  KinematicRows(const Problem& problem, const Velocities& v, double factor, const Units& units)
      : problem_(problem), v_(v), factor_(factor), units_(units), next_(find_first(problem)) {
    made_.work.assign(static_cast<std::size_t>(v.count), 0);
  }

  SupportWork build() {
    for (const Contact& contact : list_contacts(problem_, v_)) add_contact(contact);
    const auto edges = list_wall_edges(problem_);
    for (std::size_t w = 0; w < problem_.walls.size(); ++w) {
      const Wall& wall = problem_.walls[w];
      const WallMotion& motion = v_.walls[w];
      for (std::size_t i = 1; i < wall.size() && i <= motion.free; ++i) add_hinge(wall, motion, i);
      const auto shortenings = list_shortenings(wall, motion);
      for (std::size_t s = 0; s < shortenings.size(); ++s) {
        use(shortenings[s], next_);
        limit_strut(made_.rows, wall.struts[s], next_++, units_, 0);
      }
      for (std::size_t i = 0; i < wall.size(); ++i) load_edge(wall, edges[w][i], motion.ends[i]);
    }
    for (const BarEdge& bar : problem_.bars) add_bar(bar);
    for (const BarHead& head : problem_.heads) add_head(head);
    made_.rows.unknowns = next_ - find_first(problem_);
    return std::move(made_);
  }

 private:
  void use(const MotionForm& form, int unknown, double times = 1) {
    for (const auto& [number, value] : form) made_.uses.push_back({number, unknown, times * value, 0});
  }

  /// Adds a force between zero and `most` that resists a motion.
  void resist(const MotionForm& motion, double most, bool is_reduced) {
    const double force = most / (units_.stress * units_.length) / (is_reduced ? factor_ : 1);
    for (const auto& [number, value] : motion)
      made_.uses.push_back({number, next_, force * value, is_reduced ? -force * value / factor_ : 0});
    limit_force(made_.rows, next_++, 1, 0);
  }

  /// The elongation along an edge is linear; each end resists it with its part of the tension, as the check counts it.
  void add_bar(const BarEdge& bar) {
    const Vec<2>&a = problem_.nodes[static_cast<std::size_t>(bar.from)],
          &b = problem_.nodes[static_cast<std::size_t>(bar.to)];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const Vec<2> along{(b[0] - a[0]) / length, (b[1] - a[1]) / length};
    const std::array<int, 3> nodes = v_.find_nodes(bar.from, bar.to);
    const auto add_end = [&](const std::array<double, 3>& slopes, double tension) {
      MotionForm form;
      for (std::size_t k = 0; k < 3; ++k)
        add_form(form, find_component(v_.freedoms[static_cast<std::size_t>(nodes[k])], along, slopes[k]));
      resist(form, tension, bar.is_reduced);
    };
    add_end({-3, 4, -1}, (2 * bar.force[0] + bar.force[1]) / 6);
    add_end({1, -4, 3}, (bar.force[0] + 2 * bar.force[1]) / 6);
    const auto above = find_bar_above(problem_, bar);
    const int before = above ? v_.find_nodes(above->from, above->to)[2] : nodes[0];
    if (before == nodes[0]) return;
    MotionForm gap = find_component(v_.freedoms[static_cast<std::size_t>(nodes[0])], along);
    add_form(gap, find_component(v_.freedoms[static_cast<std::size_t>(before)], along, -1));
    resist(gap, bar.force[0], bar.is_reduced);
  }

  void add_head(const BarHead& head) {
    int node = head.node;
    for (const BarEdge& bar : problem_.bars)
      if (bar.from == head.node && bar.bar == head.bar) node = v_.find_nodes(bar.from, bar.to)[0];
    MotionForm form = find_component(v_.freedoms[static_cast<std::size_t>(node)], head.direction);
    if (head.wall) {
      const std::size_t at = find_wall_node(problem_.walls[*head.wall], head.node);
      add_form(form, find_component(find_wall_velocity(v_.walls[*head.wall], at), head.direction, -1));
    }
    const auto measure = [&](const std::array<int, 2>& side) {
      const Vec<2>&a = problem_.nodes[static_cast<std::size_t>(side[0])],
            &b = problem_.nodes[static_cast<std::size_t>(side[1])];
      return std::hypot(b[0] - a[0], b[1] - a[1]);
    };
    double width = 0;
    for (const auto& side : head.sides) width += measure(side);
    for (const auto& side : head.sides) {
      const std::array<int, 3> nodes = v_.find_nodes(side[0], side[1]);
      for (std::size_t k = 0; k < 3; ++k)
        add_form(form, find_component(v_.freedoms[static_cast<std::size_t>(nodes[k])], head.direction,
                                      -(k == 1 ? 4 : 1) * measure(side) / 6 / width));
    }
    resist(form, head.force, head.is_reduced);
  }

  /// Adds the work of a load.
  void push(const std::vector<Freedom>& velocity, const Vec<2>& force, double times) {
    for (const Freedom& f : velocity)
      made_.work[static_cast<std::size_t>(f.number)] +=
          times * dot(force, f.direction) / (units_.stress * units_.length);
  }

  void add_contact(const Contact& contact) {
    const double weight = contact.weight / units_.length;
    use(contact.opening, next_, weight), use(contact.slip, next_ + 1, weight);
    for (const auto& [number, value] : contact.opening)
      made_.work[static_cast<std::size_t>(number)] += weight * value * contact.pressure / units_.stress;
    limit_contact(made_.rows, contact.strength, factor_, units_, make_unknown(next_), make_unknown(next_ + 1),
                  rigid_strength);
    next_ += 2;
  }

  void add_hinge(const Wall& wall, const WallMotion& motion, std::size_t i) {
    const auto add_unknown = [&](double strength, auto add_uses) {
      if (!std::isfinite(strength)) return RowForm{};
      add_uses();
      return make_unknown(next_++);
    };
    const RowForm moment =
        add_unknown(wall.moment, [&] { use(motion.rotation[i], next_), use(motion.rotation[i - 1], next_, -1); });
    const RowForm axial = add_unknown(wall.axial, [&] { made_.uses.push_back({motion.jump[i][0], next_, 1, 0}); });
    const RowForm shear = add_unknown(wall.shear, [&] { made_.uses.push_back({motion.jump[i][1], next_, 1, 0}); });
    limit_section(made_.rows, wall, &axial, &moment, units_, 0);
    if (std::isfinite(wall.shear)) limit(made_.rows, shear, wall.shear / (units_.stress * units_.length), 0);
  }

  void load_edge(const Wall& wall, const WallEdge& edge, const std::array<std::vector<Freedom>, 2>& ends) {
    for (const std::size_t p : {0, 1})
      for (const std::size_t q : {0, 1}) {
        Vec<2> load = edge.load[q];
        for (std::size_t d = 0; d < 2; ++d) load[d] += wall.line_load[d];
        push(ends[p], load, edge.length * (p == q ? 2 : 1) / 6);
      }
  }

  const Problem& problem_;
  const Velocities& v_;
  double factor_;
  const Units& units_;
  SupportWork made_;
  int next_;
};

}  // namespace

SupportRows make_static_rows(const Problem& problem, double factor, const Units& units) {
  return StaticRows(problem, factor, units).build();
}

void add_hinges(const Problem& problem, const Units& units, const ConicSolution& solution, std::size_t soil,
                std::vector<double>& contributions) {
  if (problem.walls.empty()) return;
  constexpr double gap_of_hinges = 0.1;
  const SupportRows rows = make_static_rows(problem, 1, units);
  std::vector<std::size_t> first{0};
  for (const auto& cone : rows.cones) first.push_back(first.back() + cone.size());
  const auto edges = list_wall_edges(problem);
  for (const auto& [cone, wall, edge] : rows.sections)
    for (const auto& face : edges[wall][edge].face)
      if (face) contributions[face->triangle] += gap_of_hinges * solution.z[soil - first.back() + first[cone]];
}

SupportWork make_support_work(const Problem& problem, const Velocities& v, double factor, const Units& units) {
  return KinematicRows(problem, v, factor, units).build();
}

void read_supports(const Problem& problem, const double* unknowns, const Units& units, StressField& field) {
  for (std::size_t bar = 0; bar < problem.count_bars(); ++bar) field.bars.push_back(*unknowns++);
  for (const Wall& wall : problem.walls) {
    unknowns += 3 * (wall.size() - 1);
    auto& own = field.struts.emplace_back();
    for (std::size_t s = 0; s < wall.struts.size(); ++s) own.push_back(units.stress * units.length * *unknowns++);
  }
}

}  // namespace talus::bounds
