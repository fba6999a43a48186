// SPDX-License-Identifier: MIT
#include "mesh/split.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "base/error.hpp"

namespace talus::mesh {

namespace {

using Edge = std::pair<int, int>;
using Elements = std::vector<std::array<int, 3>>;

std::set<Edge> sort_edges(const Cuts& cuts) {
  std::set<Edge> edges;
  for (const auto& [a, b] : cuts) edges.insert(std::minmax(a, b));
  return edges;
}

/// Returns the number of the sector of each element around a node.
std::vector<std::size_t> find_sectors(int node, const std::vector<std::size_t>& star, const Elements& elements,
                                      const std::set<Edge>& edges) {
  std::vector<std::size_t> sector(star.size());
  std::iota(sector.begin(), sector.end(), 0);
  // The far ends of the edges at the node that are no cuts join its elements to sectors.
  std::map<int, std::size_t> seen;
  for (std::size_t s = 0; s < star.size(); ++s)
    for (const int far : elements[star[s]]) {
      if (far == node || edges.contains(std::minmax(node, far))) continue;
      const auto [other, is_new] = seen.try_emplace(far, s);
      if (is_new) continue;
      const std::size_t from = sector[s], to = sector[other->second];
      std::replace(sector.begin(), sector.end(), std::max(from, to), std::min(from, to));
    }
  return sector;
}

/// Returns the sides of a cut mesh by their edges as given: those of soil, of air where there is no soil.
std::map<Edge, std::vector<Mesh<2>::Side>> map_sides(const Elements& given, const Mesh<2>& mesh) {
  std::map<Edge, std::vector<Mesh<2>::Side>> now;
  for (const bool of_soil : {true, false})
    for (std::size_t e = 0; e < given.size(); ++e) {
      if ((mesh.element_region[e] != empty_region) != of_soil) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const bool is_forward = given[e][i] < given[e][j];
        const std::size_t low = is_forward ? i : j, high = is_forward ? j : i;
        std::vector<Mesh<2>::Side>& sides = now[{given[e][low], given[e][high]}];
        const Mesh<2>::Side side{mesh.elements[e][low], mesh.elements[e][high]};
        const bool is_known = std::find(sides.begin(), sides.end(), side) != sides.end();
        if (!is_known && (of_soil || sides.empty())) sides.push_back(side);
      }
    }
  return now;
}

}  // namespace

std::vector<DoubledNode> list_doubles(const Elements& elements, const Cuts& cuts) {
  std::map<int, std::vector<std::size_t>> stars;  // elements at each node of the cuts
  for (const auto& cut : cuts)
    for (const int node : cut) stars[node];
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (const int node : elements[e])
      if (const auto star = stars.find(node); star != stars.end()) star->second.push_back(e);
  const std::set<Edge> edges = sort_edges(cuts);
  std::vector<DoubledNode> doubles;
  for (const auto& [node, star] : stars) {
    const std::vector<std::size_t> sector = find_sectors(node, star, elements, edges);
    std::map<std::size_t, std::size_t> own;  // sector → its entry
    for (std::size_t s = 0; s < star.size(); ++s) {
      if (sector[s] == sector[0]) continue;
      const auto [entry, is_new] = own.try_emplace(sector[s], doubles.size());
      if (is_new) doubles.push_back({node, {}});
      doubles[entry->second].elements.push_back(star[s]);
    }
  }
  return doubles;
}

Mesh<2> split(Mesh<2> mesh, const Cuts& cuts, const std::string& name) {
  const Elements given = mesh.elements;
  const auto is_soil = [&](std::size_t e) { return mesh.element_region[e] != empty_region; };
  Elements soil = given;  // air around the head of a wall does not join its sides
  for (std::size_t e = 0; e < soil.size(); ++e)
    if (!is_soil(e)) soil[e].fill(-1);
  for (const DoubledNode& doubled : list_doubles(soil, cuts)) {
    const int own = mesh.node_count();
    mesh.nodes.push_back(mesh.nodes[static_cast<std::size_t>(doubled.node)]);
    for (const std::size_t e : doubled.elements)
      std::replace(mesh.elements[e].begin(), mesh.elements[e].end(), doubled.node, own);
  }
  const auto now = map_sides(given, mesh);

  for (auto& [key, list] : mesh.sides) {
    std::vector<Mesh<2>::Side> renewed;
    for (const Mesh<2>::Side& side : list) {
      const auto found = now.find(std::minmax(side[0], side[1]));
      if (found == now.end())
        renewed.push_back(side);
      else
        for (const auto& [low, high] : found->second)
          renewed.push_back(side[0] < side[1] ? Mesh<2>::Side{low, high} : Mesh<2>::Side{high, low});
    }
    list = std::move(renewed);
  }
  std::vector<Mesh<2>::Side>& cut_sides = mesh.sides[name];
  for (const Edge& edge : sort_edges(cuts))
    if (const auto found = now.find(edge); found != now.end())
      cut_sides.insert(cut_sides.end(), found->second.begin(), found->second.end());
  finish(mesh, Order::as_given);
  std::set<Edge> kept;
  for (const Mesh<2>::Side& side : cut_sides) kept.insert(std::minmax(side[0], side[1]));
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = mesh.elements[e][(k + 1) % 3], b = mesh.elements[e][(k + 2) % 3];
      const int behind = mesh.neighbours[e][k];
      if (behind >= 0 && is_soil(e) && is_soil(static_cast<std::size_t>(behind)) && kept.contains(std::minmax(a, b)))
        throw Error(
            ExitCode::wrong_input,
            "a wall inside the soil is one element long, which lets water pass: give a smaller 'size' in [mesh]");
    }
  return mesh;
}

}  // namespace talus::mesh
