// SPDX-License-Identifier: MIT
#pragma once
// Kernels of the surface of wet soil and of the pressure of outside water on it, element by element, for a body B here
// or on a GPU (theory 14, Conditions).

#include <algorithm>
#include <array>

#include "mesh/mesh.hpp"
#include "mpm/kernels/water_surface.hpp"
#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Content of an element.
enum class Content : char { nothing, dry_soil, wet_soil };
TALUS_PORTABLE Content find_content(const auto& body, int e) {
  if (body.water.volume[e] > 0) return Content::wet_soil;
  return body.points.count[e] > 0 ? Content::dry_soil : Content::nothing;
}

/// Returns whether the water of node `i` is fixed along the unit vector `n`.
template <class W, std::size_t D>
TALUS_PORTABLE bool is_held(const W& water, int i, const std::array<double, D>& n) {
  const int c = water.constraint_of_node[i];
  return c >= 0 && norm(remove_fixed<D>(water.constraints[c].fixed, water.constraints[c].fixed_count, n)) < 1e-9;
}

/// Returns whether the water of all nodes of the side opposite node `k` of element `e` is fixed along the side's
/// normal.
template <class B>
TALUS_PORTABLE bool is_closed(const B& body, int e, int k) {
  constexpr int D = B::dimension;
  const auto& nodes = body.mesh().elements[e];
  Vec<D> normal = mesh::find_shape_gradient(body.mesh(), e, k);
  const double length = norm(normal);
  for (double& c : normal) c /= length;
  bool closed = true;
  for (int i = 0; i <= D; ++i) closed = closed && (i == k || is_held(body.water, nodes[i], normal));
  return closed;
}

/// Returns whether an element without wet soil is outside regardless of its neighbours. Elements of a thin shear band
/// inside the soil may lose their points; such a gap is no surface, and no water leaves there. A group of neighbours is
/// outside when one of them touches no wet soil, holds dry soil, or has a side of the mesh that is open to water.
/// `touches`: by node, whether it belongs to a wet element.
template <class B, class Touches>
TALUS_PORTABLE bool is_outside_by_itself(const B& body, int e, Content content, const Touches& touches) {
  const auto& mesh = body.mesh();
  bool is_far = true, lets_through = false;
  for (int k = 0; k <= B::dimension; ++k) {
    is_far = is_far && !touches[mesh.elements[e][k]];
    lets_through = lets_through || (mesh.neighbours[e][k] < 0 && !is_closed(body, e, k));
  }
  return is_far || lets_through || content == Content::dry_soil;
}

/// Returns whether the side opposite node `k` of the wet element `e` is open: the outside is behind it, and its nodes
/// do not all fix the water along its normal.
template <class B, class Outside>
TALUS_PORTABLE bool is_open(const B& body, int e, int k, const Outside& outside) {
  const int behind = body.mesh().neighbours[e][k];
  return !((behind >= 0 && !outside[behind]) || is_closed(body, e, k));
}

/// Area vector of each node's part of the side opposite node `k` of element `e`, pointing outwards [m²].
template <template <int> class M, int D>
TALUS_PORTABLE Vec<D> find_side_share(const M<D>& mesh, int e, int k) {
  Vec<D> share = mesh::find_shape_gradient(mesh, e, k);
  for (double& c : share) c *= -mesh.volumes[e];
  return share;
}

/// Returns whether node `k` of element `e` has a part of the open side opposite node `opposite`. A side with a node
/// under an impervious skin belongs to the skin and to no other surface.
template <class B>
TALUS_PORTABLE bool has_share(const B& body, int e, int opposite, int k) {
  if (k == opposite) return false;
  const auto is_skin = [&](int i) {
    return lets_nothing_through(body.water.surfaces[body.water.surface_of_node[body.mesh().elements[e][i]]]);
  };
  bool skin = false;
  for (int i = 0; i <= B::dimension; ++i) skin = skin || (i != opposite && is_skin(i));
  return skin == is_skin(k);
}

/// The part of an element that its points fill: Σ V N_i of wet points [m³], and whether the element is integrated as a
/// whole.
template <int D>
struct Filling : std::array<double, D + 2> {
  TALUS_PORTABLE bool is_full() const { return this->back() != 0; }
  TALUS_PORTABLE Filling() : std::array<double, D + 2>{} {}
};
template <class B>
TALUS_PORTABLE Filling<B::dimension> find_filling(const B& body, int e, bool mixed) {
  constexpr int D = B::dimension, width = B::width;
  using P = PointFields<D>;
  Filling<D> moment;
  const auto& points = body.points;
  const std::int64_t first = points.block_start[e / width];
  double all = 0;
  int material = -1;
  bool uniform = true;
  for (int k = 0; k < static_cast<int>(points.count[e]); ++k) {
    const double* p = points.slot(first + k) + e % width;
    const int m = points.material[points.id[static_cast<std::size_t>((first + k) * width + e % width)]];
    const double v = p[P::volume * width];
    all += v;
    uniform = uniform && (k == 0 || m == material);
    material = m;
    if (!body.water.laws[m].wet) continue;
    double rest = 1;
    for (int d = 0; d < D; ++d) {
      const double xi = p[(P::xi + d) * width];
      moment[d + 1] += v * xi;
      rest -= xi;
    }
    moment[0] += v * rest;
  }
  moment.back() = mixed && uniform && all > body.elements.fill_limit[e] ? 1 : 0;
  return moment;
}

/// An open side with outside water at all its nodes.
template <int D>
struct PressedSide {
  int element, opposite;
  int like = -1;             ///< its last node; -1: the side is not pressed
  double pressure[D + 1]{};  ///< at its nodes [Pa]
};

/// The open side opposite node `opposite` of element `e`, with the outside pressures at its nodes.
template <class B, int D = B::dimension>
TALUS_PORTABLE PressedSide<D> find_pressed_side(const B& body, int e, int opposite, const OuterWater<D>& outer) {
  PressedSide<D> side{e, opposite};
  for (int i = 0; i <= D; ++i) {
    if (i == opposite) continue;
    const int node = body.mesh().elements[e][i];
    const auto pressure = find_outer_pressure(body, node, node, outer);
    if (!pressure.has_value()) return {e, opposite};
    side.like = node;
    side.pressure[i] = *pressure;
  }
  return side;
}

/// Correction for an element that is not full (T14.12): its soil, and with it the outside pressure, ends inside the
/// element. Sides with other soil behind them change nothing: ∮ p̂ N_i n dA over the soil's surface differs from that
/// over the element's by ∫ div(p̂ N_i) dV over the part that the soil does not fill. `side`: an open side of the
/// element; its last node has the condition of the other nodes. Calls add(k, on_water, on_darcy) with forces [N] on its
/// nodes.
template <class B, class Add, int D = B::dimension>
TALUS_PORTABLE void load_inside(const B& body, const PressedSide<D>& side, const Filling<D>& filling,
                                const OuterWater<D>& outer, Add&& add) {
  const auto& mesh = body.mesh();
  const int e = side.element;
  double pressure[D + 1];
  for (int i = 0; i <= D; ++i)
    pressure[i] =
        i == side.opposite ? *find_outer_pressure(body, mesh.elements[e][i], side.like, outer) : side.pressure[i];
  Vec<D> gradient[D + 1];
  for (int k = 0; k <= D; ++k) gradient[k] = mesh::find_shape_gradient(mesh, e, k);
  const double of_node = mesh.volumes[e] / (D + 1);
  double missing[2] = {};  // ∫ p̂ dV over the points minus that over the element: of the water, of the mixture
  Vec<D> slope[2] = {};
  for (int k = 0; k <= D; ++k) {
    const double p[2] = {pressure[k], std::min(0.0, pressure[k])};
    for (int phase = 0; phase < 2; ++phase) {
      missing[phase] += p[phase] * (filling[k] - of_node);
      for (int d = 0; d < D; ++d) slope[phase][d] += p[phase] * gradient[k][d];
    }
  }
  for (int k = 0; k <= D; ++k) {
    const double share = filling[k] - of_node;
    Vec<D> force[2];
    for (int phase = 0; phase < 2; ++phase)
      for (int d = 0; d < D; ++d) force[phase][d] = missing[phase] * gradient[k][d] + share * slope[phase][d];
    add(k, force[0], force[1]);
  }
}

/// Forces of outside water on a side, with pressure linear between its nodes: on the water, and on the mixture where
/// the pressure is compressive. `share`: area vector of each node's part of the side [m²].
template <int D, class Add>
TALUS_PORTABLE void load_side(const PressedSide<D>& side, const std::type_identity_t<Vec<D>>& share, Add&& add) {
  double sum = 0;
  for (int i = 0; i <= D; ++i)
    if (i != side.opposite) sum += side.pressure[i];
  for (int i = 0; i <= D; ++i) {
    if (i == side.opposite) continue;
    const double mean = (sum + side.pressure[i]) / (D + 1);
    Vec<D> on_water, on_darcy;
    for (int d = 0; d < D; ++d) {
      on_water[d] = mean * share[d];
      on_darcy[d] = std::min(0.0, mean) * share[d];
    }
    add(i, on_water, on_darcy);
  }
}

// Root uptake of an element (T16.4), for a body B here or on a GPU.

/// Largest fraction of an element's water that one uptake removes, whatever the rate.
inline constexpr double most_drawn = 0.05;

/// Sum of the uptake weights of the points of element `e` [m²] (2D: m).
template <class B, class Uptake>
TALUS_PORTABLE double sum_weights(const B& body, const Uptake& uptake, int e) {
  constexpr int width = B::width;
  const auto& points = body.points;
  const int b = e / width, lane = e % width, count = static_cast<int>(points.count[e]);
  double sum = 0;
  for (int k = 0; k < count; ++k)
    sum += uptake.weight[static_cast<std::size_t>(
        points.id[static_cast<std::size_t>((points.block_start[b] + k) * width + lane)])];
  return sum;
}

/// Root uptake [m³] of element `e` in `dt` seconds. `rates`: of the uptakes [m/s]; water_in(): water of the element
/// [m³].
template <class B, class Uptakes, class Rates, class WaterIn>
TALUS_PORTABLE double find_draw(const B& body, const Uptakes& uptakes, const Rates& rates, double dt, int e,
                                const WaterIn& water_in) {
  if (body.points.count[e] == 0 || !(body.water.volume[e] > 0)) return 0;
  double volume = 0;
  for (std::size_t q = 0; q < rates.size(); ++q) {
    if (rates[q] == 0) continue;
    const double share = uptakes[q].reduction.evaluate(body.water.mean_pressure[e]).value;
    if (share > 0) volume += share * rates[q] * dt * sum_weights(body, uptakes[q], e);
  }
  return volume == 0 ? 0 : std::min(volume, most_drawn * water_in());
}

}  // namespace talus::mpm
