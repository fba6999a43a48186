// SPDX-License-Identifier: MIT
// Nodal forces (2.37) of tractions on sides and on points, at body.time, and of bars.
#include "mpm/state/body.hpp"

#include <algorithm>

#include "mpm/state/partition.hpp"

namespace talus::mpm {

namespace {

/// Position of a point that carries a force.
template <int D>
struct Carrier {
  std::size_t entry = 0;  ///< index in the load
  int element = 0;
  double shape[D + 1];
};

/// The carriers of a load whose points are on the grid, gathered from all ranks, in the order of the load's entries.
template <int D>
std::vector<Carrier<D>> find_carriers(const Body<D>& body, const Load<D>& load) {
  const Points<D>& points = body.points;
  std::vector<Carrier<D>> carriers;
  for (std::size_t i = 0; i < load.entries.size(); ++i) {
    const int point = load.entries[i].index;
    Carrier<D> c{i, points.element[point], {}};
    if (c.element < 0) continue;
    const std::int64_t place = points.place[point];
    const double* p = points.slot(place / lane_width) + place % lane_width;
    c.shape[0] = 1;
    for (int k = 0; k < D; ++k) {
      c.shape[k + 1] = p[(Points<D>::xi + k) * lane_width];
      c.shape[0] -= c.shape[k + 1];
    }
    carriers.push_back(c);
  }
  if (!body.partition) return carriers;
  carriers = join_lists(body, std::move(carriers));
  std::sort(carriers.begin(), carriers.end(), [](const auto& a, const auto& b) { return a.entry < b.entry; });
  return carriers;
}

}  // namespace

template <int D>
void gather_loads(Body<D>& body) {
  // nodes.load of the Darcy step includes the pressure of outside water, which another step would count twice.
  body.nodes.load.clear();
  if (body.conditions.loads.empty() && body.bars.empty()) return;
  body.nodes.load.assign(body.mesh().nodes.size(), Vec<D>{});
  if constexpr (D == 2) add_bar_forces(body);
  for (const Load<D>& load : body.conditions.loads) {
    const double factor = load.factor.at(body.time);
    if (!load.on_points) {
      for (const auto& entry : load.entries)
        for (int d = 0; d < D; ++d) body.nodes.load[entry.index][d] += factor * entry.force[d];
      continue;
    }
    for (const Carrier<D>& c : find_carriers(body, load))
      for (int k = 0; k <= D; ++k) {
        Vec<D>& f = body.nodes.load[body.mesh().elements[c.element][k]];
        for (int d = 0; d < D; ++d) f[d] += factor * c.shape[k] * load.entries[c.entry].force[d];
      }
  }
}

template void gather_loads<2>(Body<2>&);
template void gather_loads<3>(Body<3>&);

}  // namespace talus::mpm
