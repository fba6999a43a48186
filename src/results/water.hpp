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
void describe(Visitor& v, SurfaceWater& r);

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
void describe(Visitor& v, WaterBudget& r);

/// Name of the ground surface without a [[hydraulic]] block.
inline constexpr const char* other_surfaces = "other surfaces";

/// Flow through a named side [m³/s; m³/(s m) in plane strain]; for a season the volume [m³; m³/m].
struct Discharge {
  std::string name;
  double inflow = 0, outflow = 0, runoff = 0;
};
void describe(Visitor& v, Discharge& r);

/// Seepage exit: where water leaves a side.
struct SeepageExit {
  std::string name;
  std::vector<double> highest, lowest;  ///< [m]
};
void describe(Visitor& v, SeepageExit& r);

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
void describe(Visitor& v, Seepage& r);

/// Potential and actual transpiration of the plants on one ground surface [m³].
struct PlantWater {
  std::string ground;
  double potential = 0, transpired = 0;
};
void describe(Visitor& v, PlantWater& r);

/// Suction in a layer parallel to the ground [Pa].
struct SuctionLayer {
  double depth = 0;  ///< of the lower end of the layer [m]
  double initial = 0, mean = 0, least = 0, greatest = 0, driest = 0;
};
void describe(Visitor& v, SuctionLayer& r);

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
void describe(Visitor& v, Season& r);

/// Origin of the pore pressures of a state. `lowered` is the water table after a rapid drawdown, for soil that drains.
enum class WaterFlow { hydrostatic, steady, transient, lowered };
template <>
inline constexpr auto words<WaterFlow> = std::array{"hydrostatic", "steady", "transient", "lowered"};

/// Ponded water on a part of the ground.
struct StandingWater {
  Point from{}, to{};                   ///< ends on the ground, left to right [m]
  double level_from = 0, level_to = 0;  ///< water level at these ends [m]
};
void describe(Visitor& v, StandingWater& r);

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
void describe(Visitor& v, WaterState& r);

/// Fields of one state of the pore water.
struct WaterField {
  WaterFlow flow = WaterFlow::hydrostatic;
  double time = 0;                            ///< [s]
  std::vector<double> pressure;               ///< nodal, positive in compression [Pa]
  std::vector<double> saturation;             ///< by element; empty if unknown
  std::vector<std::vector<double>> velocity;  ///< Darcy velocity by element [m/s]; empty if there is no flow
};
void describe(Visitor& v, WaterField& r);

/// water.json: fields of the pore water on triangles, up to the initial state of the methods.
struct WaterFields {
  double unit_weight = 0;                  ///< of water [N/m³]
  std::vector<Point> nodes;                ///< [m]
  std::vector<std::vector<int>> elements;  ///< node numbers
  std::vector<WaterField> states;          ///< in order of time; the last is the initial state of the methods
};
void describe(Visitor& v, WaterFields& r);

}  // namespace talus::results
