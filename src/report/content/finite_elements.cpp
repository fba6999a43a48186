// SPDX-License-Identifier: MIT
#include "report/content/finite_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/file_name.hpp"
#include "report/words/numbers.hpp"
#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// A mesh with more elements would be the largest part of the report, and too fine to be seen.
constexpr std::size_t most_field_elements = 60000;
constexpr std::size_t corners_per_element = 6;

json take_factor(double factor) {
  return factor > 0 ? json(factor) : json();
}

json take_trials(std::vector<results::ElementTrial> trials) {
  std::stable_sort(trials.begin(), trials.end(), [](const auto& a, const auto& b) { return a.factor < b.factor; });
  json list = json::array();
  for (const results::ElementTrial& trial : trials)
    list.push_back({{"factor", trial.factor},
                    {"converged", trial.converged},
                    {"iterations", trial.iterations},
                    {"force_residual", keep_finite(trial.force_residual)},
                    {"displacement_residual", keep_finite(trial.displacement_residual)},
                    {"displacement", keep_finite(trial.displacement)},
                    {"seconds", trial.seconds}});
  return list;
}

json take_run(const results::ElementRun& run) {
  json taken{{"flow", results::to_word(run.flow)},
             {"title", run.flow == results::Flow::associated ? "associated flow, ψ = φ" : "ψ as given"},
             {"psi", run.psi},
             {"trials", take_trials(run.trials)},
             {"slip_lines", json::array()},
             {"warnings", run.warnings},
             {"factor", take_factor(run.factor)},
             {"stable", take_factor(run.stable)},
             {"failed", take_factor(run.failed)},
             {"by_displacement", take_factor(run.by_displacement.value_or(0))},
             {"lower", run.interval ? json(results::show_lower(run.interval->lower)) : json()},
             {"upper", run.interval ? json(results::show_upper(run.interval->upper)) : json()}};
  if (run.sides)
    for (const results::SideLine& side : *run.sides) taken["slip_lines"].push_back(side.points);
  else if (!run.slip_line.empty())
    taken["slip_lines"].push_back(run.slip_line);
  return taken;
}

/// Limits of the colours: the largest strain of all but the most strained hundredth of the nodes.
std::vector<double> find_strain_scale(std::vector<double> strain) {
  if (strain.empty()) return {0, 1};
  const auto at = strain.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(strain.size() - 1));
  std::nth_element(strain.begin(), at, strain.end());
  return {0, *at > 0 ? *at : 1};
}

/// `rows` one after the other; throws Error (wrong_input) where one is not `width` long.
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

/// The mesh; null where it cannot be drawn.
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

/// The fields of one strength reduction; null where the file has none of this mesh.
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

json make_finite_elements(const ResultFolder& folder, Packer& packer, json& warnings) {
  if (!folder.run.elements) return {};
  const results::ElementResult& fem = *folder.run.elements;
  json block{{"element", fem.element.empty() ? "T6" : fem.element},
             {"elements", fem.elements},
             {"nodes", fem.nodes},
             {"unknowns", fem.unknowns},
             {"size", fem.size},
             {"seconds", fem.seconds.value_or(0)},
             {"runs", json::array()}};
  if (fem.error) block["error"] = *fem.error;
  for (const results::ElementRun& run : fem.runs) block["runs"].push_back(take_run(run));
  try {
    const auto file = results::read_file<results::ElementFile>(
        join_name(folder.path, fem.fields_file.empty() ? "fem.json" : fem.fields_file));
    json mesh = file ? pack_mesh(file->mesh, packer) : json();
    if (mesh.is_null()) return block;
    block["mesh"] = std::move(mesh);
    for (std::size_t i = 0; i < fem.runs.size(); ++i)
      if (json fields = pack_fields(file->mesh, fem.runs[i].flow, packer); !fields.is_null())
        block["runs"][i]["fields"] = std::move(fields);
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The finite elements are not drawn: {}", error.what()));
  }
  return block;
}

}  // namespace talus::report
