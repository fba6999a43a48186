// SPDX-License-Identifier: MIT
#pragma once
// The equation of the nodal pressures in the plain step of the Darcy formulation (T22.5), with the surface conditions.

#include <Eigen/Sparse>
#include <cmath>
#include <vector>

#include "reference/plain_mixture_water.hpp"

namespace talus::reference {

/// Sums over the wet points of an element, each with the volume that it is integrated with, at the element's pressure.
struct ElementFlow {
  double saturated = 0;     ///< Σ V S [m³]
  double effective = 0;     ///< Σ V χ [m³]
  double conductive = 0;    ///< Σ V K, K = k k_r/(ρ_w g) [m⁵/(N s)]
  double soft = 0;          ///< Σ 2V/E_c [m³/Pa]
  double coupling = 0;      ///< Σ V √(Sχ) [m³]
  double water_weight = 0;  ///< Σ V K ρ_w [m² s]
};

template <int D>
ElementFlow find_element_flow(const DarcyBody<D>& body, int e) {
  const WetCell& cell = at(body.cells, e);
  ElementFlow flow;
  double relative[D + 1];
  for (std::size_t p : cell.points) {
    const WetPoint<D>& point = body.points[p];
    const Soil& soil = soil_of(body, point);
    if (!soil.wet) continue;
    const double volume = cell.stretch * point.volume;
    const double s = soil.water.saturation(point.pressure), chi = find_chi(soil.water, point.pressure);
    // k_r as the mean over the nodes: a dry one does not close the element to a front.
    double k_r = 0;
    for (int i = 0; i <= D; ++i) {
      relative[i] =
          soil.water.relative_conductivity(soil.water.saturation(at(body.pressure, node_of(body.mesh, e, i))));
      k_r += std::max(lowest_relative_conductivity, relative[i]) / (D + 1);
    }
    const double k = soil.water.conductivity * k_r / (soil.water.density * soil.water.drag_gravity);
    const double nu = soil.skeleton.poisson_ratio,
                 modulus = soil.skeleton.young_modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    flow.saturated += volume * s;
    flow.effective += volume * chi;
    flow.conductive += volume * k;
    flow.water_weight += volume * k * soil.water.density;
    flow.soft += 2 * volume / modulus;
    flow.coupling += volume * std::sqrt(s * chi);
  }
  return flow;
}

/// −Σ V χ δ ∇N at every node, δ the mean over the element's nodes [N].
template <int D>
std::vector<Vector<D>> find_pressure_force(const DarcyBody<D>& body, const std::vector<ElementFlow>& flow,
                                           const std::vector<double>& field) {
  std::vector<Vector<D>> force(body.mesh.nodes.size(), Vector<D>::Zero());
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    if (!at(body.cells, e).wet) continue;
    const Gradients<D> b = shape_gradients(body.mesh, e);
    const double mean = mean_over_nodes(body.mesh, e, field);
    for (int i = 0; i <= D; ++i)
      at(force, node_of(body.mesh, e, i)) -= at(flow, e).effective * mean * b.row(i).transpose();
  }
  return force;
}

/// Condition of the surface on the water of a node.
struct SurfaceWater {
  bool is_given = false;  ///< the pressure is
  double pressure = 0;    ///< [Pa]
  bool may_pond = false;  ///< water may pond or leave at zero pressure
  double inflow = 0;      ///< offered [m³/s]
};

template <int D>
SurfaceWater find_surface_water(const DarcyBody<D>& body, int number) {
  SurfaceWater water;
  const Vector<D>& area = at(body.area, number);
  if (area.norm() == 0) return water;
  const SurfaceCondition<D> condition = surface_condition(body, number);
  const bool flooded = condition.kind == SurfaceKind::head && submergence(body, number) > 0;
  if (condition.kind == SurfaceKind::open || condition.kind == SurfaceKind::pressure || flooded) {
    water.is_given = true;
    water.pressure = condition.kind == SurfaceKind::open ? 0.0 : outer_pressure(body, number, number);
    return water;
  }
  if (condition.kind == SurfaceKind::closed) return water;
  WetNode<D> node;
  node.surface = area;
  node.suction = at(body.pressure, number);
  water.inflow = -offered_flux(condition, node) * area.norm();
  water.may_pond = condition.kind != SurfaceKind::flux;
  return water;
}

template <int D>
double darcy_mass(const WetNode<D>& node) {
  return node.solid_mass + node.water_mass;
}

/// Fraction s of a node's motion that the points receive (T22.3) [-]: 1, and less where few points are near.
template <int D>
std::vector<double> find_seen(const DarcyBody<D>& body) {
  std::vector<double> seen(body.nodes.size(), 0);
  for (const WetPoint<D>& point : body.points) {
    const Weights<D> n = shape_functions(body.mesh, point.element, point.x);
    for (int i = 0; i <= D; ++i)
      at(seen, node_of(body.mesh, point.element, i)) += n[i] * n[i] * (point.mass + point.water_mass);
  }
  for (std::size_t i = 0; i < seen.size(); ++i)
    seen[i] = body.nodes[i].solid_mass <= massless_limit(body)
                  ? 0
                  : std::min(1.0, 0.5 * (D + 2) * seen[i] / darcy_mass(body.nodes[i]));
  return seen;
}

/// Growth of the pores by the pressures at the end of the step: Δt²/β B Π s M⁻¹ Bᵀ (T22.5), with s of (T22.3), Π the
/// projection onto the free directions of the nodes, and B from `squeeze` [m³/Pa].
template <int D>
Eigen::SparseMatrix<double> find_pushed_growth(const DarcyBody<D>& body, const DarcySettings& settings,
                                               const std::vector<Eigen::Triplet<double>>& squeeze) {
  const auto count = static_cast<Eigen::Index>(body.mesh.nodes.size());
  const std::vector<double> seen = find_seen(body);
  std::vector<Eigen::Triplet<double>> free;
  const double dt = settings.time_step;
  for (std::size_t i = 0; i < body.nodes.size(); ++i)
    for (int d = 0; d < D && seen[i] > 0; ++d) {
      const Vector<D> moved = body.solid_constraints[i].apply(Vector<D>::Unit(d));
      for (int c = 0; c < D; ++c)
        free.emplace_back(static_cast<int>(i) * D + c, static_cast<int>(i) * D + d,
                          dt * dt / settings.mass_scaling * seen[i] / darcy_mass(body.nodes[i]) * moved[c]);
    }
  Eigen::SparseMatrix<double> b(count, D * count), inverse(D * count, D * count);
  b.setFromTriplets(squeeze.begin(), squeeze.end());
  inverse.setFromTriplets(free.begin(), free.end());
  return b * inverse * b.transpose();
}

/// Linear solutions in a step until contents and surface fit, and the tolerance of the contents as a fraction of the
/// pores [-].
inline constexpr int most_pressure_rounds = 60;
inline constexpr double line_tolerance = 1e-12;

/// Bends the line after a solution with the pressure `next`: the tangent where the node's own equation
/// H(p) - at(next) = stiffness (p - next) is satisfied, with the other pressures as they are. Returns whether the line
/// fitted before.
inline bool bend_line(LinearContent& line, const std::vector<SoilPores>& soils, double next, double stiffness) {
  if (!line.gives) return true;
  const double before = line.at(next), full = compute_content(soils, 0).first;
  const double error = (next > 0 ? compute_content(soils, next).first : fill_line(soils).at(next)) - before;
  if (std::abs(error) <= line_tolerance * full) return true;
  if (full - before + stiffness * next <= 0) {
    line = fill_line(soils);
  } else {
    double low = 0, high = 1e9;
    for (int i = 0; i < 60; ++i) {
      const double p = 0.5 * (low + high);
      (compute_content(soils, p).first - before - stiffness * (p - next) > 0 ? low : high) = p;
    }
    line = start_line(soils, high);
  }
  return false;
}

/// Solves matrix δ = source + what the surface takes. Writes δ and that.
template <int D>
void solve_round(DarcyBody<D>& body, const DarcySettings& settings, const std::vector<SurfaceWater>& surface,
                 const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& source, Eigen::VectorXd& change,
                 Eigen::VectorXd& outside) {
  const Eigen::Index count = source.size();
  Eigen::VectorXd given = Eigen::VectorXd::Zero(count), right = source;
  const auto is_fixed = [&](Eigen::Index i) { return body.water[static_cast<std::size_t>(i)].fixed; };
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto number = static_cast<std::size_t>(i);
    WaterNode& node = body.water[number];
    const SurfaceWater& water = surface[number];
    if (node.pores <= 0) continue;
    node.fixed = water.is_given || (water.may_pond && body.ponded[number]);
    if (node.fixed)
      given[i] = (water.is_given ? water.pressure : 0.0) - body.pressure[number];
    else
      right[i] -= settings.time_step * water.inflow;
  }
  right -= matrix * given;
  for (Eigen::Index i = 0; i < count; ++i)
    if (is_fixed(i)) right[i] = 0;
  Eigen::SparseMatrix<double> free = matrix;
  free.prune([&](Eigen::Index row, Eigen::Index column, double) {
    return row == column || !(is_fixed(row) || is_fixed(column));
  });
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(free);
  change = solver.solve(right);
  for (Eigen::Index i = 0; i < count; ++i)
    if (is_fixed(i)) change[i] = given[i];
  outside = matrix * change - source;
  for (Eigen::Index i = 0; i < count; ++i)
    if (!is_fixed(i)) outside[i] = -settings.time_step * surface[static_cast<std::size_t>(i)].inflow;
}

/// Ponds water where the pressure would rise above zero, until the inflow would exceed the supply. Returns whether the
/// set of ponded nodes is unchanged.
template <int D>
bool settle_surface(DarcyBody<D>& body, const DarcySettings& settings, const std::vector<SurfaceWater>& surface,
                    const Eigen::VectorXd& change, const Eigen::VectorXd& outside) {
  bool settled = true;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (!surface[i].may_pond || body.water[i].pores <= 0) continue;
    const auto at = static_cast<Eigen::Index>(i);
    const bool is_ponded = body.ponded[i] ? -outside[at] <= settings.time_step * surface[i].inflow * (1 + 1e-12)
                                          : body.pressure[i] + change[at] < 0;
    settled = settled && is_ponded == body.ponded[i];
    body.ponded[i] = is_ponded;
  }
  return settled;
}

/// Solves for the pressures at the end of the step, the outflow of every node, and the flow through the surface.
/// `predicted` are the nodal velocities under the forces of the start, `acceleration` their accelerations.
template <int D>
std::vector<ElementFlow> solve_pressures(DarcyBody<D>& body, const DarcySettings& settings,
                                         const std::vector<Vector<D>>& predicted,
                                         const std::vector<Vector<D>>& acceleration) {
  const double dt = settings.time_step;
  const auto count = static_cast<Eigen::Index>(body.mesh.nodes.size());
  std::vector<ElementFlow> flow(body.cells.size());
  std::vector<Eigen::Triplet<double>> all, through, squeeze;  // storage and flow; flow alone; growth of pores by motion
  Eigen::VectorXd growth = Eigen::VectorXd::Zero(count), drained = growth, p = growth;
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    if (!at(body.cells, e).wet) continue;
    const ElementFlow f = at(flow, e) = find_element_flow(body, e);
    const Gradients<D> b = shape_gradients(body.mesh, e);
    double divergence = 0;
    Vector<D> mean = Vector<D>::Zero();
    for (int i = 0; i <= D; ++i) {
      const int node = node_of(body.mesh, e, i);
      divergence += at(predicted, node).dot(b.row(i));
      mean += at(acceleration, node) / (D + 1);
      for (int d = 0; d < D; ++d)
        for (int j = 0; j <= D; ++j)
          squeeze.emplace_back(node_of(body.mesh, e, j), node * D + d, f.coupling / (D + 1) * b(i, d));
    }
    for (int i = 0; i <= D; ++i) {
      const int row = node_of(body.mesh, e, i);
      growth[row] += dt * f.saturated * divergence / (D + 1);
      drained[row] -= dt * f.water_weight * b.row(i).dot(body.gravity - mean);
      for (int j = 0; j <= D; ++j) {
        const double l = b.row(i).dot(b.row(j)), same = i == j ? 1.0 : 0.0;
        const double flux =
            dt * f.conductive * l + settings.projection * f.soft / ((D + 1) * (D + 2)) * (same - 1.0 / (D + 1));
        through.emplace_back(row, node_of(body.mesh, e, j), flux);
        all.emplace_back(row, node_of(body.mesh, e, j), flux);
      }
      for (int j = 0; j <= D; ++j) {
        const int column = node_of(body.mesh, e, j);
        drained[row] -= dt * f.conductive * b.row(i).dot(b.row(j)) * at(body.pressure, column);
      }
    }
  }
  for (int i = 0; i < static_cast<int>(count); ++i) all.emplace_back(i, i, 0.0);
  Eigen::SparseMatrix<double> matrix(count, count), moving(count, count);
  matrix.setFromTriplets(all.begin(), all.end());
  matrix += find_pushed_growth(body, settings, squeeze);
  moving.setFromTriplets(through.begin(), through.end());
  std::vector<SurfaceWater> surface;
  for (int i = 0; i < static_cast<int>(count); ++i) surface.push_back(find_surface_water(body, i));
  body.ponded.resize(body.mesh.nodes.size(), false);
  Eigen::VectorXd change = Eigen::VectorXd::Zero(count), outside = change;
  std::vector<LinearContent> lines;
  for (std::size_t i = 0; i < surface.size(); ++i)
    lines.push_back(body.water[i].pores > 0 ? start_line(body.soils_at[i], body.pressure[i]) : LinearContent{});
  for (int round = 0; round < most_pressure_rounds; ++round) {
    Eigen::VectorXd source = growth + drained;
    Eigen::SparseMatrix<double> whole = matrix;
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto number = static_cast<std::size_t>(i);
      const LinearContent& line = lines[number];
      whole.coeffRef(i, i) += line.storage;
      if (body.water[number].pores > 0) source[i] += line.at(body.pressure[number]) - body.water[number].water;
    }
    solve_round(body, settings, surface, whole, source, change, outside);
    bool settled = settle_surface(body, settings, surface, change, outside);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto number = static_cast<std::size_t>(i);
      if (body.water[number].pores <= 0) continue;
      const double next = body.pressure[number] + change[i];
      if (!body.water[number].fixed)
        settled = bend_line(lines[number], body.soils_at[number], next, matrix.coeff(i, i)) && settled;
      else if (lines[number].gives)
        lines[number] = start_line(body.soils_at[number], next);
    }
    if (settled) break;
  }
  const Eigen::VectorXd out = drained - moving * change + outside;
  for (Eigen::Index i = 0; i < count; ++i) {
    WaterNode& node = body.water[static_cast<std::size_t>(i)];
    if (node.pores <= 0) continue;
    node.change = change[i];
    node.out = out[i];
    node.passed = outside[i];
    node.offered = surface[static_cast<std::size_t>(i)].inflow;
  }
  return flow;
}

}  // namespace talus::reference
