// SPDX-License-Identifier: MIT
#include "run/fem/start_stress.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "mesh/generate.hpp"
#include "run/fem/solid_of_case.hpp"

namespace talus::run {
namespace {

/// Resolution of the least strength factor with equilibrium, and the smallest factor tried.
constexpr double resolution = 0.01, smallest_factor = 1.0 / 32;

/// Soil that softens in MPM has not done so at the start.
SolidOfCase<2> make_start_solid(const input::Case& data) {
  input::Case peak = data;
  peak.fem.softening = input::FemSoftening::none;
  for (auto& [name, soil] : peak.materials) soil.limit_strength = material::LimitStrength::peak;
  return make_solid_on<2>(peak, std::make_shared<const mesh::Mesh<2>>(mesh::generate<2>(peak.mesh)));
}

fem::SolidResult<2> balance(const SolidOfCase<2>& solid, const fem::SolidOptions& options, double factor) {
  throw_if_interrupted();
  return fem::find_equilibrium<2>(solid.model, options, factor);
}

/// Returns the equilibrium with the least increase of strength that has one; the strength is divided by `factor`.
fem::SolidResult<2> find_weakest(const SolidOfCase<2>& solid, const fem::SolidOptions& options, double& factor) {
  double fails = 1;
  factor = 1;
  while (factor >= smallest_factor) {
    fem::SolidResult<2> found = balance(solid, options, factor);
    if (!found.converged) {
      fails = factor;
      factor *= 0.5;
      continue;
    }
    while (factor < 1 && fails - factor > resolution) {
      const double middle = 0.5 * (factor + fails);
      fem::SolidResult<2> weaker = balance(solid, options, middle);
      if (weaker.converged)
        found = std::move(weaker), factor = middle;
      else
        fails = middle;
    }
    return found;
  }
  throw Error(ExitCode::wrong_input,
              fmt::format("[initial] stress = \"elements\": FEM does not converge even with the strength "
                          "multiplied by {:g}; check weights, supports and pore pressures",
                          1 / smallest_factor));
}

}  // namespace

fem::SolidOptions make_solid_options(const input::FiniteElements& settings, int threads) {
  fem::SolidOptions options;
  options.force_tolerance = settings.force_tolerance;
  options.displacement_tolerance = settings.displacement_tolerance;
  options.most_iterations = settings.iterations;
  options.load_steps = settings.load_steps;
  options.threads = threads;
  return options;
}

Balance find_balance(const input::Case& data, int threads) {
  const fem::SolidResult<2> found = balance(make_start_solid(data), make_solid_options(data.fem, threads), 1);
  return {found.converged, !found.converged && !found.flows};
}

std::shared_ptr<const input::KnownStress> find_start_stress(const input::Case& data, int threads,
                                                            results::StressStart& result) {
  const SolidOfCase<2> solid = make_start_solid(data);
  const fem::SolidResult<2> found = find_weakest(solid, make_solid_options(data.fem, threads), result.factor);
  const fem::QuadraticMesh<2> mesh = fem::make_quadratic<2>(*solid.mesh, fem::list_cuts(solid.model));
  auto known = std::make_shared<input::KnownStress>();
  known->mesh = *solid.mesh;
  known->elements.resize(known->mesh.elements.size());
  const std::size_t points = input::KnownStress::points, states = found.at.state.size() / mesh.points.size();
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    auto& element = known->elements[static_cast<std::size_t>(mesh.linear_element[k])];
    for (std::size_t q = 0; q < points; ++q) {
      element.stress[q] = found.at.stress[k * points + q];
      element.plastic_strain[q] = found.at.state[(k * points + q) * states];
    }
  }
  result.force_residual = found.force_residual;
  result.elements = static_cast<int>(mesh.elements.size());
  return known;
}

}  // namespace talus::run
