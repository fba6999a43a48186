// SPDX-License-Identifier: MIT
// Least changes of a solution.

#include "bounds/read_field.hpp"

#include <algorithm>

#include "bounds/least_change.hpp"
#include "bounds/opening.hpp"

namespace talus::bounds {

namespace {

/// The least of `opening` that every corner needs to keep the flow rule of this factor.
void open_soil(const Problem& problem, const Velocities& mesh, double factor, double length, OpeningSearch& openings,
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
  const std::vector<double>* opening = openings.find(problem, mesh, factor, length);
  if (!opening) return;
  const std::vector<Strain> own = find_strains(problem, mesh, *opening);
  constexpr double rounding_of_sums = 1e-13;
  double share = 0;
  for (std::size_t i = 0; i < strains.size(); ++i)
    if (may_open(problem, i / 3, i % 3, units))
      share = std::max(share, (find_lack(strains, i) + rounding_of_sums * strains[i].shear) / -find_lack(own, i));
  for (std::size_t n = 0; n < numbers.size(); ++n) numbers[n] += share * (*opening)[n];
}

/// Changes of velocities that also move soil with friction are dear: its flow rule would need more opening.
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

StressField read_stress(const Problem& problem, const ConicProgram& program, const ConicSolution& solution,
                        const Units& units) {
  std::vector<double> stress(solution.x.begin(), solution.x.end() - 1);
  fulfil(program.rows, program.equations, program.right, stress);
  StressField field;
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
