// SPDX-License-Identifier: MIT
// Derived data of a mesh: orientation, volume, gradients of local coordinates, smallest altitude; renumbering along a
// space-filling curve; improvement of flat elements.
#include "mesh/gmsh_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "mesh/locate.hpp"
#include "mesh/mesh.hpp"

namespace talus::mesh {

namespace {

/// Volume over (longest edge)^D below which an element is flat: its altitude is then below about 1e-10 of its edges,
/// and its orientation is within the rounding error of the coordinates.
constexpr double flat_fraction = 1e-10;

/// Returns edges[k*D+d] = (x_{k+1} - x_0)_d [m].
template <int D>
std::array<double, D * D> compute_edges(const Mesh<D>& mesh, const typename Mesh<D>::Element& element) {
  std::array<double, D * D> edges;
  for (int k = 0; k < D; ++k)
    for (int d = 0; d < D; ++d) edges[k * D + d] = mesh.nodes[element[k + 1]][d] - mesh.nodes[element[0]][d];
  return edges;
}

template <int D>
double compute_determinant(const std::array<double, D * D>& m) {
  if constexpr (D == 2)
    return m[0] * m[3] - m[1] * m[2];
  else
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
}

/// Returns ∂ξ_k/∂x_d: x - x_0 = Σ_k ξ_k edge_k, so the gradients are the columns of the inverse of the edge matrix.
template <int D>
std::array<double, D * D> compute_gradients(const std::array<double, D * D>& m, double det) {
  if constexpr (D == 2) {
    return {m[3] / det, -m[2] / det, -m[1] / det, m[0] / det};
  } else {
    std::array<double, 9> g;
    for (int k = 0; k < 3; ++k) {
      const double* a = &m[3 * ((k + 1) % 3)];
      const double* b = &m[3 * ((k + 2) % 3)];
      for (int d = 0; d < 3; ++d)
        g[3 * k + d] = (a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3]) / det;
    }
    return g;
  }
}

/// The altitude over the side opposite node k is 1/|∇N_k|, with N_0 = 1 - Σ ξ_k.
template <int D>
double compute_altitude(const std::array<double, D * D>& gradients) {
  std::array<double, D> first{};
  double steepest = 0;
  for (int k = 0; k < D; ++k) {
    double square = 0;
    for (int d = 0; d < D; ++d) {
      first[d] -= gradients[k * D + d];
      square += gradients[k * D + d] * gradients[k * D + d];
    }
    steepest = std::max(steepest, square);
  }
  double square = 0;
  for (double g : first) square += g * g;
  return 1 / std::sqrt(std::max(steepest, square));
}

template <int D>
double compute_longest_edge(const Mesh<D>& mesh, const typename Mesh<D>::Element& element) {
  double longest = 0;
  for (int i = 0; i <= D; ++i)
    for (int j = 0; j < i; ++j) {
      double square = 0;
      for (int d = 0; d < D; ++d) {
        const double x = mesh.nodes[element[i]][d] - mesh.nodes[element[j]][d];
        square += x * x;
      }
      longest = std::max(longest, square);
    }
  return std::sqrt(longest);
}

template <int D>
[[noreturn]] void fail_flat(const Mesh<D>& mesh, int e) {
  std::string place;
  for (double x : mesh.nodes[mesh.elements[e][0]]) place += fmt::format("{}{:.9g}", place.empty() ? "" : ", ", x);
  fail_input("element {} of the mesh has no {}: its first node lies at ({})", e + 1, D == 2 ? "area" : "volume", place);
}

/// Gives every element positive orientation.
template <int D>
void orient(Mesh<D>& mesh) {
  for (int e = 0; e < mesh.element_count(); ++e) {
    auto& element = mesh.elements[e];
    const double det = compute_determinant<D>(compute_edges(mesh, element));
    if (!(std::abs(det) > flat_fraction * std::pow(compute_longest_edge(mesh, element), D))) fail_flat(mesh, e);
    if (det < 0) std::swap(element[D - 1], element[D]);
  }
}

/// Checks the sizes of the arrays against each other, and that every node number exists.
template <int D>
void check_numbers(const Mesh<D>& mesh) {
  const auto check = [&](int node) {
    if (node < 0 || node >= mesh.node_count())
      fail_input("the mesh refers to node {}, but it has {} nodes", node, mesh.node_count());
  };
  if (mesh.elements.empty()) fail_input("the mesh has no elements");
  if (mesh.element_region.size() != mesh.elements.size())
    fail_input("the mesh has {} elements but {} region numbers", mesh.elements.size(), mesh.element_region.size());
  for (const auto& element : mesh.elements) std::for_each(element.begin(), element.end(), check);
  for (const auto& [name, sides] : mesh.sides)
    for (const auto& side : sides) std::for_each(side.begin(), side.end(), check);
}

}  // namespace

template <int D>
void finish(Mesh<D>& mesh, Order order) {
  check_numbers(mesh);
  orient(mesh);
  if (order == Order::space_filling) renumber(mesh);
  mesh.neighbours = find_neighbours(mesh);
  const std::size_t count = mesh.elements.size();
  mesh.volumes.resize(count);
  mesh.gradients.resize(count);
  mesh.altitudes.resize(count);
  for (std::size_t e = 0; e < count; ++e) {
    const auto edges = compute_edges(mesh, mesh.elements[e]);
    const double det = compute_determinant<D>(edges);
    mesh.volumes[e] = det / (D == 2 ? 2 : 6);
    mesh.gradients[e] = compute_gradients<D>(edges, det);
    mesh.altitudes[e] = compute_altitude<D>(mesh.gradients[e]);
  }
}

template <int D>
std::array<double, D> to_global(const Mesh<D>& mesh, int e, const typename Mesh<D>::Point& xi) {
  return find_place(mesh, e, xi);
}

template <int D>
std::array<double, D> to_local(const Mesh<D>& mesh, int e, const typename Mesh<D>::Point& x) {
  return find_local(mesh, e, x);
}

template void finish<2>(Mesh<2>&, Order);
template void finish<3>(Mesh<3>&, Order);
template std::array<double, 2> to_global<2>(const Mesh<2>&, int, const std::array<double, 2>&);
template std::array<double, 3> to_global<3>(const Mesh<3>&, int, const std::array<double, 3>&);
template std::array<double, 2> to_local<2>(const Mesh<2>&, int, const std::array<double, 2>&);
template std::array<double, 3> to_local<3>(const Mesh<3>&, int, const std::array<double, 3>&);

namespace {

/// Interleaves the bits of D integers, the first axis lowest.
template <int D>
std::uint64_t interleave(std::array<std::uint64_t, D> cell, int bits) {
  std::uint64_t code = 0;
  for (int b = 0; b < bits; ++b)
    for (int d = 0; d < D; ++d) code |= ((cell[d] >> b) & 1u) << (b * D + d);
  return code;
}

/// Returns the Morton code of every element's centroid on a grid of cubes that covers the mesh.
template <int D>
std::vector<std::pair<std::uint64_t, int>> compute_codes(const Mesh<D>& mesh) {
  constexpr int bits = D == 2 ? 24 : 20;  // far finer than any mesh; the doubles below remain exact
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
  std::sort(codes.begin(), codes.end());  // ties are broken by the element number, so the order is unique
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
        if (new_number[node] < 0) fail_input("a part of side '" + name + "' of the mesh does not touch any element");
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

namespace {

/// Elements with a lower ratio of altitude to size are improved. The regular simplex has 0.866 (2D) and 0.816 (3D).
template <int D>
constexpr double target = D == 2 ? 0.7 : 0.5;
constexpr int most_sweeps = 30;
constexpr double first_step = 0.2, last_step = 0.01;  ///< fractions of the element size
constexpr double least_gain = 1e-3;                   ///< smaller gains are ignored

/// Returns the smallest altitude of a simplex, D V / (largest side) [m]; negative if it is inverted.
template <int D>
double measure_altitude(const std::array<std::array<double, D>, D + 1>& x, double orientation) {
  const auto subtract = [](const std::array<double, D>& a, const std::array<double, D>& b) {
    std::array<double, D> c;
    for (int d = 0; d < D; ++d) c[d] = a[d] - b[d];
    return c;
  };
  if constexpr (D == 2) {
    const auto a = subtract(x[1], x[0]), b = subtract(x[2], x[0]), c = subtract(x[2], x[1]);
    const double longest = std::max({a[0] * a[0] + a[1] * a[1], b[0] * b[0] + b[1] * b[1], c[0] * c[0] + c[1] * c[1]});
    return orientation * (a[0] * b[1] - a[1] * b[0]) / std::sqrt(longest);
  } else {
    const auto cross = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
      return std::array<double, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const auto square = [](const std::array<double, 3>& a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; };
    const auto a = subtract(x[1], x[0]), b = subtract(x[2], x[0]), c = subtract(x[3], x[0]);
    const auto ab = cross(a, b);
    const double largest =
        std::max({square(ab), square(cross(a, c)), square(cross(b, c)), square(cross(subtract(b, a), subtract(c, a)))});
    return orientation * (ab[0] * c[0] + ab[1] * c[1] + ab[2] * c[2]) / std::sqrt(largest);
  }
}

template <int D>
class Smoother {
 public:
  using Point = typename Mesh<D>::Point;

  Smoother(Mesh<D>& mesh, const std::vector<Freedom<D>>& freedoms, const std::function<double(const Point&)>& get_size)
      : mesh_(mesh), freedoms_(freedoms), orientations_(mesh.elements.size(), 1), start_(mesh.nodes.size() + 1, 0) {
    sizes_.reserve(mesh.nodes.size());
    for (const Point& x : mesh.nodes) sizes_.push_back(get_size(x));
    for (int e = 0; e < mesh.element_count(); ++e) {
      if (measure(e) < 0) orientations_[e] = -1;
      for (int node : mesh.elements[e]) ++start_[node + 1];
    }
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    star_.resize(static_cast<std::size_t>(start_.back()));
    std::vector<int> fill(start_.begin(), start_.end() - 1);
    for (int e = 0; e < mesh.element_count(); ++e)
      for (int node : mesh.elements[e]) star_[fill[node]++] = e;
  }

  void run() {
    bool moved = true;
    for (int sweep = 0; moved && sweep < most_sweeps; ++sweep) {
      moved = false;
      for (int node = 0; node < mesh_.node_count(); ++node)
        if (freedoms_[node].count > 0 && measure_star(node) < target<D>) moved = improve(node) || moved;
    }
  }

 private:
  /// Returns the altitude over the mean target size at the element's nodes.
  double measure(int e) const {
    std::array<Point, D + 1> x;
    double size = 0;
    for (int k = 0; k <= D; ++k) {
      x[k] = mesh_.nodes[mesh_.elements[e][k]];
      size += sizes_[mesh_.elements[e][k]] / (D + 1);
    }
    return measure_altitude<D>(x, orientations_[e]) / size;
  }

  double measure_star(int node) const {
    double worst = 1;
    for (int i = start_[node]; i < start_[node + 1]; ++i) worst = std::min(worst, measure(star_[i]));
    return worst;
  }

  /// Compass search: moves to the best of the directions, or reduces the step if none is better.
  bool improve(int node) {
    Point& x = mesh_.nodes[node];
    const Freedom<D>& freedom = freedoms_[node];
    double best = measure_star(node);
    bool moved = false;
    for (double step = first_step; step > last_step;) {
      const Point origin = x;
      Point target_place = x;
      double value = best * (1 + least_gain);
      int combinations = 1;
      for (int i = 0; i < freedom.count; ++i) combinations *= 3;
      for (int c = 0; c < combinations; ++c) {
        Point offset{};
        int terms = 0;
        for (int i = 0, rest = c; i < freedom.count; ++i, rest /= 3) {
          const int sign = rest % 3 - 1;
          terms += sign * sign;
          for (int d = 0; d < D; ++d) offset[d] += sign * freedom.directions[i][d];
        }
        if (terms == 0) continue;
        for (int d = 0; d < D; ++d) x[d] = origin[d] + step * sizes_[node] / std::sqrt(terms) * offset[d];
        if (const double tried = measure_star(node); tried > value) {
          value = tried;
          target_place = x;
        }
      }
      x = target_place;
      if (x == origin) {
        step /= 2;
      } else {
        best = value;
        moved = true;
      }
    }
    return moved;
  }

  Mesh<D>& mesh_;
  const std::vector<Freedom<D>>& freedoms_;
  std::vector<double> orientations_;  ///< 1 or -1, per element
  std::vector<double> sizes_;         ///< target size at each node [m]
  std::vector<int> start_, star_;     ///< elements around each node
};

}  // namespace

template <int D>
void raise_altitudes(Mesh<D>& mesh, const std::vector<Freedom<D>>& freedoms,
                     const std::function<double(const typename Mesh<D>::Point&)>& get_size) {
  Smoother<D>(mesh, freedoms, get_size).run();
}

template void raise_altitudes<2>(Mesh<2>&, const std::vector<Freedom<2>>&,
                                 const std::function<double(const Mesh<2>::Point&)>&);
template void raise_altitudes<3>(Mesh<3>&, const std::vector<Freedom<3>>&,
                                 const std::function<double(const Mesh<3>::Point&)>&);

}  // namespace talus::mesh
