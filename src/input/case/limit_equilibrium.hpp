#pragma once
// [lem]: slip surfaces, slices and the search for the critical surface.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/methods.hpp"

namespace talus::input {

using talus::SliceMethod;
enum class SurfaceSearch { none, entry_exit, grid };

/// A surface that the user gives: a circle or a polyline.
struct SlipSurface {
  std::string name;
  std::optional<std::array<double, 2>> centre;  ///< of a circle [m]
  std::optional<double> radius;                 ///< [m]
  std::vector<double> ends;  ///< x where the arc leaves the ground [m]; empty: where circle and ground meet
  std::vector<std::array<double, 2>> points;  ///< of a polyline, from left to right [m]
};

/// Entries and exits on the ground, and depths between them.
struct EntryExit {
  std::vector<double> exit, entry;  ///< [from, to] in x [m]; empty: all of the ground
  int exits = 25, entries = 25, depths = 15;
};

/// Centres on a grid, radii between two levels.
struct CentreGrid {
  std::vector<std::array<double, 2>> corners;  ///< lower left, upper right [m]; empty: chosen from the ground
  int columns = 20, rows = 20, radii = 21;
  std::vector<double> levels;  ///< [lowest, highest] deepest point of the circles [m]; empty: base to toe and above
};

struct TensionCrack {
  double depth = 0;  ///< [m]; 0: none
  double water = 0;  ///< height of water in it [m]
};

struct LimitEquilibrium {
  std::vector<SliceMethod> methods{SliceMethod::bishop, SliceMethod::janbu_corrected, SliceMethod::spencer,
                                   SliceMethod::morgenstern_price};
  int slices = 50;
  SurfaceSearch search = SurfaceSearch::entry_exit;
  EntryExit entry_exit;
  CentreGrid grid;
  bool composite = false;            ///< circles that reach the bottom of the model follow it
  bool noncircular = true;           ///< also optimise a polyline
  int vertices = 12;                 ///< of that polyline
  int minima = 5;                    ///< local minima that are shown
  double smallest_depth = 0;         ///< of a sliding mass [m]
  double smallest_m_alpha = 0.2;     ///< [-]
  double most_tension = 0.2;         ///< share of the base with tensile N' [-]
  double most_thrust_outside = 0.5;  ///< share of E whose thrust acts outside the mass [-]
  bool reject = true;                ///< surfaces that fail these checks
  bool yield_acceleration = true;    ///< k_y of the critical surfaces
  TensionCrack crack;
  std::vector<SlipSurface> surfaces;
};

/// What suction adds to the strength on a slip surface.
enum class SuctionStrength { from_water, none, saturation, phi_b };

/// What slices (and finite elements, where they can) need of a material beside its strength.
struct SliceSoil {
  std::optional<double> unit_weight;            ///< γ above the water table, instead of grains and pores [N/m³]
  std::optional<double> saturated_unit_weight;  ///< γ below it [N/m³]
  double pore_pressure_ratio = 0;               ///< r_u [-]
  SuctionStrength suction_strength = SuctionStrength::from_water;  ///< from_water: χ = S_w where the soil has a
                                                                   ///< retention curve, else none
  double phi_b = 0;                                                ///< [rad]
  double cohesion_gradient = 0;                                    ///< growth of c below `cohesion_level` [Pa/m]
  double cohesion_level = 0;                                       ///< [m]
};

/// A vertical load on the ground, for slices and finite elements.
struct Surcharge {
  std::string name;
  std::vector<double> x;     ///< from left to right [m]
  std::vector<double> load;  ///< at each x [Pa], linear between; down positive
  bool variable = false;     ///< a variable action in the sense of Eurocode 7, else permanent
};

/// Pseudo-static acceleration over g.
struct Earthquake {
  double horizontal = 0;  ///< k_h out of the slope [-]
  double vertical = 0;    ///< k_v, down positive [-]
};

/// Eurocode 7, EN 1997-1 Annex A; or factors by hand.
enum class DesignApproach { none, da1_1, da1_2, da2, da3, by_hand };

struct PartialFactors {
  DesignApproach set = DesignApproach::none;
  // Given values replace those of the set.
  std::optional<double> cohesion;        ///< γ_c' divides c'
  std::optional<double> friction;        ///< γ_φ' divides tanφ'
  std::optional<double> undrained;       ///< γ_cu divides c of soils with φ = 0
  std::optional<double> weight;          ///< γ_γ divides the weight
  std::optional<double> permanent_load;  ///< γ_G multiplies unfavourable permanent surcharges
  std::optional<double> variable_load;   ///< γ_Q multiplies unfavourable variable surcharges
  std::optional<double> resistance;      ///< γ_R;e divides the factor of safety
};

}  // namespace talus::input
