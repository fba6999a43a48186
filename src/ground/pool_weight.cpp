// SPDX-License-Identifier: MIT
#include "ground/pool_weight.hpp"

#include <algorithm>

#include "ground/ground_line.hpp"
#include "ground/plane_water.hpp"
#include "ground/pore_water.hpp"

namespace talus::ground {

std::function<std::vector<double>(double time)> make_pool_weight(const input::Case& data, const mesh::Mesh<2>& mesh) {
  const Polyline ground = find_ground(data.mesh);
  std::vector<std::array<double, 2>> verticals;  // x, level of the ground
  for (const auto& node : mesh.nodes) verticals.push_back({node[0], find_level(ground, node[0])});
  const double first = find_first_time(data), unit_weight = find_water_weight(data);
  return [data, ground, verticals = std::move(verticals), first, unit_weight](double time) {
    const std::vector<Pond> ponds = find_ponds(data, ground, time == 0 ? first : time);
    std::vector<double> weight;
    for (const auto& [x, level] : verticals) {
      const auto water = find_standing_level(ponds, {}, ground, x);
      weight.push_back(water ? unit_weight * std::max(0.0, *water - level) : 0);
    }
    return weight;
  };
}

}  // namespace talus::ground
