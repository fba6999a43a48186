// SPDX-License-Identifier: MIT
// Rows of the programs of both bounds: equilibrium, virtual work, and the cones that they have in common.
#include "bounds/program_of.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/problem.hpp"
#include "bounds/support_rows.hpp"
#include "bounds/velocities.hpp"

namespace talus::bounds {

namespace {

/// Coefficients of σx, σy and τxy.
using Row = std::array<double, 3>;

std::map<EdgeKey, const Side*> index_sides(const Problem& problem) {
  std::map<EdgeKey, const Side*> sides;
  for (const Side& s : problem.sides) sides[make_key(s.from, s.to)] = &s;
  return sides;
}

/// Returns three times the mean over the triangle of a linear field times the shape function of corner i: its weight in
/// a sum over the corners.
double find_weighted(const std::array<double, 3>& field, std::size_t i) {
  return 0.25 * (field[0] + field[1] + field[2] + field[i]);
}

/// Strengths of the cones: those at the corners (lower bound), or weighted ones, with which the sum over the corners is
/// not less than the dissipation of the field (upper bound).
enum class Strengths { own, weighted };

/// The cone 0 ≤ available + lacking · m − mean (σx + σy) that must not be less than half the difference of the
/// principal stresses, with the derivatives of its three coefficients by the factor. That of weak planes has twice
/// their normal stress in the place of σx + σy, and the shear stress on them in that of half the difference.
struct Cone {
  double mean = 0, lacking = 0, available = 0;
  double mean_rate = 0, lacking_rate = 0, available_rate = 0;
  const WeakPlanes* planes = nullptr;

  /// Returns the coefficients of the mean stress, half the difference and the shear stress in its normal stress.
  Row find_normal() const {
    return planes ? Row{1, -std::cos(2 * planes->angle), -std::sin(2 * planes->angle)} : Row{1, 0, 0};
  }
  int count_rows() const { return planes ? 2 : 3; }
};

/// Calls use(planes) for every cone of a strength; null but for that of weak planes.
void visit_rigid(const Strength& soil, auto use) {
  soil.visit_programmed_lines([&](double, double) { use(nullptr); });
  if (soil.tension) use(nullptr);
  if (soil.planes) use(soil.planes.get());
}

/// Calls use(triangle, corner, cone) for the cone of every programmed line of the envelope and then for those of the
/// tension cut-off and of weak planes, if there are any.
void visit_cones(const Problem& problem, double factor, const Units& units, Strengths strengths, auto use) {
  for (std::size_t e = 0; e < problem.size(); ++e) {
    const auto& own = problem.strength[e];
    // A rigid triangle has no part in the equations of the upper bound. Its cones must keep its mean stress finite,
    // which the cost of leave_room() would otherwise drive to infinity.
    if (strengths == Strengths::weighted && is_rigid(own, units)) {
      for (std::size_t i = 0; i < 3; ++i)
        visit_rigid(own[i], [&](const WeakPlanes* planes) { use(e, i, Cone{0, 1, 1, 0, 0, 0, planes}); });
      continue;
    }
    const double most = strengths == Strengths::own ? most_strength : std::numeric_limits<double>::infinity();
    const auto find = [&](std::size_t i, auto get) {
      const double at = get(own[i]);
      return (strengths == Strengths::own ? at : find_weighted({get(own[0]), get(own[1]), get(own[2])}, i)) /
             units.stress;
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const double divisor = own[i].find_divisor(factor), rate = own[i].is_reduced ? 1 / factor : 0;
      const double given = find(i, [](const Strength& s) { return s.cohesion; });
      own[i].visit_programmed_lines([&](double more_cohesion, double tan_friction) {
        const double cohesion = (given + more_cohesion / units.stress) / divisor;
        const double taken = std::min(cohesion, most), cohesion_rate = cohesion < most ? -cohesion * rate : 0;
        const double tangent = tan_friction / divisor, cosine = 1 / std::hypot(1.0, tangent),
                     cube = cosine * cosine * cosine;
        const double tangent_rate = -tangent * rate, cosine_rate = -tangent * cube * tangent_rate;
        use(e, i,
            Cone{0.5 * tangent * cosine, cosine, taken * cosine, 0.5 * cube * tangent_rate, cosine_rate,
                 taken * cosine_rate + cohesion_rate * cosine});
      });
      if (own[i].tension) {
        const double tension = find(i, [](const Strength& s) { return s.tension.value_or(0); }) / divisor;
        use(e, i, Cone{0.5, 1, std::min(tension, most), 0, 0, tension < most ? -tension * rate : 0});
      }
      if (const WeakPlanes* planes = own[i].planes.get()) {
        const double cohesion = planes->cohesion / units.stress / divisor, half = 0.5 * planes->tan_friction / divisor;
        use(e, i,
            Cone{half, 1, std::min(cohesion, most), -half * rate, 0, cohesion < most ? -cohesion * rate : 0, planes});
      }
    }
  }
}

class ProgramBuilder {
 public:
  /// `supports`: unknowns, equations and cones of bars and walls.
  ProgramBuilder(const Problem& problem, double factor, const Units& units, SupportRows supports)
      : problem_(problem), factor_(factor), units_(units), supports_(std::move(supports)) {
    program_.variables = static_cast<int>(9 * problem.size()) + supports_.unknowns + 1;
    program_.cost.assign(static_cast<std::size_t>(program_.variables), 0);
    program_.cost.back() = 1;
  }

  /// Adds the coefficients of a corner to the current equation.
  void add(std::size_t triangle, std::size_t corner, const Row& row, double times = 1) {
    add_unknowns(triangle, corner, {row[0] + row[1], row[0] - row[1], row[2]}, times);
  }
  /// `rate`: derivative of the coefficient by the factor.
  void add_unknown(int number, double value, double rate = 0) {
    entries_.push_back({number, value});
    if (rate != 0) rates_.push_back({number, rate});
  }
  void end_equation(double right) {
    if (!rates_.empty()) program_.rates.push_back({program_.rows.count(), 0, std::move(rates_)});
    rates_.clear();
    program_.add_row(entries_, right);
    ++program_.equations;
  }

  /// Adds equations and cones of bars and walls, then the criterion at every corner of every triangle, with the
  /// cohesion increased by m.
  ConicProgram finish(Strengths strengths) {
    const int lack = program_.variables - 1;
    for (const RowForm& equation : supports_.equations) {
      add_form(equation);
      program_.equations += 1;
    }
    for (const auto& cone : supports_.cones) {
      for (const RowForm& row : cone) add_form(row);
      program_.cones.push_back(static_cast<int>(cone.size()));
    }
    visit_cones(problem_, factor_, units_, strengths,
                [&](std::size_t e, std::size_t i, const Cone& cone) { add_cone(e, i, cone, lack); });
    return std::move(program_);
  }

 private:
  /// Adds the row s = form, or form = 0.
  void add_form(const RowForm& form) {
    const auto find_number = [&](int number) { return number == lacking ? program_.variables - 1 : number; };
    RowRate rate{program_.rows.count(), form.constant_rate, {}};
    for (const auto& [number, value] : form.rates) rate.entries.emplace_back(find_number(number), -value);
    if (rate.right != 0 || !rate.entries.empty()) program_.rates.push_back(std::move(rate));
    for (const auto& [number, value] : form.entries) entries_.emplace_back(find_number(number), -value);
    program_.add_row(entries_, form.constant);
  }

  /// Adds coefficients of the mean stress, half the difference and the shear stress.
  void add_unknowns(std::size_t triangle, std::size_t corner, const Row& row, double times = 1) {
    for (int d = 0; d < 3; ++d)
      if (row[static_cast<std::size_t>(d)] != 0)
        entries_.push_back({static_cast<int>(9 * triangle + 3 * corner) + d, times * row[static_cast<std::size_t>(d)]});
  }

  void add_cone(std::size_t e, std::size_t i, const Cone& cone, int lack) {
    add_unknowns(e, i, cone.find_normal(), 2 * cone.mean);
    entries_.push_back({lack, -cone.lacking});
    program_.add_row(entries_, cone.available);
    if (cone.planes) {
      add_unknowns(e, i, {0, std::sin(2 * cone.planes->angle), -std::cos(2 * cone.planes->angle)});
      program_.add_row(entries_, 0);
    } else {
      add_unknowns(e, i, {0, -1, 0});
      program_.add_row(entries_, 0);
      add_unknowns(e, i, {0, 0, -1});
      program_.add_row(entries_, 0);
    }
    program_.cones.push_back(cone.count_rows());
  }

  const Problem& problem_;
  double factor_;
  Units units_;
  SupportRows supports_;
  ConicProgram program_;
  std::vector<std::pair<int, double>> entries_, rates_;
};

/// Normal and shear traction on an edge as coefficients of a stress.
struct EdgeRows {
  Row normal, along;
  Vec<2> n, t;
};
EdgeRows find_rows(const Vec<2>& from, const Vec<2>& to) {
  const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
  const Vec<2> t{(to[0] - from[0]) / length, (to[1] - from[1]) / length}, n{t[1], -t[0]};
  return {{n[0] * n[0], n[1] * n[1], 2 * n[0] * n[1]}, {n[0] * t[0], n[1] * t[1], n[0] * t[1] + n[1] * t[0]}, n, t};
}

ConicProgram make_static_program(const Problem& problem, double factor, const Units& units) {
  ProgramBuilder builder(problem, factor, units, make_static_rows(problem, factor, units));
  const WallKeys walls(problem);
  const double unit = units.stress;
  for (std::size_t e = 0; e < problem.size(); ++e) {
    // div σ' = ∇p − b, times the length of the section.
    const Shape shape = find_shape(problem, e);
    Vec<2> right{-problem.body_force[e][0], -problem.body_force[e][1]};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t d = 0; d < 2; ++d) right[d] += problem.pore_pressure[e][i] * shape.gradient[i][d];
    for (std::size_t d = 0; d < 2; ++d) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec<2>& g = shape.gradient[i];
        builder.add(e, i, d == 0 ? Row{g[0], 0, g[1]} : Row{0, g[1], g[0]}, units.length);
      }
      builder.end_equation(right[d] * units.length / unit);
    }
  }
  const auto sides = index_sides(problem);
  std::map<EdgeKey, std::vector<LineForce>> of_supports;
  for (const LineForce& force : list_line_forces(problem)) of_supports[make_key(force.from, force.to)].push_back(force);
  for (const Edge& edge : list_edges(problem.triangles)) {
    if (walls.contains(edge.from, edge.to)) continue;
    const Vec<2>&from = problem.nodes[static_cast<std::size_t>(edge.from)],
          &to = problem.nodes[static_cast<std::size_t>(edge.to)];
    const EdgeRows rows = find_rows(from, to);
    const auto e = static_cast<std::size_t>(edge.triangle);
    const auto found = sides.find(make_key(edge.from, edge.to));
    const Side* side = edge.other < 0 && found != sides.end() ? found->second : nullptr;
    const auto support = of_supports.find(make_key(edge.from, edge.to));
    const auto add_supports = [&](const Vec<2>& direction) {
      if (support == of_supports.end()) return;
      for (const LineForce& force : support->second) {
        const double value = -dot(force.traction, direction) / force.find_divisor(factor) / unit;
        builder.add_unknown(find_bar_unknown(problem, force.bar), value, force.is_reduced ? -value / factor : 0);
      }
    };
    for (const int node : {edge.from, edge.to}) {
      const std::size_t i = find_corner(problem.triangles[e], node);
      double normal = problem.pore_pressure[e][i], along = 0;
      if (edge.other >= 0) {
        const auto o = static_cast<std::size_t>(edge.other);
        const std::size_t j = find_corner(problem.triangles[o], node);
        normal -= problem.pore_pressure[o][j];
        builder.add(e, i, rows.normal), builder.add(o, j, rows.normal, -1), add_supports(rows.n);
        builder.end_equation(normal / unit);
        builder.add(e, i, rows.along), builder.add(o, j, rows.along, -1), add_supports(rows.t);
        builder.end_equation(0);
        continue;
      }
      if (side) {
        const Vec<2>& t = side->traction[node == side->from ? 0 : 1];
        normal += dot(t, rows.n), along += dot(t, rows.t);
      }
      if (!side || !side->holds_normal)
        builder.add(e, i, rows.normal), add_supports(rows.n), builder.end_equation(normal / unit);
      if (!side || !side->holds_along)
        builder.add(e, i, rows.along), add_supports(rows.t), builder.end_equation(along / unit);
    }
  }
  return builder.finish(Strengths::own);
}

ConicProgram make_kinematic_program(const Problem& problem, double factor, const Units& units) {
  const Velocities v = number_velocities(problem, units);
  struct Use {
    std::size_t triangle, corner;
    Row row;
  };
  std::vector<std::vector<Use>> uses(static_cast<std::size_t>(v.count));
  std::vector<double> work(static_cast<std::size_t>(v.count), 0);
  auto each = [&](int node, auto&& give) {
    for (const auto& f : v.freedoms[static_cast<std::size_t>(node)])
      give(static_cast<std::size_t>(f.number), f.direction);
  };
  const double force_unit = units.stress * units.length;
  for (std::size_t e = 0; e < problem.size(); ++e) {
    const Shape shape = find_shape(problem, e);
    const double third = shape.area / 3;
    const bool rigid = is_rigid(problem.strength[e], units);
    for (std::size_t c = 0; c < 3; ++c) {
      each(v.triangles[e][3 + c], [&](std::size_t number, const Vec<2>& d) {
        work[number] += third * dot(problem.body_force[e], d) / force_unit;
      });
      if (rigid) continue;
      const auto gradients = find_quadratic_gradients(shape, c);
      const double pore = find_weighted(problem.pore_pressure[e], c);
      for (std::size_t k = 0; k < 6; ++k)
        each(v.triangles[e][k], [&](std::size_t number, const Vec<2>& d) {
          const Vec<2>& g = gradients[k];
          const double by = third / units.length;
          uses[number].push_back({e, c, {by * g[0] * d[0], by * g[1] * d[1], by * (g[1] * d[0] + g[0] * d[1])}});
          work[number] += third * pore * dot(g, d) / force_unit;
        });
    }
  }
  const WallKeys keys(problem);
  for (const Side& side : problem.sides) {
    if (keys.contains(side.from, side.to)) continue;  // its load acts on the wall
    const Vec<2>&a = problem.nodes[static_cast<std::size_t>(side.from)],
          &b = problem.nodes[static_cast<std::size_t>(side.to)];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const auto [from, middle, to] = v.find_nodes(side.from, side.to);
    const auto& t = side.traction;
    each(from, [&](std::size_t number, const Vec<2>& d) { work[number] += length * dot(t[0], d) / 6 / force_unit; });
    each(to, [&](std::size_t number, const Vec<2>& d) { work[number] += length * dot(t[1], d) / 6 / force_unit; });
    each(middle, [&](std::size_t number, const Vec<2>& d) {
      work[number] += length * (dot(t[0], d) + dot(t[1], d)) / 3 / force_unit;
    });
  }
  SupportWork supports = make_support_work(problem, v, factor, units);
  std::vector<std::vector<SupportWork::Use>> of_supports(uses.size());
  for (const SupportWork::Use& use : supports.uses) of_supports[static_cast<std::size_t>(use.number)].push_back(use);
  ProgramBuilder builder(problem, factor, units, std::move(supports.rows));
  for (std::size_t number = 0; number < uses.size(); ++number) {
    for (const Use& use : uses[number]) builder.add(use.triangle, use.corner, use.row);
    for (const SupportWork::Use& use : of_supports[number]) builder.add_unknown(use.unknown, use.value, use.rate);
    builder.end_equation(work[number] + supports.work[number]);
  }
  return builder.finish(Strengths::weighted);
}

}  // namespace

double find_lack_rate(const Problem& problem, const ConicProgram& program, Bound bound, double factor,
                      const Units& units, const ConicSolution& solution) {
  std::size_t row = solution.z.size();
  for (const auto& strengths : problem.strength)
    for (const Strength& soil : strengths) row -= soil.count_rows();
  const double lack = solution.x.back();
  double rate = 0;
  for (const RowRate& of : program.rates) {
    double change = -of.right;
    for (const auto& [variable, value] : of.entries) change += value * solution.x[static_cast<std::size_t>(variable)];
    rate += solution.z[static_cast<std::size_t>(of.row)] * change;
  }
  visit_cones(problem, factor, units, bound == Bound::lower ? Strengths::own : Strengths::weighted,
              [&](std::size_t e, std::size_t i, const Cone& cone) {
                const double* stress = &solution.x[9 * e + 3 * i];
                const Row on = cone.find_normal();
                const double normal = on[0] * stress[0] + on[1] * stress[1] + on[2] * stress[2];
                rate +=
                    solution.z[row] * (2 * cone.mean_rate * normal - cone.lacking_rate * lack - cone.available_rate);
                row += static_cast<std::size_t>(cone.count_rows());
              });
  return rate;
}

std::vector<double> find_slacks(const Problem& problem, Bound bound, double factor, const Units& units,
                                const std::vector<double>& unknowns) {
  std::vector<double> slacks;
  visit_cones(problem, factor, units, bound == Bound::lower ? Strengths::own : Strengths::weighted,
              [&](std::size_t e, std::size_t i, const Cone& cone) {
                const double* stress = &unknowns[9 * e + 3 * i];
                const Row on = cone.find_normal();
                const double normal = on[0] * stress[0] + on[1] * stress[1] + on[2] * stress[2];
                slacks.push_back(cone.available + cone.lacking * unknowns.back() - 2 * cone.mean * normal);
                if (cone.planes) {
                  const double angle = 2 * cone.planes->angle;
                  slacks.push_back(std::cos(angle) * stress[2] - std::sin(angle) * stress[1]);
                } else {
                  slacks.insert(slacks.end(), {stress[1], stress[2]});
                }
              });
  return slacks;
}

ConicProgram make_program(const Problem& problem, Bound bound, double factor, const Units& units) {
  return bound == Bound::lower ? make_static_program(problem, factor, units)
                               : make_kinematic_program(problem, factor, units);
}

// With z = z' + room · e in each cone, Aᵀz + q = Aᵀz' + (q + room Σ first rows).
void leave_room(ConicProgram& program, double room) {
  int row = program.equations;
  for (const int size : program.cones) {
    for (std::size_t k = program.rows.begin(row); k < program.rows.begin(row + 1); ++k)
      program.cost[static_cast<std::size_t>(program.rows.column[k])] += room * program.rows.value[k];
    row += size;
  }
}

double use_room(const ConicProgram& program, double room, ConicSolution& solution) {
  auto row = static_cast<std::size_t>(program.equations);
  for (const int size : program.cones) {
    solution.z[row] += room;
    row += static_cast<std::size_t>(size);
  }
  double lack = 0;
  for (std::size_t i = 0; i < program.right.size(); ++i) lack -= program.right[i] * solution.z[i];
  return lack;
}

}  // namespace talus::bounds
