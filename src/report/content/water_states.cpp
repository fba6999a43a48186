// SPDX-License-Identifier: MIT
#include "report/content/parts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "report/folder/numbers.hpp"
#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;
using results::WaterFlow;

namespace {

constexpr double hour = 3600, day = 86400;

/// Packs the values of a field; returns null if their number does not match the mesh.
json pack_field(const results::WaterFields& file, const results::WaterField& field, const std::string& name,
                Packer& packer) {
  const std::size_t nodes = file.nodes.size(), elements = file.elements.size();
  if (field.pressure.size() != nodes) return {};
  json packed{{"pressure", packer.add_values(name + ".pressure", field.pressure, {nodes}, false)}};
  if (field.saturation.size() == elements)
    packed["saturation"] = packer.add_values(name + ".saturation", field.saturation, {elements}, false);
  if (field.velocity.size() == elements) {
    std::vector<double> velocity;
    for (const std::vector<double>& v : field.velocity) velocity.insert(velocity.end(), v.begin(), v.end());
    if (velocity.size() == 2 * elements)
      packed["velocity"] = packer.add_reals(name + ".velocity", velocity, {elements, 2});
  }
  return packed;
}

}  // namespace

json pack_water_mesh(const results::WaterFields& file, const std::string& name, Packer& packer) {
  std::vector<double> nodes;
  std::vector<std::uint32_t> elements;
  for (const results::Point& x : file.nodes) nodes.insert(nodes.end(), x.begin(), x.end());
  for (const std::vector<int>& element : file.elements) {
    if (element.size() != 3) throw Error(ExitCode::wrong_input, "an element has other than three nodes");
    for (const int node : element) {
      if (node < 0 || static_cast<std::size_t>(node) >= file.nodes.size())
        throw Error(ExitCode::wrong_input, fmt::format("an element names the node {} of {}", node, file.nodes.size()));
      elements.push_back(static_cast<std::uint32_t>(node));
    }
  }
  return {{"unit_weight", file.unit_weight},
          {"nodes", packer.add_places(name + ".nodes", nodes, {file.nodes.size(), 2})},
          {"elements", packer.add_numbers(name + ".elements", elements, {file.elements.size(), 3}, true)}};
}

json pack_water_field(const results::WaterFields& file, const results::WaterState& state, const std::string& name,
                      Packer& packer) {
  for (const results::WaterField& field : file.states)
    if (field.time == state.time && field.flow == state.flow) return pack_field(file, field, name, packer);
  return {};
}

std::string show_duration(double seconds) {
  const double unit = seconds >= day ? day : seconds >= hour ? hour : 1;
  const std::string number = show_number(seconds / unit);
  const bool one = number == "1";
  if (unit == 1) return number + " s";
  return fmt::format("{} {}{}", number, unit == day ? "day" : "hour", one ? "" : "s");
}

std::string name_water_state(const results::WaterState& state, bool is_last) {
  const std::string before = state.time < 0 ? show_duration(-state.time) + " before the start" : "";
  switch (state.flow) {
    case WaterFlow::hydrostatic:
      return before.empty() ? "water at rest under the table of the case" : "water at rest, " + before;
    case WaterFlow::steady:
      return before.empty() ? "steady seepage" : "steady seepage, " + before;
    case WaterFlow::lowered:
      return "water table after drawdown, of soil that drains";
    case WaterFlow::transient:
      break;
  }
  return is_last ? "transient seepage, at the start" : "transient seepage, " + before;
}

std::vector<results::WaterState> find_water_states(const ResultFolder& folder) {
  if (folder.run.water_states) return *folder.run.water_states;
  const input::InitialWater& initial = folder.data.initial.water;
  if (get_dimension(folder.run) != 2 || initial.pressure != input::InitialPressure::water_table ||
      initial.water_table.empty())
    return {};
  results::WaterState state;
  state.water_table = {{initial.water_table.begin(), initial.water_table.end()}};
  return {state};
}

json list_water_states(const ResultFolder& folder) {
  const std::vector<results::WaterState> states = find_water_states(folder);
  json list = json::array();
  for (std::size_t i = 0; i < states.size(); ++i)
    list.push_back({{"title", name_water_state(states[i], i + 1 == states.size())}});
  return list;
}

void add_water_fields(const ResultFolder& folder, json& document, Packer& packer) {
  try {
    const auto file = results::read_file<results::WaterFields>(folder.path / "water.json");
    if (!file || file->nodes.empty() || file->elements.empty()) return;
    json mesh = pack_water_mesh(*file, "water", packer), list = list_water_states(folder);
    const std::vector<results::WaterState> states = find_water_states(folder);
    for (std::size_t i = 0; i < states.size(); ++i)
      if (json packed = pack_water_field(*file, states[i], fmt::format("water.{}", i), packer); !packed.is_null())
        list[i]["fields"] = std::move(packed);
    document["model"]["water_mesh"] = std::move(mesh);
    document["model"]["water"] = std::move(list);
  } catch (const Error& error) {
    document["warnings"].push_back(fmt::format("The fields of the pore water are not drawn: {}", error.what()));
  }
}

}  // namespace talus::report
