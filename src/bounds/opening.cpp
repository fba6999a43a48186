// SPDX-License-Identifier: MIT
// Lifting, and the program of the largest margin.

#include "bounds/opening.hpp"

#include <algorithm>
#include <cmath>

#include "bounds/conic/solve.hpp"
#include "bounds/least_change.hpp"

namespace talus::bounds {

namespace {

/// Coefficients of one number in ε_x, ε_y and γ at corner c of triangle e.
template <class Use>
void visit_strains(const Problem& problem, const Velocities& mesh, std::size_t e, std::size_t c, Use use) {
  const auto gradients = find_quadratic_gradients(find_shape(problem, e), c);
  for (std::size_t k = 0; k < 6; ++k)
    for (const auto& f : mesh.freedoms[static_cast<std::size_t>(mesh.triangles[e][k])]) {
      const Vec<2>&g = gradients[k], &d = f.direction;
      use(f.number, std::array<double, 3>{g[0] * d[0], g[1] * d[1], g[1] * d[0] + g[0] * d[1]});
    }
}

/// Largest t with ε_v − t ≥ sin φ √(…) at the corners that may open, where the mean of their ε_v is one.
ConicProgram make_program(const Problem& problem, const Velocities& mesh, double factor, double length) {
  const Units units = find_units(problem);
  ConicProgram program;
  const int margin = mesh.count;
  program.variables = mesh.count + 1;
  program.cost.assign(static_cast<std::size_t>(program.variables), 0);
  program.cost.back() = -1;
  program.rows = list_openings(problem, mesh, length);
  program.right.assign(static_cast<std::size_t>(program.rows.count()), 0);
  std::vector<std::pair<int, double>> mean, entries;
  double area = 0;
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t c = 0; c < 3; ++c)
      if (may_open(problem, e, c, units)) area += find_shape(problem, e).area / 3;
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t c = 0; c < 3; ++c) {
      if (!may_open(problem, e, c, units)) continue;
      const double share = find_shape(problem, e).area / 3 / area * length;
      visit_strains(problem, mesh, e, c, [&](int n, const auto& row) {
        mean.push_back({n, share * (row[0] + row[1])});
      });
    }
  program.add_row(mean, 1);
  program.equations = program.rows.count();
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t c = 0; c < 3; ++c) {
      if (!may_open(problem, e, c, units)) continue;
      const double sine = find_sine(problem.strength[e][c], factor);
      visit_strains(problem, mesh, e, c, [&](int n, const auto& row) {
        entries.push_back({n, -length * (row[0] + row[1])});
      });
      entries.push_back({margin, 1});
      program.add_row(entries, 0);
      program.cones.push_back(sine > 0 ? 3 : 1);
      if (!(sine > 0)) continue;
      visit_strains(problem, mesh, e, c, [&](int n, const auto& row) {
        entries.push_back({n, sine * length * (row[0] - row[1])});
      });
      program.add_row(entries, 0);
      visit_strains(problem, mesh, e, c, [&](int n, const auto& row) {
        entries.push_back({n, sine * length * row[2]});
      });
      program.add_row(entries, 0);
    }
  return program;
}

/// Corners that may not open keep their volume to `rounding_of_volume` of the largest strain.
bool opens_everywhere(const Problem& problem, const Velocities& mesh, double factor, double length,
                      const std::vector<double>& numbers) {
  constexpr double least = 1e-6;  ///< margin over the mean
  constexpr double rounding_of_volume = 1e-11;
  const Units units = find_units(problem);
  const std::vector<Strain> strains = find_strains(problem, mesh, numbers);
  double largest = 0;
  for (const Strain& s : strains) largest = std::max({largest, std::abs(s.opening), s.shear});
  for (std::size_t i = 0; i < strains.size(); ++i) {
    const Strength& soil = problem.strength[i / 3][i % 3];
    const double margin = length * (strains[i].opening - find_sine(soil, factor) * strains[i].shear);
    if (may_open(problem, i / 3, i % 3, units) ? margin < least
                                               : std::abs(strains[i].opening) > rounding_of_volume * largest)
      return false;
  }
  return true;
}

/// Each node by its height above the lowest one.
std::vector<double> lift(const Problem& problem, const Velocities& mesh, double length) {
  double lowest = problem.nodes.front()[1];
  for (const Vec<2>& x : problem.nodes) lowest = std::min(lowest, x[1]);
  std::vector<double> numbers(static_cast<std::size_t>(mesh.count), 0);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    for (const auto& f : mesh.freedoms[n])
      numbers[static_cast<std::size_t>(f.number)] = f.direction[1] * (mesh.nodes[n][1] - lowest) / length;
  return numbers;
}

/// The field of the largest margin; nothing where the solver finds none.
std::optional<std::vector<double>> open_most(const Problem& problem, const Velocities& mesh, double factor,
                                             double length) {
  const ConicProgram program = make_program(problem, mesh, factor, length);
  const ConicSolution found = solve(program, {});
  if (found.end != ConicEnd::solved) return std::nullopt;
  std::vector<double> numbers(found.x.begin(), found.x.begin() + mesh.count);
  const SparseRows closed = list_openings(problem, mesh, length);
  fulfil(closed, closed.count(), std::vector<double>(static_cast<std::size_t>(closed.count()), 0), numbers);
  return numbers;
}

}  // namespace

std::vector<Strain> find_strains(const Problem& problem, const Velocities& mesh, const std::vector<double>& numbers) {
  std::vector<Strain> strains;
  strains.reserve(3 * problem.size());
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<double, 3> sum{};
      visit_strains(problem, mesh, e, c, [&](int n, const auto& row) {
        for (std::size_t d = 0; d < 3; ++d) sum[d] += row[d] * numbers[static_cast<std::size_t>(n)];
      });
      strains.push_back({sum[0] + sum[1], std::hypot(sum[0] - sum[1], sum[2])});
    }
  return strains;
}

double find_sine(const Strength& soil, double factor) {
  return soil.tan_friction / std::hypot(factor, soil.tan_friction);
}

SparseRows list_openings(const Problem& problem, const Velocities& mesh, double length) {
  const Units units = find_units(problem);
  SparseRows rows;
  std::vector<std::pair<int, double>> entries;
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t c = 0; c < 3; ++c) {
      if (may_open(problem, e, c, units) || is_rigid(problem.strength[e], units)) continue;
      entries.clear();
      visit_strains(problem, mesh, e, c, [&](int n, const auto& row) {
        entries.push_back({n, length * (row[0] + row[1])});
      });
      std::sort(entries.begin(), entries.end());
      for (const auto& [number, value] : entries) rows.add(number, value);
      rows.end_row();
    }
  return rows;
}

const std::vector<double>* OpeningSearch::find(const Problem& problem, const Velocities& mesh, double factor,
                                               double length) {
  if (found_ && opens_everywhere(problem, mesh, factor, length, *found_)) return &*found_;
  found_ = lift(problem, mesh, length);
  if (opens_everywhere(problem, mesh, factor, length, *found_)) return &*found_;
  found_ = open_most(problem, mesh, factor, length);
  if (found_ && !opens_everywhere(problem, mesh, factor, length, *found_)) found_.reset();
  return found_ ? &*found_ : nullptr;
}

}  // namespace talus::bounds
