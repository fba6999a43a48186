// SPDX-License-Identifier: MIT
// The quadratic mesh on a linear one.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "fem/solid/shape.hpp"
#include "fem/solid/system.hpp"

namespace talus::fem {
namespace {

template <int D>
std::string describe_element(const mesh::Mesh<D>& mesh, std::size_t e, const Vec<D>& centre) {
  const auto region = static_cast<std::size_t>(mesh.element_region[e]);
  const std::string soil = region < mesh.region_names.size() ? fmt::format(" of '{}'", mesh.region_names[region]) : "";
  return fmt::format("element {}{} at ({:.4g}) m", e, soil, fmt::join(centre, ", "));
}

/// Doubles the nodes on cuts.
class Splitter {
 public:
  Splitter(QuadraticMesh<2>& mesh, const Cuts& cuts) : mesh_(mesh), cuts_(cuts), list_(cuts) {}

  void run() {
    mesh_.original.resize(mesh_.nodes.size());
    std::iota(mesh_.original.begin(), mesh_.original.end(), 0);
    const auto given = mesh_.elements;
    std::vector<std::array<int, 3>> corners;
    for (const auto& element : given) corners.push_back({element[0], element[1], element[2]});
    for (const mesh::DoubledNode& doubled : mesh::list_doubles(corners, list_)) {
      const int own = add_double(doubled.node);
      for (const std::size_t k : doubled.elements) replace(k, doubled.node, own);
    }
    split_middles(given);
  }

 private:
  using Elements = decltype(QuadraticMesh<2>::elements);

  int add_double(int node) {
    mesh_.original.push_back(node);
    mesh_.nodes.push_back(mesh_.nodes[static_cast<std::size_t>(node)]);
    return static_cast<int>(mesh_.nodes.size()) - 1;
  }
  void replace(std::size_t k, int node, int by) {
    std::replace(mesh_.elements[k].begin(), mesh_.elements[k].end(), node, by);
  }

  void split_middles(const Elements& given) {
    std::map<int, int> uses;
    for (std::size_t k = 0; k < given.size(); ++k)
      for (std::size_t i = 0; i < Quadratic<2>::edges.size(); ++i) {
        const auto [a, b] = Quadratic<2>::edges[i];
        const int middle = given[k][Quadratic<2>::corners + i];
        if (cuts_.contains(given[k][a], given[k][b]) && uses[middle]++ > 0) replace(k, middle, add_double(middle));
      }
  }

  QuadraticMesh<2>& mesh_;
  CutSet cuts_;
  const Cuts& list_;
};

}  // namespace

template <int D>
Cuts list_cuts(const SolidModel<D>& model) {
  Cuts cuts;
  for (const Wall& wall : model.walls)
    for (std::size_t i = 0; i + 1 < wall.nodes.size(); ++i) cuts.push_back({wall.nodes[i], wall.nodes[i + 1]});
  return cuts;
}

template <int D>
QuadraticMesh<D> make_quadratic(const mesh::Mesh<D>& mesh, const Cuts& cuts) {
  using Q = Quadratic<D>;
  QuadraticMesh<D> r;
  r.nodes.assign(mesh.nodes.begin(), mesh.nodes.end());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (mesh.element_region[e] != mesh::empty_region) r.linear_element.push_back(static_cast<int>(e));
  if (r.linear_element.empty())
    fail_input("the mesh has no element with soil ({} elements, all empty): FEM needs at least one",
               mesh.elements.size());
  // Edges are numbered in the order in which the elements have them, so that neighbours get similar numbers.
  std::vector<std::pair<std::array<int, 2>, std::size_t>> uses;  // edge, its position in the elements
  r.elements.resize(r.linear_element.size());
  for (std::size_t k = 0; k < r.elements.size(); ++k) {
    const auto e = static_cast<std::size_t>(r.linear_element[k]);
    std::array<Vec<D>, D + 1> x, g;
    Vec<D> centre{};
    for (std::size_t i = 0; i < Q::corners; ++i) {
      const int node = mesh.elements[e][i];
      r.elements[k][i] = node;
      x[i] = mesh.nodes[static_cast<std::size_t>(node)];
      for (std::size_t d = 0; d < D; ++d) centre[d] += x[i][d] / (D + 1);
    }
    const double volume = find_simplex<D>(x, g);
    if (!(volume > 0))
      fail_input("{} is inverted: its {} is {:.3g} {} where a positive one was expected",
                 describe_element<D>(mesh, e, centre), D == 2 ? "area" : "volume", volume, D == 2 ? "m2" : "m3");
    for (std::size_t q = 0; q < Q::points; ++q) {
      const auto l = find_barycentric<D>(q);
      Vec<D> point{};
      for (std::size_t i = 0; i < Q::corners; ++i)
        for (std::size_t d = 0; d < D; ++d) point[d] += l[i] * x[i][d];
      r.points.push_back(point);
      r.weights.push_back(volume / Q::points);
    }
    for (std::size_t i = 0; i < Q::edges.size(); ++i) {
      const int a = r.elements[k][Q::edges[i][0]], b = r.elements[k][Q::edges[i][1]];
      uses.push_back({{std::min(a, b), std::max(a, b)}, k * Q::edges.size() + i});
    }
  }
  std::sort(uses.begin(), uses.end());
  std::vector<std::size_t> first(uses.size());  // of each use, the first use of the same edge
  for (std::size_t i = 0; i < uses.size(); ++i)
    first[uses[i].second] = i > 0 && uses[i].first == uses[i - 1].first ? first[uses[i - 1].second] : uses[i].second;
  std::vector<int> number(uses.size());
  for (std::size_t place = 0; place < first.size(); ++place) {
    const std::size_t k = place / Q::edges.size(), i = place % Q::edges.size();
    if (first[place] == place) {
      number[place] = static_cast<int>(r.nodes.size());
      Vec<D> middle;
      const auto& a = r.nodes[static_cast<std::size_t>(r.elements[k][Q::edges[i][0]])];
      const auto& b = r.nodes[static_cast<std::size_t>(r.elements[k][Q::edges[i][1]])];
      for (std::size_t d = 0; d < D; ++d) middle[d] = 0.5 * (a[d] + b[d]);
      r.nodes.push_back(middle);
    }
    r.elements[k][Q::corners + i] = number[first[place]];
  }
  if constexpr (D == 2)
    if (!cuts.empty()) Splitter(r, cuts).run();
  return r;
}

template QuadraticMesh<2> make_quadratic<2>(const mesh::Mesh<2>&, const Cuts&);
template QuadraticMesh<3> make_quadratic<3>(const mesh::Mesh<3>&, const Cuts&);
template Cuts list_cuts<2>(const SolidModel<2>&);
template Cuts list_cuts<3>(const SolidModel<3>&);

}  // namespace talus::fem
