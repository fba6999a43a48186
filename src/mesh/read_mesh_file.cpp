// SPDX-License-Identifier: MIT
// A ready mesh in Gmsh's format: its physical groups are regions and sides.

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "mesh/gmsh_mesh.hpp"
#include "mesh/gmsh_session.hpp"

namespace talus::mesh {
namespace {

/// Names of the physical groups that an entity is part of. A group without a name is called by its number.
std::vector<std::string> get_group_names(int dimension, int entity) {
  std::vector<int> tags;
  gmsh::model::getPhysicalGroupsForEntity(dimension, entity, tags);
  std::vector<std::string> names;
  for (int tag : tags) {
    std::string name;
    gmsh::model::getPhysicalName(dimension, tag, name);
    names.push_back(name.empty() ? std::to_string(tag) : name);
  }
  return names;
}

/// Region names in the order of the groups' numbers; "empty" is none.
std::vector<std::string> get_region_names(int dimension) {
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, dimension);
  std::vector<std::string> names;
  for (const auto& [dim, tag] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dim, tag, name);
    if (name.empty()) name = std::to_string(tag);
    if (name != "empty" && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

int find_region(const std::vector<std::string>& regions, int dimension, int entity, const std::array<double, 3>& x) {
  const auto groups = get_group_names(dimension, entity);
  if (groups.size() != 1)
    throw Error(ExitCode::wrong_input,
                fmt::format("the element at {} belongs to {} physical groups of "
                            "dimension {}: each element needs exactly one, named after its soil or 'empty'",
                            format_point(x), groups.empty() ? "no" : std::to_string(groups.size()), dimension));
  if (groups[0] == "empty") return empty_region;
  return static_cast<int>(std::find(regions.begin(), regions.end(), groups[0]) - regions.begin());
}

}  // namespace

template <int D>
Mesh<D> read_mesh_file(const std::string& path) {
  const GmshSession session;
  try {
    gmsh::open(path);
  } catch (...) {  // Gmsh throws strings and numbers
    throw Error(ExitCode::wrong_input,
                fmt::format("mesh file '{}' cannot be read: {}", path, GmshSession::get_last_error()));
  }
  const auto regions = get_region_names(D);
  Naming naming;
  naming.region = [&](int entity, const std::array<double, 3>& x) { return find_region(regions, D, entity, x); };
  naming.sides = [&](int entity, const std::array<double, 3>&) { return get_group_names(D - 1, entity); };
  try {
    Mesh<D> mesh = extract_mesh<D>(naming);
    mesh.region_names = regions;
    return mesh;
  } catch (const Error& e) {
    throw Error(e.code(), fmt::format("mesh file '{}': {}", path, e.what()));
  }
}

template Mesh<2> read_mesh_file<2>(const std::string&);
template Mesh<3> read_mesh_file<3>(const std::string&);

}  // namespace talus::mesh
