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

enum class WaterCondition { total_head, pressure, seepage_face, rain, flux, no_flow };
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
};

template <>
inline constexpr auto choices<RainDirection> = std::array{
    Choice{RainDirection::vertical, "vertical", "an intensity on the horizontal, as rain gauges measure it"},
    Choice{RainDirection::normal, "normal", "an intensity on the inclined surface itself"},
};

void describe(auto& v, Hydraulic& h) {
  using C = WaterCondition;
  v.key("on", h.on, plain().required().example(R"("crest")"),
        "A side of the box or a named line, as in [[boundary]]. One on the surface of the soil goes with it.");
  v.key("condition", h.condition, plain().required().example(R"("rain")"), "What water meets there.");
  Series head{h.head}, pressure{h.pressure}, rate{h.rate};
  v.key("head", head, quantity("m").needed_with("condition", h.condition, C::total_head).example("10"),
        "Level of the water, or rows of time and level.");
  v.key("pressure", pressure, quantity("kPa").needed_with("condition", h.condition, C::pressure).example("-20"),
        "Pore pressure, positive in compression: suction is negative. Or rows of time and pressure.");
  v.key("rate", rate,
        quantity("mm/h")
            .needed_with("condition", h.condition, C::rain)
            .or_with("condition", h.condition, C::flux)
            .example(R"([[0, "20 mm/h"], ["6 h", 5], ["12 h", 0]])"),
        "Water that is offered or enters, per area, or rows of time and rate. A plain number is in mm/h for a flux as "
        "well; write \"1e-6 m/s\" where that is handier.");
  v.key("series", h.series,
        plain()
            .allowed_with("condition", h.condition, C::total_head)
            .or_with("condition", h.condition, C::pressure)
            .or_with("condition", h.condition, C::rain)
            .or_with("condition", h.condition, C::flux)
            .example(R"("steps")"),
        "How rows of time are joined. The value is constant before the first and after the last.");
  v.key("rain", h.rain, plain().allowed_with("condition", h.condition, C::rain), "How the rate is measured.");
  v.key("suction_limit", h.suction_limit,
        quantity("kPa").above(0).or_infinite().allowed_with("condition", h.condition, C::rain),
        "Suction at the surface where evaporation ends.");
  v.key("standing_depth", h.standing_depth,
        quantity("mm").at_least(0).allowed_with("condition", h.condition, C::rain).example("5"),
        "Rain that cannot enter stands on the ground up to this depth, and enters later. In a season and a timeline.");
  v.key(
      "runs_on", h.runs_on, plain().allowed_with("condition", h.condition, C::rain),
      "Rain that cannot enter, and does not stand, runs down the ground to where it can, or to the pool, or off the "
      "section; water that comes out of the ground too. Its way ends where the ground has no condition or `no_flow`. "
      "It holds for all of the ground once one rain has it. Without it such rain is gone. In a season and a timeline.");
}

}  // namespace talus::input
