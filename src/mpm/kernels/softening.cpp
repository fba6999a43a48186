// SPDX-License-Identifier: MIT
// Nonlocal averaging of softening (theory 23): search of neighbours, weights, and the correction of each element.
#include "mpm/kernels/softening.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "mpm/state/partition.hpp"

namespace talus::mpm {
namespace {

/// Cut-off of the weight r exp(-r²) of (T23.1), in nonlocal lengths; the weight there is a twelfth of its maximum.
constexpr double farthest = 2;

/// Element centroids in cells of the cut-off's width: neighbours are in the same or in an adjacent cell.
template <int D>
class MiddleGrid {
 public:
  MiddleGrid(const mesh::Mesh<D>& mesh, double width) : width_(width), middles_(mesh.elements.size()) {
    for (std::size_t e = 0; e < middles_.size(); ++e) {
      for (const int node : mesh.elements[e])
        for (int d = 0; d < D; ++d) middles_[e][d] += mesh.nodes[static_cast<std::size_t>(node)][d] / (D + 1);
      cells_[find_cell(middles_[e])].push_back(static_cast<int>(e));
    }
  }
  /// Calls work(element, distance) for the elements whose centroid is closer than the width [m], in the order of their
  /// numbers.
  void visit(int e, auto&& work) const {
    std::vector<int> near;
    add_cells(find_cell(middles_[static_cast<std::size_t>(e)]), 0, near);
    std::sort(near.begin(), near.end());
    for (const int other : near) {
      Vec<D> between = middles_[static_cast<std::size_t>(other)];
      for (int d = 0; d < D; ++d) between[d] -= middles_[static_cast<std::size_t>(e)][d];
      if (const double distance = norm(between); distance < width_) work(other, distance);
    }
  }

 private:
  using Cell = std::array<long, D>;

  Cell find_cell(const Vec<D>& x) const {
    Cell cell;
    for (std::size_t d = 0; d < D; ++d) cell[d] = std::lround(std::floor(x[d] / width_));
    return cell;
  }
  void add_cells(Cell cell, std::size_t d, std::vector<int>& near) const {
    if (d == D) {
      if (const auto found = cells_.find(cell); found != cells_.end())
        near.insert(near.end(), found->second.begin(), found->second.end());
      return;
    }
    const long middle = cell[d];
    for (cell[d] = middle - 1; cell[d] <= middle + 1; ++cell[d]) add_cells(cell, d + 1, near);
  }

  double width_;
  std::vector<Vec<D>> middles_;
  std::map<Cell, std::vector<int>> cells_;
};

/// Halo exchange: softened and softening_volume of the elements of other ranks within reach of this rank's elements.
template <int D>
void update_reach(Body<D>& body) {
  if (body.partition)
    body.partition->reach->update({as_halo(body.elements.softened), as_halo(body.elements.softening_volume)});
}

}  // namespace

template <int D>
SofteningReach find_softening_reach(const mesh::Mesh<D>& mesh, double length) {
  const MiddleGrid<D> grid(mesh, farthest * length);
  SofteningReach reach;
  reach.start.push_back(0);
  for (int e = 0; e < mesh.element_count(); ++e) {
    grid.visit(e, [&](int other, double distance) {
      const double r = distance / length;
      if (other == e) return;
      reach.element.push_back(other);
      reach.weight.push_back(r * std::exp(-r * r));
    });
    reach.start.push_back(static_cast<std::int64_t>(reach.element.size()));
  }
  return reach;
}

template <int D>
void set_softening_length(Body<D>& body, double length) {
  body.softening_reach = std::make_shared<SofteningReach>(find_softening_reach(body.mesh(), length));
  Elements<D>& elements = body.elements;
  for (auto* field : {&elements.softened, &elements.softening_volume, &elements.nonlocal_correction})
    field->assign(elements.fill_limit.size(), 0.0);
}

template <int D>
void average_softening(Body<D>& body, int threads) {
  const SofteningReach& reach = *body.softening_reach;
  Elements<D>& elements = body.elements;
  const Layout<D>& layout = *body.layout;
  const auto for_elements = [&](auto&& work) {
    for_chunks(body, threads, [&](int c) {
      const int end =
          std::min(layout.chunk_start[static_cast<std::size_t>(c) + 1] * lane_width, body.mesh().element_count());
      for (int e = layout.chunk_start[static_cast<std::size_t>(c)] * lane_width; e < end; ++e)
        work(static_cast<std::size_t>(e));
    });
  };
  update_reach(body);
  for_elements([&](std::size_t e) { elements.nonlocal_correction[e] = find_nonlocal_correction(reach, elements, e); });
  for_elements([&](std::size_t e) { elements.softened[e] = elements.softening_volume[e] = 0; });
}

#define TALUS_INSTANTIATE(D)                                                     \
  template SofteningReach find_softening_reach<D>(const mesh::Mesh<D>&, double); \
  template void set_softening_length<D>(Body<D>&, double);                       \
  template void average_softening<D>(Body<D>&, int);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::mpm
