// SPDX-License-Identifier: MIT
#include "mesh/quality.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus::mesh {
namespace {

/// Returns ∇N_i·∇N_j for all nodes, which determines the shape of a simplex.
template <int D>
std::array<std::array<double, D + 1>, D + 1> compute_gradient_products(const std::array<double, D * D>& g) {
  std::array<std::array<double, D>, D + 1> n{};
  for (int k = 0; k < D; ++k)
    for (int d = 0; d < D; ++d) {
      n[k + 1][d] = g[k * D + d];
      n[0][d] -= g[k * D + d];
    }
  std::array<std::array<double, D + 1>, D + 1> products{};
  for (int i = 0; i <= D; ++i)
    for (int j = 0; j <= D; ++j)
      for (int d = 0; d < D; ++d) products[i][j] += n[i][d] * n[j][d];
  return products;
}

/// Returns the circumradius [m]: the centre c (from node 0) solves edge_k·c = |edge_k|²/2, and the gradients are the
/// dual basis of the edges, so c = Σ_k ∇ξ_k |edge_k|²/2.
template <int D>
double compute_circumradius(const Mesh<D>& mesh, int e) {
  std::array<double, D> centre{};
  const auto& element = mesh.elements[e];
  for (int k = 0; k < D; ++k) {
    double square = 0;
    for (int d = 0; d < D; ++d) {
      const double x = mesh.nodes[element[k + 1]][d] - mesh.nodes[element[0]][d];
      square += x * x;
    }
    for (int d = 0; d < D; ++d) centre[d] += mesh.gradients[e][k * D + d] * square / 2;
  }
  double square = 0;
  for (double c : centre) square += c * c;
  return std::sqrt(square);
}

}  // namespace

template <int D>
Quality<D> measure_quality(const Mesh<D>& mesh, bool soil_only) {
  Quality<D> quality;
  double sum = 0, volume = 0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (soil_only && mesh.element_region[e] == empty_region) continue;
    if (quality.worst_element < 0) {
      quality.min_altitude = mesh.altitudes[e];
      quality.min_angle = std::numbers::pi;
      quality.min_radius_ratio = 1;
    }
    const auto products = compute_gradient_products<D>(mesh.gradients[e]);
    double inverse_inradius = 0;  // Σ 1/altitude_i = 1/r
    for (int i = 0; i <= D; ++i) {
      inverse_inradius += std::sqrt(products[i][i]);
      for (int j = 0; j < i; ++j) {
        // The cosine of the angle between the sides opposite i and j is -∇N_i·∇N_j / (|∇N_i||∇N_j|).
        const double cosine = -products[i][j] / std::sqrt(products[i][i] * products[j][j]);
        quality.min_angle = std::min(quality.min_angle, std::acos(std::clamp(cosine, -1.0, 1.0)));
      }
    }
    quality.min_radius_ratio =
        std::min(quality.min_radius_ratio, D / (inverse_inradius * compute_circumradius(mesh, e)));
    ++quality.element_count;
    sum += mesh.altitudes[e];
    volume += mesh.volumes[e];
    if (quality.worst_element < 0 || mesh.altitudes[e] < quality.min_altitude) {
      quality.min_altitude = mesh.altitudes[e];
      quality.worst_element = e;
    }
  }
  if (quality.element_count > 0) {
    quality.mean_altitude = sum / quality.element_count;
    // A regular triangle of edge a has the area √3/4 a², a regular tetrahedron the volume a³/(6√2).
    const double mean = volume / quality.element_count;
    quality.mean_size = D == 2 ? std::sqrt(4 * mean / std::sqrt(3.0)) : std::cbrt(6 * std::sqrt(2.0) * mean);
    std::array<double, D> centroid;
    centroid.fill(1.0 / (D + 1));
    quality.worst_place = to_global(mesh, quality.worst_element, centroid);
  }
  return quality;
}

template Quality<2> measure_quality<2>(const Mesh<2>&, bool);
template Quality<3> measure_quality<3>(const Mesh<3>&, bool);

}  // namespace talus::mesh
