// SPDX-License-Identifier: MIT
#include "mesh/renumber.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/error.hpp"

namespace talus::mesh {
namespace {

/// Interleaves the bits of D integers, the first axis lowest.
template <int D>
std::uint64_t interleave(std::array<std::uint64_t, D> cell, int bits) {
  std::uint64_t code = 0;
  for (int b = 0; b < bits; ++b)
    for (int d = 0; d < D; ++d) code |= ((cell[d] >> b) & 1u) << (b * D + d);
  return code;
}

/// Morton code of every element's centroid on a grid of cubes that covers the mesh.
template <int D>
std::vector<std::pair<std::uint64_t, int>> compute_codes(const Mesh<D>& mesh) {
  constexpr int bits = D == 2 ? 24 : 20;  // far finer than any mesh; the doubles below stay exact
  std::array<double, D> low, high;
  low.fill(std::numeric_limits<double>::max());
  high.fill(std::numeric_limits<double>::lowest());
  for (const auto& x : mesh.nodes)
    for (int d = 0; d < D; ++d) {
      low[d] = std::min(low[d], x[d]);
      high[d] = std::max(high[d], x[d]);
    }
  double extent = 0;
  for (int d = 0; d < D; ++d) extent = std::max(extent, high[d] - low[d]);
  const double cells = static_cast<double>((std::uint64_t{1} << bits) - 1) / (extent > 0 ? extent : 1);

  std::vector<std::pair<std::uint64_t, int>> codes(mesh.elements.size());
  for (int e = 0; e < mesh.element_count(); ++e) {
    std::array<std::uint64_t, D> cell;
    for (int d = 0; d < D; ++d) {
      double sum = 0;
      for (int node : mesh.elements[e]) sum += mesh.nodes[node][d];
      cell[d] = static_cast<std::uint64_t>(std::max(0.0, (sum / (D + 1) - low[d]) * cells));
    }
    codes[e] = {interleave<D>(cell, bits), e};
  }
  return codes;
}

template <int D>
void reorder_elements(Mesh<D>& mesh) {
  auto codes = compute_codes(mesh);
  std::sort(codes.begin(), codes.end());  // the element's number breaks ties, so the sort is stable
  std::vector<typename Mesh<D>::Element> elements(codes.size());
  std::vector<int> regions(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i) {
    elements[i] = mesh.elements[codes[i].second];
    regions[i] = mesh.element_region[codes[i].second];
  }
  mesh.elements = std::move(elements);
  mesh.element_region = std::move(regions);
}

template <int D>
void reorder_nodes(Mesh<D>& mesh) {
  std::vector<int> new_number(mesh.nodes.size(), -1);
  std::vector<typename Mesh<D>::Point> nodes;
  nodes.reserve(mesh.nodes.size());
  for (auto& element : mesh.elements)
    for (int& node : element) {
      if (new_number[node] < 0) {
        new_number[node] = static_cast<int>(nodes.size());
        nodes.push_back(mesh.nodes[node]);
      }
      node = new_number[node];
    }
  for (auto& [name, sides] : mesh.sides)
    for (auto& side : sides)
      for (int& node : side) {
        if (new_number[node] < 0)
          throw Error(ExitCode::wrong_input, "a part of side '" + name + "' of the mesh does not touch any element");
        node = new_number[node];
      }
  mesh.nodes = std::move(nodes);
}

}  // namespace

template <int D>
void renumber(Mesh<D>& mesh) {
  reorder_elements(mesh);
  reorder_nodes(mesh);
}

template void renumber<2>(Mesh<2>&);
template void renumber<3>(Mesh<3>&);

}  // namespace talus::mesh
