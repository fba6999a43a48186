// SPDX-License-Identifier: MIT
#pragma once
// [water] and [materials.NAME.water]: pore water and the hydraulic laws of soils.

#include <array>
#include <optional>
#include <vector>

#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

/// [water]: properties of water, the same in the whole section.
struct Water {
  double density = 1000;        ///< ρ_w at zero pressure [kg/m³]
  double bulk_modulus = 2.2e9;  ///< K_w [Pa]
  double viscosity = 1.002e-3;  ///< μ_d [Pa s]; converts a permeability into a conductivity
  double drag_gravity = 9.81;   ///< gravity at which conductivities were measured [m/s²]
};

enum class RetentionCurve { dry, saturated, van_genuchten, linear, exponential, table };
enum class ConductivityCurve { constant, mualem, hillel, exponential, table };
enum class SaturationShare { total, effective };
enum class BishopChi { saturation, khalili_khabbaz };

/// [materials.NAME.water]: the hydraulic laws of a soil. The default is soil without pore water.
struct PoreWater {
  RetentionCurve retention = RetentionCurve::dry;
  double minimum_saturation = 0;                       ///< S_min [-]
  double maximum_saturation = 1;                       ///< S_max [-]
  double reference_pressure = 0;                       ///< p_ref of van Genuchten [Pa]
  double lambda = 0;                                   ///< λ of van Genuchten and Mualem [-]
  double dry_suction = 0;                              ///< linear: suction at S_min [Pa]
  double decay = 0;                                    ///< exponential: α [1/Pa] of retention and conductivity
  std::vector<std::array<double, 2>> retention_table;  ///< suction [Pa], saturation [-]
  std::optional<double> conductivity;                  ///< saturated k [m/s]; or
  std::optional<double> permeability;                  ///< intrinsic κ [m²]
  double conductivity_ratio = 1;                       ///< k across bedding over k along it [-]
  double conductivity_inclination = 0;                 ///< of bedding, positive where it rises along x [rad]
  double compressibility = 0;                          ///< m_v of the skeleton, for seepage in rigid soil [1/Pa]
  ConductivityCurve relative_conductivity = ConductivityCurve::constant;
  SaturationShare measure = SaturationShare::total;       ///< X of (4.16), (4.17)
  double exponent = 0;                                    ///< r of Hillel [-]
  std::optional<double> air_entry;                        ///< Mualem: air-entry suction, k_r = 1 up to it [Pa]
  std::vector<std::array<double, 2>> conductivity_table;  ///< suction [Pa], k_r [-]
  BishopChi chi = BishopChi::saturation;
  double chi_air_entry = 0;  ///< s_e of Khalili and Khabbaz [Pa]

  bool is_wet() const { return retention != RetentionCurve::dry; }
};

template <>
inline constexpr auto choices<RetentionCurve> = std::array{
    Choice{RetentionCurve::dry, "dry", "the soil has no pore water"},
    Choice{RetentionCurve::saturated, "saturated", "it stays saturated whatever the suction"},
    Choice{RetentionCurve::van_genuchten, "van_genuchten", "S_min + (S_max - S_min)[1 + (s/p_ref)^(1/(1-λ))]^(-λ)"},
    Choice{RetentionCurve::linear, "linear", "a straight line from S_max to S_min"},
    Choice{RetentionCurve::exponential, "exponential", "S_min + (S_max - S_min)exp(-αs), after Gardner"},
    Choice{RetentionCurve::table, "table", "measured pairs, joined by monotone cubics"},
};
template <>
inline constexpr auto choices<ConductivityCurve> = std::array{
    Choice{ConductivityCurve::constant, "constant", "that of the saturated soil at any suction"},
    Choice{ConductivityCurve::mualem, "mualem", "√X[1 - (1 - X^(1/λ))^λ]² of it"},
    Choice{ConductivityCurve::hillel, "hillel", "X^r of it"},
    Choice{ConductivityCurve::exponential, "exponential", "exp(-αs) of it, after Gardner"},
    Choice{ConductivityCurve::table, "table", "measured pairs, their logarithms joined by monotone cubics"},
};
template <>
inline constexpr auto choices<SaturationShare> = std::array{
    Choice{SaturationShare::total, "total", "the degree of saturation S"},
    Choice{SaturationShare::effective, "effective", "the effective one, (S - S_min)/(S_max - S_min)"},
};
template <>
inline constexpr auto choices<BishopChi> = std::array{
    Choice{BishopChi::saturation, "saturation", "χ = S"},
    Choice{BishopChi::khalili_khabbaz, "khalili_khabbaz", "χ = (s/s_e)^(-0.55) above the air entry s_e, 1 below"},
};

void describe(Visitor& v, Water& w);

void describe(Visitor& v, PoreWater& w);

}  // namespace talus::input
