// SPDX-License-Identifier: MIT
// What every element needs once: orientation, volume, gradients of its local coordinates, smallest altitude.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "mesh/mesh.hpp"
#include "mesh/neighbours.hpp"
#include "mesh/renumber.hpp"

namespace talus::mesh {
namespace {

/// An element whose volume is below this fraction of (longest edge)^D is taken as flat: its altitude is then below
/// about 1e-10 of its edges, where coordinates of 16 digits no longer tell its orientation.
constexpr double flat_fraction = 1e-10;

/// edges[k*D+d] = (x_{k+1} - x_0)_d [m]
template <int D>
std::array<double, D * D> compute_edges(const Mesh<D>& mesh, const typename Mesh<D>::Element& element) {
  std::array<double, D * D> edges;
  for (int k = 0; k < D; ++k)
    for (int d = 0; d < D; ++d) edges[k * D + d] = mesh.nodes[element[k + 1]][d] - mesh.nodes[element[0]][d];
  return edges;
}

template <int D>
double compute_determinant(const std::array<double, D * D>& m) {
  if constexpr (D == 2)
    return m[0] * m[3] - m[1] * m[2];
  else
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
}

/// ∂ξ_k/∂x_d: x - x_0 = Σ_k ξ_k edge_k, so the gradients are the columns of the inverse of the edge matrix.
template <int D>
std::array<double, D * D> compute_gradients(const std::array<double, D * D>& m, double det) {
  if constexpr (D == 2) {
    return {m[3] / det, -m[2] / det, -m[1] / det, m[0] / det};
  } else {
    std::array<double, 9> g;
    for (int k = 0; k < 3; ++k) {
      const double* a = &m[3 * ((k + 1) % 3)];
      const double* b = &m[3 * ((k + 2) % 3)];
      for (int d = 0; d < 3; ++d)
        g[3 * k + d] = (a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3]) / det;
    }
    return g;
  }
}

/// The altitude over the side opposite node k is 1/|∇N_k|; N_0 = 1 - Σ ξ_k.
template <int D>
double compute_altitude(const std::array<double, D * D>& gradients) {
  std::array<double, D> first{};
  double steepest = 0;
  for (int k = 0; k < D; ++k) {
    double square = 0;
    for (int d = 0; d < D; ++d) {
      first[d] -= gradients[k * D + d];
      square += gradients[k * D + d] * gradients[k * D + d];
    }
    steepest = std::max(steepest, square);
  }
  double square = 0;
  for (double g : first) square += g * g;
  return 1 / std::sqrt(std::max(steepest, square));
}

template <int D>
double compute_longest_edge(const Mesh<D>& mesh, const typename Mesh<D>::Element& element) {
  double longest = 0;
  for (int i = 0; i <= D; ++i)
    for (int j = 0; j < i; ++j) {
      double square = 0;
      for (int d = 0; d < D; ++d) {
        const double x = mesh.nodes[element[i]][d] - mesh.nodes[element[j]][d];
        square += x * x;
      }
      longest = std::max(longest, square);
    }
  return std::sqrt(longest);
}

template <int D>
[[noreturn]] void fail_flat(const Mesh<D>& mesh, int e) {
  std::string place;
  for (double x : mesh.nodes[mesh.elements[e][0]]) place += fmt::format("{}{:.9g}", place.empty() ? "" : ", ", x);
  throw Error(ExitCode::wrong_input, fmt::format("element {} of the mesh has no {}: its first node lies at ({})", e + 1,
                                                 D == 2 ? "area" : "volume", place));
}

/// Positive orientation for every element.
template <int D>
void orient(Mesh<D>& mesh) {
  for (int e = 0; e < mesh.element_count(); ++e) {
    auto& element = mesh.elements[e];
    const double det = compute_determinant<D>(compute_edges(mesh, element));
    if (!(std::abs(det) > flat_fraction * std::pow(compute_longest_edge(mesh, element), D))) fail_flat(mesh, e);
    if (det < 0) std::swap(element[D - 1], element[D]);
  }
}

/// The arrays of the mesh fit each other and every node number exists.
template <int D>
void check_numbers(const Mesh<D>& mesh) {
  const auto check = [&](int node) {
    if (node < 0 || node >= mesh.node_count())
      throw Error(ExitCode::wrong_input,
                  fmt::format("the mesh refers to node {}, but it has {} nodes", node, mesh.node_count()));
  };
  if (mesh.elements.empty()) throw Error(ExitCode::wrong_input, "the mesh has no elements");
  if (mesh.element_region.size() != mesh.elements.size())
    throw Error(ExitCode::wrong_input, fmt::format("the mesh has {} elements but {} region numbers",
                                                   mesh.elements.size(), mesh.element_region.size()));
  for (const auto& element : mesh.elements) std::for_each(element.begin(), element.end(), check);
  for (const auto& [name, sides] : mesh.sides)
    for (const auto& side : sides) std::for_each(side.begin(), side.end(), check);
}

}  // namespace

template <int D>
void finish(Mesh<D>& mesh, Order order) {
  check_numbers(mesh);
  orient(mesh);
  if (order == Order::space_filling) renumber(mesh);
  mesh.neighbours = find_neighbours(mesh);
  const std::size_t count = mesh.elements.size();
  mesh.volumes.resize(count);
  mesh.gradients.resize(count);
  mesh.altitudes.resize(count);
  for (std::size_t e = 0; e < count; ++e) {
    const auto edges = compute_edges(mesh, mesh.elements[e]);
    const double det = compute_determinant<D>(edges);
    mesh.volumes[e] = det / (D == 2 ? 2 : 6);
    mesh.gradients[e] = compute_gradients<D>(edges, det);
    mesh.altitudes[e] = compute_altitude<D>(mesh.gradients[e]);
  }
}

template <int D>
std::array<double, D> to_global(const Mesh<D>& mesh, int e, const typename Mesh<D>::Point& xi) {
  return find_place(mesh, e, xi);
}

template <int D>
std::array<double, D> to_local(const Mesh<D>& mesh, int e, const typename Mesh<D>::Point& x) {
  return find_local(mesh, e, x);
}

template void finish<2>(Mesh<2>&, Order);
template void finish<3>(Mesh<3>&, Order);
template std::array<double, 2> to_global<2>(const Mesh<2>&, int, const std::array<double, 2>&);
template std::array<double, 3> to_global<3>(const Mesh<3>&, int, const std::array<double, 3>&);
template std::array<double, 2> to_local<2>(const Mesh<2>&, int, const std::array<double, 2>&);
template std::array<double, 3> to_local<3>(const Mesh<3>&, int, const std::array<double, 3>&);

template <int D>
Mesh<D>::Mesh() = default;
template <int D>
Mesh<D>::Mesh(const Mesh&) = default;
template <int D>
Mesh<D>::Mesh(Mesh&&) noexcept = default;
template <int D>
Mesh<D>& Mesh<D>::operator=(const Mesh&) = default;
template <int D>
Mesh<D>& Mesh<D>::operator=(Mesh&&) noexcept = default;
template <int D>
Mesh<D>::~Mesh() = default;
template struct Mesh<2>;
template struct Mesh<3>;

}  // namespace talus::mesh
