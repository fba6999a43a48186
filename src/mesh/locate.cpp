// SPDX-License-Identifier: MIT
#include "mesh/locate.hpp"

namespace talus::mesh {
namespace {

/// The local node whose shape function is lowest at `x`, and that value.
template <int D>
struct Lowest {
  int node = 0;
  double value = 1;
};

template <int D>
Lowest<D> find_lowest(const Mesh<D>& mesh, int e, const typename Mesh<D>::Point& x) {
  const auto xi = to_local(mesh, e, x);
  Lowest<D> lowest;
  for (double value : xi) lowest.value -= value;
  for (int k = 0; k < D; ++k)
    if (xi[k] < lowest.value) lowest = {k + 1, xi[k]};
  return lowest;
}

}  // namespace

template <int D>
int find_element(const Mesh<D>& mesh, const typename Mesh<D>::Point& x, int start) {
  const int count = mesh.element_count();
  int e = start >= 0 && start < count ? start : 0;
  for (int step = 0; step < count; ++step) {
    const auto lowest = find_lowest(mesh, e, x);
    if (lowest.value >= -inside_tolerance) return e;
    const int next = mesh.neighbours[e][lowest.node];
    if (next < 0) break;
    e = next;
  }
  for (e = 0; e < count; ++e)
    if (find_lowest(mesh, e, x).value >= -inside_tolerance) return e;
  return -1;
}

template int find_element<2>(const Mesh<2>&, const std::array<double, 2>&, int);
template int find_element<3>(const Mesh<3>&, const std::array<double, 3>&, int);

}  // namespace talus::mesh
