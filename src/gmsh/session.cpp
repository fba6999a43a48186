// SPDX-License-Identifier: MIT
#include "gmsh/session.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "base/error.hpp"
#include "base/numbers.hpp"

namespace talus::mesh {

GmshSession::GmshSession() {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.Verbosity", 1);
  gmsh::option::setNumber("General.NumThreads", 1);
  gmsh::option::setNumber("Mesh.RandomSeed", 1);
}

GmshSession::~GmshSession() {
  try {
    gmsh::model::mesh::removeSizeCallback();
    gmsh::finalize();
  } catch (...) {  // destructors must not throw
  }
}

std::string GmshSession::get_last_error() {
  std::string text;
  gmsh::logger::getLastError(text);
  while (!text.empty() && (text.back() == '.' || text.back() == '\n')) text.pop_back();
  return text.empty() ? "no reason given" : text;
}

// Extraction of Gmsh's nodes, elements and named sides, and of the freedom of its nodes to move.

namespace {

/// Gmsh's element types of the linear simplices: point, line, triangle, tetrahedron.
constexpr std::array<int, 4> simplex_type{15, 1, 2, 4};

/// Gmsh's nodes by tag.
struct Nodes {
  std::unordered_map<std::size_t, int> index;
  std::vector<std::array<double, 3>> places;
};

Nodes get_nodes() {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parametric;
  gmsh::model::mesh::getNodes(tags, coordinates, parametric, -1, -1, false, false);
  Nodes nodes;
  nodes.index.reserve(tags.size());
  nodes.places.reserve(tags.size());
  for (std::size_t i = 0; i < tags.size(); ++i)
    if (nodes.index.emplace(tags[i], static_cast<int>(nodes.places.size())).second)
      nodes.places.push_back({coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]});
  return nodes;
}

/// Returns the simplices of dimension `N-1` on one geometric entity. Throws Error for other elements.
template <int N>
std::vector<std::array<int, N>> get_simplices(int entity, const Nodes& nodes) {
  constexpr int dimension = N - 1;
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> element_tags, node_tags;
  gmsh::model::mesh::getElements(types, element_tags, node_tags, dimension, entity);
  std::vector<std::array<int, N>> simplices;
  for (std::size_t t = 0; t < types.size(); ++t) {
    if (types[t] != simplex_type[dimension]) {
      std::string name;
      int dim, order, count, primary;
      std::vector<double> local;
      gmsh::model::mesh::getElementProperties(types[t], name, dim, order, count, local, primary);
      fail_input("the mesh holds {} elements of type '{}': only linear {} are understood", element_tags[t].size(), name,
                 dimension == 1 ? "lines" : (dimension == 2 ? "triangles" : "tetrahedra"));
    }
    for (std::size_t i = 0; i < node_tags[t].size(); i += N) {
      std::array<int, N> simplex;
      for (int k = 0; k < N; ++k) simplex[k] = nodes.index.at(node_tags[t][i + static_cast<std::size_t>(k)]);
      simplices.push_back(simplex);
    }
  }
  return simplices;
}

template <std::size_t N>
std::array<double, 3> compute_centroid(const std::array<int, N>& simplex, const Nodes& nodes) {
  std::array<double, 3> centroid{};
  for (int node : simplex)
    for (int d = 0; d < 3; ++d) centroid[d] += nodes.places[node][d] / static_cast<double>(N);
  return centroid;
}

/// Checks that a 2D mesh lies in a plane of constant z, because z is dropped.
void check_plane(const Mesh<2>& mesh, const Nodes& nodes) {
  const auto& first = nodes.places[mesh.elements[0][0]];
  for (const auto& element : mesh.elements)
    for (int node : element)
      if (const auto& x = nodes.places[node]; x[2] != first[2])
        fail_input(
            "the triangles of the mesh do not lie in one plane of constant z: z is {} at ({}, {}) and {} elsewhere",
            format_coordinate(x[2]), format_coordinate(x[0]), format_coordinate(x[1]), format_coordinate(first[2]));
}

/// Returns the directions in which nodes inside one geometric entity may move; all entities of a plan are flat.
template <int D>
Freedom<D> find_freedom(int dimension, int entity, const Nodes& nodes) {
  Freedom<D> freedom;
  freedom.count = dimension;
  if (dimension == D) {
    for (int d = 0; d < D; ++d) freedom.directions[d][d] = 1;
    return freedom;
  }
  const auto span = [&](const auto& simplex) {  // by Gram–Schmidt orthogonalisation of its edges
    for (int i = 0; i < dimension; ++i) {
      auto& v = freedom.directions[i];
      for (int d = 0; d < D; ++d) v[d] = nodes.places[simplex[i + 1]][d] - nodes.places[simplex[0]][d];
      for (int j = 0; j < i; ++j) {
        const double share = std::inner_product(v.begin(), v.end(), freedom.directions[j].begin(), 0.0);
        for (int d = 0; d < D; ++d) v[d] -= share * freedom.directions[j][d];
      }
      const double length = std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.0));
      for (double& component : v) component /= length;
    }
  };
  if (dimension == 1) {
    const auto lines = get_simplices<2>(entity, nodes);
    if (lines.empty()) return {};
    span(lines.front());
  } else {
    const auto triangles = get_simplices<3>(entity, nodes);
    if (triangles.empty()) return {};
    span(triangles.front());
  }
  return freedom;
}

}  // namespace

template <int D>
std::vector<Freedom<D>> extract_freedoms() {
  const Nodes nodes = get_nodes();
  std::vector<Freedom<D>> freedoms(nodes.places.size());
  for (int dimension = 1; dimension <= D; ++dimension) {
    gmsh::vectorpair entities;
    gmsh::model::getEntities(entities, dimension);
    for (const auto& [dim, entity] : entities) {
      std::vector<std::size_t> tags;
      std::vector<double> coordinates, parametric;
      gmsh::model::mesh::getNodes(tags, coordinates, parametric, dim, entity, false, false);
      if (tags.empty()) continue;
      const auto freedom = find_freedom<D>(dim, entity, nodes);
      for (std::size_t tag : tags) freedoms[nodes.index.at(tag)] = freedom;
    }
  }
  return freedoms;
}

template <int D>
Mesh<D> extract_mesh(const Naming& naming) {
  const Nodes nodes = get_nodes();
  Mesh<D> mesh;
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, D);
  for (const auto& [dim, entity] : entities) {
    const auto simplices = get_simplices<D + 1>(entity, nodes);
    if (simplices.empty()) continue;
    const int region = naming.region(entity, compute_centroid(simplices.front(), nodes));
    mesh.elements.insert(mesh.elements.end(), simplices.begin(), simplices.end());
    mesh.element_region.insert(mesh.element_region.end(), simplices.size(), region);
  }
  if (mesh.elements.empty())
    fail_input("the mesh has no {}, which a {}D case needs", D == 2 ? "triangles" : "tetrahedra", D);
  if constexpr (D == 2) check_plane(mesh, nodes);
  gmsh::model::getEntities(entities, D - 1);
  for (const auto& [dim, entity] : entities) {
    const auto simplices = get_simplices<D>(entity, nodes);
    if (simplices.empty()) continue;
    for (const std::string& name : naming.sides(entity, compute_centroid(simplices.front(), nodes))) {
      auto& side = mesh.sides[name];
      side.insert(side.end(), simplices.begin(), simplices.end());
    }
  }
  for (auto& [name, side] : mesh.sides) {  // two entities of one group may share a side
    for (auto& s : side) std::sort(s.begin(), s.end());
    std::sort(side.begin(), side.end());
    side.erase(std::unique(side.begin(), side.end()), side.end());
  }
  mesh.nodes.resize(nodes.places.size());
  for (std::size_t i = 0; i < nodes.places.size(); ++i) std::copy_n(nodes.places[i].begin(), D, mesh.nodes[i].begin());
  return mesh;
}

template std::vector<Freedom<2>> extract_freedoms<2>();
template std::vector<Freedom<3>> extract_freedoms<3>();
template Mesh<2> extract_mesh<2>(const Naming&);
template Mesh<3> extract_mesh<3>(const Naming&);

}  // namespace talus::mesh

extern "C" std::size_t talus_gmsh_layout() {
  return talus::mesh::gmsh_layout;
}
