// SPDX-License-Identifier: MIT
// Nodal forces of weight and of tractions on sides; the integrals are exact.

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "fem/solid/system.hpp"

namespace talus::fem {
namespace {

/// Shares of a weight or a uniform traction: corners and middles of a triangle or tetrahedron.
template <int D>
inline constexpr double corner_share = D == 2 ? 0.0 : -1.0 / 20;
template <int D>
inline constexpr double middle_share = D == 2 ? 1.0 / 3 : 1.0 / 5;

double find_size(const mesh::Mesh<2>& mesh, const std::array<int, 2>& side) {
  const auto &a = mesh.nodes[static_cast<std::size_t>(side[0])], &b = mesh.nodes[static_cast<std::size_t>(side[1])];
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}
double find_size(const mesh::Mesh<3>& mesh, const std::array<int, 3>& side) {
  const auto &a = mesh.nodes[static_cast<std::size_t>(side[0])], &b = mesh.nodes[static_cast<std::size_t>(side[1])],
             &c = mesh.nodes[static_cast<std::size_t>(side[2])];
  const Vec<3> p{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, q{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return norm(Vec<3>{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]}) / 2;
}

/// ∫N_i L_j over a side of size 1, i over its corners and middles, j over its corners.
template <int D>
double find_side_weight(std::size_t i, std::size_t j) {
  if constexpr (D == 2) {
    if (i == 2) return 1.0 / 3;
    return i == j ? 1.0 / 6 : 0;
  } else {
    if (i < 3) return i == j ? 1.0 / 30 : -1.0 / 60;
    const std::size_t a = i - 3, b = (i - 2) % 3;  // the edge's corners
    return j == a || j == b ? 2.0 / 15 : 1.0 / 15;
  }
}

}  // namespace

template <int D>
std::vector<Vec<D>> find_loads(const SolidModel<D>& model, const QuadraticMesh<D>& mesh) {
  using Q = Quadratic<D>;
  std::vector<Vec<D>> f(mesh.nodes.size(), Vec<D>{});
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    const double weight =
        model.unit_weight[static_cast<std::size_t>(mesh.linear_element[k])] * Q::points * mesh.weights[k * Q::points];
    for (std::size_t i = 0; i < Q::nodes; ++i) {
      const double share = i < Q::corners ? corner_share<D> : middle_share<D>;
      auto& at = f[static_cast<std::size_t>(mesh.elements[k][i])];
      for (std::size_t d = 0; d < D; ++d) at[d] += weight * share * model.direction[d];
    }
  }
  const EdgeMiddles<D> middles(mesh);
  for (const SurfaceLoad<D>& load : model.loads) {
    for (std::size_t s = 0; s < load.sides.size(); ++s) {
      const auto nodes = middles.find_side(load.sides[s]);
      if (nodes.empty())
        throw Error(ExitCode::wrong_input,
                    fmt::format("the load '{}' acts on a side at ({:.4g}) m, where there is no soil", load.name,
                                fmt::join(model.mesh->nodes[static_cast<std::size_t>(load.sides[s][0])], ", ")));
      const double size = find_size(*model.mesh, load.sides[s]);
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t j = 0; j < D; ++j)
          for (std::size_t d = 0; d < D; ++d)
            f[static_cast<std::size_t>(nodes[i])][d] += size * find_side_weight<D>(i, j) * load.traction[s][j][d];
    }
  }
  return f;
}

template std::vector<Vec<2>> find_loads<2>(const SolidModel<2>&, const QuadraticMesh<2>&);
template std::vector<Vec<3>> find_loads<3>(const SolidModel<3>&, const QuadraticMesh<3>&);

}  // namespace talus::fem
