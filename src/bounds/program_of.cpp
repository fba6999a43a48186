// SPDX-License-Identifier: MIT
// Rows of the programs of both bounds: equilibrium, virtual work, and the cones that they have in common; and the
// conversion of solutions to fields.
#include "bounds/program_of.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/problem.hpp"
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
  soil.visit_lines([&](double, double) { use(nullptr); });
  if (soil.tension) use(nullptr);
  if (soil.planes) use(soil.planes.get());
}

/// Calls use(triangle, corner, cone) for the cone of every line of the envelope and then for those of the tension
/// cut-off and of weak planes, if there are any.
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
      own[i].visit_lines([&](double more_cohesion, double tan_friction) {
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
  ProgramBuilder(const Problem& problem, double factor, const Units& units)
      : problem_(problem), factor_(factor), units_(units) {
    program_.variables = static_cast<int>(9 * problem.size()) + 1;
    program_.cost.assign(static_cast<std::size_t>(program_.variables), 0);
    program_.cost.back() = 1;
  }

  /// Adds the coefficients of a corner to the current equation.
  void add(std::size_t triangle, std::size_t corner, const Row& row, double times = 1) {
    add_unknowns(triangle, corner, {row[0] + row[1], row[0] - row[1], row[2]}, times);
  }
  /// `rate`: derivative of the right-hand side by the factor.
  void end_equation(double right, double rate = 0) {
    program_.add_row(entries_, right);
    if (rate != 0) program_.right_rate.resize(static_cast<std::size_t>(program_.equations) + 1, 0);
    if (rate != 0) program_.right_rate.back() = rate;
    ++program_.equations;
  }

  /// Adds the criterion at every corner of every triangle, with the cohesion increased by m.
  ConicProgram finish(Strengths strengths) {
    const int lack = program_.variables - 1;
    visit_cones(problem_, factor_, units_, strengths,
                [&](std::size_t e, std::size_t i, const Cone& cone) { add_cone(e, i, cone, lack); });
    return std::move(program_);
  }

 private:
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
  ConicProgram program_;
  std::vector<std::pair<int, double>> entries_;
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
  ProgramBuilder builder(problem, factor, units);
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
  struct Traction {
    Vec<2> now{}, rate{};
  };
  std::map<EdgeKey, Traction> of_supports;
  for (const LineForce& force : list_line_forces(problem)) {
    Traction& at = of_supports[make_key(force.from, force.to)];
    for (std::size_t d = 0; d < 2; ++d) {
      const double now = force.traction[d] / force.find_divisor(factor) / unit;
      at.now[d] += now;
      if (force.is_reduced) at.rate[d] -= now / factor;
    }
  }
  for (const Edge& edge : list_edges(problem.triangles)) {
    const Vec<2>&from = problem.nodes[static_cast<std::size_t>(edge.from)],
          &to = problem.nodes[static_cast<std::size_t>(edge.to)];
    const EdgeRows rows = find_rows(from, to);
    const auto e = static_cast<std::size_t>(edge.triangle);
    const auto found = sides.find(make_key(edge.from, edge.to));
    const Side* side = edge.other < 0 && found != sides.end() ? found->second : nullptr;
    const auto support = of_supports.find(make_key(edge.from, edge.to));
    const Traction given = support != of_supports.end() ? support->second : Traction{};
    const double push = dot(given.now, rows.n), push_rate = dot(given.rate, rows.n), drag = dot(given.now, rows.t),
                 drag_rate = dot(given.rate, rows.t);
    for (const int node : {edge.from, edge.to}) {
      const std::size_t i = find_corner(problem.triangles[e], node);
      double normal = problem.pore_pressure[e][i], along = 0;
      if (edge.other >= 0) {
        const auto o = static_cast<std::size_t>(edge.other);
        const std::size_t j = find_corner(problem.triangles[o], node);
        normal -= problem.pore_pressure[o][j];
        builder.add(e, i, rows.normal), builder.add(o, j, rows.normal, -1);
        builder.end_equation(normal / unit + push, push_rate);
        builder.add(e, i, rows.along), builder.add(o, j, rows.along, -1);
        builder.end_equation(drag, drag_rate);
        continue;
      }
      if (side) {
        const Vec<2>& t = side->traction[node == side->from ? 0 : 1];
        normal += dot(t, rows.n), along += dot(t, rows.t);
      }
      if (!side || !side->holds_normal)
        builder.add(e, i, rows.normal), builder.end_equation(normal / unit + push, push_rate);
      if (!side || !side->holds_along)
        builder.add(e, i, rows.along), builder.end_equation(along / unit + drag, drag_rate);
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
  std::vector<double> work(static_cast<std::size_t>(v.count), 0), work_rate = work;
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
  for (const Side& side : problem.sides) {
    const Vec<2>&a = problem.nodes[static_cast<std::size_t>(side.from)],
          &b = problem.nodes[static_cast<std::size_t>(side.to)];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const int middle = v.middles.at(make_key(side.from, side.to));
    const auto& t = side.traction;
    each(side.from,
         [&](std::size_t number, const Vec<2>& d) { work[number] += length * dot(t[0], d) / 6 / force_unit; });
    each(side.to, [&](std::size_t number, const Vec<2>& d) { work[number] += length * dot(t[1], d) / 6 / force_unit; });
    each(middle, [&](std::size_t number, const Vec<2>& d) {
      work[number] += length * (dot(t[0], d) + dot(t[1], d)) / 3 / force_unit;
    });
  }
  for (const LineForce& force : list_line_forces(problem)) {
    const auto add = [&](int node, double share) {
      each(node, [&](std::size_t number, const Vec<2>& d) {
        const double own = share * force.length * dot(force.traction, d) / force.find_divisor(factor) / force_unit;
        work[number] += own;
        if (force.is_reduced) work_rate[number] -= own / factor;
      });
    };
    add(force.from, 1.0 / 6), add(v.middles.at(make_key(force.from, force.to)), 4.0 / 6), add(force.to, 1.0 / 6);
  }
  ProgramBuilder builder(problem, factor, units);
  for (std::size_t number = 0; number < uses.size(); ++number) {
    for (const Use& use : uses[number]) builder.add(use.triangle, use.corner, use.row);
    builder.end_equation(work[number], work_rate[number]);
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
  for (std::size_t i = 0; i < program.right_rate.size(); ++i) rate -= solution.z[i] * program.right_rate[i];
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

// Smallest changes that turn a solution into an admissible field.

namespace {

/// Adds the smallest multiple of the opening field with which every corner satisfies the flow rule of this factor.
void open_soil(const Problem& problem, const Velocities& mesh, double factor, double length, OpeningSearch& openings,
               std::vector<double>& numbers) {
  const auto get_soil = [&](std::size_t i) -> const Strength& { return problem.strength[i / 3][i % 3]; };
  const Units units = find_units(problem);
  const std::vector<Strain> strains = find_strains(problem, mesh, numbers);
  bool lacks = false;
  for (std::size_t i = 0; i < strains.size(); ++i)
    lacks = lacks || (may_open(problem, i / 3, i % 3, units) && find_lack(get_soil(i), factor, strains[i]) > 0);
  if (!lacks) return;
  const std::vector<double>* opening = openings.find(problem, mesh, factor, length);
  if (!opening) return;
  const std::vector<Strain> own = find_strains(problem, mesh, *opening);
  constexpr double rounding_of_sums = 1e-13;
  double share = 0;
  // The field opens the soil itself, and what slips on weak planes lacks no more with it.
  for (std::size_t i = 0; i < strains.size(); ++i)
    if (may_open(problem, i / 3, i % 3, units)) {
      const double opens = own[i].opening - find_sine(get_soil(i), factor) * own[i].find_shear();
      share = std::max(
          share, (find_lack(get_soil(i), factor, strains[i]) + rounding_of_sums * strains[i].find_shear()) / opens);
    }
  for (std::size_t n = 0; n < numbers.size(); ++n) numbers[n] += share * (*opening)[n];
}

/// Returns the weights of the changes of velocities. Changes that also affect soil with friction are penalised, since
/// its flow rule would then need more opening.
std::vector<double> weigh_changes(const Problem& problem, const Velocities& mesh) {
  constexpr double weight_of_friction = 1e6;
  const Units units = find_units(problem);
  std::vector<double> weights(static_cast<std::size_t>(mesh.count), 1);
  for (std::size_t e = 0; e < problem.size(); ++e) {
    if (!may_open(problem, e, 0, units) && !may_open(problem, e, 1, units) && !may_open(problem, e, 2, units)) continue;
    for (const int node : mesh.triangles[e])
      for (const auto& f : mesh.freedoms[static_cast<std::size_t>(node)])
        weights[static_cast<std::size_t>(f.number)] = weight_of_friction;
  }
  return weights;
}

}  // namespace

StressField read_stress(const Problem& problem, const ConicProgram& program, double factor,
                        const ConicSolution& solution, const Units& units) {
  std::vector<double> stress(solution.x.begin(), solution.x.end() - 1);
  fulfil(program.rows, program.equations, program.right, stress);
  StressField field;
  field.factor = factor;
  field.stress.resize(problem.size());
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t i = 0; i < 3; ++i) {
      const double *at = &stress[9 * e + 3 * i], mean = at[0], half_difference = at[1], shear = at[2];
      field.stress[e][i] = {units.stress * (mean + half_difference), units.stress * (mean - half_difference),
                            units.stress * shear};
    }
  return field;
}

VelocityField read_velocity(const Problem& problem, double factor, const ConicSolution& solution,
                            OpeningSearch& opening) {
  const Units units = find_units(problem);
  VelocityField field{number_velocities(problem, units), {}};
  const double length = units.length;
  std::vector<double> numbers(solution.z.begin(), solution.z.begin() + field.mesh.count);
  for (double& u : numbers) u = -u;
  const SparseRows closed = list_openings(problem, field.mesh, length);
  fulfil(closed, closed.count(), std::vector<double>(static_cast<std::size_t>(closed.count()), 0), numbers,
         weigh_changes(problem, field.mesh));
  open_soil(problem, field.mesh, factor, length, opening, numbers);
  field.velocity.assign(field.mesh.nodes.size(), {0, 0});
  for (std::size_t n = 0; n < field.velocity.size(); ++n)
    for (const auto& f : field.mesh.freedoms[n])
      for (std::size_t d = 0; d < 2; ++d)
        field.velocity[n][d] += f.direction[d] * numbers[static_cast<std::size_t>(f.number)];
  return field;
}

}  // namespace talus::bounds
