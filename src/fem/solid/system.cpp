// SPDX-License-Identifier: MIT
// Unknowns and pattern of the equations of equilibrium.

#include "fem/solid/system.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace talus::fem {
namespace {

/// Fills the axes behind the held ones so that all are orthonormal.
template <int D>
void complete(std::vector<Vec<D>>& axes) {
  for (std::size_t d = 0; axes.size() < D && d < D; ++d) {
    // of the coordinate axes the one that is least along those that are there
    std::size_t best = 0;
    double least = 2;
    for (std::size_t c = 0; c < D; ++c) {
      double along = 0;
      for (const auto& a : axes) along += a[c] * a[c];
      if (along < least - 1e-9) least = along, best = c;
    }
    Vec<D> v{};
    v[best] = 1;
    for (const auto& a : axes) {
      const double along = a[best];
      for (std::size_t c = 0; c < D; ++c) v[c] -= along * a[c];
    }
    const double length = norm(v);
    for (double& x : v) x /= length;
    axes.push_back(v);
  }
}

template <int D>
bool is_along_axes(const std::vector<Vec<D>>& held) {
  for (const auto& h : held)
    for (double x : h)
      if (std::abs(x) > 1e-9 && std::abs(x) < 1 - 1e-9) return false;
  return true;
}

}  // namespace

template <int D>
SolidSystem<D>::SolidSystem(const SolidModel<D>& m) : model(m), mesh(make_quadratic(*m.mesh)) {
  const auto held = find_held_directions(model, mesh);
  nodes.resize(mesh.nodes.size());
  std::vector<char> has_soil(mesh.nodes.size(), 0);
  for (const auto& element : mesh.elements)
    for (int n : element) has_soil[static_cast<std::size_t>(n)] = 1;
  bool supported = false;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    auto& node = nodes[n];
    node.unknown.fill(-1);
    for (std::size_t d = 0; d < D; ++d) node.axes[d] = Vec<D>{}, node.axes[d][d] = 1;
    supported = supported || !held[n].empty();
    if (!has_soil[n]) continue;
    std::array<bool, D> fixed{};
    if (is_along_axes<D>(held[n])) {
      for (const auto& h : held[n])
        for (std::size_t d = 0; d < D; ++d) fixed[d] = fixed[d] || std::abs(h[d]) > 0.5;
    } else {
      node.turned = true;
      auto axes = held[n];
      complete<D>(axes);
      std::copy(axes.begin(), axes.end(), node.axes.begin());
      for (std::size_t d = 0; d < held[n].size(); ++d) fixed[d] = true;
    }
    for (std::size_t d = 0; d < D; ++d)
      if (!fixed[d]) node.unknown[d] = unknowns++;
  }
  if (!supported)
    throw Error(ExitCode::wrong_input,
                "no side of the soil is held: finite elements need a support to find equilibrium");
  if (unknowns == 0)
    throw Error(ExitCode::wrong_input, "every node of the soil is held: finite elements have nothing to find");

  gradients.resize(mesh.elements.size());
  pore.assign(mesh.elements.size(), {});
  turned.assign(mesh.elements.size(), 0);
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    std::array<Vec<D>, D + 1> x;
    for (std::size_t i = 0; i < Q::corners; ++i) x[i] = mesh.nodes[static_cast<std::size_t>(mesh.elements[k][i])];
    find_simplex<D>(x, gradients[k]);
    for (int n : mesh.elements[k])
      if (nodes[static_cast<std::size_t>(n)].turned) turned[k] = 1;
    if (model.pore_stress.empty()) continue;
    const auto& p = model.pore_stress[static_cast<std::size_t>(mesh.linear_element[k])];
    for (std::size_t q = 0; q < Q::points; ++q) {
      const auto l = find_barycentric<D>(q);
      for (std::size_t i = 0; i < Q::corners; ++i) pore[k][q] += l[i] * p[i];
    }
  }
  to_unknowns(find_loads(model, mesh), load);
  make_pattern();
}

/// Every unknown of an element meets every other.
template <int D>
void SolidSystem<D>::make_pattern() {
  const auto list_unknowns = [&](std::size_t k) {
    std::array<int, locals> list;
    for (std::size_t i = 0; i < Q::nodes; ++i)
      for (std::size_t d = 0; d < D; ++d)
        list[i * D + d] = nodes[static_cast<std::size_t>(mesh.elements[k][i])].unknown[d];
    return list;
  };
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(unknowns));
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    const auto list = list_unknowns(k);
    for (int j : list)
      if (j >= 0)
        for (int i : list)
          if (i >= 0) columns[static_cast<std::size_t>(j)].push_back(i);
  }
  column_start.assign(1, 0);
  for (auto& column : columns) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    row.insert(row.end(), column.begin(), column.end());
    column_start.push_back(static_cast<int>(row.size()));
  }
  slots.resize(mesh.elements.size());
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    const auto list = list_unknowns(k);
    for (std::size_t b = 0; b < locals; ++b) {
      for (std::size_t a = 0; a < locals; ++a) {
        int& slot = slots[k][a * locals + b];
        slot = -1;
        if (list[a] < 0 || list[b] < 0) continue;
        const auto begin = row.begin() + column_start[static_cast<std::size_t>(list[b])],
                   end = row.begin() + column_start[static_cast<std::size_t>(list[b]) + 1];
        slot = static_cast<int>(std::lower_bound(begin, end, list[a]) - row.begin());
      }
    }
  }
}

template <int D>
void SolidSystem<D>::to_nodes(const std::vector<double>& q, std::vector<Vec<D>>& u) const {
  u.assign(nodes.size(), Vec<D>{});
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (std::size_t k = 0; k < D; ++k)
      if (nodes[n].unknown[k] >= 0)
        for (std::size_t d = 0; d < D; ++d)
          u[n][d] += nodes[n].axes[k][d] * q[static_cast<std::size_t>(nodes[n].unknown[k])];
}

template <int D>
void SolidSystem<D>::to_unknowns(const std::vector<Vec<D>>& f, std::vector<double>& q) const {
  q.assign(static_cast<std::size_t>(unknowns), 0);
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (std::size_t k = 0; k < D; ++k)
      if (nodes[n].unknown[k] >= 0) q[static_cast<std::size_t>(nodes[n].unknown[k])] = dot(nodes[n].axes[k], f[n]);
}

template struct SolidSystem<2>;
template struct SolidSystem<3>;

}  // namespace talus::fem
