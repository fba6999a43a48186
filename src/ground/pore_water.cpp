// SPDX-License-Identifier: MIT
#include "ground/pore_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "input/case/soil_water_law.hpp"

namespace talus::ground {

bool has_water(const input::Case& data) {
  return std::any_of(data.regions.begin(), data.regions.end(), [&](const auto& region) {
    const auto material = data.materials.find(region.second);
    return material != data.materials.end() && material->second.water.is_wet();
  });
}

std::vector<mpm::WaterLaw> make_water_laws(const input::Case& data) {
  std::vector<mpm::WaterLaw> laws;
  if (!has_water(data)) return laws;
  for (const auto& [name, m] : data.materials) {
    mpm::WaterLaw law;
    law.grain_density = m.grain_density;
    law.density = data.water.density;
    law.bulk_modulus = data.water.bulk_modulus;
    law.drag_gravity = data.water.drag_gravity;
    law.wet = m.water.is_wet();
    if (law.wet) {
      law.conductivity = input::find_saturated_conductivity(m.water, data.water, data.water.drag_gravity);
      law.retention = input::make_retention(m.water);
      law.relative = input::make_relative_conductivity(m.water);
      if (m.water.chi == input::BishopChi::khalili_khabbaz) law.chi_air_entry = m.water.chi_air_entry;
    }
    laws.push_back(law);
  }
  return laws;
}

double find_water_weight(const input::Case& data) {
  return data.water.density * data.gravity.acceleration;
}

template <int D>
const input::Material* find_soil(const input::Case& data, const mesh::Mesh<D>& mesh, int e) {
  const int region = mesh.element_region[e];
  if (region < 0) return nullptr;
  const auto given = data.regions.find(mesh.region_names[region]);
  const auto material = given == data.regions.end() ? data.materials.end() : data.materials.find(given->second);
  if (material == data.materials.end()) {
    throw Error(ExitCode::wrong_input,
                fmt::format("region '{}' of the mesh has no material; add it to [regions]", mesh.region_names[region]));
  }
  return &material->second;
}

void check_upright(const input::Case& data, const char* what) {
  constexpr double upright = 1e-9;
  if (data.gravity.direction[1] > -1 + upright) {
    throw Error(ExitCode::wrong_input,
                fmt::format("{} is a level of y, so gravity must act along -y; its direction is ({:g}, {:g}, {:g})",
                            what, data.gravity.direction[0], data.gravity.direction[1], data.gravity.direction[2]));
  }
}

template const input::Material* find_soil<2>(const input::Case&, const mesh::Mesh<2>&, int);
template const input::Material* find_soil<3>(const input::Case&, const mesh::Mesh<3>&, int);

}  // namespace talus::ground
