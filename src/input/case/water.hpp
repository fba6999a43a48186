#pragma once
// Pore water in the case: its properties, what a soil does with it, what it meets at the border, and how it starts.

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "input/language/time_table.hpp"

namespace talus::input {

/// [water]: the same water everywhere.
struct Water {
  double density = 1000;        ///< ρ_w at zero pressure [kg/m³]
  double bulk_modulus = 2.2e9;  ///< K_w [Pa]
  double viscosity = 1.002e-3;  ///< μ_d [Pa s]; turns a permeability into a conductivity
  double drag_gravity = 9.81;   ///< the g at which conductivities were measured [m/s²]
};

enum class RetentionCurve { dry, saturated, van_genuchten, linear, exponential, table };
enum class ConductivityCurve { constant, mualem, hillel, exponential, table };
enum class SaturationShare { total, effective };
enum class BishopChi { saturation, khalili_khabbaz };

/// [materials.NAME.water]: what a soil does with water. The default is a soil without pore water.
struct PoreWater {
  RetentionCurve retention = RetentionCurve::dry;
  double minimum_saturation = 0;                       ///< S_min [-]
  double maximum_saturation = 1;                       ///< S_max [-]
  double reference_pressure = 0;                       ///< p_ref of van Genuchten [Pa]
  double lambda = 0;                                   ///< λ of van Genuchten, and of Mualem [-]
  double dry_suction = 0;                              ///< linear: suction at which S_min is reached [Pa]
  double decay = 0;                                    ///< exponential: α [1/Pa], of retention and of conductivity
  std::vector<std::array<double, 2>> retention_table;  ///< suction [Pa], saturation [-]
  std::optional<double> conductivity;                  ///< saturated k [m/s]; or
  std::optional<double> permeability;                  ///< intrinsic κ [m²]
  ConductivityCurve relative_conductivity = ConductivityCurve::constant;
  SaturationShare measure = SaturationShare::total;       ///< X of (4.16), (4.17)
  double exponent = 0;                                    ///< r of Hillel [-]
  std::optional<double> air_entry;                        ///< Mualem: k_r = 1 up to this suction [Pa]
  std::vector<std::array<double, 2>> conductivity_table;  ///< suction [Pa], k_r [-]
  BishopChi chi = BishopChi::saturation;
  double chi_air_entry = 0;  ///< s_e of Khalili and Khabbaz [Pa]

  bool is_wet() const { return retention != RetentionCurve::dry; }
};

enum class WaterCondition { total_head, pressure, seepage_face, rain, flux, no_flow };
enum class SeriesShape { linear, steps };
enum class RainDirection { vertical, normal };

/// [[hydraulic]]: what water meets on a named side or line. Values are series in time; a constant is one row.
struct Hydraulic {
  std::string on;
  WaterCondition condition = WaterCondition::no_flow;
  TimeTable head;      ///< level of the water [m]
  TimeTable pressure;  ///< pore pressure, positive in compression as engineers write it [Pa]
  TimeTable rate;      ///< rain or flux into the soil [m/s]; negative rain evaporates, negative flux is pumped out
  SeriesShape series = SeriesShape::linear;
  RainDirection rain = RainDirection::vertical;
  double suction_limit = std::numeric_limits<double>::infinity();  ///< where evaporation stops [Pa]

  /// The series of the condition in force, steps written out as jumps (two rows at one time); zero for conditions
  /// without a value.
  TimeTable values() const;
};

enum class InitialPressure { zero, water_table, seepage };

/// Pore pressure at the start; part of [initial].
struct InitialWater {
  InitialPressure pressure = InitialPressure::zero;
  std::vector<std::array<double, 2>> water_table;  ///< polyline of zero pressure [m]; horizontal beyond its ends
  double largest_suction = std::numeric_limits<double>::infinity();  ///< above the water table [Pa]
  /// Weather before the run [s]: transient seepage in soil at rest from time -season, where `pressure` holds, to time
  /// 0.
  double season = 0;
};

}  // namespace talus::input
