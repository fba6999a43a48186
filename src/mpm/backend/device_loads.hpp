// SPDX-License-Identifier: MIT
#pragma once
// Tractions as nodal forces on a device, from loads on nodes and loads on points. Grid: TimedGrid of a HostGrid or a
// CudaGrid.

#include "mpm/backend/device.hpp"
#include "mpm/backend/device_array.hpp"

namespace talus::mpm::device {

/// Distributes the load of a point over the nodes of its element, for a later sort of the loads by element.
template <int D>
struct ShareCarried {
  ThreadBody<D> body;
  View<const DeviceLoad<D>> loads;
  View<const double> factors;
  View<unsigned> element;  ///< the number of elements if the point has left the grid
  View<int> order;
  View<std::array<Vec<D>, D + 1>> shares;

  TALUS_PORTABLE void operator()(int n) const {
    const auto i = static_cast<std::size_t>(n);
    const auto id = static_cast<std::size_t>(loads[i].index);
    const int e = body.points.element[id];
    order[i] = n;
    element[i] = static_cast<unsigned>(e >= 0 ? e : body.element_count);
    if (e < 0) return;
    const std::int64_t at = body.points.place[id];
    const double* p = body.points.slot(at / device_width) + at % device_width;
    double shape[D + 1] = {1};
    for (int k = 0; k < D; ++k) {
      shape[k + 1] = p[(PointFields<D>::xi + k) * device_width];
      shape[0] -= shape[k + 1];
    }
    const double factor = factors[static_cast<std::size_t>(loads[i].load)];
    for (int k = 0; k <= D; ++k)
      for (int d = 0; d < D; ++d) shares[i][static_cast<std::size_t>(k)][d] = factor * shape[k] * loads[i].force[d];
  }
};

/// Sum of the tractions at a node.
template <int D>
struct SumTractions {
  ThreadBody<D> body;
  View<const int> start;  ///< start of the node's own entries in `loads`
  View<const DeviceLoad<D>> loads;
  View<const double> factors;
  View<const unsigned> element;  ///< of the loads on points, sorted
  View<const int> order;
  View<const std::array<Vec<D>, D + 1>> shares;
  View<Vec<D>> sums;

  TALUS_PORTABLE void operator()(int i) const {
    Vec<D> sum{};
    for (int n = start[i]; n < start[i + 1]; ++n) {
      const DeviceLoad<D>& own = loads[static_cast<std::size_t>(n)];
      for (int d = 0; d < D; ++d) sum[d] += factors[static_cast<std::size_t>(own.load)] * own.force[d];
    }
    for (int r = body.layout->row_start[i]; r < body.layout->row_start[i + 1] && !element.empty(); ++r) {
      const int row = body.layout->node_rows[r];
      const auto e = static_cast<unsigned>(row / (D + 1));
      for (std::size_t n = find_first(e); n < element.size() && element[n] == e; ++n) {
        const Vec<D>& share = shares[static_cast<std::size_t>(order[n])][static_cast<std::size_t>(row % (D + 1))];
        for (int d = 0; d < D; ++d) sum[d] += share[d];
      }
    }
    sums[static_cast<std::size_t>(i)] = sum;
  }

 private:
  /// The first load in element `e` or a later one (binary search).
  TALUS_PORTABLE std::size_t find_first(unsigned e) const {
    std::size_t begin = 0, end = element.size();
    while (begin < end) {
      const std::size_t middle = (begin + end) / 2;
      if (element[middle] < e)
        begin = middle + 1;
      else
        end = middle;
    }
    return begin;
  }
};

template <class Grid, int D>
class DeviceLoads {
 public:
  explicit DeviceLoads(Grid& grid) : grid_(grid) {}

  void take(const DeviceImage<D>& image) {
    start_.upload(image.load_start);
    on_nodes_.upload(image.node_loads);
    on_points_.upload(image.point_loads);
    const std::size_t carried = image.point_loads.size();
    element_.resize(carried);
    sorted_.resize(carried);
    order_.resize(carried);
    shares_.resize(carried);
    sums_.resize(image.load_start.empty() ? 0 : image.mesh.nodes.size());
    last_.clear();
  }

  /// Nodal forces; empty: there are no tractions. `factors`: current factors of the loads.
  View<const Vec<D>> find(const ThreadBody<D>& body, const std::vector<double>& factors) {
    if (sums_.size() == 0 || (on_points_.size() == 0 && factors == last_)) return sums_.read();
    last_ = factors;
    factors_.upload(factors);
    const int carried = static_cast<int>(on_points_.size());
    if (carried > 0) {
      grid_.launch(carried, ShareCarried<D>{body, on_points_.read(), factors_.read(), element_.view(), order_.view(),
                                            shares_.view()});
      grid_.sort(element_.view().start, sorted_.view().start, order_.view().start, carried);
    }
    grid_.launch(body.node_count, SumTractions<D>{body, start_.read(), on_nodes_.read(), factors_.read(),
                                                  sorted_.read(), order_.read(), shares_.read(), sums_.view()});
    return sums_.read();
  }

 private:
  template <class T>
  using Array = DeviceArray<Grid, T>;

  Grid& grid_;
  std::vector<double> last_;  ///< factors
  Array<int> start_, order_;
  Array<DeviceLoad<D>> on_nodes_, on_points_;
  Array<double> factors_;
  Array<unsigned> element_, sorted_;
  Array<std::array<Vec<D>, D + 1>> shares_;
  Array<Vec<D>> sums_;
};

}  // namespace talus::mpm::device
