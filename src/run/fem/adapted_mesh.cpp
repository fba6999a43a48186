// SPDX-License-Identifier: MIT
#include "run/fem/adapted_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/extrapolate.hpp"

namespace talus::run {

namespace {

/// Fraction of the error indicator in the elements that are refined, and the least with which refinement is worth a
/// search: the size (T19.17) falls by at least a third then.
constexpr double refined_work = 0.95, least_refined_work = 0.7;
/// Elements that the division of one adds: three, and some for conformity.
constexpr double added_elements = 3.3;
/// Orders of convergence that are computed: above the first the order is that of chance, and below nothing shows a
/// limit.
constexpr double least_order = 0.1, most_order = 1;

/// Returns the edge of the equilateral triangle of an area, √(4 A/√3).
double find_edge(double area) {
  return std::sqrt(4 * area / std::sqrt(3.0));
}

}  // namespace

std::vector<double> compute_shear_work(const fem::QuadraticMesh<2>& mesh, const fem::SolidState<2>& failure,
                                       const fem::SolidState<2>& motion) {
  const std::size_t elements = mesh.elements.size(), per = elements > 0 ? mesh.points.size() / elements : 0;
  std::vector<double> work(elements, 0.0);
  if (motion.strain.size() != mesh.points.size() || failure.stress.size() != mesh.points.size()) return work;
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    if (failure.yields[k] == 0) continue;
    const auto& s = failure.stress[k];
    const auto& e = motion.strain[k];
    const double mean = (s[0] + s[1] + s[2]) / 3;
    double rate = 0;
    for (std::size_t i = 0; i < 6; ++i) rate += (i < 3 ? s[i] - mean : s[i]) * e[i];
    work[k / per] += mesh.weights[k] * std::abs(rate);
  }
  return work;
}

double compute_shear_size(const mesh::Mesh<2>& mesh, const fem::QuadraticMesh<2>& quadratic,
                          const std::vector<double>& work) {
  double sum = 0, all = 0;
  for (std::size_t i = 0; i < work.size(); ++i) {
    sum += work[i] * find_edge(mesh.volumes[static_cast<std::size_t>(quadratic.linear_element[i])]);
    all += work[i];
  }
  return all > 0 ? sum / all : 0;
}

std::optional<std::vector<bool>> mark_shear(const mesh::Mesh<2>& mesh, const fem::QuadraticMesh<2>& quadratic,
                                            const std::vector<double>& work, std::size_t most) {
  std::vector<double> error;
  for (std::size_t i = 0; i < work.size(); ++i)
    error.push_back(work[i] * find_edge(mesh.volumes[static_cast<std::size_t>(quadratic.linear_element[i])]));
  std::vector<std::size_t> order(work.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return error[a] > error[b]; });
  const double all = std::accumulate(error.begin(), error.end(), 0.0);
  if (!(all > 0)) return std::nullopt;
  std::vector<bool> marked(mesh.elements.size(), false);
  auto free = static_cast<double>(most) - static_cast<double>(work.size());
  const auto add = [&](std::size_t e) {
    if (marked[e] || mesh.element_region[e] == mesh::empty_region || free < added_elements) return;
    marked[e] = true;
    free -= added_elements;
  };
  std::vector<std::size_t> band;
  double sum = 0;
  for (const std::size_t i : order) {
    if (sum >= refined_work * all || free < added_elements) break;
    sum += error[i];
    band.push_back(static_cast<std::size_t>(quadratic.linear_element[i]));
    add(band.back());
  }
  if (sum < least_refined_work * all) return std::nullopt;
  for (const std::size_t e : band)
    for (const int other : mesh.neighbours[e])
      if (other >= 0) add(static_cast<std::size_t>(other));
  return marked;
}

double compute_order(const std::vector<results::ElementMeshFactor>& meshes) {
  const auto &fine = meshes.back(), &coarse = meshes[meshes.size() - 2], &first = meshes[meshes.size() - 3];
  const double step = coarse.factor - fine.factor, before = first.factor - coarse.factor;
  if (step <= 0) return most_order;
  // (h_1^p − h_2^p)/(h_2^p − h_3^p) increases with p.
  const auto falls_faster = [&](double p) {
    return before * (std::pow(coarse.size, p) - std::pow(fine.size, p)) >=
           step * (std::pow(first.size, p) - std::pow(coarse.size, p));
  };
  double low = least_order, high = most_order;
  if (falls_faster(high)) return high;
  if (!falls_faster(low)) return low;
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (falls_faster(middle) ? low : high) = middle;
  }
  return low;
}

std::optional<results::ElementInterval> find_sequence_interval(const std::vector<results::ElementMeshFactor>& meshes,
                                                               const LeastMeshError& least, double safety) {
  const auto &fine = meshes.back(), &coarse = meshes[meshes.size() - 2];
  auto interval = find_mesh_interval(coarse, fine, least);
  if (!interval || meshes.size() < 3) return interval;
  const auto& first = meshes[meshes.size() - 3];
  const double rest = 1 / (std::pow(coarse.size / fine.size, compute_order(meshes)) - 1),
               step = std::max(0.0, coarse.factor - fine.factor),
               fall = rest * (*coarse.flowing - fine.stable + (safety - 1) * step),
               // The difference before, with the first order: it limits agreement of the last two by chance.
      earlier = safety * (first.factor - coarse.factor) * find_rest(first.size, coarse.size) * fine.size / coarse.size;
  interval->lower = std::max(0.0, fine.stable - std::max({fall, earlier, least.below * fine.factor}));
  return interval;
}

}  // namespace talus::run
