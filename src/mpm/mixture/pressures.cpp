// SPDX-License-Identifier: MIT
// The equation of the nodal pressures (T22.5), with the conditions of the surface, and the water that it moves.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mesh/shape_gradient.hpp"
#include "mpm/coupled/coupled_step.hpp"
#include "mpm/coupled/root_uptake.hpp"
#include "mpm/coupled/water_surface.hpp"
#include "mpm/mixture/held_water.hpp"
#include "mpm/mixture/mixture_step.hpp"
#include "mpm/mixture/sweep.hpp"

namespace talus::mpm {
namespace {

constexpr int most_rounds = 12;           ///< solutions in a step, until lines and surface fit
constexpr int most_iterations = 5000;     ///< of the linear solver
constexpr double smallest_change = 1e-3;  ///< a change of the pressures that is none [Pa]

/// What the surface does with the water of a node.
struct SurfaceWater {
  bool is_given = false;  ///< the pressure is
  bool may_pond = false;  ///< water may stand or leave at zero pressure
  bool is_rain = false;
  double pressure = 0;  ///< [Pa]
  double inflow = 0;    ///< offered [m³/s]
};

/// One step's equation: matrix, sources, and its solution.
template <int D>
class PressureEquation {
 public:
  PressureEquation(Body<D>& body, const StepOptions<D>& o)
      : body_(body), water_(body.water), m_(body.water.mixture), mesh_(body.mesh()), graph_(*m_.graph), o_(o) {
    const std::size_t nodes = mesh_.nodes.size();
    for (auto* field : {&source_, &storage_, &diagonal_, &growth_, &drained_, &r_, &z_, &d_, &q_})
      field->assign(nodes, 0.0);
    fixed_.assign(nodes, 0);
    pushed_.assign(nodes, {});
    pores_.assign(nodes, 0.0);
    divergence_.assign(mesh_.elements.size(), 0.0);
    flux_.assign(mesh_.elements.size(), {});
    lift_ = flux_;
    entries_.assign(graph_.column.size(), {});
    for (std::size_t i = 0; i < nodes; ++i)
      for (const auto& pores : m_.node_pores) pores_[i] += pores[i];
    update_nodes(body_, pores_);
    wet_nodes_ = list_nodes(body_, [&](int i) { return pores_[i] > 0; });
    for (std::size_t i = 0; i < nodes; ++i)
      if (!(pores_[i] > 0)) m_.change[i] = m_.out[i] = m_.passed[i] = 0;
    find_surface();
    assemble();
  }

  void solve() {
    std::vector<HeldLine> lines(mesh_.nodes.size());
    for_nodes([&](int i) { lines[i] = HeldLine::start(held(i), m_.pressure[i]); });
    m_.iterations = 0;
    for (m_.rounds = 1; m_.rounds <= most_rounds; ++m_.rounds) {
      for_nodes([&](int i) {
        source_[i] = growth_[i] + drained_[i];
        storage_[i] = lines[i].storage;
        source_[i] += lines[i].at(m_.pressure[i]) - m_.node_water[i];
      });
      solve_round();
      bool settled = settle_surface();
      std::vector<std::uint8_t> right(mesh_.nodes.size(), 1);
      for_nodes([&](int i) {
        right[i] = lines[i].bend(held(i), m_.node_water[i], m_.pressure[i] + m_.change[i], m_.rounds - 1);
      });
      settled = settled && std::all_of(right.begin(), right.end(), [](auto b) { return b != 0; });
      if (!is_any(body_, !settled)) break;
    }
    apply(m_.change, q_, false);  // what flows between the nodes
    for_nodes([&](int i) { m_.out[i] = drained_[i] - q_[i] + m_.passed[i]; });
  }

  /// What every pore of an element loses, and what its nodes do not see of that: it stays with them as their own, until
  /// the soil has moved over the size of an element (T22.6, T22.7).
  void share_water() {
    update_nodes(body_, m_.out);
    for_elements([&](int e) {
      m_.share[e] = 0;
      if (!(water_.volume[e] > 0)) return;
      for (int node : mesh_.elements[e]) m_.share[e] += m_.out[node] / pores_[node] / (D + 1);
    });
    update_elements(body_, m_.share);
    for_nodes([&](int i) {
      m_.own[i] -= m_.out[i];
      for (int t = graph_.touch_start[i]; t < graph_.touch_start[i + 1]; ++t) {
        const int e = graph_.element[t];
        for (const auto& pores : m_.pores) m_.own[i] += pores[e] * m_.share[e] / (D + 1);
      }
      if (o_.moving) m_.own[i] *= std::max(0.0, 1 - o_.dt * norm(m_.velocity[i]) / graph_.size[i]);
    });
  }

  /// Darcy's flow at the end of the step, and the pressures of elements.
  void find_end() {
    for_nodes([&](int i) { m_.pressure[i] += m_.change[i]; });
    update_nodes(body_, m_.pressure);
    for_elements([&](int e) {
      for (int d = 0; d < D; ++d) m_.flux[d][e] = 0;
      if (!(water_.volume[e] > 0)) return;
      double mean = 0;
      Vec<D> gradient{};
      for (int k = 0; k <= D; ++k) {
        const double p = m_.pressure[mesh_.elements[e][k]];
        const Vec<D> b = mesh::find_shape_gradient(mesh_, e, k);
        mean += p / (D + 1);
        for (int d = 0; d < D; ++d) gradient[d] += p * b[d];
      }
      water_.mean_pressure[e] = mean;
      if (!(m_.water[e] > 0)) return;
      for (int d = 0; d < D; ++d)
        m_.flux[d][e] = m_.conductive[e] / (water_.stretch[e] * m_.water[e]) * (gradient[d] + lift_[e][d]);
    });
  }

  void count_water() {
    const std::size_t surfaces = water_.surfaces.size();
    water_.budgets.resize(surfaces);
    std::vector<SurfaceBudget> budgets(static_cast<std::size_t>(body_.layout->chunks) * surfaces);
    wet_nodes_.for_each_in_chunk([&](int i, int c) {
      SurfaceBudget& budget =
          budgets[static_cast<std::size_t>(c) * surfaces + static_cast<std::size_t>(water_.surface_of_node[i])];
      const double out = water_.density * m_.passed[i];
      (out > 0 ? budget.left : budget.entered) += std::abs(out);
      const double offered = water_.density * o_.dt * surface_[i].inflow;
      if (!surface_[i].is_rain || !(offered > 0)) return;
      budget.supplied += offered;
      budget.runoff += offered - std::max(0.0, -out);
    });
    add_budgets(body_, budgets);
  }

 private:
  HeldWater held(int i) const { return {water_.laws, m_.node_pores, i}; }

  template <class Work>
  void for_nodes(const Work& work) const {
    wet_nodes_.for_each(o_.threads, work);
  }
  template <class Work>
  void for_elements(const Work& work) const {
    mpm::for_elements(body_, o_.threads, work);
  }
  template <class Value>
  double sum(const Value& value) const {
    return wet_nodes_.sum(body_, o_.threads, value);
  }

  bool is_skin(int node) const { return lets_nothing_through(water_.surfaces[water_.surface_of_node[node]]); }

  void find_surface() {
    std::fill(m_.area.begin(), m_.area.end(), Vec<D>{});
    for (const OpenSide<D>& side : water_.open_sides) {
      const auto& nodes = mesh_.elements[side.element];
      bool skin = false;  // with a node under a skin it is a part of that, and of no other surface
      for (int k = 0; k <= D; ++k) skin = skin || (k != side.opposite && is_skin(nodes[k]));
      for (int k = 0; k <= D; ++k)
        if (k != side.opposite && skin == is_skin(nodes[k]))
          for (int d = 0; d < D; ++d) m_.area[nodes[k]][d] += side.share[d];
    }
    surface_.assign(mesh_.nodes.size(), {});
    const Vec<D> up = find_up<D>(o_.gravity);
    const double weight = water_.density * norm(o_.gravity);
    for_nodes([&](int i) {
      const double area = norm(m_.area[i]);
      if (area == 0) return;
      SurfaceWater& s = surface_[i];
      const SurfaceCondition& condition = water_.surfaces[water_.surface_of_node[i]];
      const double outside = find_outer_pressure(body_, i, i, weight, up).value_or(0);
      s.is_given = condition.kind == SurfaceKind::open || condition.kind == SurfaceKind::pressure || outside < 0;
      if (s.is_given) {
        s.pressure = outside;
        return;
      }
      s.may_pond = condition.kind != SurfaceKind::flux;
      s.is_rain = condition.kind == SurfaceKind::rain;
      Vec<D> normal = m_.area[i];
      for (double& n : normal) n /= area;
      s.inflow = -area * find_offered_flux<D>(condition, normal, m_.pressure[i], up, body_.time);
    });
  }

  /// What holds node `i` taken from a vector.
  Vec<D> hold(int i, Vec<D> v) const {
    const int c = body_.conditions.constraint_of_node[i];
    if (c < 0) return v;
    const Constraint<D>& constraint = body_.conditions.constraints[static_cast<std::size_t>(c)];
    v = free_part(constraint, v);
    if (constraint.has_wall && body_.conditions.pressed[static_cast<std::size_t>(c)]) {
      const double along = dot(v, constraint.wall_normal);
      for (int d = 0; d < D; ++d) v[d] -= along * constraint.wall_normal[d];
    }
    return v;
  }

  void assemble() {
    for_elements([&](int e) {
      divergence_[e] = 0;
      flux_[e] = {};
      if (!(water_.volume[e] > 0)) return;
      Vec<D> gradient{}, mean{};
      for (int k = 0; k <= D; ++k) {
        const int node = mesh_.elements[e][k];
        const Vec<D> b = mesh::find_shape_gradient(mesh_, e, k);
        divergence_[e] += dot(b, m_.velocity[node]);
        for (int d = 0; d < D; ++d) {
          gradient[d] += b[d] * m_.pressure[node];
          mean[d] += m_.acceleration[node][d] / (D + 1);
        }
      }
      for (int d = 0; d < D; ++d) {
        lift_[e][d] = water_.density * (o_.gravity[d] - mean[d]);
        flux_[e][d] = m_.conductive[e] * (gradient[d] + lift_[e][d]);
      }
    });
    update_elements(body_, divergence_, flux_, m_.drawn);
    for_nodes([&](int i) {
      for (int t = graph_.touch_start[i]; t < graph_.touch_start[i + 1]; ++t) {
        const int e = graph_.element[t];
        if (!(water_.volume[e] > 0)) continue;
        const Vec<D> b = mesh::find_shape_gradient(mesh_, e, graph_.local[t]);
        growth_[i] += o_.dt * m_.saturated[e] * divergence_[e] / (D + 1);
        drained_[i] += m_.drawn[e] / (D + 1) - o_.dt * dot(b, flux_[e]);
        const double squeeze = m_.coupling[e] / (D + 1);
        for (int k = 0; k <= D; ++k) {
          const Vec<D> other = mesh::find_shape_gradient(mesh_, e, k);
          const double same = k == graph_.local[t] ? 1.0 : 0.0;
          Entry& entry = entries_[static_cast<std::size_t>(
              graph_.place[static_cast<std::size_t>(t) * (D + 1) + static_cast<std::size_t>(k)])];
          entry.through +=
              o_.dt * m_.conductive[e] * dot(b, other) + m_.soft[e] / ((D + 1) * (D + 2)) * (same - 1.0 / (D + 1));
          for (int d = 0; d < D; ++d) {
            entry.push[d] += squeeze * b[d];
            entry.growth[d] += squeeze * other[d];
          }
        }
      }
    });
    for_nodes([&](int i) {
      diagonal_[i] = entries_[graph_.row_start[i]].through;
      for (int n = graph_.row_start[i]; n < graph_.row_start[i + 1]; ++n) {
        const int j = graph_.column[n];
        diagonal_[i] += m_.mobility[j] * dot(hold(j, entries_[n].growth), entries_[n].growth);
      }
    });
  }

  /// y = (flow [+ storage + growth by the push of the pressures]) x.
  void apply(std::vector<double>& x, std::vector<double>& y, bool whole) {
    update_nodes(body_, x);
    if (whole) {
      for_nodes([&](int j) {
        Vec<D> push{};
        for (int n = graph_.row_start[j]; n < graph_.row_start[j + 1]; ++n)
          for (int d = 0; d < D; ++d) push[d] += x[graph_.column[n]] * entries_[n].push[d];
        push = hold(j, push);
        for (int d = 0; d < D; ++d) pushed_[j][d] = m_.mobility[j] * push[d];
      });
      update_nodes(body_, pushed_);
    }
    for_nodes([&](int i) {
      double s = whole ? storage_[i] * x[i] : 0.0;
      for (int n = graph_.row_start[i]; n < graph_.row_start[i + 1]; ++n) {
        const int j = graph_.column[n];
        s += entries_[n].through * x[j];
        if (whole) s += dot(entries_[n].growth, pushed_[j]);
      }
      y[i] = s;
    });
  }

  /// Solves for m_.change, and for what passes the surface.
  void solve_round() {
    std::vector<double>& x = m_.change;
    for_nodes([&](int i) {
      const SurfaceWater& s = surface_[i];
      fixed_[i] = s.is_given || (s.may_pond && m_.ponded[i]);
      if (fixed_[i]) x[i] = (s.is_given ? s.pressure : 0.0) - m_.pressure[i];
    });
    apply(x, q_, true);
    for_nodes([&](int i) {
      r_[i] = fixed_[i] ? 0.0 : source_[i] - o_.dt * surface_[i].inflow - q_[i];
      z_[i] = r_[i] / (diagonal_[i] + storage_[i]);
      d_[i] = z_[i];
    });
    const double wanted = o_.pressure_tolerance * o_.pressure_tolerance * sum([&](int i) {
                            const double stiffness = diagonal_[i] + storage_[i];
                            const double b = source_[i] - o_.dt * surface_[i].inflow;
                            const double known = fixed_[i] ? x[i] * x[i] * stiffness : b * b / stiffness;
                            return known + smallest_change * smallest_change * stiffness;
                          });
    double rz = sum([&](int i) { return r_[i] * z_[i]; });
    for (int n = 0; n < most_iterations && rz > wanted; ++n, ++m_.iterations) {
      apply(d_, q_, true);
      const double step = rz / sum([&](int i) { return fixed_[i] ? 0.0 : d_[i] * q_[i]; });
      for_nodes([&](int i) {
        if (fixed_[i]) return;
        x[i] += step * d_[i];
        r_[i] -= step * q_[i];
        z_[i] = r_[i] / (diagonal_[i] + storage_[i]);
      });
      const double last = rz;
      rz = sum([&](int i) { return r_[i] * z_[i]; });
      for_nodes([&](int i) { d_[i] = fixed_[i] ? 0.0 : z_[i] + rz / last * d_[i]; });
    }
    if (!(rz <= wanted))  // or no number
      throw Error(ExitCode::unstable, fmt::format("the pore pressures of step {} were not found within {} iterations",
                                                  body_.step_count, most_iterations));
    apply(x, q_, true);
    for_nodes([&](int i) { m_.passed[i] = fixed_[i] ? q_[i] - source_[i] : -o_.dt * surface_[i].inflow; });
  }

  /// Water stands where pressure would rise above zero, until more would have to enter than is offered. Returns whether
  /// that is so already.
  bool settle_surface() {
    bool settled = true;
    wet_nodes_.for_each(1, [&](int i) {
      if (!surface_[i].may_pond) return;
      const bool stands =
          m_.ponded[i] ? -m_.passed[i] <= o_.dt * surface_[i].inflow * (1 + 1e-12) : m_.pressure[i] + m_.change[i] < 0;
      settled = settled && stands == (m_.ponded[i] != 0);
      m_.ponded[i] = stands;
    });
    return settled;
  }

  Body<D>& body_;
  Water<D>& water_;
  MixtureWater<D>& m_;
  const mesh::Mesh<D>& mesh_;
  const NodeGraph<D>& graph_;
  const StepOptions<D>& o_;
  NodeList wet_nodes_;
  std::vector<SurfaceWater> surface_;
  /// What the pressure at node j does to node i.
  struct Entry {
    double through = 0;  ///< flow [m³/Pa]
    Vec<D> push{};       ///< force [m²]
    Vec<D> growth{};     ///< of the pores at i with the displacement of j [m²]
  };
  std::vector<Entry> entries_;  ///< as the graph's columns
  std::vector<double> source_, storage_, diagonal_, growth_, drained_, pores_, divergence_;
  std::vector<double> r_, z_, d_, q_;
  std::vector<Vec<D>> pushed_, flux_, lift_;
  std::vector<std::uint8_t> fixed_;
};

}  // namespace

template <int D>
void solve_pressures(Body<D>& body, const StepOptions<D>& o) {
  find_root_draw(body, o);
  PressureEquation<D> equation(body, o);
  equation.solve();
  equation.share_water();
  equation.count_water();
  equation.find_end();
}

template void solve_pressures<2>(Body<2>&, const StepOptions<2>&);
template void solve_pressures<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
