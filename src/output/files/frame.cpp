// SPDX-License-Identifier: MIT
#include "output/files/frame.hpp"

#include <fmt/format.h>

#include <set>

#include "base/error.hpp"

namespace talus::output {
namespace {

[[noreturn]] void fail(const std::string& sentence) {
  throw Error(ExitCode::internal_error, sentence);
}

void check_length(const std::string& what, std::size_t have, std::size_t want) {
  if (have != want) fail(fmt::format("a frame's {} has {} values where {} were expected", what, have, want));
}

void check_fields(const std::vector<Field>& fields, std::size_t items, std::set<std::string> taken) {
  for (const Field& field : fields) {
    if (field.name.empty() || field.name.find('/') != std::string::npos)
      fail(fmt::format("'{}' cannot be the name of a field: it is empty or holds '/'", field.name));
    if (!taken.insert(field.name).second) fail(fmt::format("a frame has two fields called '{}'", field.name));
    if (field.components < 1) fail(fmt::format("the field '{}' has no components", field.name));
    check_length("field '" + field.name + "'", field.values.size(), items * static_cast<std::size_t>(field.components));
  }
}

}  // namespace

void check(const Frame& frame) {
  if (frame.positions.size() % 3 != 0) fail("a frame's positions are not three coordinates a point");
  const std::size_t points = frame.positions.size() / 3;
  check_length("ids", frame.ids.size(), points);
  check_length("materials", frame.materials.size(), points);
  check_fields(frame.point_fields, points, {"id", "material"});
  if (!frame.mesh) return;
  const MeshFrame& mesh = *frame.mesh;
  if (mesh.nodes_per_element != 3 && mesh.nodes_per_element != 4)
    fail(fmt::format("elements with {} nodes cannot be stored: only 3 and 4 are known", mesh.nodes_per_element));
  if (mesh.nodes.size() % 3 != 0) fail("a mesh's nodes are not three coordinates a node");
  const std::size_t per_element = static_cast<std::size_t>(mesh.nodes_per_element);
  if (mesh.elements.size() % per_element != 0) fail("a mesh's elements are not complete");
  check_fields(mesh.element_fields, mesh.elements.size() / per_element, {});
  check_fields(mesh.node_fields, mesh.nodes.size() / 3, {});
}

const Field* find(const std::vector<Field>& fields, const std::string& name) {
  for (const Field& field : fields)
    if (field.name == name) return &field;
  return nullptr;
}

}  // namespace talus::output
