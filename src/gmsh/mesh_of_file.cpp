// SPDX-License-Identifier: MIT
// An external mesh in Gmsh's format, whose physical groups are regions and sides.

#include <gmsh.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "gmsh/session.hpp"
#include "mesh/gmsh_module.hpp"

namespace talus::mesh {
namespace {

/// Returns the names of the physical groups of an entity. A group without a name has its number as the name.
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

/// Returns the region names in the order of the group numbers; "empty" is not a region.
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
    fail_input(
        "the element at {} belongs to {} physical groups of dimension {}: each element needs exactly one, named after "
        "its soil or 'empty'",
        format_point(x), groups.empty() ? "no" : std::to_string(groups.size()), dimension);
  if (groups[0] == "empty") return empty_region;
  return static_cast<int>(std::find(regions.begin(), regions.end(), groups[0]) - regions.begin());
}

template <int D>
Mesh<D> read_mesh_file(const std::string& path) {
  const GmshSession session;
  try {
    gmsh::open(path);
  } catch (...) {  // Gmsh throws strings and numbers
    fail_input("mesh file '{}' cannot be read: {}", path, GmshSession::get_last_error());
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
    throw Error(e.code(), "mesh file '{}': {}", path, e.what());
  }
}

}  // namespace
}  // namespace talus::mesh

extern "C" void talus_read_mesh_2(const std::string& path, talus::mesh::Mesh<2>& mesh) {
  mesh = talus::mesh::read_mesh_file<2>(path);
}
extern "C" void talus_read_mesh_3(const std::string& path, talus::mesh::Mesh<3>& mesh) {
  mesh = talus::mesh::read_mesh_file<3>(path);
}
