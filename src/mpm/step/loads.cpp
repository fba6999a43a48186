// SPDX-License-Identifier: MIT
// Nodal forces of the tractions on sides and on points, at the time of the body.

#include "mpm/step/loads.hpp"

#include "mpm/body/share.hpp"
#include "mpm/step/step.hpp"

namespace talus::mpm {
namespace {

/// Where points of this rank are, as they are wanted; those of other ranks are nowhere.
template <int D>
std::vector<PointPlace<D>> locate(const Body<D>& body, const std::vector<int>& wanted) {
  const Points<D>& points = body.points;
  std::vector<PointPlace<D>> places;
  for (const int point : wanted) {
    PointPlace<D>& at = places.emplace_back();
    at.element = points.element[point];
    if (at.element < 0) continue;
    const std::int64_t place = points.place[point];
    const double* p = points.slot(place / lane_width) + place % lane_width;
    for (int k = 0; k < D; ++k) at.xi[k] = p[(Points<D>::xi + k) * lane_width];
  }
  return places;
}

/// A point that carries a force.
template <int D>
struct Carrier {
  std::size_t entry = 0;  ///< of the load
  PointPlace<D> place;
};

/// The same for all points, whatever rank has them.
template <int D>
std::vector<PointPlace<D>> locate_on_ranks(const Body<D>& body, const std::vector<int>& wanted) {
  std::vector<PointPlace<D>> places = locate(body, wanted);
  if (!body.share) return places;
  std::vector<Carrier<D>> here;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i].element >= 0) here.push_back({i, places[i]});
  for (const Carrier<D>& c : join_lists(body, std::move(here))) places[c.entry] = c.place;
  return places;
}

}  // namespace

template <int D>
std::vector<Vec<D>> find_loads(const Body<D>& body, double time,
                               const std::function<std::vector<PointPlace<D>>(const std::vector<int>&)>& locate) {
  std::vector<Vec<D>> forces(body.mesh().nodes.size(), Vec<D>{});
  for (const Load<D>& load : body.conditions.loads) {
    const double factor = load.factor.at(time);
    if (!load.on_points) {
      for (const auto& entry : load.entries)
        for (int d = 0; d < D; ++d) forces[entry.index][d] += factor * entry.force[d];
      continue;
    }
    std::vector<int> points;
    for (const auto& entry : load.entries) points.push_back(entry.index);
    const std::vector<PointPlace<D>> places = locate(points);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (places[i].element < 0) continue;
      double shape[D + 1] = {1};
      for (int k = 0; k < D; ++k) {
        shape[k + 1] = places[i].xi[k];
        shape[0] -= shape[k + 1];
      }
      for (int k = 0; k <= D; ++k) {
        Vec<D>& f = forces[body.mesh().elements[places[i].element][k]];
        for (int d = 0; d < D; ++d) f[d] += factor * shape[k] * load.entries[i].force[d];
      }
    }
  }
  return forces;
}

template <int D>
void gather_loads(Body<D>& body) {
  // Those of the step of the mixture hold the water outside too: another step's would count it twice.
  body.nodes.load.clear();
  if (body.conditions.loads.empty()) return;
  body.nodes.load =
      find_loads<D>(body, body.time, [&body](const std::vector<int>& points) { return locate_on_ranks(body, points); });
}

template std::vector<Vec<2>> find_loads<2>(const Body<2>&, double,
                                           const std::function<std::vector<PointPlace<2>>(const std::vector<int>&)>&);
template std::vector<Vec<3>> find_loads<3>(const Body<3>&, double,
                                           const std::function<std::vector<PointPlace<3>>(const std::vector<int>&)>&);
template void gather_loads<2>(Body<2>&);
template void gather_loads<3>(Body<3>&);

}  // namespace talus::mpm
