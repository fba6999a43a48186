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

void describe(auto& v, Water& w) {
  v.key("density", w.density, quantity("kg/m3").above(0).usual(950, 1250, {{"g/cm3", 1e3}, {"kN/m3", 101.972}}),
        "Density of the water at zero pressure.");
  v.key("bulk_modulus", w.bulk_modulus, quantity("kPa").above(0).or_infinite(),
        "Bulk modulus of the water. A softer one makes the time step longer; the undrained response suffers.");
  v.key("viscosity", w.viscosity, quantity("Pa.s").above(0),
        "Dynamic viscosity; it turns a permeability into a conductivity.");
  v.key("drag_gravity", w.drag_gravity, quantity("m/s2").above(0),
        "Acceleration of gravity at which conductivities were measured. In a centrifuge model it stays 9.81 when they "
        "were measured at rest.");
}

// NOLINTNEXTLINE(readability-function-size): a list of keys
void describe(auto& v, PoreWater& w) {
  using R = RetentionCurve;
  using K = ConductivityCurve;
  v.key("retention", w.retention, plain().example(R"("van_genuchten")"), "How the saturation follows the suction s.");
  v.key("relative_conductivity", w.relative_conductivity,
        plain().allowed_unless("retention", w.retention, R::dry).example(R"("mualem")"),
        "How the conductivity follows the suction s or the saturation X.");
  v.key("minimum_saturation", w.minimum_saturation,
        plain()
            .at_least(0)
            .below(1)
            .allowed_with("retention", w.retention, R::van_genuchten)
            .or_with("retention", w.retention, R::linear)
            .or_with("retention", w.retention, R::exponential)
            .example("0.15"),
        "Saturation S_min of the driest soil. A table has its own.");
  v.key("maximum_saturation", w.maximum_saturation,
        plain()
            .above(0)
            .at_most(1)
            .allowed_with("retention", w.retention, R::saturated)
            .or_with("retention", w.retention, R::van_genuchten)
            .or_with("retention", w.retention, R::linear)
            .or_with("retention", w.retention, R::exponential),
        "Saturation S_max below the water table. A table has its own.");
  v.key("reference_pressure", w.reference_pressure,
        quantity("kPa").above(0).needed_with("retention", w.retention, R::van_genuchten).example("6.13"),
        "p_ref of van Genuchten's curve.");
  v.key("lambda", w.lambda,
        plain()
            .above(0)
            .below(1)
            .needed_with("retention", w.retention, R::van_genuchten)
            .or_with("relative_conductivity", w.relative_conductivity, K::mualem)
            .example("0.27"),
        "λ of van Genuchten's curve (called m by others) and of Mualem's conductivity.");
  v.key("dry_suction", w.dry_suction,
        quantity("kPa").above(0).needed_with("retention", w.retention, R::linear).example("100"),
        "Suction at which the straight line reaches S_min.");
  v.key("decay", w.decay,
        quantity("kPa-1")
            .above(0)
            .needed_with("retention", w.retention, R::exponential)
            .or_with("relative_conductivity", w.relative_conductivity, K::exponential)
            .example("0.1"),
        "α of the exponential laws: one over the suction at which they have fallen to 37 %. Tables of others give it "
        "per metre of head; divide that by the unit weight of water.");
  SuctionCurve retention{w.retention_table}, conductivity{w.conductivity_table};
  v.key("retention_table", retention,
        quantity("kPa")
            .at_least(0)
            .needed_with("retention", w.retention, R::table)
            .example(R"([[0, 1], ["10 kPa", 0.8], [100, 0.3]])"),
        "Suctions and saturations; constant beyond the ends.");
  v.key("conductivity", w.conductivity,
        quantity("m/s")
            .above(0)
            .usual(1e-13, 0.1, {{"cm/s", 0.01}, {"m/day", 1 / 86400.0}, {"mm/h", 1e-3 / 3600}})
            .allowed_unless("retention", w.retention, R::dry)
            .example("1e-5"),
        "Conductivity of the saturated soil. Either this or `permeability` is needed.");
  v.key("permeability", w.permeability,
        quantity("m2")
            .above(0)
            .usual(1e-20, 1e-8, {{"cm2", 1e-4}})
            .allowed_unless("retention", w.retention, R::dry)
            .example("6e-11"),
        "Intrinsic permeability instead; the conductivity is density · gravity · permeability/viscosity.");
  v.key("compressibility", w.compressibility,
        quantity("kPa-1")
            .at_least(0)
            .usual_or_zero(1e-6, 1e-1, {{"MPa-1", 1e-3}})
            .allowed_unless("retention", w.retention, R::dry)
            .example("1e-4"),
        "Coefficient of volume compressibility m_v of the skeleton: what saturated soil at rest stores under a change "
        "of its pressure, in seepage over time (initial.season, [timeline]). Soil that moves has that of its model.");
  v.key("measure", w.measure,
        plain()
            .allowed_with("relative_conductivity", w.relative_conductivity, K::mualem)
            .or_with("relative_conductivity", w.relative_conductivity, K::hillel),
        "The saturation X of the relative conductivity.");
  v.key("exponent", w.exponent,
        plain().at_least(0).needed_with("relative_conductivity", w.relative_conductivity, K::hillel).example("3"),
        "r of Hillel's conductivity.");
  v.key("air_entry", w.air_entry,
        quantity("kPa")
            .at_least(0)
            .allowed_with("relative_conductivity", w.relative_conductivity, K::mualem)
            .example("2"),
        "Mualem's conductivity falls from this suction on only. For λ < 1/2 it would fall with infinite slope from "
        "zero, which stops seepage over time: there (initial.season, [timeline]) 0.2 kPa (2 cm of water) are used "
        "where no value is given (Vogel et al. 2001). 0: none.");
  v.key("conductivity_table", conductivity,
        quantity("kPa")
            .at_least(0)
            .needed_with("relative_conductivity", w.relative_conductivity, K::table)
            .example(R"([[0, 1], ["10 kPa", 0.1], [100, 1e-4]])"),
        "Suctions and relative conductivities, which lie above 0; constant beyond the ends.");
  v.key("chi", w.chi, plain().allowed_unless("retention", w.retention, R::dry),
        "χ of Bishop's effective stress: this share of the pore pressure acts between the grains.");
  v.key("chi_air_entry", w.chi_air_entry,
        quantity("kPa").above(0).needed_with("chi", w.chi, BishopChi::khalili_khabbaz).example("5"),
        "Air entry s_e of Khalili and Khabbaz.");
}

}  // namespace talus::input
