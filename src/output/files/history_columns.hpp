// SPDX-License-Identifier: MIT
#pragma once
// What the columns of histories and monitors hold. Their names are those that run/mpm/record/ writes; a CSV file has no
// room for more.

#include <array>
#include <optional>
#include <string>

#include "results/about.hpp"

namespace talus::output {

enum class HistoryQuantity {
  time,
  time_step,
  count,
  energy,  ///< what the balance of energy adds up
  potential_energy,
  force_ratio,
  nodal_speed,
  mass,
  momentum,
  position,
  displacement,
  front,  ///< how far the soil has run
  velocity,
  stress,
  strain,
  pore_pressure,
  suction,
  saturation,
  water_mass,
  water_flow,
  transpiration,
  state  ///< another variable of a soil model
};

/// Terms of the balance of energy: energy that enters the body, and its forms.
enum class EnergyPart { external, kinetic, elastic, plastic, damping, walls, mapping, drag, pore_water };

struct HistoryColumn {
  HistoryQuantity quantity = HistoryQuantity::state;
  std::optional<EnergyPart> part;  ///< of energy
  std::string of;                  ///< monitor or side; empty: the whole body
  bool largest = false;            ///< of all points
  char component = 0;              ///< 'x', 'y', 'z'; 0: a scalar, or the length of a vector
  bool extensive = false;          ///< in plane strain per metre of thickness
};

/// "crest.displacement_x", "kinetic_energy", "left.inflow".
HistoryColumn describe_column(const std::string& name);

}  // namespace talus::output

namespace talus::results {

template <>
inline constexpr auto words<output::EnergyPart> =
    std::array{Word{output::EnergyPart::external, "external"},    Word{output::EnergyPart::kinetic, "kinetic"},
               Word{output::EnergyPart::elastic, "elastic"},      Word{output::EnergyPart::plastic, "plastic"},
               Word{output::EnergyPart::damping, "damping"},      Word{output::EnergyPart::walls, "walls"},
               Word{output::EnergyPart::mapping, "mapping"},      Word{output::EnergyPart::drag, "drag"},
               Word{output::EnergyPart::pore_water, "pore_water"}};

template <>
inline constexpr auto words<output::HistoryQuantity> =
    std::array{Word{output::HistoryQuantity::time, "time"},
               Word{output::HistoryQuantity::time_step, "time_step"},
               Word{output::HistoryQuantity::count, "count"},
               Word{output::HistoryQuantity::energy, "energy"},
               Word{output::HistoryQuantity::potential_energy, "potential_energy"},
               Word{output::HistoryQuantity::force_ratio, "force_ratio"},
               Word{output::HistoryQuantity::nodal_speed, "nodal_speed"},
               Word{output::HistoryQuantity::mass, "mass"},
               Word{output::HistoryQuantity::momentum, "momentum"},
               Word{output::HistoryQuantity::position, "position"},
               Word{output::HistoryQuantity::displacement, "displacement"},
               Word{output::HistoryQuantity::front, "front"},
               Word{output::HistoryQuantity::velocity, "velocity"},
               Word{output::HistoryQuantity::stress, "stress"},
               Word{output::HistoryQuantity::strain, "strain"},
               Word{output::HistoryQuantity::pore_pressure, "pore_pressure"},
               Word{output::HistoryQuantity::suction, "suction"},
               Word{output::HistoryQuantity::saturation, "saturation"},
               Word{output::HistoryQuantity::water_mass, "water_mass"},
               Word{output::HistoryQuantity::water_flow, "water_flow"},
               Word{output::HistoryQuantity::transpiration, "transpiration"},
               Word{output::HistoryQuantity::state, "state"}};

}  // namespace talus::results
