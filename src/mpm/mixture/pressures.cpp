// SPDX-License-Identifier: MIT
// The equation of the nodal pressures (T22.4), with the conditions of the surface, and the water that it moves.

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "mesh/shape_gradient.hpp"
#include "mpm/body/node_rows.hpp"
#include "mpm/coupled/water_surface.hpp"
#include "mpm/mixture/held_water.hpp"
#include "mpm/mixture/mixture_step.hpp"

namespace talus::mpm {
namespace {

constexpr int most_rounds = 12;        ///< solutions in a step, until lines and surface fit
constexpr int most_iterations = 2000;  ///< of the linear solver
constexpr double tolerance = 1e-12;    ///< of its residual
constexpr int water_rounds = 2;        ///< (T22.5)

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
    values_.assign(graph_.column.size(), 0.0);
    find_surface();
    assemble();
  }

  void solve() {
    std::vector<HeldLine> lines(mesh_.nodes.size());
    for_nodes([&](int i) {
      if (pores_[i] > 0) lines[i] = HeldLine::start(held(i), m_.pressure[i]);
    });
    std::fill(m_.change.begin(), m_.change.end(), 0.0);
    m_.iterations = 0;
    for (m_.rounds = 1; m_.rounds <= most_rounds; ++m_.rounds) {
      for_nodes([&](int i) {
        source_[i] = growth_[i] + drained_[i];
        storage_[i] = 1;
        if (!(pores_[i] > 0)) return;
        storage_[i] = lines[i].storage;
        source_[i] += lines[i].at(m_.pressure[i]) - m_.node_water[i];
      });
      solve_round();
      bool settled = settle_surface();
      std::vector<std::uint8_t> right(mesh_.nodes.size(), 1);
      for_nodes([&](int i) {
        if (pores_[i] > 0)
          right[i] = lines[i].bend(held(i), m_.pressure[i], m_.pressure[i] + m_.change[i], m_.rounds - 1);
      });
      settled = settled && std::all_of(right.begin(), right.end(), [](auto b) { return b != 0; });
      if (settled) break;
    }
    apply(m_.change, q_, false);  // what flows between the nodes
    for_nodes([&](int i) { m_.out[i] = pores_[i] > 0 ? drained_[i] - q_[i] + m_.passed[i] : 0.0; });
  }

  /// What left the nodes, by pore of their elements.
  void share_water() {
    std::vector<double> rest = m_.out;
    std::fill(m_.share.begin(), m_.share.end(), 0.0);
    std::vector<double> share(mesh_.elements.size(), 0.0);
    for (int round = 0; round < water_rounds; ++round) {
      for_elements([&](int e) {
        share[e] = 0;
        if (!(water_.volume[e] > 0)) return;
        for (int node : mesh_.elements[e]) share[e] += rest[node] / pores_[node] / (D + 1);
        m_.share[e] += share[e];
      });
      for_nodes([&](int i) {
        for (int t = graph_.touch_start[i]; t < graph_.touch_start[i + 1]; ++t) {
          const int e = graph_.element[t];
          for (const auto& pores : m_.pores) rest[i] -= pores[e] * share[e] / (D + 1);
        }
      });
    }
  }

  void count_water() {
    water_.budgets.resize(water_.surfaces.size());
    for (std::size_t i = 0; i < surface_.size(); ++i) {
      if (!(pores_[i] > 0)) continue;
      SurfaceBudget& budget = water_.budgets[static_cast<std::size_t>(water_.surface_of_node[i])];
      const double out = water_.density * m_.passed[i];
      (out > 0 ? budget.left : budget.entered) += std::abs(out);
      const double offered = water_.density * o_.dt * surface_[i].inflow;
      if (!surface_[i].is_rain || !(offered > 0)) continue;
      budget.supplied += offered;
      budget.runoff += offered - std::max(0.0, -out);
    }
  }

 private:
  HeldWater held(int i) const { return {water_.laws, m_.node_pores, i}; }

  template <class Work>
  void for_nodes(Work&& work) const {
    parallel_for(body_.layout->chunks, o_.threads, [&](int c) {
      for (int i = first_node(body_, c); i < first_node(body_, c + 1); ++i) work(i);
    });
  }
  template <class Work>
  void for_elements(Work&& work) const {
    const int elements = mesh_.element_count();
    const Layout<D>& layout = *body_.layout;
    parallel_for(layout.chunks, o_.threads, [&](int c) {
      const int end = std::min(elements, layout.chunk_start[c + 1] * lane_width);
      for (int e = layout.chunk_start[c] * lane_width; e < end; ++e) work(e);
    });
  }
  /// Sums over the nodes, piece by piece in their order.
  template <class Value>
  double sum(Value&& value) const {
    std::vector<double> pieces(static_cast<std::size_t>(body_.layout->chunks), 0.0);
    parallel_for(body_.layout->chunks, o_.threads, [&](int c) {
      double s = 0;
      for (int i = first_node(body_, c); i < first_node(body_, c + 1); ++i) s += value(i);
      pieces[static_cast<std::size_t>(c)] = s;
    });
    double all = 0;
    for (double s : pieces) all += s;
    return all;
  }

  void find_surface() {
    std::fill(m_.area.begin(), m_.area.end(), Vec<D>{});
    for (const OpenSide<D>& side : water_.open_sides)
      for (int k = 0; k <= D; ++k)
        if (k != side.opposite)
          for (int d = 0; d < D; ++d) m_.area[mesh_.elements[side.element][k]][d] += side.share[d];
    surface_.assign(mesh_.nodes.size(), {});
    const Vec<D> up = find_up<D>(o_.gravity);
    const double weight = water_.density * norm(o_.gravity);
    for_nodes([&](int i) {
      const double area = norm(m_.area[i]);
      if (area == 0) return;
      SurfaceWater& s = surface_[i];
      const SurfaceCondition& condition = water_.surfaces[water_.surface_of_node[i]];
      const double value = condition.value.time.empty() ? 0.0 : condition.value.at(body_.time);
      switch (condition.kind) {
        case SurfaceKind::open:
          s.is_given = true;
          break;
        case SurfaceKind::pressure:
          s.is_given = true;
          s.pressure = value;
          break;
        case SurfaceKind::seepage:
          s.may_pond = true;
          break;
        case SurfaceKind::head: {
          const double depth = find_submergence<D>(value, up, mesh_.nodes[i]);
          s.is_given = depth > 0;
          s.may_pond = !s.is_given;
          s.pressure = -weight * std::max(0.0, depth);
          break;
        }
        case SurfaceKind::flux:
          s.inflow = value * area;
          break;
        case SurfaceKind::rain: {
          s.may_pond = s.is_rain = true;
          if (value >= 0) {
            s.inflow = condition.vertical ? std::max(0.0, value * dot(up, m_.area[i])) : value * area;
          } else {
            const double limit = condition.suction_limit;
            const double left = std::isinf(limit) ? 1 : (limit - m_.pressure[i]) / (evaporation_taper * limit);
            s.inflow = value * area * std::clamp(left, 0.0, 1.0);
          }
          break;
        }
      }
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
      for (int d = 0; d < D; ++d)
        flux_[e][d] = m_.conductive[e] * (gradient[d] + water_.density * (o_.gravity[d] - mean[d]));
    });
    for_nodes([&](int i) {
      for (int t = graph_.touch_start[i]; t < graph_.touch_start[i + 1]; ++t) {
        const int e = graph_.element[t];
        if (!(water_.volume[e] > 0)) continue;
        for (const auto& pores : m_.pores) pores_[i] += pores[e] / (D + 1);
        const Vec<D> b = mesh::find_shape_gradient(mesh_, e, graph_.local[t]);
        growth_[i] += o_.dt * m_.saturated[e] * divergence_[e] / (D + 1);
        drained_[i] -= o_.dt * dot(b, flux_[e]);
        const double push = m_.coupling[e] / (D + 1);
        for (int k = 0; k <= D; ++k) {
          const Vec<D> other = mesh::find_shape_gradient(mesh_, e, k);
          const double same = k == graph_.local[t] ? 1.0 : 0.0;
          values_[graph_.place[static_cast<std::size_t>(t) * (D + 1) + static_cast<std::size_t>(k)]] +=
              o_.dt * m_.conductive[e] * dot(b, other) + m_.soft[e] / ((D + 1) * (D + 2)) * (same - 1.0 / (D + 1));
          // Of B Π M⁻¹ Bᵀ, as far as the element alone makes it: for the preconditioner.
          diagonal_[i] += m_.mobility[mesh_.elements[e][k]] * push * push * dot(other, other);
        }
      }
      diagonal_[i] += values_[graph_.row_start[i]];
    });
  }

  /// y = (flow [+ storage + growth by the push of the pressures]) x.
  void apply(const std::vector<double>& x, std::vector<double>& y, bool whole) {
    if (whole) {
      for_elements([&](int e) {
        double mean = 0;
        for (int node : mesh_.elements[e]) mean += x[node];
        divergence_[e] = m_.coupling[e] * mean / (D + 1);
      });
      for_nodes([&](int j) {
        Vec<D> push{};
        for (int t = graph_.touch_start[j]; t < graph_.touch_start[j + 1]; ++t) {
          const Vec<D> b = mesh::find_shape_gradient(mesh_, graph_.element[t], graph_.local[t]);
          for (int d = 0; d < D; ++d) push[d] += divergence_[graph_.element[t]] * b[d];
        }
        push = hold(j, push);
        for (int d = 0; d < D; ++d) pushed_[j][d] = m_.mobility[j] * push[d];
      });
      for_elements([&](int e) {
        double s = 0;
        for (int k = 0; k <= D; ++k) s += dot(mesh::find_shape_gradient(mesh_, e, k), pushed_[mesh_.elements[e][k]]);
        divergence_[e] = m_.coupling[e] * s / (D + 1);
      });
    }
    for_nodes([&](int i) {
      double s = whole ? storage_[i] * x[i] : 0.0;
      for (int n = graph_.row_start[i]; n < graph_.row_start[i + 1]; ++n) s += values_[n] * x[graph_.column[n]];
      for (int t = graph_.touch_start[i]; whole && t < graph_.touch_start[i + 1]; ++t)
        s += divergence_[graph_.element[t]];
      y[i] = s;
    });
  }

  /// Solves for m_.change, and for what passes the surface.
  void solve_round() {
    std::vector<double>& x = m_.change;
    for_nodes([&](int i) {
      const SurfaceWater& s = surface_[i];
      fixed_[i] = !(pores_[i] > 0) || s.is_given || (s.may_pond && m_.ponded[i]);
      if (!(pores_[i] > 0))
        x[i] = 0;
      else if (fixed_[i])
        x[i] = (s.is_given ? s.pressure : 0.0) - m_.pressure[i];
    });
    apply(x, q_, true);
    for_nodes([&](int i) {
      r_[i] = fixed_[i] ? 0.0 : source_[i] - o_.dt * surface_[i].inflow - q_[i];
      z_[i] = r_[i] / (diagonal_[i] + storage_[i]);
      d_[i] = z_[i];
    });
    const double wanted = tolerance * tolerance * sum([&](int i) {
                            const double b = fixed_[i] ? 0.0 : source_[i] - o_.dt * surface_[i].inflow;
                            return b * b / (diagonal_[i] + storage_[i]);
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
    apply(x, q_, true);
    for_nodes([&](int i) {
      m_.passed[i] = !(pores_[i] > 0) ? 0.0 : fixed_[i] ? q_[i] - source_[i] : -o_.dt * surface_[i].inflow;
    });
  }

  /// Water stands where pressure would rise above zero, until more would have to enter than is offered. Returns whether
  /// that is so already.
  bool settle_surface() {
    bool settled = true;
    for (std::size_t i = 0; i < surface_.size(); ++i) {
      if (!surface_[i].may_pond || !(pores_[i] > 0)) continue;
      const bool stands =
          m_.ponded[i] ? -m_.passed[i] <= o_.dt * surface_[i].inflow * (1 + 1e-12) : m_.pressure[i] + m_.change[i] < 0;
      settled = settled && stands == (m_.ponded[i] != 0);
      m_.ponded[i] = stands;
    }
    return settled;
  }

  Body<D>& body_;
  Water<D>& water_;
  MixtureWater<D>& m_;
  const mesh::Mesh<D>& mesh_;
  const NodeGraph<D>& graph_;
  const StepOptions<D>& o_;
  std::vector<SurfaceWater> surface_;
  std::vector<double> values_, source_, storage_, diagonal_, growth_, drained_, pores_, divergence_;
  std::vector<double> r_, z_, d_, q_;
  std::vector<Vec<D>> pushed_, flux_;
  std::vector<std::uint8_t> fixed_;
};

}  // namespace

template <int D>
void solve_pressures(Body<D>& body, const StepOptions<D>& o) {
  PressureEquation<D> equation(body, o);
  equation.solve();
  equation.share_water();
  equation.count_water();
  MixtureWater<D>& m = body.water.mixture;
  const mesh::Mesh<D>& mesh = body.mesh();
  for (std::size_t i = 0; i < m.pressure.size(); ++i) m.pressure[i] += m.change[i];
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (!(body.water.volume[e] > 0)) continue;
    double p = 0;
    for (int node : mesh.elements[e]) p += m.pressure[node] / (D + 1);
    body.water.mean_pressure[e] = p;
  }
}

template void solve_pressures<2>(Body<2>&, const StepOptions<2>&);
template void solve_pressures<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
