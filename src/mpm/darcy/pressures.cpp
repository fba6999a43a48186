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
      : body_(body), water_(body.water), m_(body.water.darcy), mesh_(body.mesh()), o_(o), s_(find_arrays()) {
    allocate();
    for (int i = 0; i < mesh_.node_count(); ++i) lines_.sum_pores(i);
    update_nodes(body_, s_.pores);
    wet_nodes_ = list_nodes(body_, [&](int i) { return s_.pores[i] > 0; });
    slices_ = list_slices(body_, wet_nodes_);
    find_area();
    for_nodes([&](int i) { lines_.find_surface(i); });
    surface_nodes_ = list_nodes(body_, [&](int i) { return s_.pores[i] > 0 && s_.surface[i].may_pond; });
    for_blocks([&](int e) { lines_.template assemble_elements<Pack>(e); });
    update_elements(body_, s_.growth_of, m_.drawn);
    for (auto& flux : s_.flux) update_elements(body_, flux);
    for_slices([&]<class T>(int i) { lines_.template clear<T>(i); });
    for_slices([&]<class T>(int i) { lines_.template find_source<T>(i); });
    for_blocks([&, all = s_.assembled_from.dt != o_.dt](int e) { lines_.template mark_changed<Pack>(e, all); });
    s_.assembled_from.dt = o_.dt;
    update_elements(body_, s_.assembled_from.changed);
    for_slices([&]<class T>(int i) { lines_.template assemble_rows<T>(i); });
    for_slices([&]<class T>(int i) { lines_.template find_diagonal<T>(i); });
  }

  void solve() {
    std::vector<std::uint8_t> drains(mesh_.nodes.size(), 0);
    for_nodes([&](int i) { drains[i] = lines_.start_line(i); });
    const NodeList draining = list_nodes(body_, [&](int i) { return drains[i] != 0; });
    m_.iterations = 0;
    bool settled = false;
    for (m_.rounds = 1; m_.rounds <= most_rounds; ++m_.rounds) {
      double rz =
          settled ? sum([&]<class T>(int i) { return lines_.template start_direction<T>(i); }) : start_residual();
      const double wanted = o_.pressure_tolerance * o_.pressure_tolerance *
                            sum([&]<class T>(int i) { return lines_.template find_scale<T>(i); });
      rz = reduce_residual(rz, std::max(wanted, round_reduction * round_reduction * rz));
      for_nodes([&](int i) { lines_.find_passed(i); });
      settled = true;
      surface_nodes_.for_each(1, [&](int i) { settled = lines_.settle_surface(i) && settled; });
      settled = !is_any(body_, !settled);
      rz += draining.sum(body_, o_.threads, [&](int i) { return lines_.bend_line(i, m_.rounds - 1); });
      if (settled && rz <= wanted) break;
    }
    for_nodes([&](int i) { lines_.find_passed(i); });
    update_nodes(body_, m_.change);
    for_slices([&]<class T>(int i) { lines_.template find_flow<T>(m_.change, i); });
    for_nodes([&](int i) { lines_.find_out(i); });
  }

  /// Water lost per pore volume of the elements (T22.6), and the part that stays with the nodes (T22.7).
  void distribute_water() {
    update_nodes(body_, s_.z);
    for_blocks([&](int e) { lines_.template distribute_water<Pack>(e); });
    update_elements(body_, s_.lost);
    for_slices([&]<class T>(int i) { lines_.template keep_own<T>(i); });
  }

  void find_end() {
    for_nodes([&](int i) { m_.pressure[i] += m_.change[i]; });
    update_nodes(body_, m_.pressure);
    for_blocks([&](int e) { lines_.template find_end<Pack>(e); });
    update_elements(body_, m_.pressing);
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
  using Arrays = PressureArrays<D, ArrayHere>;
  void for_nodes(const auto& work) const { wet_nodes_.for_each(o_.threads, work); }
  void for_blocks(const auto& work) const { for_blocks_of_elements(body_, o_.threads, work); }
  void for_slices(const auto& work) const { slices_.for_each(o_.threads, work); }
  double sum(const auto& work) const { return slices_.sum(body_, o_.threads, work); }

  Arrays& find_arrays() {
    if (!m_.work.arrays) m_.work.arrays = std::make_shared<Arrays>();
    return *static_cast<Arrays*>(m_.work.arrays.get());
  }
  void allocate() {
    const std::size_t nodes = mesh_.nodes.size(), lanes = m_.graph->lanes, entries = m_.graph->column.size();
    for (auto* field : {&s_.drive, &s_.storage, &s_.diagonal, &s_.inverse, &s_.grown, &s_.drained, &s_.pores, &s_.r,
                        &s_.z, &s_.d, &s_.q})
      field->resize(nodes);
    s_.carried.resize(nodes);
    s_.fixed.resize(nodes);
    s_.surface.resize(nodes);
    s_.lines.resize(nodes);
    for (auto* field : {&s_.growth_of, &s_.lost, &s_.assembled_from.coupling, &s_.assembled_from.conductive,
                        &s_.assembled_from.soft, &s_.assembled_from.changed})
      field->resize(lanes);
    for (int d = 0; d < D; ++d) {
      s_.flux[d].resize(lanes);
      s_.lift[d].resize(lanes);
    }
    s_.through.resize(entries);
    s_.growth.resize(entries * D);
    s_.push.resize(entries * D);
  }

  void find_area() {
    std::fill(m_.area.begin(), m_.area.end(), Vec<D>{});
    for (const OpenSide<D>& side : water_.open_sides) {
      for (int k = 0; k <= D; ++k)
        if (has_share(body_, side.element, side.opposite, k))
          for (int d = 0; d < D; ++d) m_.area[mesh_.elements[side.element][k]][d] += side.share[d];
    }
  }

  /// q = A x. Returns x·q.
  double multiply(auto& x) {
    update_nodes(body_, x);
    for_slices([&]<class T>(int j) { lines_.template push<T>(x, j); });
    update_nodes(body_, s_.carried);
    return sum([&]<class T>(int i) { return lines_.template multiply<T>(x, i); });
  }

  /// Residual of the equation with the prescribed pressures of this round. Returns r·z.
  double start_residual() {
    for_nodes([&](int i) { lines_.fix_node(i); });
    multiply(m_.change);
    return sum([&]<class T>(int i) { return lines_.template start_residual<T>(i); });
  }
  /// Conjugate gradients for m_.change until r·z, which is `rz` at the start, is at most `goal`. Returns r·z.
  double reduce_residual(double rz, double goal) {
    for (int n = 0; n < most_iterations && rz > goal; ++n, ++m_.iterations) {
      const double step = rz / multiply(s_.d), last = rz;
      rz = sum([&]<class T>(int i) { return lines_.template advance_solution<T>(step, i); });
      for_slices([&]<class T>(int i) { lines_.template update_direction<T>(rz / last, i); });
    }
    if (!(rz <= goal)) throw_no_pressures(body_.step_count);  // also if rz is NaN
    return rz;
  }

  Body<D>& body_;
  Water<D>& water_;
  DarcyWater<D>& m_;
  const mesh::Mesh<D>& mesh_;
  const StepOptions<D>& o_;
  NodeList wet_nodes_, surface_nodes_;  ///< wet nodes, and of them those where water may pond
  SliceList slices_;
  Arrays& s_;
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
