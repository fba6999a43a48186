// SPDX-License-Identifier: MIT
// Conversion of solutions of the programs of both bounds to fields: smallest changes that make them admissible.
#include <algorithm>
#include <cmath>

#include "bounds/program_of.hpp"
#include "bounds/support_rows.hpp"
#include "bounds/wall_motion.hpp"

namespace talus::bounds {

namespace {

/// Adds the smallest multiple of the opening field with which every corner satisfies the flow rule of this factor.
void open_soil(const Problem& problem, const Velocities& mesh, double factor, double length, OpeningSearch& openings,
               std::vector<double>& numbers) {
  const auto get_soil = [&](std::size_t i) -> const Strength& { return problem.strength[i / 3][i % 3]; };
  const std::vector<bool> opens = find_opening_corners(problem, mesh);
  const std::vector<Strain> strains = find_strains(problem, mesh, numbers);
  bool lacks = false;
  for (std::size_t i = 0; i < strains.size(); ++i)
    lacks = lacks || (opens[i] && find_lack(get_soil(i), factor, strains[i]) > 0);
  const std::vector<OpeningLimit> limits = list_opening_limits(problem, mesh);
  const auto find_limit_lack = [&](const OpeningLimit& limit, const std::vector<double>& of) {
    return std::abs(evaluate(limit.slip, of)) * limit.tan_friction / factor - evaluate(limit.opening, of);
  };
  for (const OpeningLimit& limit : limits) lacks = lacks || find_limit_lack(limit, numbers) > 0;
  if (!lacks) return;
  const std::vector<double>* opening = openings.find(problem, mesh, factor, length);
  if (!opening) return;
  const std::vector<Strain> own = find_strains(problem, mesh, *opening);
  constexpr double rounding_of_sums = 1e-13;
  double share = 0;
  // The field opens the soil itself, and what slips on weak planes lacks no more with it.
  for (std::size_t i = 0; i < strains.size(); ++i)
    if (opens[i]) {
      const double margin = own[i].opening - find_sine(get_soil(i), factor) * own[i].find_shear();
      share = std::max(
          share, (find_lack(get_soil(i), factor, strains[i]) + rounding_of_sums * strains[i].find_shear()) / margin);
    }
  for (const OpeningLimit& limit : limits) {
    const double rounding_of_slip = rounding_of_sums * std::abs(evaluate(limit.slip, numbers));
    share = std::max(share, (find_limit_lack(limit, numbers) + rounding_of_slip) / -find_limit_lack(limit, *opening));
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
  read_supports(problem, stress.data() + 9 * problem.size(), units, field);
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
  VelocityField field{number_velocities(problem, units), {}, {}};
  const double length = units.length;
  std::vector<double> numbers(solution.z.begin(), solution.z.begin() + field.mesh.count);
  for (double& u : numbers) u = -u;
  const SparseRows closed = list_openings(problem, field.mesh, length);
  fulfil(closed, closed.count(), std::vector<double>(static_cast<std::size_t>(closed.count()), 0), numbers,
         weigh_changes(problem, field.mesh));
  open_soil(problem, field.mesh, factor, length, opening, numbers);
  const auto add = [&](const std::vector<Freedom>& freedoms) {
    Vec<2> sum{0, 0};
    for (const Freedom& f : freedoms)
      for (std::size_t d = 0; d < 2; ++d) sum[d] += f.direction[d] * numbers[static_cast<std::size_t>(f.number)];
    return sum;
  };
  for (const auto& freedoms : field.mesh.freedoms) field.velocity.push_back(add(freedoms));
  for (const WallMotion& wall : field.mesh.walls) {
    auto& own = field.walls.emplace_back();
    for (const auto& ends : wall.ends) own.push_back({add(ends[0]), add(ends[1])});
  }
  return field;
}

}  // namespace talus::bounds
