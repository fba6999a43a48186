// SPDX-License-Identifier: MIT
#pragma once
// [[hydraulic]]: hydraulic boundary conditions.

#include <array>
#include <limits>
#include <string>

#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

// Interpolation between rows of a series in time.

enum class SeriesShape { linear, steps };

template <>
inline constexpr auto choices<SeriesShape> = std::array{
    Choice{SeriesShape::linear, "linear", "straight lines between the rows; two rows at one time are a jump"},
    Choice{SeriesShape::steps, "steps", "each value holds until the time of the next row, as in a hyetograph"},
};

enum class WaterCondition { total_head, pressure, seepage_face, rain, flux, no_flow, free_drainage };
enum class RainDirection { vertical, normal };

/// [[hydraulic]]: the condition on a named side or line. Values are series in time; a constant is a single row.
struct Hydraulic {
  std::string on;
  WaterCondition condition = WaterCondition::no_flow;
  TimeTable head;      ///< level of the water [m]
  TimeTable pressure;  ///< pore pressure, positive in compression [Pa]
  TimeTable rate;      ///< rain or inflow [m/s]; negative: evaporation, pumping
  SeriesShape series = SeriesShape::linear;
  RainDirection rain = RainDirection::vertical;
  double suction_limit = std::numeric_limits<double>::infinity();  ///< suction at which evaporation stops [Pa]
  double standing_depth = 0;  ///< largest depth of ponded rain, in a season or a timeline [m]
  bool runs_on =
      false;  ///< rain that exceeds infiltration runs off along the ground and may infiltrate further down, likewise

  /// Returns the series of the selected condition, with steps written as jumps (two rows at one time); zero for
  /// conditions without a value.
  TimeTable values() const;
};

template <>
inline constexpr auto choices<WaterCondition> = std::array{
    Choice{WaterCondition::total_head, "total_head", "standing water up to a level, and a seepage face above it"},
    Choice{WaterCondition::pressure, "pressure", "the pore pressure is given"},
    Choice{WaterCondition::seepage_face, "seepage_face", "water may leave at zero pressure, none enters"},
    Choice{WaterCondition::rain, "rain", "this much is offered; what does not enter runs off. Negative: evaporation"},
    Choice{WaterCondition::flux, "flux", "this much enters whatever the pressure. Negative: it is pumped out"},
    Choice{WaterCondition::no_flow, "no_flow", "no water passes"},
    Choice{WaterCondition::free_drainage, "free_drainage",
           "water drains downwards by its weight alone, as above a deep water table: the gradient is 1. Not in MPM"},
};

template <>
inline constexpr auto choices<RainDirection> = std::array{
    Choice{RainDirection::vertical, "vertical", "an intensity on the horizontal, as rain gauges measure it"},
    Choice{RainDirection::normal, "normal", "an intensity on the inclined surface itself"},
};

void describe(Visitor& v, Hydraulic& h);

}  // namespace talus::input
