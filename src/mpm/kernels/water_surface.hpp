// SPDX-License-Identifier: MIT
#pragma once
// Hydraulic conditions at the surface of wet soil: the surface of a node, the flux that is offered there, and the limit
// on inflow (theory 14, Conditions).

#include <algorithm>
#include <cmath>
#include <optional>

#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Fraction below which a node's area is round-off or the quadrature error of crowded points, and no surface.
inline constexpr double surface_share = 1e-3;
/// Evaporation decreases to zero over this fraction of its limiting suction.
inline constexpr double evaporation_taper = 0.1;

/// `f` without its components along `count` fixed directions (unit vectors, orthonormal).
template <int D>
TALUS_KERNEL Vec<D> remove_fixed(const Vec<D>* fixed, int count, std::type_identity_t<Vec<D>> f) {
  for (int k = 0; k < count; ++k) {
    const double along = dot(f, fixed[k]);
    for (int d = 0; d < D; ++d) f[d] -= along * fixed[k][d];
  }
  return f;
}

/// Unit vector against gravity; zero without gravity.
template <int D>
TALUS_PORTABLE Vec<D> find_up(const Vec<D>& gravity) {
  const double g = norm(gravity);
  Vec<D> up{};
  for (int d = 0; d < D && g > 0; ++d) up[d] = -gravity[d] / g;
  return up;
}

/// Surface of a node, and the condition on the water that passes it.
template <int D>
struct SurfaceNode {
  const SurfaceCondition* condition = nullptr;  ///< nullptr: the node is on no surface
  Vec<D> normal{};                              ///< unit, out of the soil
  double area = 0;                              ///< [m²]
  double offered = 0;                           ///< given flux q̂·n, negative inwards [m/s]
  bool limits = false;                          ///< the condition may limit the flux
  bool always = false;                          ///< the flux is prescribed in both directions
  bool supplies = false;                        ///< outside water is present: rain, or standing water
};

/// Depth of the node below the water level [m]; negative: the node is dry.
template <int D>
TALUS_PORTABLE double find_submergence(double level, const Vec<D>& up, const Vec<D>& x) {
  double height = 0;
  for (std::size_t d = 0; d < D; ++d) height += up[d] * x[d];
  return level - height;
}

/// Flux q̂_n [m/s], negative inwards, of rain, evaporation or a given flux at time `t` [s], for the outward unit normal
/// `normal` and the suction [Pa] of the soil below the surface.
template <int D, class Condition>
TALUS_PORTABLE double find_offered_flux(const Condition& condition, const Vec<D>& normal, double suction,
                                        const std::type_identity_t<Vec<D>>& up, double t) {
  const double value = find_value(condition, t);
  if (condition.kind == SurfaceKind::flux) return -value;
  if (condition.kind != SurfaceKind::rain) return 0;
  if (value >= 0) return condition.vertical ? std::min(0.0, -value * dot(up, normal)) : -value;
  const double limit = condition.suction_limit;
  const double left = std::isinf(limit) ? 1 : (limit - suction) / (evaporation_taper * limit);
  return -value * std::clamp(left, 0.0, 1.0);
}

/// Standing water outside the soil.
template <int D>
struct OuterWater {
  double unit_weight;  ///< [N/m³]
  Vec<D> up;           ///< unit vector against gravity

  TALUS_PORTABLE OuterWater(double density, const Vec<D>& gravity)
      : unit_weight(density * norm(gravity)), up(find_up<D>(gravity)) {}
};

/// Pressure [Pa] of outside water at node `i` under the condition of node `like`; nullopt where there is none.
template <class B, int D = B::dimension>
TALUS_PORTABLE std::optional<double> find_outer_pressure(const B& body, int i, int like, const OuterWater<D>& outer) {
  const auto& c = body.water.surfaces[body.water.surface_of_node[like]];
  const double value = find_value(c, body.time);
  if (c.kind == SurfaceKind::head)
    return -outer.unit_weight * std::max(0.0, find_submergence<D>(value, outer.up, body.mesh().nodes[i]));
  if (c.kind == SurfaceKind::pressure) return value;
  return std::nullopt;
}

/// The surface at node `i` at time `t` [s]. `outside` is its area vector Σ V̄ ∇N, `up` the unit vector against gravity.
template <int D>
SurfaceNode<D> find_surface_node(const Body<D>& body, int i, const double* outside, double scale,
                                 const std::type_identity_t<Vec<D>>& up, double t) {
  const Water<D>& water = body.water;
  SurfaceNode<D> s;
  const Vec<D>& facing = water.facing[i];
  if (dot(facing, facing) == 0) return s;
  Vec<D> part;
  for (int d = 0; d < D; ++d) part[d] = outside[d];
  if (const int c = water.constraint_of_node[i]; c >= 0)
    part = remove_fixed<D>(water.constraints[c].fixed, water.constraints[c].fixed_count, part);
  const double area = norm(part);
  if (!(dot(part, facing) > 0 && area > surface_share * scale)) return s;
  s.area = area;
  for (int d = 0; d < D; ++d) s.normal[d] = part[d] / area;
  s.condition = &water.surfaces[water.surface_of_node[i]];
  const double value = find_value(*s.condition, t);
  switch (s.condition->kind) {
    case SurfaceKind::open:
    case SurfaceKind::pressure:
      s.supplies = true;
      break;
    case SurfaceKind::seepage:
      s.limits = true;
      break;
    case SurfaceKind::head:
      s.limits = find_submergence<D>(value, up, body.mesh().nodes[i]) <= 0;
      s.supplies = !s.limits;
      break;
    case SurfaceKind::flux:
      s.limits = s.always = true;
      s.offered = -value;
      break;
    case SurfaceKind::rain:
      s.limits = true;
      s.offered = find_offered_flux<D>(*s.condition, s.normal, water.suction.empty() ? 0.0 : water.suction[i], up, t);
      s.supplies = value >= 0 && s.offered < 0;
      break;
  }
  return s;
}

/// If more water would enter than is supplied, an impulse along the normal, opposite on the two phases, corrects the
/// relative velocity (T14.11). Fixed directions take no impulse; the supports take it. Updates `v` and `w` [m/s] and
/// returns whether they changed.
template <int D>
// NOLINTNEXTLINE(readability-function-size): two phases, each with its mass and velocity
bool limit_inflow(const Body<D>& body, int i, const SurfaceNode<D>& s, double solid_mass, double water_mass,
                  double content, std::type_identity_t<Vec<D>>& v, std::type_identity_t<Vec<D>>& w) {
  if (!s.limits) return false;
  double net = -s.offered;
  for (int d = 0; d < D; ++d) net += content * (w[d] - v[d]) * s.normal[d];
  if (net >= 0 && !s.always) return false;
  Vec<D> solid = s.normal, water = s.normal;
  if (const int c = body.conditions.constraint_of_node[i]; c >= 0) {
    const Constraint<D>& k = body.conditions.constraints[c];
    solid = remove_fixed<D>(k.fixed, k.fixed_count, solid);
    if (k.has_wall && body.conditions.pressed[c]) {
      const double along = dot(solid, k.wall_normal);
      for (int d = 0; d < D; ++d) solid[d] -= along * k.wall_normal[d];
    }
  }
  if (const int c = body.water.constraint_of_node[i]; c >= 0)
    water = remove_fixed<D>(body.water.constraints[c].fixed, body.water.constraints[c].fixed_count, water);
  if (norm(water) < 1e-9) return false;
  for (int d = 0; d < D; ++d) {
    solid[d] /= solid_mass;
    water[d] /= water_mass;
  }
  const double impulse = -net / (content * (dot(solid, s.normal) + dot(water, s.normal)));
  for (int d = 0; d < D; ++d) {
    w[d] += impulse * water[d];
    v[d] -= impulse * solid[d];
  }
  return true;
}

}  // namespace talus::mpm
