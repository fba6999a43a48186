// SPDX-License-Identifier: MIT
#include "run/fem/tell_elements.hpp"

#include <algorithm>
#include <cmath>

#include "base/extrapolate.hpp"
#include "run/round_to.hpp"

namespace talus::run {
namespace {

/// Safety factor of the grid convergence index for two grids (Roache 1994): error of the fine mesh over what the
/// extrapolation takes from it. Holds the limit for orders of convergence of 0.42 and more.
constexpr double spread = 3;

/// Displacements and strains of the fields are kept to so many digits after the point: micrometres and 1e-6.
constexpr double field_digits = 1e6;

}  // namespace

double find_shear_strain(const std::array<double, 6>& e) {
  const double mean = (e[0] + e[1] + e[2]) / 3;
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i) squares += (e[i] - mean) * (e[i] - mean);
  for (std::size_t i = 3; i < 6; ++i) squares += 0.5 * e[i] * e[i];
  return std::sqrt(2.0 / 3 * squares);
}

std::array<double, 2> find_dilatancy(const input::Case& data, bool associated) {
  double low = 1e9, high = -1e9;
  for (const auto& [region, name] : data.regions) {
    const input::Material& m = data.materials.at(name);
    if (m.traits().strength == material::Strength::none) continue;
    const double psi = associated ? m.friction_angle : m.dilatancy_angle;
    low = std::min(low, psi);
    high = std::max(high, psi);
  }
  return low <= high ? std::array{low, high} : std::array{0.0, 0.0};
}

results::ElementTrial make_trial_result(const fem::ReductionTrial& t) {
  return {t.factor, t.converged, t.iterations, t.force_residual, t.displacement_residual, t.displacement, t.seconds};
}

template <int D>
results::ElementMeshFactor make_mesh_factor_result(const fem::ReductionResult<D>& found, double size) {
  return {size, found.factor, found.stable, found.failed,
          found.flowing > 0 ? std::optional(found.flowing) : std::nullopt};
}

std::optional<results::ElementInterval> find_mesh_interval(const results::ElementMeshFactor& coarse,
                                                           const results::ElementMeshFactor& fine,
                                                           const LeastMeshError& least) {
  if (!coarse.flowing || !fine.flowing) return std::nullopt;
  // The difference of the meshes is known to the brackets of both searches, and passed on as the extrapolation does.
  const double rest = find_rest(coarse.size, fine.size), difference = std::max(0.0, coarse.factor - fine.factor),
               fall = rest * (*coarse.flowing - fine.stable + (spread - 1) * difference),
               rise = rest * (*fine.flowing - coarse.stable);
  return results::ElementInterval{fine.stable - std::max(fall, least.below * fine.factor),
                                  *fine.flowing + std::max(rise, least.above * fine.factor)};
}

template <int D>
results::ElementMesh make_mesh_result(const fem::QuadraticMesh<D>& mesh) {
  results::ElementMesh result;
  for (const auto& x : mesh.nodes) {
    std::vector<double>& row = result.nodes.emplace_back();
    for (const double c : x) row.push_back(round_to(c, field_digits));
  }
  for (const auto& e : mesh.elements) result.elements.emplace_back(e.begin(), e.end());
  return result;
}

template <int D>
results::ElementFields make_fields_result(const fem::QuadraticMesh<D>& mesh, const fem::SolidState<D>& state,
                                   results::Flow flow) {
  const std::size_t elements = mesh.elements.size(), per = elements > 0 ? mesh.points.size() / elements : 0;
  std::vector<double> strain(mesh.nodes.size(), 0.0), volume(mesh.nodes.size(), 0.0);
  results::ElementFields fields;
  fields.flow = flow;
  for (std::size_t e = 0; e < elements; ++e) {
    double sum = 0, weight = 0;
    std::size_t plastic = 0;
    for (std::size_t k = e * per; k < (e + 1) * per; ++k) {
      sum += mesh.weights[k] * find_shear_strain(state.strain[k]);
      weight += mesh.weights[k];
      plastic += state.yields[k] != 0 ? 1 : 0;
    }
    for (const int i : mesh.elements[e]) {
      strain[i] += sum;
      volume[i] += weight;
    }
    fields.yields.push_back(2 * plastic > per ? 1 : 0);
  }
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    fields.shear_strain.push_back(volume[i] > 0 ? round_to(strain[i] / volume[i], field_digits) : 0);
    std::vector<double>& u = fields.displacement.emplace_back();
    for (const double c : state.displacement[i]) u.push_back(round_to(c, field_digits));
  }
  return fields;
}

template results::ElementMeshFactor make_mesh_factor_result<2>(const fem::ReductionResult<2>&, double);
template results::ElementMeshFactor make_mesh_factor_result<3>(const fem::ReductionResult<3>&, double);
template results::ElementMesh make_mesh_result<2>(const fem::QuadraticMesh<2>&);
template results::ElementMesh make_mesh_result<3>(const fem::QuadraticMesh<3>&);
template results::ElementFields make_fields_result<2>(const fem::QuadraticMesh<2>&, const fem::SolidState<2>&, results::Flow);
template results::ElementFields make_fields_result<3>(const fem::QuadraticMesh<3>&, const fem::SolidState<3>&, results::Flow);

}  // namespace talus::run
