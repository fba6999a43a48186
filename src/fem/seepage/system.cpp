// SPDX-License-Identifier: MIT
// Numbering, pattern and stores of the nodal equations of seepage.

#include "fem/seepage/system.hpp"

#include <algorithm>
#include <map>

#include "fem/seepage/check.hpp"

namespace talus::fem {

namespace {

template <int D>
void build_pattern(SeepageSystem<D>& s) {
  constexpr std::size_t n = D + 1;
  const auto& mesh = *s.model.mesh;
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(s.size()));
  const auto unknown = [&](int e, std::size_t k) {
    return s.unknown_of_node[static_cast<std::size_t>(mesh.elements[static_cast<std::size_t>(e)][k])];
  };
  for (int e : s.elements) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) columns[static_cast<std::size_t>(unknown(e, j))].push_back(unknown(e, i));
    }
  }
  s.column_start.assign(1, 0);
  for (auto& c : columns) {
    std::sort(c.begin(), c.end());
    c.erase(std::unique(c.begin(), c.end()), c.end());
    s.row.insert(s.row.end(), c.begin(), c.end());
    s.column_start.push_back(static_cast<int>(s.row.size()));
  }
  const auto find_slot = [&](int i, int j) {
    const auto first = s.row.begin() + s.column_start[static_cast<std::size_t>(j)];
    const auto last = s.row.begin() + s.column_start[static_cast<std::size_t>(j) + 1];
    return static_cast<int>(std::lower_bound(first, last, i) - s.row.begin());
  };
  for (int e : s.elements) {
    auto& slots = s.slots.emplace_back();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) slots[i * n + j] = find_slot(unknown(e, i), unknown(e, j));
    }
  }
  for (int i = 0; i < s.size(); ++i) s.diagonal.push_back(find_slot(i, i));
}

template <int D>
void build_stores(SeepageSystem<D>& s) {
  const auto& mesh = *s.model.mesh;
  std::map<std::pair<int, int>, double> volume;
  for (int e : s.elements) {
    const auto el = static_cast<std::size_t>(e);
    for (int node : mesh.elements[el])
      volume[{s.unknown_of_node[static_cast<std::size_t>(node)], mesh.element_region[el]}] +=
          mesh.volumes[el] / (D + 1);
  }
  for (const auto& [key, v] : volume) s.stores.push_back({key.first, key.second, v});
}

}  // namespace

template <int D>
SeepageSystem<D>::SeepageSystem(const SeepageModel<D>& m) : model(m) {
  check_model(m);
  const auto& mesh = *m.mesh;
  unknown_of_node.assign(mesh.nodes.size(), -1);
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (mesh.element_region[static_cast<std::size_t>(e)] == mesh::empty_region) continue;
    elements.push_back(e);
    for (int node : mesh.elements[static_cast<std::size_t>(e)]) unknown_of_node[static_cast<std::size_t>(node)] = 0;
  }
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    if (unknown_of_node[i] < 0) continue;
    unknown_of_node[i] = size();
    node_of_unknown.push_back(static_cast<int>(i));
    elevation.push_back(mesh.nodes[i][static_cast<std::size_t>(m.up)]);
  }
  if (!elevation.empty()) datum = *std::min_element(elevation.begin(), elevation.end());
  for (double& y : elevation) y -= datum;
  build_pattern(*this);
  build_stores(*this);
  build_shares(*this);
}

template <int D>
material::CurvePoint<double> SeepageSystem<D>::find_content(const HydraulicSoil<D>& soil, double s) const {
  const auto w = material::find_water(soil.retention, s);
  const double squeeze = 1 / soil.water_modulus;
  const double skeleton = s < 0 ? soil.skeleton_compressibility * w.saturation : 0;
  return {soil.porosity * w.saturation * (1 - s * squeeze) - skeleton * s,
          soil.porosity * (w.slope * (1 - s * squeeze) - w.saturation * squeeze) - skeleton};
}

template <int D>
std::vector<double> SeepageSystem<D>::find_contents(const std::vector<double>& head) const {
  std::vector<double> contents;
  contents.reserve(stores.size());
  for (const Store& store : stores) {
    const auto u = static_cast<std::size_t>(store.unknown);
    contents.push_back(store.volume *
                       find_content(model.soils[static_cast<std::size_t>(store.soil)], suction(u, head[u])).value);
  }
  return contents;
}

template struct SeepageSystem<2>;
template struct SeepageSystem<3>;

}  // namespace talus::fem
