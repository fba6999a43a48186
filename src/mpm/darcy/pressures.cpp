// SPDX-License-Identifier: MIT
// Assembly and solution of the equation of the nodal pressures (T22.5) with the conditions of the surface, and the
// redistribution of water that follows (T22.6, T22.7).
#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "mpm/darcy/darcy_step.hpp"
#include "mpm/darcy/sweep.hpp"
#include "mpm/kernels/pressure_kernels.hpp"
#include "mpm/kernels/surface_kernels.hpp"
#include "mpm/pore_water/surface.hpp"

namespace talus::mpm {

namespace {

/// The equation of one step, chunk by chunk.
template <int D>
class PressureEquation {
 public:
  PressureEquation(Body<D>& body, const StepOptions<D>& o)
      : body_(body), water_(body.water), m_(body.water.darcy), mesh_(body.mesh()), o_(o) {
    const std::size_t nodes = mesh_.nodes.size();
    for (auto* field : {&s_.storage, &s_.diagonal, &s_.grown, &s_.drained, &s_.r, &s_.z, &s_.d, &s_.q})
      field->assign(nodes, 0.0);
    s_.fixed.assign(nodes, 0);
    s_.pushed.assign(nodes, {});
    s_.pores.assign(nodes, 0.0);
    s_.divergence.assign(mesh_.elements.size(), 0.0);
    s_.flux.assign(mesh_.elements.size(), {});
    s_.lift = s_.flux;
    s_.entries.assign(m_.graph->column.size(), {});
    s_.push.assign(m_.graph->column.size(), {});
    s_.surface.assign(nodes, {});
    s_.lines.assign(nodes, {});
    for (int i = 0; i < mesh_.node_count(); ++i) lines_.sum_pores(i);
    update_nodes(body_, s_.pores);
    wet_nodes_ = list_nodes(body_, [&](int i) { return s_.pores[i] > 0; });
    find_area();
    for_nodes([&](int i) { lines_.find_surface(i); });
    for_elements([&](int e) { lines_.assemble_element(e); });
    update_elements(body_, s_.divergence, s_.flux, m_.drawn);
    for_nodes([&](int i) { lines_.assemble_node(i); });
    for_nodes([&](int i) { lines_.find_diagonal(i); });
  }

  void solve() {
    for_nodes([&](int i) { lines_.start_line(i); });
    m_.iterations = 0;
    bool settled = false;
    for (m_.rounds = 1; m_.rounds <= most_rounds; ++m_.rounds) {
      if (!settled) start_residual();
      const double wanted = find_wanted(), rz = sum([&](int i) { return lines_.find_residual(i); });
      reduce_residual(rz, std::max(wanted, round_reduction * round_reduction * rz));
      settled = true;
      wet_nodes_.for_each(1, [&](int i) { settled = lines_.settle_surface(i) && settled; });
      settled = !is_any(body_, !settled);
      for_nodes([&](int i) { lines_.bend_line(i, m_.rounds - 1); });
      if (settled && sum([&](int i) { return lines_.find_error(i); }) <= wanted) break;
    }
    for_nodes([&](int i) { lines_.find_passed(i); });
    apply(m_.change, false);
    for_nodes([&](int i) { lines_.find_out(i); });
  }

  /// Water lost per pore volume of the elements (T22.6), and the part that stays with the nodes (T22.7).
  void distribute_water() {
    update_nodes(body_, m_.out);
    for_elements([&](int e) { lines_.distribute_water(e); });
    update_elements(body_, m_.share);
    for_nodes([&](int i) { lines_.keep_own(i); });
  }

  void find_end() {
    for_nodes([&](int i) { m_.pressure[i] += m_.change[i]; });
    update_nodes(body_, m_.pressure);
    for_elements([&](int e) { lines_.find_end(e); });
  }

  void count_water() {
    const std::size_t surfaces = water_.surfaces.size();
    water_.budgets.resize(surfaces);
    std::vector<SurfaceBudget> budgets(static_cast<std::size_t>(body_.layout->chunks) * surfaces);
    wet_nodes_.for_each_in_chunk([&](int i, int c) {
      budgets[static_cast<std::size_t>(c) * surfaces + static_cast<std::size_t>(water_.surface_of_node[i])].add(
          lines_.count_water(i));
    });
    add_budgets(body_, budgets);
  }

 private:
  void for_nodes(const auto& work) const { wet_nodes_.for_each(o_.threads, work); }
  void for_elements(const auto& work) const { mpm::for_elements(body_, o_.threads, work); }
  double sum(const auto& value) const { return wet_nodes_.sum(body_, o_.threads, value); }

  void find_area() {
    std::fill(m_.area.begin(), m_.area.end(), Vec<D>{});
    for (const OpenSide<D>& side : water_.open_sides) {
      for (int k = 0; k <= D; ++k)
        if (has_share(body_, side.element, side.opposite, k))
          for (int d = 0; d < D; ++d) m_.area[mesh_.elements[side.element][k]][d] += side.share[d];
    }
  }

  /// q = A x: flow only, or with `whole` also storage and pore growth by the motion that x causes.
  void apply(std::vector<double>& x, bool whole) {
    update_nodes(body_, x);
    if (whole) {
      for_nodes([&](int j) { lines_.push(x, j); });
      update_nodes(body_, s_.pushed);
    }
    for_nodes([&](int i) { lines_.multiply(x, whole, i); });
  }

  /// Residual of the equation with the prescribed pressures of this round.
  void start_residual() {
    for_nodes([&](int i) { lines_.fix_node(i); });
    apply(m_.change, true);
    for_nodes([&](int i) { lines_.start_residual(i); });
  }
  /// Square of the residual at convergence.
  double find_wanted() {
    return o_.pressure_tolerance * o_.pressure_tolerance * sum([&](int i) { return lines_.find_scale(i); });
  }
  /// Conjugate gradients for m_.change until r·z, which is `rz` at the start, is at most `wanted`.
  void reduce_residual(double rz, double wanted) {
    for_nodes([&](int i) { lines_.update_direction(0, i); });
    for (int n = 0; n < most_iterations && rz > wanted; ++n, ++m_.iterations) {
      apply(s_.d, true);
      const double step = rz / sum([&](int i) { return lines_.find_curvature(i); });
      for_nodes([&](int i) { lines_.advance_solution(step, i); });
      const double last = rz;
      rz = sum([&](int i) { return lines_.find_residual(i); });
      for_nodes([&](int i) { lines_.update_direction(rz / last, i); });
    }
    if (!(rz <= wanted)) throw_no_pressures(body_.step_count);  // also if rz is NaN
    for_nodes([&](int i) { lines_.find_passed(i); });
  }

  using Arrays = PressureArrays<D, ArrayHere>;
  Body<D>& body_;
  Water<D>& water_;
  DarcyWater<D>& m_;
  const mesh::Mesh<D>& mesh_;
  const StepOptions<D>& o_;
  NodeList wet_nodes_;
  Arrays s_;
  PressureLines<Body<D>, Arrays> lines_{body_, s_, o_};
};

}  // namespace

void throw_no_pressures(std::int64_t step) {
  throw Error(ExitCode::unstable, "the pore pressures of step {} were not found within {} iterations", step,
              most_iterations);
}

template <int D>
void solve_pressures(Body<D>& body, const StepOptions<D>& o) {
  find_root_draw(body, o);
  PressureEquation<D> equation(body, o);
  equation.solve();
  equation.distribute_water();
  equation.count_water();
  equation.find_end();
}

template void solve_pressures<2>(Body<2>&, const StepOptions<2>&);
template void solve_pressures<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
