// SPDX-License-Identifier: MIT
#pragma once
// Hydraulic conductivity of unsaturated soil: k = k_s k_r, with k_r <= 1 a function of saturation or suction.
//
// A law is a plain struct with
//   template <class T> CurvePoint<T> evaluate(const SoilWater<T>&) const    k_r [-] and dk_r/ds [1/Pa]
// A new law needs its struct, one alternative in Conductivity, its checks in conductivity.cpp, and a test.

#include "material/water/retention.hpp"

namespace talus::material {

/// k = k_s at any suction.
struct ConstantConductivity {
  template <class T>
  TALUS_KERNEL CurvePoint<T> evaluate(const SoilWater<T>& /*water*/) const {
    return {T(1.0), T(0.0)};
  }
};

/// The saturation X of a law.
enum class SaturationMeasure {
  total,     ///< S_w, as in (4.16) and (4.17) of the source
  effective  ///< S_e, as in Mualem (1976) and van Genuchten (1980)
};

/// k_r = √X [1 - (1 - X^(1/λ))^λ]², (4.16), with X = S_w or S_e. With X = S_w and S_max < 1, k_r stays below 1. For λ <
/// 1/2 its slope at saturation is infinite (limited here at 1 - X^(1/λ) = 1e-9). For λ near 0.1, k_r falls to a half
/// within 1 Pa, an artefact of the formula; an air-entry value removes it (Vogel et al. 2001): with X_a = X at air
/// entry, k_r = 1 for X >= X_a and k_r(X)/k_r(X_a) below.
struct Mualem {
  double lambda = 0;  ///< λ of van Genuchten's curve [-]
  SaturationMeasure measure = SaturationMeasure::total;
  double entry = 1;         ///< X_a [-]; 1: (4.16) without air entry
  double at_entry = 1;      ///< k_r of (4.16) at X_a [-]
  bool same_curve = false;  ///< X is S_e of a van Genuchten curve with the same λ

  /// Returns the law with air entry at the suction `air_entry` [Pa].
  static Mualem with_air_entry(double lambda, SaturationMeasure measure, const Retention& retention, double air_entry) {
    Mualem law{lambda, measure};
    const SoilWater<double> water = find_water(retention, air_entry);
    law.entry = measure == SaturationMeasure::total ? water.saturation : water.effective;
    law.at_entry = law.find_plain(law.entry, -1.0).value;
    return law;
  }

  template <class T>
  TALUS_KERNEL CurvePoint<T> evaluate(const SoilWater<T>& water) const {
    const bool total = measure == SaturationMeasure::total;
    const T x = lane_min(T(entry), lane_max(total ? water.saturation : water.effective, T(1e-30)));
    const CurvePoint<T> k = find_plain(x, total ? water.slope : water.effective_slope);
    const auto enters = entry < 1 ? x < T(entry) : water.suction > T(0.0);
    return {k.value / at_entry, select(enters, k.slope / at_entry, T(0.0))};
  }

  /// Returns k_r, reusing terms of the retention curve.
  template <class T>
  TALUS_KERNEL T find_value(const SoilWater<T>& water) const {
    const T g = 1.0 - water.complement, k = lane_sqrt(water.effective) * g * g;
    return select(water.effective < T(entry), k * (1 / at_entry), T(1.0));
  }

  /// Returns (4.16) and its slope, where `dx` is dX/ds.
  template <class T>
  TALUS_KERNEL CurvePoint<T> find_plain(T x, T dx) const {
    const T y = lane_power(x, 1 / lambda);
    const T w = 1.0 - y, w_slope = lane_max(w, T(1e-9));
    const T g = 1.0 - lane_power(lane_max(w, T(1e-300)), lambda);
    const T dg = lane_power(w_slope, lambda) / w_slope * y / x;
    const T root = lane_sqrt(x);
    return {select(w > T(0.0), root * g * g, root), dx * (g * g * 0.5 / root + 2.0 * root * g * dg)};
  }
};

/// k_r = X^r, (4.17), after Hillel (1971).
struct Hillel {
  double exponent = 0;  ///< r [-]
  SaturationMeasure measure = SaturationMeasure::total;

  template <class T>
  TALUS_KERNEL CurvePoint<T> evaluate(const SoilWater<T>& water) const {
    const bool total = measure == SaturationMeasure::total;
    const T x = lane_max(total ? water.saturation : water.effective, T(1e-30));
    const T k = lane_power(x, exponent);
    return {k, k / x * exponent * (total ? water.slope : water.effective_slope)};
  }
};

/// k_r = e^(-αs), after Gardner (1958).
struct ExponentialConductivity {
  double alpha = 0;  ///< α [1/Pa]

  template <class T>
  TALUS_KERNEL CurvePoint<T> evaluate(const SoilWater<T>& water) const {
    const T k = lane_exp(lane_max(water.suction, T(0.0)) * -alpha);
    return {k, select(water.suction > T(0.0), k * -alpha, T(0.0))};
  }
};

/// Measured pairs of suction [Pa] and k_r; ln k_r is interpolated, or k_r itself.
struct TableConductivity {
  bool logarithmic = true;
  MonotoneTable table;  ///< of ln k_r if logarithmic

  template <class T>
  TALUS_KERNEL CurvePoint<T> evaluate(const SoilWater<T>& water) const {
    const CurvePoint<T> p = table.evaluate(water.suction);
    if (!logarithmic) return p;
    const T k = lane_exp(p.value);
    return {k, k * p.slope};
  }
};

/// Throws Error (wrong_input) if the pairs do not form a decreasing curve with values in (0, 1].
TableConductivity make_conductivity_table(const std::vector<std::array<double, 2>>& pairs, Interpolation interpolation,
                                          bool logarithmic = true);

using Conductivity = std::variant<ConstantConductivity, Mualem, Hillel, ExponentialConductivity, TableConductivity>;

/// Returns k_r and dk_r/ds.
template <class T>
CurvePoint<T> find_relative_conductivity(const Conductivity& law, const SoilWater<T>& water) {
  return std::visit([&](const auto& l) { return l.evaluate(water); }, law);
}

/// Returns k = ρ_w g κ / μ_d [m/s] for an intrinsic permeability κ [m²] (3.2), density [kg/m³] and viscosity [Pa s].
inline double find_conductivity(double permeability, double density, double gravity, double viscosity) {
  return density * gravity * permeability / viscosity;
}

/// Returns the fault of the parameters as a sentence for the user; std::nullopt if they are valid.
std::optional<std::string> find_fault(const Conductivity& law);

}  // namespace talus::material
