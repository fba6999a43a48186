// SPDX-License-Identifier: MIT
#include "input/case/start.hpp"

#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, Gravity& g) {
  v.key("acceleration", g.acceleration, quantity("m/s2").at_least(0), "Acceleration of gravity.");
  v.key("direction", g.direction, plain(), "Direction in which it acts, of any length but zero.");
}

void describe(Visitor& v, PiezometricLine& l) {
  v.key("materials", l.materials, plain().required().example(R"(["sand"])"), "Materials in which the line acts.");
  v.key("points", l.points, quantity("m").required().example("[[0, 12], [32, 9]]"),
        "The line to which water would rise in a standpipe, from left to right; level beyond its ends. It may lie "
        "above the ground (artesian) or below the soil (drained, with suction).");
}

void describe(Visitor& v, PressureTable& t) {
  v.key("file", t.file, plain().required().example(R"("piezometers.csv")"),
        "A table (relative to the case file) with the columns x, y and that of `quantity`, with their units: "
        "`x [m], y [m], pressure [kPa]`.");
  v.key("quantity", t.quantity, plain(), "Which quantity the table has; its column has the same name.");
  v.key("interpolation", t.interpolation, plain(),
        "How values between the points are found. Pressures are interpolated as total heads, so that hydrostatic water "
        "is exact. Beyond the points the head of the nearest one holds for linear interpolation.");
}

void describe(Visitor& v, Initial& i) {
  v.key("result", i.result, plain().example(R"("gravity_results")"),
        "A folder of results (relative to the case file) whose state at the end of its stages is the start: mesh, "
        "points, stress, pore water, velocities and plastic strain are those of the result. Time, displacements and "
        "budgets begin anew.");
  const bool has_result = !i.result.empty();
  v.key("stress", i.stress, plain().allowed_without("result", has_result), "Stress at the start.");
  v.key(
      "k0", i.k0,
      plain().at_least(0).allowed_with("stress", i.stress, {InitialStress::k0, InitialStress::elements}).example("0.5"),
      "Ratio of horizontal to vertical stress; if not given, ν/(1-ν) of each material.");
  v.key("pore_pressure", i.water.pressure, plain().allowed_without("result", has_result),
        "Pore pressure at the start.");
  v.key("water_table", i.water.water_table,
        quantity("m")
            .needed_with("pore_pressure", i.water.pressure, InitialPressure::water_table)
            .example("[[0, 10], [32, 5]]"),
        "The line of zero pore pressure, from left to right; level beyond its ends.");
  v.key("largest_suction", i.water.largest_suction,
        quantity("kPa").at_least(0).or_infinite().allowed_with("pore_pressure", i.water.pressure,
                                                               {InitialPressure::water_table, InitialPressure::grid}),
        "Suction grows with the height above the water table up to this value.");
  v.key("season", i.water.season,
        quantity("day")
            .at_least(0)
            .allowed_with("pore_pressure", i.water.pressure, {InitialPressure::water_table, InitialPressure::seepage})
            .example("90"),
        "Weather before the run: seepage is calculated in soil at rest from this long before time 0, where the pore "
        "pressure named above holds, with the [[hydraulic]] series at negative times and the roots' transpiration.");
  v.key("date", i.date, plain().example("2023-07-01"),
        "The date of time 0: tables of dates begin there, and the times of [timeline] are printed as dates as well.");
  v.key("equilibrium", i.equilibrium, plain().example(R"("gravity")"),
        "The stage at whose end `preconsolidation_ratio` of Cam-clay soils is applied; if not given, the first one.");
  v.entries("velocity", i.velocity, "soil", 0, quantity("m/s").example("[1, 0]"),
            "Velocity of a region at the start; not with 'result'.");
  v.tables("piezometric_line", i.water.lines, 0,
           "A piezometric line of its own for some soils, beside the water table: perched or artesian water, or water "
           "held back by a cut-off. Water stands on the ground under the water table only.");
  v.optional_table("pressure_grid", i.water.table, "Pore pressures at points, for pore_pressure = \"grid\".");
}

}  // namespace talus::input
