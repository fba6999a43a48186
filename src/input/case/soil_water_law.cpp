// SPDX-License-Identifier: MIT
#include "input/case/soil_water_law.hpp"

namespace talus::input {

material::Retention make_retention(const PoreWater& soil) {
  const double low = soil.minimum_saturation, high = soil.maximum_saturation;
  switch (soil.retention) {
    case RetentionCurve::van_genuchten:
      return material::VanGenuchten{low, high, soil.reference_pressure, soil.lambda};
    case RetentionCurve::linear:
      return material::LinearRetention::from_scale(low, high, soil.dry_suction);
    case RetentionCurve::exponential:
      return material::ExponentialRetention{low, high, soil.decay};
    case RetentionCurve::table:
      return material::make_retention_table(soil.retention_table, material::Interpolation::smooth);
    case RetentionCurve::dry:
    case RetentionCurve::saturated:
      break;
  }
  return material::ConstantSaturation{low, high};
}

material::Conductivity make_relative_conductivity(const PoreWater& soil) {
  const auto measure = soil.measure == SaturationShare::total ? material::SaturationMeasure::total
                                                              : material::SaturationMeasure::effective;
  switch (soil.relative_conductivity) {
    case ConductivityCurve::mualem: {
      material::Mualem law{soil.lambda, measure};
      if (soil.air_entry.value_or(0) > 0)
        law = material::Mualem::with_air_entry(soil.lambda, measure, make_retention(soil), *soil.air_entry);
      law.same_curve =
          soil.retention == RetentionCurve::van_genuchten && measure == material::SaturationMeasure::effective;
      return law;
    }
    case ConductivityCurve::hillel:
      return material::Hillel{soil.exponent, measure};
    case ConductivityCurve::exponential:
      return material::ExponentialConductivity{soil.decay};
    case ConductivityCurve::table:
      return material::make_conductivity_table(soil.conductivity_table, material::Interpolation::smooth);
    case ConductivityCurve::constant:
      break;
  }
  return material::ConstantConductivity{};
}

PoreWater add_air_entry(const PoreWater& soil) {
  constexpr double small = 200;       // [Pa]
  constexpr double least_safe = 0.5;  // λ from which the slope at saturation is finite
  PoreWater safe = soil;
  if (soil.relative_conductivity == ConductivityCurve::mualem && soil.lambda < least_safe && !soil.air_entry)
    safe.air_entry = small;
  return safe;
}

double find_saturated_conductivity(const PoreWater& soil, const Water& water, double gravity) {
  if (soil.conductivity) return *soil.conductivity * (gravity / water.drag_gravity);
  return material::find_conductivity(soil.permeability.value_or(0), water.density, gravity, water.viscosity);
}

}  // namespace talus::input
