#include "report/content/finite_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "base/error.hpp"
#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// A mesh with more elements would be the largest part of the report, and too fine to be seen.
constexpr std::size_t most_drawn_elements = 60000;
constexpr std::size_t corners = 6;

json take_factor(const json& node, const char* key) {
  const auto value = find_number(node, {key});
  return value && *value > 0 ? json(*value) : json();
}

json take_trials(const json& run) {
  json trials = json::array();
  for (const json& trial : find_list(run, {"trials"})) {
    json row{{"converged", trial.value("converged", false)}};
    for (const char* key :
         {"factor", "iterations", "force_residual", "displacement_residual", "displacement", "seconds"})
      row[key] = get_number(trial, {key});
    trials.push_back(std::move(row));
  }
  std::stable_sort(trials.begin(), trials.end(),
                   [](const json& a, const json& b) { return a["factor"].get<double>() < b["factor"].get<double>(); });
  return trials;
}

json take_run(const json& run) {
  const std::string flow = get_text(run, {"flow"});
  json taken{{"flow", flow},
             {"title", flow == "associated" ? "associated flow, ψ = φ" : "ψ as given"},
             {"psi", find_list(run, {"psi"})},
             {"trials", take_trials(run)},
             {"slip_line", find_list(run, {"slip_line"})},
             {"warnings", find_list(run, {"warnings"})}};
  for (const char* key : {"factor", "stable", "failed", "by_displacement"}) taken[key] = take_factor(run, key);
  return taken;
}

/// Limits of the colours: the largest strain of all but the most strained hundredth of the nodes.
std::vector<double> find_strain_scale(std::vector<double> strain) {
  if (strain.empty()) return {0, 1};
  const auto at = strain.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(strain.size() - 1));
  std::nth_element(strain.begin(), at, strain.end());
  return {0, *at > 0 ? *at : 1};
}

std::vector<double> gather(const json& list, std::size_t width) {
  std::vector<double> values;
  values.reserve(list.size() * width);
  for (const json& row : list)
    for (std::size_t k = 0; k < width; ++k) values.push_back((width == 1 ? row : row.at(k)).get<double>());
  return values;
}

/// The mesh; null where it cannot be drawn.
json pack_mesh(const json& file, Packer& packer) {
  const json &nodes = find_list(file, {"nodes"}), &elements = find_list(file, {"elements"});
  if (nodes.empty() || elements.empty() || elements.size() > most_drawn_elements || nodes[0].size() != 2 ||
      elements[0].size() != corners)
    return {};
  std::vector<std::uint32_t> cells;
  cells.reserve(elements.size() * corners);
  for (const json& element : elements)
    for (const json& node : element) {
      cells.push_back(node.get<std::uint32_t>());
      if (cells.back() >= nodes.size())
        throw Error(ExitCode::wrong_input,
                    fmt::format("an element names the node {} of {}", cells.back(), nodes.size()));
    }
  return {{"nodes", packer.add_reals("fem.nodes", gather(nodes, 2), {nodes.size(), 2})},
          {"elements", packer.add_numbers("fem.elements", cells, {elements.size(), corners}, true)}};
}

void add_fields(const json& file, json& runs, std::size_t nodes, std::size_t elements, Packer& packer) {
  for (json& run : runs)
    for (const json& fields : find_list(file, {"runs"})) {
      if (get_text(fields, {"flow"}) != run["flow"]) continue;
      const json &displacement = find_list(fields, {"displacement"}), &strain = find_list(fields, {"shear_strain"}),
                 &yields = find_list(fields, {"yields"});
      if (displacement.size() != nodes || strain.size() != nodes || yields.size() != elements) continue;
      const std::string id = "fem." + run["flow"].get<std::string>();
      const std::vector<double> strains = gather(strain, 1);
      std::vector<std::uint8_t> plastic;
      for (const json& y : yields) plastic.push_back(y.is_boolean() ? y.get<bool>() : y.get<double>() != 0);
      run["fields"] = {
          {"displacement", packer.add_values(id + ".displacement", gather(displacement, 2), {nodes, 2}, false)},
          {"shear_strain", packer.add_values(id + ".shear_strain", strains, {nodes}, false)},
          {"strain_scale", find_strain_scale(strains)},
          {"yields", packer.add_bytes(id + ".yields", plastic, {elements})}};
      break;
    }
}

}  // namespace

json make_finite_elements(const ResultFolder& folder, Packer& packer, json& warnings) {
  const json* fem = find(folder.summary, {"fem"});
  if (fem == nullptr || !fem->is_object()) return {};
  json block{{"element", get_text(*fem, {"element"}, "T6")}, {"runs", json::array()}};
  for (const char* key : {"elements", "nodes", "unknowns", "size", "seconds"}) block[key] = get_number(*fem, {key});
  if (const std::string error = get_text(*fem, {"error"}); !error.empty()) block["error"] = error;
  for (const json& run : find_list(*fem, {"runs"})) block["runs"].push_back(take_run(run));
  try {
    const json file = read_json(folder.path / get_text(*fem, {"fields_file"}, "fem.json"));
    if (json mesh = pack_mesh(file, packer); !mesh.is_null()) {
      block["mesh"] = std::move(mesh);
      add_fields(file, block["runs"], find_list(file, {"nodes"}).size(), find_list(file, {"elements"}).size(), packer);
    }
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The finite elements are not drawn: {}", error.what()));
  }
  return block;
}

}  // namespace talus::report
