// SPDX-License-Identifier: MIT
// Nodal forces of the tractions on sides and on points, at the time of the body.

#include <algorithm>

#include "mpm/body/share.hpp"
#include "mpm/step/step.hpp"

namespace talus::mpm {

namespace {

/// A point that carries a force: where it stands.
template <int D>
struct Carrier {
  std::size_t entry = 0;  ///< of the load
  int element = 0;
  double shape[D + 1];
};

/// The carriers of a load on points that are in the body, in the order of its entries, whatever rank has them.
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
  if (!body.share) return carriers;
  carriers = join_lists(body, std::move(carriers));
  std::sort(carriers.begin(), carriers.end(), [](const auto& a, const auto& b) { return a.entry < b.entry; });
  return carriers;
}

}  // namespace

template <int D>
void gather_loads(Body<D>& body) {
  // Those of the step of the mixture hold the water outside too: another step's would count it twice.
  body.nodes.load.clear();
  if (body.conditions.loads.empty()) return;
  body.nodes.load.assign(body.mesh().nodes.size(), Vec<D>{});
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
