// SPDX-License-Identifier: MIT
// Saturation, unit weight and suction stress of soil, and the weight of pools on a mesh.
#include "site/weights.hpp"

#include <algorithm>
#include <cmath>

#include "input/case/soil_water_law.hpp"

namespace talus::site {

namespace {

/// Exponent of χ = (s/s_e)^-0.55 (Khalili and Khabbaz 1998).
constexpr double khalili_exponent = -0.55;

double find_saturation(const input::Material& soil, double p) {
  if (!soil.water.is_wet()) return p > 0 ? 0 : 1;  // dry above the water table, saturated below
  return material::saturation(input::make_retention(soil.water), p);
}

}  // namespace

double find_unit_weight(const input::Case& data, const input::Material& soil, double p) {
  if (p <= 0) return find_saturated_weight(data, soil);
  if (soil.slices.unit_weight) return *soil.slices.unit_weight;
  const double g = data.gravity.acceleration;
  return (soil.density() + soil.porosity * find_saturation(soil, p) * data.water.density) * g;
}

double find_saturated_weight(const input::Case& data, const input::Material& soil) {
  if (soil.slices.saturated_unit_weight) return *soil.slices.saturated_unit_weight;
  if (soil.slices.unit_weight) return *soil.slices.unit_weight;
  const double full = soil.water.is_wet() ? find_saturation(soil, 0) : 1;
  return (soil.density() + soil.porosity * full * data.water.density) * data.gravity.acceleration;
}

bool uses_saturation(const input::Material& soil) {
  if (!soil.water.is_wet()) return false;
  return soil.slices.suction_strength == input::SuctionStrength::from_water ||
         soil.slices.suction_strength == input::SuctionStrength::saturation;
}

double find_suction_stress(const input::Material& soil, double suction) {
  if (suction > 0 && soil.slices.suction_strength == input::SuctionStrength::phi_b && soil.friction_angle > 0)
    return suction * std::tan(soil.slices.phi_b) / std::tan(soil.friction_angle);
  if (suction <= 0 || !uses_saturation(soil)) return 0;
  if (soil.water.chi == input::BishopChi::khalili_khabbaz) {
    const double entry = soil.water.chi_air_entry;
    return suction <= entry ? suction : suction * std::pow(suction / entry, khalili_exponent);
  }
  return suction * find_saturation(soil, suction);
}

std::function<std::vector<double>(double time)> make_pool_weight(const Site& site, const mesh::Mesh<2>& mesh) {
  std::vector<std::array<double, 2>> verticals;  // x, level of the ground
  for (const auto& node : mesh.nodes) verticals.push_back({node[0], find_level(site.ground(), node[0])});
  return [site, verticals = std::move(verticals)](double time) {
    const std::vector<Pond> ponds = time == 0 ? site.ponds() : site.find_ponds(time);
    std::vector<double> weight;
    for (const auto& [x, level] : verticals) {
      const auto water = find_standing_level(ponds, {}, site.ground(), x);
      weight.push_back(water ? site.water_weight() * std::max(0.0, *water - level) : 0);
    }
    return weight;
  };
}

}  // namespace talus::site
