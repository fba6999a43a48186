// SPDX-License-Identifier: MIT
#pragma once
// Results on pore water: budget of a run, steady seepage, weather before the run, and the states of the pore water.

#include <optional>
#include <string>
#include <vector>

#include "results/about.hpp"

namespace talus::results {

enum class SurfaceCondition { open, seepage_face, rain, flux, total_head, pressure };
template <>
inline constexpr auto words<SurfaceCondition> =
    std::array{"open", "seepage_face", "rain", "flux", "total_head", "pressure"};

/// Mass of water through one surface [kg; kg/m in plane strain].
struct SurfaceWater {
  std::string name;
  SurfaceCondition condition = SurfaceCondition::open;
  double entered = 0, left = 0, supplied = 0, runoff = 0;
};
void describe(auto& v, As<SurfaceWater> auto& r) {
  v.key("name", r.name, {"", "surface"});
  v.key("condition", r.condition, {"", "what it is to water"});
  v.key("entered", r.entered, {"kg", "water that came in"});
  v.key("left", r.left, {"kg", "water that left"});
  v.key("supplied", r.supplied, {"kg", "water supplied by rain or a given flux"});
  v.key("runoff", r.runoff, {"kg", "water that ran off"});
}

/// Mass budget of the pore water of a run [kg; kg/m in plane strain].
struct WaterBudget {
  double density = 1000;  ///< [kg/m³]
  double initial = 0, stored = 0, entered = 0, left = 0, runoff = 0, lost_between = 0, left_grid = 0, pressed_in = 0;
  double error = 0;                                  ///< relative to the mass of water in the model
  double largest_pressure = 0, largest_suction = 0;  ///< at the end [Pa]
  std::vector<double> largest_suction_at;            ///< [m]
  std::vector<SurfaceWater> surfaces;
  std::optional<double> transpired;
};
void describe(auto& v, As<WaterBudget> auto& r) {
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

/// Name of the ground surface without a [[hydraulic]] block.
inline constexpr const char* other_surfaces = "other surfaces";

/// Flow through a named side [m³/s; m³/(s m) in plane strain]; for a season the volume [m³; m³/m].
struct Discharge {
  std::string name;
  double inflow = 0, outflow = 0, runoff = 0;
};
void describe(auto& v, As<Discharge> auto& r) {
  v.key("name", r.name, {"", "side"});
  v.key("inflow", r.inflow, {"m3/s", "flow in"});
  v.key("outflow", r.outflow, {"m3/s", "flow out"});
  v.key("runoff", r.runoff, {"m3/s", "flow that runs off"});
}

/// Seepage exit: where water leaves a side.
struct SeepageExit {
  std::string name;
  std::vector<double> highest, lowest;  ///< [m]
};
void describe(auto& v, As<SeepageExit> auto& r) {
  v.key("name", r.name, {"", "seepage face"});
  v.key("highest", r.highest, {"m", "highest wet place"});
  v.key("lowest", r.lowest, {"m", "lowest wet place"});
}

/// Steady seepage by FEM.
struct Seepage {
  double inflow = 0, outflow = 0;  ///< [m³/s; m³/(s m) in plane strain]
  double balance_error = 0;
  int iterations = 0;
  int undecided = 0;                       ///< ground nodes with neither a dry nor a wet solution
  double largest_suction = 0;              ///< [Pa]
  std::vector<double> largest_suction_at;  ///< [m]
  std::vector<Discharge> discharges;
  std::vector<SeepageExit> exits;
  std::vector<std::vector<std::vector<double>>> water_table;  ///< polylines [m]
};
void describe(auto& v, As<Seepage> auto& r) {
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

/// Potential and actual transpiration of the plants on one ground surface [m³].
struct PlantWater {
  std::string ground;
  double potential = 0, transpired = 0;
};
void describe(auto& v, As<PlantWater> auto& r) {
  v.key("ground", r.ground, {"", "ground that they stand on"});
  v.key("potential", r.potential, {"m3", "potential transpiration"});
  v.key("transpired", r.transpired, {"m3", "transpiration"});
}

/// Suction in a layer parallel to the ground [Pa].
struct SuctionLayer {
  double depth = 0;  ///< of the lower end of the layer [m]
  double initial = 0, mean = 0, least = 0, greatest = 0, driest = 0;
};
void describe(auto& v, As<SuctionLayer> auto& r) {
  v.key("depth", r.depth, {"m", "depth of the lower end"});
  v.key("initial", r.initial, {"Pa", "mean suction at the start"});
  v.key("mean", r.mean, {"Pa", "mean suction at the end"});
  v.key("least", r.least, {"Pa", "least suction at the end"});
  v.key("greatest", r.greatest, {"Pa", "greatest suction at the end"});
  v.key("driest", r.driest, {"Pa", "greatest suction of the season"});
}

/// Water budget of the weather before the run [m³; m³/m in plane strain].
struct Season {
  double duration = 0;  ///< [s]
  double initial = 0, growth = 0, inflow = 0, outflow = 0, runoff = 0, potential = 0, transpired = 0;
  std::optional<double> standing;  ///< nullopt if there is no ponded rain at the end
  double error = 0;                ///< relative error of the budget
  int steps = 0, rejected = 0, iterations = 0;
  std::vector<Discharge> surfaces;
  std::vector<PlantWater> plants;
  std::vector<SuctionLayer> layers;
};
void describe(auto& v, As<Season> auto& r) {
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

/// Origin of the pore pressures of a state. `lowered` is the water table after a rapid drawdown, for soil that drains.
enum class WaterFlow { hydrostatic, steady, transient, lowered };
template <>
inline constexpr auto words<WaterFlow> = std::array{"hydrostatic", "steady", "transient", "lowered"};

/// Ponded water on a part of the ground.
struct StandingWater {
  Point from{}, to{};                   ///< ends on the ground, left to right [m]
  double level_from = 0, level_to = 0;  ///< water level at these ends [m]
};
void describe(auto& v, As<StandingWater> auto& r) {
  v.key("from", r.from, {"m", "left end on the ground"});
  v.key("to", r.to, {"m", "right end on the ground"});
  v.key("level_from", r.level_from, {"m", "level of the water at the left end"});
  v.key("level_to", r.level_to, {"m", "level of the water at the right end"});
}

/// State of the pore water at one time, with the flow through each side.
struct WaterState {
  WaterFlow flow = WaterFlow::hydrostatic;
  double time = 0;                 ///< [s]; 0 for the initial state of the methods
  double inflow = 0, outflow = 0;  ///< [m³/s; m³/(s m) in plane strain]
  double storage_rate = 0;         ///< rate of change of the water volume in the soil [m³/s]
  std::vector<Discharge> discharges;
  std::vector<SeepageExit> exits;
  std::vector<std::vector<Point>> water_table;  ///< lines of zero pressure [m]; empty in 3D
  std::vector<StandingWater> ponds;             ///< empty in 3D
};
void describe(auto& v, As<WaterState> auto& r) {
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

/// Fields of one state of the pore water.
struct WaterField {
  WaterFlow flow = WaterFlow::hydrostatic;
  double time = 0;                            ///< [s]
  std::vector<double> pressure;               ///< nodal, positive in compression [Pa]
  std::vector<double> saturation;             ///< by element; empty if unknown
  std::vector<std::vector<double>> velocity;  ///< Darcy velocity by element [m/s]; empty if there is no flow
};
void describe(auto& v, As<WaterField> auto& r) {
  v.key("flow", r.flow, {"", "what the pore pressures follow from"});
  v.key("time", r.time, {"s", "when"});
  v.key("pressure", r.pressure, {"Pa", "pore pressure at the nodes, compression positive"});
  v.key("saturation", r.saturation, {"", "degree of saturation of the elements"});
  v.key("velocity", r.velocity, {"m/s", "Darcy's velocity of the elements"});
}

/// water.json: fields of the pore water on triangles, up to the initial state of the methods.
struct WaterFields {
  double unit_weight = 0;                  ///< of water [N/m³]
  std::vector<Point> nodes;                ///< [m]
  std::vector<std::vector<int>> elements;  ///< node numbers
  std::vector<WaterField> states;          ///< in order of time; the last is the initial state of the methods
};
void describe(auto& v, As<WaterFields> auto& r) {
  v.key("unit_weight", r.unit_weight, {"N/m3", "unit weight of water"});
  v.key("nodes", r.nodes, {"m", "nodes"});
  v.key("elements", r.elements, {"", "nodes of the triangles"});
  v.key("states", r.states, {"", "the fields at each time"});
}

}  // namespace talus::results
