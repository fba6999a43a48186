// SPDX-License-Identifier: MIT
// Pictures of the stages of construction: the mesh and the fields at their ends.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/user_file.hpp"
#include "report/content/parts.hpp"
#include "results/construction.hpp"
#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// Limit on the elements of all stages together, which would dominate the size of the report.
constexpr std::size_t most_elements = 200000;
/// Fraction of the points of an element from which on it counts as yielding.
constexpr double most_yields = 0.5;

bool has_values(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return v != 0; });
}

json pack_stage(const results::ConstructionFile& file, std::size_t number, Packer& packer) {
  const results::ConstructionFields& stage = file.stages[number];
  const std::size_t nodes = file.nodes.size(), elements = file.elements.size();
  if (stage.displacement_x.size() != nodes || stage.displacement_y.size() != nodes ||
      stage.yields.size() != stage.elements.size())
    throw Error(ExitCode::wrong_input, fmt::format("the fields of stage '{}' do not fit their mesh", stage.stage));
  std::vector<std::uint8_t> state(elements, 0);
  for (std::size_t i = 0; i < stage.elements.size(); ++i) {
    const auto e = static_cast<std::size_t>(stage.elements[i]);
    if (e >= elements)
      throw Error(ExitCode::wrong_input,
                  fmt::format("stage '{}' names the element {} of {}", stage.stage, e, elements));
    state[e] = stage.yields[i] > most_yields ? 2 : 1;
  }
  std::vector<double> displacement;
  for (std::size_t i = 0; i < nodes; ++i)
    displacement.insert(displacement.end(), {stage.displacement_x[i], stage.displacement_y[i]});
  const std::string id = fmt::format("construction.{}", number + 1);
  json packed{{"stage", stage.stage},
              {"state", packer.add_bytes(id + ".state", state, {elements})},
              {"displacement", packer.add_values(id + ".displacement", displacement, {nodes, 2}, false)}};
  if (stage.pressure.size() == nodes && has_values(stage.pressure))
    packed["pressure"] = packer.add_values(id + ".pressure", stage.pressure, {nodes}, false);
  if (stage.excess.size() == nodes && has_values(stage.excess))
    packed["excess"] = packer.add_values(id + ".excess", stage.excess, {nodes}, false);
  return packed;
}

}  // namespace

json pack_stages(const ResultFolder& folder, Packer& packer, json& warnings) {
  if (!folder.run.construction) return {};
  try {
    const auto file = results::read_file<results::ConstructionFile>(join_name(folder.path, "construction.json"));
    if (!file || file->nodes.empty() || file->stages.empty()) return {};
    if (file->elements.empty() || file->elements.size() * file->stages.size() > most_elements) return {};
    std::vector<double> places;
    for (const auto& x : file->nodes) places.insert(places.end(), {x[0], x[1]});
    std::vector<std::uint32_t> corners;
    for (const auto& element : file->elements)
      for (const int node : element) {
        if (node < 0 || static_cast<std::size_t>(node) >= file->nodes.size())
          throw Error(ExitCode::wrong_input,
                      fmt::format("an element names the node {} of {}", node, file->nodes.size()));
        corners.push_back(static_cast<std::uint32_t>(node));
      }
    json stages = json::array();
    for (std::size_t i = 0; i < file->stages.size(); ++i) stages.push_back(pack_stage(*file, i, packer));
    return {{"nodes", packer.add_places("construction.nodes", places, {file->nodes.size(), 2})},
            {"elements", packer.add_numbers("construction.elements", corners, {file->elements.size(), 3}, true)},
            {"stages", std::move(stages)}};
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The stages are not drawn: {}", error.what()));
    return {};
  }
}

}  // namespace talus::report
