// SPDX-License-Identifier: MIT
#include "output/files/history_columns.hpp"

#include <map>
#include <string_view>

namespace talus::output {
namespace {

struct Known {
  HistoryQuantity quantity;
  bool extensive = false;
  std::optional<EnergyPart> part{};
};

/// Names without monitor, "largest_" and component.
const std::map<std::string_view, Known>& list_known() {
  using enum HistoryQuantity;
  static const std::map<std::string_view, Known> known{
      {"time", {time}},
      {"step", {count}},
      {"time_step", {time_step}},
      {"kinetic_energy", {energy, true, EnergyPart::kinetic}},
      {"potential_energy", {potential_energy, true}},
      {"elastic_energy", {energy, true, EnergyPart::elastic}},
      {"plastic_work", {energy, true, EnergyPart::plastic}},
      {"damping_work", {energy, true, EnergyPart::damping}},
      {"wall_work", {energy, true, EnergyPart::walls}},
      {"mapping_loss", {energy, true, EnergyPart::mapping}},
      {"drag_work", {energy, true, EnergyPart::drag}},
      {"pore_water_work", {energy, true, EnergyPart::pore_water}},
      {"external_work", {energy, true, EnergyPart::external}},
      {"force_ratio", {force_ratio}},
      {"nodal_speed", {nodal_speed}},
      {"points", {count}},
      {"mass", {mass, true}},
      {"momentum", {momentum, true}},
      {"centre", {position}},
      {"displacement", {displacement}},
      {"front_advance", {front}},
      {"toe_distance", {front}},
      {"velocity", {velocity}},
      {"mean_stress", {stress}},
      {"deviatoric_stress", {stress}},
      {"preconsolidation_pressure", {stress}},
      {"deviatoric_strain", {strain}},
      {"root_activation_strain", {strain}},
      {"separation", {strain}},
      {"pore_pressure", {pore_pressure}},
      {"suction", {suction}},
      {"saturation", {saturation}},
      {"water_mass", {water_mass, true}},
      {"inflow", {water_flow, true}},
      {"outflow", {water_flow, true}},
      {"runoff", {water_flow, true}},
      {"transpiration", {transpiration, true}},
  };
  return known;
}

}  // namespace

HistoryColumn describe_column(const std::string& name) {
  constexpr std::string_view largest = "largest_";
  HistoryColumn column;
  std::string_view rest = name;
  if (const std::size_t dot = name.rfind('.'); dot != std::string::npos) {
    column.of = name.substr(0, dot);
    rest.remove_prefix(dot + 1);
  }
  if (rest.starts_with(largest)) {
    column.largest = true;
    rest.remove_prefix(largest.size());
  }
  auto known = list_known().find(rest);
  if (known == list_known().end() && rest.size() > 2 && rest[rest.size() - 2] == '_') {
    known = list_known().find(rest.substr(0, rest.size() - 2));
    if (known != list_known().end()) column.component = rest.back();
  }
  if (known == list_known().end()) return column;
  column.quantity = known->second.quantity;
  column.part = known->second.part;
  column.extensive = known->second.extensive;
  return column;
}

}  // namespace talus::output
