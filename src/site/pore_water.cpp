// SPDX-License-Identifier: MIT
// Constant pore pressures and unit weights per element.
#include "site/pore_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mesh/locate.hpp"
#include "site/initial_water.hpp"
#include "site/weights.hpp"

namespace talus::site {

bool has_water(const input::Case& data) {
  return std::any_of(data.regions.begin(), data.regions.end(), [&](const auto& region) {
    const auto material = data.materials.find(region.second);
    return material != data.materials.end() && material->second.water.is_wet();
  });
}

namespace {

/// Divisions of an element's edge, for means over elements that the water table cuts.
constexpr int element_parts = 5;

/// Returns true if a table or line of the case has a step.
bool has_steps(const input::InitialWater& water) {
  if (water.pressure != input::InitialPressure::water_table) return false;
  return has_step(water.water_table) ||
         std::any_of(water.lines.begin(), water.lines.end(), [](const auto& line) { return has_step(line.points); });
}

/// Returns the mean over an element of a function of the pore pressure, which is linear between the corners.
template <int D, class F>
double find_mean(const std::array<double, D + 1>& corners, const F& find) {
  double sum = 0;
  int count = 0;
  const auto add = [&](double p) { sum += find(p), ++count; };
  constexpr double n = element_parts;
  for (int i = 0; i < element_parts; ++i)
    for (int j = 0; i + j < element_parts; ++j) {
      if constexpr (D == 2) {
        const double a = (i + 1.0 / 3) / n, b = (j + 1.0 / 3) / n;
        add(a * corners[0] + b * corners[1] + (1 - a - b) * corners[2]);
      } else {
        for (int k = 0; i + j + k < element_parts; ++k) {
          const double a = (i + 0.25) / n, b = (j + 0.25) / n, c = (k + 0.25) / n;
          add(a * corners[0] + b * corners[1] + c * corners[2] + (1 - a - b - c) * corners[3]);
        }
      }
    }
  return sum / count;
}

template <int D>
HeldWater<D> make_dry(const mesh::Mesh<D>& mesh) {
  HeldWater<D> water;
  water.unit_weight.assign(mesh.elements.size(), 0.0);
  water.pore.assign(mesh.elements.size(), {});
  return water;
}

/// Sets weight and pore pressure of an element of soil `m` from the pressures `p` at its corners.
template <int D>
void set_element(const input::Case& data, const input::Material& m, int e, const std::array<double, D + 1>& p,
                 HeldWater<D>& water) {
  water.unit_weight[e] = find_mean<D>(p, [&](double q) { return find_unit_weight(data, m, q); });
  if (material::is_total_stress(m.model, m)) return;
  for (std::size_t c = 0; c <= D; ++c) {
    water.pore[e][c] = p[c] > 0 ? find_suction_stress(m, p[c]) : p[c];
    water.acts = water.acts || water.pore[e][c] != 0;
  }
}

/// Returns the given pressures at the corners of an element; those of piezometric lines jump between soils, and at the
/// steps of a line.
template <int D>
std::array<double, D + 1> find_given_corners(const input::Case& data, const mesh::Mesh<D>& mesh, int e,
                                             const input::Material& m) {
  double middle = 0;
  for (const int node : mesh.elements[e]) middle += mesh.nodes[node][0] / (D + 1);
  const bool has_jumps = has_steps(data.initial.water);
  std::array<double, D + 1> p;
  for (std::size_t c = 0; c <= D; ++c) {
    Vec<D> x = mesh.nodes[mesh.elements[e][c]];
    if (has_jumps) x[0] = leave_steps(find_piezometric_line(data, m), x[0], middle);
    p[c] = find_given_pressure<D>(data, m, x);
  }
  return p;
}

}  // namespace

template <int D>
HeldWater<D> find_held_water(const input::Case& data, const mesh::Mesh<D>& mesh, WaterResult* result) {
  return hold_water<D>(data, mesh, find_nodal_pressure<D>(data, mesh, result));
}

template <int D>
HeldWater<D> hold_water(const input::Case& data, const mesh::Mesh<D>& mesh, const std::vector<double>& pressure) {
  // Else the given pressures are those at the nodes.
  const bool varies_by_soil = needs_seepage(data) || !data.initial.water.lines.empty() || has_steps(data.initial.water);
  HeldWater<D> water = make_dry<D>(mesh);
  for (int e = 0; e < mesh.element_count(); ++e) {
    const input::Material* soil = find_soil(data, mesh, e);
    if (soil == nullptr) continue;
    const PressureSource source = find_pressure_source(data, *soil);
    if (source == PressureSource::none && !soil->water.is_wet()) {
      water.unit_weight[e] = find_unit_weight(data, *soil, 1);
      continue;
    }
    std::array<double, D + 1> p{};
    if (source == PressureSource::given && varies_by_soil)
      p = find_given_corners<D>(data, mesh, e, *soil);
    else if (source != PressureSource::none)
      for (std::size_t c = 0; c <= D; ++c) p[c] = pressure[mesh.elements[e][c]];
    set_element<D>(data, *soil, e, p, water);
  }
  water.acts = add_pressure_ratio<D>(data, mesh, water.unit_weight, water.pore) || water.acts;
  return water;
}

template <int D>
HeldWater<D> find_given_water(const input::Case& data, const mesh::Mesh<D>& mesh) {
  HeldWater<D> water = make_dry<D>(mesh);
  for (int e = 0; e < mesh.element_count(); ++e) {
    const input::Material* soil = find_soil(data, mesh, e);
    if (soil == nullptr || soil->water.is_wet() || find_pressure_source(data, *soil) != PressureSource::given) continue;
    set_element<D>(data, *soil, e, find_given_corners<D>(data, mesh, e, *soil), water);
  }
  return water;
}

template <int D>
bool add_pressure_ratio(const input::Case& data, const mesh::Mesh<D>& mesh, const std::vector<double>& unit_weight,
                        std::vector<std::array<double, D + 1>>& pore) {
  if (!has_pressure_ratio(data)) return false;
  const bool is_given = data.initial.water.pressure == input::InitialPressure::grid;
  std::vector<mesh::LocalPoint<D>> places;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const input::Material* soil = find_soil(data, mesh, e);
    if (soil == nullptr || (soil->slices.pore_pressure_ratio == 0 && !is_given)) continue;
    if (material::is_total_stress(soil->model, *soil)) continue;
    for (std::size_t c = 0; c <= D; ++c) {
      std::array<double, D> xi{};
      if (c > 0) xi[c - 1] = 1;
      places.push_back({e, xi});
    }
  }
  if (places.empty()) return false;
  Vec<D> up;
  for (std::size_t d = 0; d < D; ++d) up[d] = -data.gravity.direction[d];
  const std::vector<double> overburden = mesh::overburden_integral<D>(mesh, unit_weight, places, up);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const int e = places[i].element;
    const Vec<D>& x = mesh.nodes[mesh.elements[e][i % (D + 1)]];
    pore[e][i % (D + 1)] = -find_pressure_ratio<D>(data, *find_soil(data, mesh, e), x) * overburden[i];
  }
  return true;
}

#define TALUS_INSTANTIATE(D)                                                                                 \
  template HeldWater<D> find_held_water<D>(const input::Case&, const mesh::Mesh<D>&, WaterResult*);          \
  template HeldWater<D> hold_water<D>(const input::Case&, const mesh::Mesh<D>&, const std::vector<double>&); \
  template HeldWater<D> find_given_water<D>(const input::Case&, const mesh::Mesh<D>&);                       \
  template bool add_pressure_ratio<D>(const input::Case&, const mesh::Mesh<D>&, const std::vector<double>&,  \
                                      std::vector<std::array<double, D + 1>>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::site
