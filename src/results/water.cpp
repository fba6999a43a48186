// SPDX-License-Identifier: MIT
#include "results/water.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, SurfaceWater& r) {
  v.key("name", r.name, {"", "surface"});
  v.key("condition", r.condition, {"", "what it is to water"});
  v.key("entered", r.entered, {"kg", "water that came in"});
  v.key("left", r.left, {"kg", "water that left"});
  v.key("supplied", r.supplied, {"kg", "water supplied by rain or a given flux"});
  v.key("runoff", r.runoff, {"kg", "water that ran off"});
}

void describe(Visitor& v, WaterBudget& r) {
  v.key("density", r.density, {"kg/m3", "density of water"});
  v.key("initial", r.initial, {"kg", "water at the start"});
  v.key("stored", r.stored, {"kg", "water at the end"});
  v.key("entered", r.entered, {"kg", "water that came in"});
  v.key("left", r.left, {"kg", "water that left"});
  v.key("runoff", r.runoff, {"kg", "rain that ran off"});
  v.key("lost_between", r.lost_between, {"kg", "water that was cut off between elements"});
  v.key("left_grid", r.left_grid, {"kg", "water of points that left the grid"});
  v.key("pressed_in", r.pressed_in,
        {"kg", "water that the volumetric strain at frozen geometry would expel, kept in the pores"});
  v.key("error", r.error, {"", "error of the water budget over the water in the model"});
  v.key("largest_pressure", r.largest_pressure, {"Pa", "largest pore pressure at the end"});
  v.key("largest_suction", r.largest_suction, {"Pa", "largest suction at the end"});
  v.key("largest_suction_at", r.largest_suction_at, {"m", "where the suction is largest"});
  v.key("surfaces", r.surfaces, {"", "water by surface"});
  v.maybe("transpired", r.transpired, {"kg", "water that roots drew"});
}

void describe(Visitor& v, Discharge& r) {
  v.key("name", r.name, {"", "side"});
  v.key("inflow", r.inflow, {"m3/s", "flow in"});
  v.key("outflow", r.outflow, {"m3/s", "flow out"});
  v.key("runoff", r.runoff, {"m3/s", "flow that runs off"});
}

void describe(Visitor& v, SeepageExit& r) {
  v.key("name", r.name, {"", "seepage face"});
  v.key("highest", r.highest, {"m", "highest wet place"});
  v.key("lowest", r.lowest, {"m", "lowest wet place"});
}

void describe(Visitor& v, Seepage& r) {
  v.key("inflow", r.inflow, {"m3/s", "flow through"});
  v.key("outflow", r.outflow, {"m3/s", "flow out"});
  v.key("balance_error", r.balance_error, {"", "difference of both over the flow"});
  v.key("iterations", r.iterations, {"", "iterations"});
  v.key("undecided", r.undecided, {"", "nodes that fit neither a dry nor a wet surface"});
  v.key("largest_suction", r.largest_suction, {"Pa", "largest suction in steady seepage"});
  v.key("largest_suction_at", r.largest_suction_at, {"m", "where the suction is largest"});
  v.key("discharges", r.discharges, {"", "flow by side"});
  v.key("exits", r.exits, {"", "where water comes out"});
  v.key("water_table", r.water_table, {"m", "lines of zero pressure"});
}

void describe(Visitor& v, PlantWater& r) {
  v.key("ground", r.ground, {"", "ground that they stand on"});
  v.key("potential", r.potential, {"m3", "potential transpiration"});
  v.key("transpired", r.transpired, {"m3", "transpiration"});
}

void describe(Visitor& v, SuctionLayer& r) {
  v.key("depth", r.depth, {"m", "depth of the lower end"});
  v.key("initial", r.initial, {"Pa", "mean suction at the start"});
  v.key("mean", r.mean, {"Pa", "mean suction at the end"});
  v.key("least", r.least, {"Pa", "least suction at the end"});
  v.key("greatest", r.greatest, {"Pa", "greatest suction at the end"});
  v.key("driest", r.driest, {"Pa", "greatest suction of the season"});
}

void describe(Visitor& v, Season& r) {
  v.key("duration", r.duration, {"s", "length of the season"});
  v.key("initial", r.initial, {"m3", "water at the start"});
  v.key("growth", r.growth, {"m3", "growth of the stored water"});
  v.key("inflow", r.inflow, {"m3", "water that came in"});
  v.key("outflow", r.outflow, {"m3", "water that left"});
  v.key("runoff", r.runoff, {"m3", "rain that ran off"});
  v.maybe("standing", r.standing, {"m3", "rain that stands on the ground at the end"});
  v.key("potential", r.potential, {"m3", "potential transpiration"});
  v.key("transpired", r.transpired, {"m3", "transpiration"});
  v.key("error", r.error, {"", "error of the budget"});
  v.key("steps", r.steps, {"", "time steps"});
  v.key("rejected", r.rejected, {"", "time steps that were repeated"});
  v.key("iterations", r.iterations, {"", "iterations"});
  v.key("surfaces", r.surfaces, {"", "water by side"});
  v.key("plants", r.plants, {"", "water that plants drew"});
  v.key("layers", r.layers, {"", "suction by depth"});
}

void describe(Visitor& v, StandingWater& r) {
  v.key("from", r.from, {"m", "left end on the ground"});
  v.key("to", r.to, {"m", "right end on the ground"});
  v.key("level_from", r.level_from, {"m", "level of the water at the left end"});
  v.key("level_to", r.level_to, {"m", "level of the water at the right end"});
}

void describe(Visitor& v, WaterState& r) {
  v.key("flow", r.flow, {"", "what the pore pressures follow from"});
  v.key("time", r.time, {"s", "when; the methods begin at 0"});
  v.key("inflow", r.inflow, {"m3/s", "flow in"});
  v.key("outflow", r.outflow, {"m3/s", "flow out"});
  v.key("storage_rate", r.storage_rate, {"m3/s", "growth of the water in the soil"});
  v.key("discharges", r.discharges, {"", "flow by side"});
  v.key("exits", r.exits, {"", "where water comes out"});
  v.key("water_table", r.water_table, {"m", "lines of zero pressure"});
  v.key("ponds", r.ponds, {"", "water that stands on the ground"});
}

void describe(Visitor& v, WaterField& r) {
  v.key("flow", r.flow, {"", "what the pore pressures follow from"});
  v.key("time", r.time, {"s", "when"});
  v.key("pressure", r.pressure, {"Pa", "pore pressure at the nodes, compression positive"});
  v.key("saturation", r.saturation, {"", "degree of saturation of the elements"});
  v.key("velocity", r.velocity, {"m/s", "Darcy's velocity of the elements"});
}

void describe(Visitor& v, WaterFields& r) {
  v.key("unit_weight", r.unit_weight, {"N/m3", "unit weight of water"});
  v.key("nodes", r.nodes, {"m", "nodes"});
  v.key("elements", r.elements, {"", "nodes of the triangles"});
  v.key("states", r.states, {"", "the fields at each time"});
}

}  // namespace talus::results
