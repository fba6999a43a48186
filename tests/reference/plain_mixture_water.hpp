// SPDX-License-Identifier: MIT
#pragma once
// The water of the plain step of the Darcy formulation: contents of nodes and elements, and the pressure at the start
// of the step.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/plain_mixture_body.hpp"
#include "reference/plain_two_phase_surface.hpp"

namespace talus::reference {

/// Pores of a point [m³]: a thousandth of its volume at least, which smoothing may make smaller than its grains.
template <int D>
double find_pores(const WetBody<D>& body, const WetPoint<D>& point) {
  return std::max(pore_volume(body, point), 1e-3 * point.volume);
}

/// Pores and water of an element's wet points [m³].
struct ElementWater {
  double pores = 0, water = 0;
};
template <int D>
ElementWater find_element_water(const WetBody<D>& body, const WetCell& cell) {
  ElementWater sum;
  for (std::size_t p : cell.points) {
    const WetPoint<D>& point = body.points[p];
    if (!soil_of(body, point).wet) continue;
    sum.pores += find_pores(body, point);
    sum.water += point.water_mass / soil_of(body, point).water.density;
  }
  return sum;
}

/// Mean of a nodal field over the nodes of element `e`.
template <int D>
double mean_over_nodes(const mesh::Mesh<D>& mesh, int e, const std::vector<double>& field) {
  double sum = 0;
  for (int i = 0; i <= D; ++i) sum += at(field, node_of(mesh, e, i));
  return sum / (D + 1);
}

/// Suction at which all soil is dry [Pa] (Fredlund and Xing 1994).
inline constexpr double driest = 1e9;
/// Largest nodal remainder over the node's fraction of the elements' water [-].
inline constexpr double most_own = 0.5;

/// Suction at which all but a thousandth is given up of what the soil gives up, at most 100 MPa [Pa].
inline double find_dry_suction(const PoreWater& soil) {
  const double full = soil.saturation(0), least = soil.saturation(driest);
  double low = 0, high = std::log(driest / 10);
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (soil.saturation(std::exp(middle)) - least <= 1e-3 * (full - least) ? high : low) = middle;
  }
  return std::exp(high);
}

/// Returns the water content H of the pores at a pressure [m³], and its slope −dH/dp [m³/Pa]. In dry soil the residual
/// content falls to zero at 1 GPa, on a logarithmic scale.
inline std::pair<double, double> compute_content(const std::vector<SoilPores>& soils, double p) {
  double held = 0, storage = 0;
  for (const SoilPores& s : soils) {
    const double stretched = std::exp(-p / s.soil->bulk_modulus);
    double saturation = s.soil->saturation(p), slope = s.soil->saturation_slope(p);
    const double dry = s.soil->saturation(1e5) < s.soil->saturation(0) ? find_dry_suction(*s.soil) : driest / 10;
    if (p > dry) {
      const double decades = std::log(driest / dry), left = std::max(0.0, std::log(driest / p) / decades);
      slope = slope * left - saturation / (p * decades);
      saturation *= left;
    }
    held += s.pores * saturation * stretched;
    storage += s.pores * (saturation / s.soil->bulk_modulus - slope) * stretched;
  }
  return {held, storage};
}

/// The suction at which the pores hold `water`, less than at zero pressure: between bounds by bisection of Newton's
/// steps.
inline double find_suction(const std::vector<SoilPores>& soils, double water, double guess) {
  if (water <= 0) return driest;
  double low = 0, high = std::max(1.0, 2 * guess);
  while (compute_content(soils, high).first > water && high < driest) low = high, high = std::min(4 * high, driest);
  double p = guess > low && guess < high ? guess : 0.5 * (low + high);
  for (int i = 0; i < 200; ++i) {
    const auto [held, storage] = compute_content(soils, p);
    (held > water ? low : high) = p;
    double next = p + (held - water) / storage;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - p) <= 1e-12 * next) return next;
    p = next;
  }
  return p;
}

/// Returns whether the soil drains under suction; otherwise only the compressibility of the water stores.
inline bool retains(const PoreWater& soil) {
  return soil.saturation(1e5) < soil.saturation(0);
}

/// Linearised water content of a node's pores over the pressure, through the content at `pressure`. In suction it is
/// the tangent of the retention at the last solution; full pores contain the content at zero pressure and the
/// compression of the water.
struct LinearContent {
  double pressure = 0, held = 0, storage = 1;
  bool full = false, gives = false;
  double at(double p) const { return held - storage * (p - pressure); }
};

inline LinearContent fill_line(const std::vector<SoilPores>& soils) {
  double storage = 0;
  for (const SoilPores& s : soils) storage += s.pores * s.soil->saturation(0) / s.soil->bulk_modulus;
  return {.pressure = 0, .held = compute_content(soils, 0).first, .storage = storage, .full = true, .gives = true};
}

inline LinearContent start_line(const std::vector<SoilPores>& soils, double p) {
  const bool gives = std::any_of(soils.begin(), soils.end(), [](const SoilPores& s) { return retains(*s.soil); });
  if (gives && p <= 0) return fill_line(soils);
  const auto [held, storage] = compute_content(soils, p);
  return {.pressure = p, .held = held, .storage = storage, .gives = gives};
}

/// Computes the contents of the nodes and the pressures at the start of the step. The water of a node at given
/// pressures beside its fraction of the elements' water is its remainder (T22.2). In unsaturated pores the pressure
/// follows from the content. In full pores it is that of the last step, because the content would give it with K_w
/// times its error.
template <int D>
void find_node_pressures(DarcyBody<D>& body) {
  const std::size_t count = body.mesh.nodes.size();
  const bool first = body.own.size() != count;
  if (first) body.own.assign(count, 0);
  body.water.assign(count, {});
  body.pressure.resize(count, NAN);
  std::vector<std::vector<SoilPores>>& soils = body.soils_at;
  soils.assign(count, {});
  std::vector<double> last(count, 0);  // pores times pressure of the points
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    const WetCell& cell = at(body.cells, e);
    if (!cell.wet) continue;
    for (std::size_t p : cell.points) {
      const WetPoint<D>& point = body.points[p];
      const Soil& soil = soil_of(body, point);
      if (!soil.wet) continue;
      const double pores = find_pores(body, point) / (D + 1);
      for (int i = 0; i <= D; ++i) {
        const int node = node_of(body.mesh, e, i);
        at(body.water, node).pores += pores;
        at(body.water, node).water += point.water_mass / soil.water.density / (D + 1);
        at(last, node) += pores * point.pressure;
        auto& known = at(soils, node);
        const auto found =
            std::find_if(known.begin(), known.end(), [&](const SoilPores& s) { return s.soil == &soil.water; });
        if (found == known.end())
          known.push_back({&soil.water, pores});
        else
          found->pores += pores;
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    WaterNode& node = body.water[i];
    double& p = body.pressure[i];
    if (node.pores <= 0) {
      p = NAN;
      body.own[i] = 0;
      continue;
    }
    if (first && !std::isnan(p)) body.own[i] = start_line(soils[i], p).at(p) - node.water;
    body.own[i] = std::clamp(body.own[i], -most_own * node.water, most_own * node.water);
    node.water += body.own[i];
    if (std::isnan(p)) p = last[i] / node.pores;
    const bool gives =
        std::any_of(soils[i].begin(), soils[i].end(), [](const SoilPores& s) { return retains(*s.soil); });
    if (gives)
      p = p > 0 && node.water < compute_content(soils[i], 0).first ? find_suction(soils[i], node.water, p)
                                                                   : std::min(p, 0.0);
    std::tie(node.held, node.storage) = compute_content(soils[i], p);
  }
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    if (!at(body.cells, e).wet) continue;
    for (std::size_t p : at(body.cells, e).points) {
      if (!soil_of(body, body.points[p]).wet) continue;
      body.points[p].pressure = mean_over_nodes(body.mesh, e, body.pressure);
      body.points[p].w = body.points[p].v;
    }
  }
}

/// Starts from given pressures by node [Pa].
template <int D>
void start_from_pressures(DarcyBody<D>& body, const std::vector<double>& given) {
  body.pressure = given;
  body.own.clear();
}

/// Area of the open sides that touch each node, outwards. A side with a node under a skin is a part of the skin, and of
/// no other surface.
template <int D>
void find_open_area(DarcyBody<D>& body) {
  body.area.assign(body.mesh.nodes.size(), Vector<D>::Zero());
  const std::vector<bool> outside = find_outside(body);
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    if (!at(body.cells, e).wet) continue;
    const Gradients<D> b = shape_gradients(body.mesh, e);
    for (int k = 0; k <= D; ++k) {
      if (!is_open_side(body, outside, e, k)) continue;
      const Vector<D> share = -at(body.mesh.volumes, e) * b.row(k).transpose();
      const auto has_skin = [&](int i) {
        return surface_condition(body, node_of(body.mesh, e, i)).kind == SurfaceKind::closed;
      };
      bool skin = false;
      for (int i = 0; i <= D; ++i) skin = skin || (i != k && has_skin(i));
      for (int i = 0; i <= D; ++i)
        if (i != k && skin == has_skin(i)) at(body.area, node_of(body.mesh, e, i)) += share;
    }
  }
}

}  // namespace talus::reference
