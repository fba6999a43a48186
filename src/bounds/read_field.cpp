// SPDX-License-Identifier: MIT
// Least changes of a solution.

#include "bounds/read_field.hpp"

#include <algorithm>

#include "bounds/least_change.hpp"
#include "bounds/opening.hpp"

namespace talus::bounds {

namespace {

/// The least of `opening` that every corner needs to keep the flow rule of this factor.
void open_soil(const Problem& problem, const Velocities& mesh, double factor, double length,
               std::vector<double>& numbers) {
  auto find_lack = [&](const std::vector<Strain>& strains, std::size_t i) {
    return find_sine(problem.strength[i / 3][i % 3], factor) * strains[i].shear - strains[i].opening;
  };
  const Units units = find_units(problem);
  const std::vector<Strain> strains = find_strains(problem, mesh, numbers);
  bool lacks = false;
  for (std::size_t i = 0; i < strains.size(); ++i)
    lacks = lacks || (may_open(problem, i / 3, i % 3, units) && find_lack(strains, i) > 0);
  if (!lacks) return;
  const auto opening = find_opening(problem, mesh, factor, length);
  if (!opening) return;
  const std::vector<Strain> own = find_strains(problem, mesh, *opening);
  constexpr double rounding_of_sums = 1e-13;
  double share = 0;
  for (std::size_t i = 0; i < strains.size(); ++i)
    if (may_open(problem, i / 3, i % 3, units))
      share = std::max(share, (find_lack(strains, i) + rounding_of_sums * strains[i].shear) / -find_lack(own, i));
  for (std::size_t n = 0; n < numbers.size(); ++n) numbers[n] += share * (*opening)[n];
}

}  // namespace

StressField read_stress(const Problem& problem, const ConicProgram& program, const ConicSolution& solution,
                        const Units& units) {
  std::vector<double> stress(solution.x.begin(), solution.x.end() - 1);
  fulfil(program.rows, program.equations, program.right, stress);
  StressField field;
  field.stress.resize(problem.size());
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t d = 0; d < 3; ++d) field.stress[e][i][d] = units.stress * stress[9 * e + 3 * i + d];
  return field;
}

VelocityField read_velocity(const Problem& problem, double factor, const ConicSolution& solution) {
  const Units units = find_units(problem);
  VelocityField field{number_velocities(problem, units), {}};
  const double length = units.length;
  std::vector<double> numbers(solution.z.begin(), solution.z.begin() + field.mesh.count);
  for (double& u : numbers) u = -u;
  const SparseRows openings = list_openings(problem, field.mesh, length);
  fulfil(openings, openings.count(), std::vector<double>(static_cast<std::size_t>(openings.count()), 0), numbers);
  open_soil(problem, field.mesh, factor, length, numbers);
  field.velocity.assign(field.mesh.nodes.size(), {0, 0});
  for (std::size_t n = 0; n < field.velocity.size(); ++n)
    for (const auto& f : field.mesh.freedoms[n])
      for (std::size_t d = 0; d < 2; ++d)
        field.velocity[n][d] += f.direction[d] * numbers[static_cast<std::size_t>(f.number)];
  return field;
}

}  // namespace talus::bounds
