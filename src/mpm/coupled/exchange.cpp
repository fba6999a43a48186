// SPDX-License-Identifier: MIT
// Exchange of water between neighbouring elements that removes pressures which no node feels (T14.9).

#include <algorithm>
#include <cmath>

#include "mesh/shape_gradient.hpp"
#include "mpm/body/share.hpp"
#include "mpm/coupled/coupled_step.hpp"
#include "mpm/coupled/kernels.hpp"
#include "mpm/step/element_force.hpp"

namespace talus::mpm {
namespace {

/// A side moves at most this share of the smaller storage in one exchange, which keeps it stable. The storage is that
/// of saturated soil: an element that fills in an exchange must not be hit by water that it could take when it was
/// drier.
constexpr double exchange_share = 0.05;

/// What a full wet element brings to an exchange.
template <int D>
struct ExchangeElement {
  Vec<D> centre{};        ///< [m]
  double pressure = 0;    ///< [Pa]
  double resistance = 0;  ///< ρ_w g/k [N s/m⁴]
  double storage = 0;     ///< of its water alone, Σ m_w/(ρ_w K_w) [m³/Pa]
};

template <int D>
bool takes_part(const Body<D>& body, int e) {
  return e >= 0 && body.points.count[e] > 0 && body.water.volume[e] > full_share * body.mesh().volumes[e];
}

template <int D>
ExchangeElement<D> read_element(const Body<D>& body, int e, double storage) {
  const Water<D>& water = body.water;
  ExchangeElement<D> r{{}, water.mean_pressure[e], water.mean_resistance[e], storage};
  for (int i : body.mesh().elements[e]) {
    for (int d = 0; d < D; ++d) r.centre[d] += body.mesh().nodes[i][d] / (D + 1);
  }
  return r;
}

/// Volume of water [m³] that passes from `e` to its neighbour across the side opposite local node `k` until the next
/// exchange.
template <int D>
double find_exchange(const Body<D>& body, const StepOptions<D>& o, int e, int k, const ExchangeElement<D>& from,
                     const ExchangeElement<D>& to) {
  const double density = body.water.density, dt = exchange_interval * o.dt;
  const mesh::Mesh<D>& mesh = body.mesh();
  Vec<D> middle{}, flux{};
  for (int i = 0; i <= D; ++i) {
    if (i == k) continue;
    const int node = mesh.elements[e][i];
    for (int d = 0; d < D; ++d) {
      middle[d] += mesh.nodes[node][d] / D;
      flux[d] += body.water.still_flux[node][d] / D;
    }
  }
  // Growth of the pressure from one middle to the other beyond that at rest, and what Darcy's law explains of it.
  double growth = to.pressure - from.pressure, explained = 0, first2 = 0, second2 = 0;
  for (int d = 0; d < D; ++d) {
    const double first = middle[d] - from.centre[d], second = to.centre[d] - middle[d];
    growth += density * o.gravity[d] * (first + second);
    explained += flux[d] * (from.resistance * first + to.resistance * second);
    first2 += first * first;
    second2 += second * second;
  }
  const double area = D * mesh.volumes[e] * norm(mesh::find_shape_gradient(mesh, e, k));
  const double conductance = area / (from.resistance * std::sqrt(first2) + to.resistance * std::sqrt(second2));
  const double most = exchange_share * std::min(from.storage, to.storage);
  // Only down the head, and not more than there is: at a boundary layer that the mesh does not resolve the nodes'
  // fluxes explain too much.
  const double rest = growth - explained;
  if (rest * growth <= 0) return 0;
  return std::min(conductance * dt, most) * (std::abs(rest) < std::abs(growth) ? rest : growth);
}

}  // namespace

template <int D>
void exchange_water(Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  const mesh::Mesh<D>& mesh = body.mesh();
  const Layout<D>& layout = *body.layout;
  const double compressibility = 1 / (water.density * water.bulk_modulus);
  std::vector<double> storage(mesh.elements.size());
  for_chunks(body, o.threads, [&](int c) {
    const int end = std::min(layout.chunk_start[c + 1] * lane_width, mesh.element_count());
    for (int e = layout.chunk_start[c] * lane_width; e < end; ++e)
      storage[e] =
          compressibility * water.moments[static_cast<std::size_t>(e / lane_width) * moment_size<D> * lane_width +
                                          static_cast<std::size_t>(e % lane_width)];
  });
  update_elements(body, storage, water.mean_pressure, water.mean_resistance, water.volume);
  if (!o.smooth_pressure) std::fill(water.surplus.begin(), water.surplus.end(), 0.0);
  // Each element looks at all its sides itself, so that a side gives both of its elements the same, in any order.
  for_chunks(body, o.threads, [&](int c) {
    const int end = std::min(layout.chunk_start[c + 1] * lane_width, mesh.element_count());
    for (int e = layout.chunk_start[c] * lane_width; e < end; ++e) {
      if (!takes_part(body, e)) continue;
      const ExchangeElement<D> mine = read_element(body, e, storage[e]);
      double lost = 0;
      for (int k = 0; k <= D; ++k) {
        const int n = mesh.neighbours[e][k];
        if (!takes_part(body, n)) continue;
        lost += find_exchange(body, o, e, k, mine, read_element(body, n, storage[n]));
      }
      water.surplus[e] += lost / water.volume[e];
    }
  });
}

template void exchange_water<2>(Body<2>&, const StepOptions<2>&);
template void exchange_water<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
