// SPDX-License-Identifier: MIT
#include "report/content/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/user_file.hpp"
#include "report/folder/numbers.hpp"
#include "results/governing.hpp"
#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// Returns the number of the governing surface among the critical, noncircular, given and optimised ones.
std::optional<std::size_t> find_governing(const results::RunResult& run) {
  const auto governing = results::find_governing_surface(run);
  if (!governing) return std::nullopt;
  static const std::vector<results::CriticalSurface> none;
  std::size_t number = 0;
  for (const auto* list : {&run.slices->critical, &run.slices->noncircular, &run.slices->given,
                           run.methods ? &run.methods->optimised : &none})
    for (const results::CriticalSurface& found : *list) {
      if (&found == governing->found) return number;
      ++number;
    }
  return std::nullopt;
}

json pack_trials(const results::SliceTrials& file, Packer& packer) {
  const std::size_t methods = file.methods.size(), count = file.trials.size();
  if (count == 0 || methods == 0) return {};
  std::vector<double> circles, factors;
  for (const std::vector<double>& trial : file.trials) {
    if (trial.size() < 5 + methods) throw Error(ExitCode::wrong_input, "a trial is shorter than the others");
    circles.insert(circles.end(), trial.begin(), trial.begin() + 5);
    for (std::size_t k = 0; k < methods; ++k) factors.push_back(keep_finite(trial[5 + k]));
  }
  return {{"count", count},
          {"methods", file.methods},
          {"circles", packer.add_places("lem.circles", circles, {count, 5})},
          {"factors", packer.add_reals("lem.factors", factors, {count, methods})}};
}

json pack_maps(const results::SliceTrials& file, Packer& packer) {
  json list = json::array();
  for (const auto& [method, map] : file.maps) {
    const auto columns = static_cast<std::size_t>(map.columns), rows = static_cast<std::size_t>(map.rows);
    if (columns * rows == 0 || map.factor.size() != columns * rows) continue;
    std::vector<double> factors;
    for (const std::optional<double>& v : map.factor) factors.push_back(v.value_or(0));
    list.push_back({{"method", method},
                    {"from", map.from},
                    {"to", map.to},
                    {"columns", columns},
                    {"rows", rows},
                    {"factor", packer.add_reals("lem.map." + method, factors, {rows, columns})}});
  }
  return list;
}

}  // namespace

json pack_slices(const ResultFolder& folder, Packer& packer, json& warnings) {
  if (!folder.run.slices) return {};
  const results::SliceResult& lem = *folder.run.slices;
  json slices{{"maps", json::array()}};
  if (lem.drawdown) slices["drawdown"] = get_title(*lem.drawdown);
  if (const auto governing = find_governing(folder.run)) slices["governing"] = *governing;
  try {
    const auto file =
        results::read_file<results::SliceFile>(join_name(folder.path, lem.trials_file.value_or("lem.json")));
    if (!file || !file->trials) return slices;
    if (json trials = pack_trials(*file->trials, packer); !trials.is_null()) slices["trials"] = std::move(trials);
    slices["maps"] = pack_maps(*file->trials, packer);
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The trial surfaces are not shown: {}", error.what()));
  }
  return slices;
}

namespace {

/// Limit on the mesh in the report; a finer mesh would dominate the file size and could not be resolved on the page.
constexpr std::size_t most_field_elements = 60000;
constexpr std::size_t corners_per_element = 6;

/// Returns the limits of the colour scale from 0 to the 99th percentile of the nodal shear strain.
std::vector<double> find_strain_scale(std::vector<double> strain) {
  if (strain.empty()) return {0, 1};
  const auto at = strain.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(strain.size() - 1));
  std::nth_element(strain.begin(), at, strain.end());
  return {0, *at > 0 ? *at : 1};
}

/// Concatenates `rows`; throws Error (wrong_input) if a row has not the length `width`.
template <class T, class To>
std::vector<To> join_rows(const std::vector<std::vector<T>>& rows, std::size_t width) {
  std::vector<To> values;
  values.reserve(rows.size() * width);
  for (const std::vector<T>& row : rows) {
    if (row.size() != width)
      throw Error(ExitCode::wrong_input, fmt::format("a row has {} numbers instead of {}", row.size(), width));
    for (const T& value : row) values.push_back(static_cast<To>(value));
  }
  return values;
}

/// Packs the mesh; returns null if it cannot be drawn.
json pack_mesh(const results::ElementMesh& file, Packer& packer) {
  const std::size_t nodes = file.nodes.size(), elements = file.elements.size();
  if (nodes == 0 || elements == 0 || elements > most_field_elements || file.nodes[0].size() != 2 ||
      file.elements[0].size() != corners_per_element)
    return {};
  const auto cells = join_rows<int, std::uint32_t>(file.elements, corners_per_element);
  for (const std::uint32_t node : cells)
    if (node >= nodes)
      throw Error(ExitCode::wrong_input, fmt::format("an element names the node {} of {}", node, nodes));
  return {{"nodes", packer.add_places("fem.nodes", join_rows<double, double>(file.nodes, 2), {nodes, 2})},
          {"elements", packer.add_numbers("fem.elements", cells, {elements, corners_per_element}, true)}};
}

/// Packs the fields of one strength reduction; returns null if the file has none for this mesh.
json pack_fields(const results::ElementMesh& file, results::Flow flow, Packer& packer) {
  const std::size_t nodes = file.nodes.size(), elements = file.elements.size();
  for (const results::ElementFields& fields : file.runs) {
    if (fields.flow != flow || fields.displacement.size() != nodes || fields.shear_strain.size() != nodes ||
        fields.yields.size() != elements)
      continue;
    const std::string id = fmt::format("fem.{}", results::to_word(flow));
    const auto displacement = join_rows<double, double>(fields.displacement, 2);
    const std::vector<std::uint8_t> yields(fields.yields.begin(), fields.yields.end());
    return {{"displacement", packer.add_values(id + ".displacement", displacement, {nodes, 2}, false)},
            {"shear_strain", packer.add_values(id + ".shear_strain", fields.shear_strain, {nodes}, false)},
            {"strain_scale", find_strain_scale(fields.shear_strain)},
            {"yields", packer.add_bytes(id + ".yields", yields, {elements})}};
  }
  return {};
}

}  // namespace

json pack_finite_elements(const ResultFolder& folder, Packer& packer, json& warnings) {
  if (!folder.run.elements) return {};
  const results::ElementResult& fem = *folder.run.elements;
  try {
    const auto file = results::read_file<results::ElementFile>(
        join_name(folder.path, fem.fields_file.empty() ? "fem.json" : fem.fields_file));
    json mesh = file ? pack_mesh(file->mesh, packer) : json();
    if (mesh.is_null()) return {};
    json fields = json::array();
    for (const results::ElementRun& run : fem.runs) fields.push_back(pack_fields(file->mesh, run.flow, packer));
    return {{"mesh", std::move(mesh)}, {"fields", std::move(fields)}};
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The fields of FEM are not drawn: {}", error.what()));
    return {};
  }
}

json pack_reduction(const ResultFolder& folder, Packer& packer) {
  if (!folder.reduction) return {};
  const results::PresentReduction& reduction = *folder.reduction;
  json block{{"title", reduction.title}, {"trials", json::array()}};
  if (reduction.stable) block["stable"] = *reduction.stable;
  if (reduction.failed) block["failed"] = *reduction.failed;
  for (const results::ElementTrial& trial : reduction.trials) block["trials"].push_back(results::to_json(trial));
  json mesh = pack_mesh(reduction.mesh, packer);
  if (mesh.is_null()) return block;
  json fields = pack_fields(reduction.mesh, results::Flow::as_given, packer);
  if (fields.is_null()) return block;
  block["mesh"] = std::move(mesh);
  block["fields"] = std::move(fields);
  return block;
}

namespace {

/// Limit on the mesh in the report; a finer mesh would dominate the file size and could not be resolved on the page.
constexpr std::size_t most_field_triangles = 60000;
constexpr std::size_t components = 3;  ///< xx, yy, xy

std::vector<double> join_places(const std::vector<results::Point>& places) {
  std::vector<double> values;
  values.reserve(2 * places.size());
  for (const results::Point& x : places) values.insert(values.end(), {x[0], x[1]});
  return values;
}

/// Concatenates `width` node numbers of each triangle; throws Error (wrong_input) for an invalid node number.
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

/// Packs the stress field of the lower bound, averaged over each triangle.
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

/// Packs the velocity field of the upper bound.
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

json pack_proven_bounds(const ResultFolder& folder, Packer& packer, json& warnings) {
  if (!folder.run.bounds || folder.run.bounds->fields_file.empty()) return {};
  json block;
  try {
    const auto file = results::read_file<results::BoundsFile>(join_name(folder.path, folder.run.bounds->fields_file));
    if (!file) return block;
    if (json field = pack_holding(file->holds, packer); !field.is_null()) block["holds"] = std::move(field);
    if (json field = pack_moving(file->moves, packer); !field.is_null()) block["moves"] = std::move(field);
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The fields of limit analysis are not drawn: {}", error.what()));
  }
  return block;
}

}  // namespace talus::report
