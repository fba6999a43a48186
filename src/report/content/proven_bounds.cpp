// SPDX-License-Identifier: MIT
#include "report/content/proven_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/file_name.hpp"
#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// A mesh with more triangles would be the largest part of the report, and too fine to be seen.
constexpr std::size_t most_field_triangles = 60000;
constexpr std::size_t components = 3;  ///< xx, yy, xy

json write_lower(std::optional<double> value) {
  return value ? json(results::show_lower(*value)) : json();
}
json write_upper(std::optional<double> value) {
  return value ? json(results::show_upper(*value)) : json();
}

std::vector<double> join_places(const std::vector<results::Point>& places) {
  std::vector<double> values;
  values.reserve(2 * places.size());
  for (const results::Point& x : places) values.insert(values.end(), {x[0], x[1]});
  return values;
}

/// `width` numbers of nodes of each triangle; throws Error (wrong_input) where one is no number of a node.
std::vector<std::uint32_t> join_triangles(const std::vector<std::vector<int>>& triangles, std::size_t width,
                                          std::size_t nodes) {
  std::vector<std::uint32_t> values;
  values.reserve(width * triangles.size());
  for (const std::vector<int>& triangle : triangles) {
    if (triangle.size() != width)
      throw Error(ExitCode::wrong_input, fmt::format("a triangle has {} nodes instead of {}", triangle.size(), width));
    for (const int node : triangle) {
      if (node < 0 || static_cast<std::size_t>(node) >= nodes)
        throw Error(ExitCode::wrong_input, fmt::format("a triangle names the node {} of {}", node, nodes));
      values.push_back(static_cast<std::uint32_t>(node));
    }
  }
  return values;
}

bool can_be_drawn(std::size_t triangles, std::size_t values) {
  return triangles > 0 && triangles <= most_field_triangles && values == triangles;
}

/// The stress field: in the middle of each triangle.
json pack_holding(const results::HoldingField& field, Packer& packer) {
  const std::size_t triangles = field.triangles.size();
  if (!can_be_drawn(triangles, field.utilisation.size()) || field.stress.size() != triangles) return {};
  std::vector<double> stress;
  for (const std::vector<double>& corners : field.stress) {
    if (corners.size() != 3 * components)
      throw Error(ExitCode::wrong_input, fmt::format("the stresses of a triangle have {} numbers", corners.size()));
    for (std::size_t d = 0; d < components; ++d)
      stress.push_back((corners[d] + corners[components + d] + corners[2 * components + d]) / 3);
  }
  return {
      {"nodes", packer.add_places("bounds.holds.nodes", join_places(field.nodes), {field.nodes.size(), 2})},
      {"triangles", packer.add_numbers("bounds.holds.triangles", join_triangles(field.triangles, 3, field.nodes.size()),
                                       {triangles, 3}, true)},
      {"stress", packer.add_values("bounds.holds.stress", stress, {triangles, components}, false)},
      {"utilisation", packer.add_values("bounds.holds.utilisation", field.utilisation, {triangles}, false)}};
}

/// The velocity field.
json pack_moving(const results::MovingField& field, Packer& packer) {
  constexpr std::size_t nodes_of_triangle = 6;
  const std::size_t triangles = field.triangles.size(), nodes = field.nodes.size();
  if (!can_be_drawn(triangles, field.shear_rate.size()) || field.velocity.size() != nodes) return {};
  return {{"nodes", packer.add_places("bounds.moves.nodes", join_places(field.nodes), {nodes, 2})},
          {"triangles",
           packer.add_numbers("bounds.moves.triangles", join_triangles(field.triangles, nodes_of_triangle, nodes),
                              {triangles, nodes_of_triangle}, true)},
          {"velocity", packer.add_values("bounds.moves.velocity", join_places(field.velocity), {nodes, 2}, false)},
          {"shear_rate", packer.add_values("bounds.moves.shear_rate", field.shear_rate, {triangles}, false)}};
}

}  // namespace

json make_proven_bounds(const ResultFolder& folder, Packer& packer, json& warnings) {
  if (!folder.run.bounds) return {};
  const results::BoundsResult& bounds = *folder.run.bounds;
  json block{{"lower", write_lower(bounds.lower)},
             {"upper", write_upper(bounds.upper)},
             {"no_lower", bounds.no_lower},
             {"no_upper", bounds.no_upper},
             {"asked_gap", bounds.asked_gap},
             {"is_davis", bounds.is_davis},
             {"takes_tension", bounds.takes_tension},
             {"seconds", bounds.seconds.value_or(0)},
             {"meshes", json::array()},
             {"slip_lines", json::array()}};
  if (bounds.error) block["error"] = *bounds.error;
  for (const results::BoundsMesh& mesh : bounds.meshes)
    block["meshes"].push_back({{"triangles", mesh.triangles},
                               {"lower", write_lower(mesh.lower)},
                               {"upper", write_upper(mesh.upper)},
                               {"programs", mesh.programs},
                               {"iterations", mesh.iterations},
                               {"seconds", mesh.seconds}});
  if (bounds.sides)
    for (const results::SideLine& side : *bounds.sides) block["slip_lines"].push_back(side.points);
  if (bounds.fields_file.empty()) return block;
  try {
    const auto file = results::read_file<results::BoundsFile>(join_name(folder.path, bounds.fields_file));
    if (!file) return block;
    if (json field = pack_holding(file->holds, packer); !field.is_null()) block["holds"] = std::move(field);
    if (json field = pack_moving(file->moves, packer); !field.is_null()) block["moves"] = std::move(field);
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The fields of the proven bounds are not drawn: {}", error.what()));
  }
  return block;
}

}  // namespace talus::report
