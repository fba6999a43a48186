// SPDX-License-Identifier: MIT
#pragma once
// Kernels of a step (grid solve, remap, averages, G2P and P2G, observation) that run on a GPU or, emulated, on the CPU.
// A kernel is a plain struct whose operator() is the work of one thread; its result must not depend on which threads
// run together or in which order.

#include "mpm/backend/device.hpp"
#include "mpm/backend/thread_body.hpp"
#include "mpm/kernels/darcy_block.hpp"
#include "mpm/kernels/element_kernels.hpp"
#include "mpm/kernels/g2p_p2g_kernels.hpp"
#include "mpm/kernels/grid_solve_kernels.hpp"
#include "mpm/kernels/observe_kernels.hpp"
#include "mpm/kernels/softening.hpp"

namespace talus::mpm::device {

/// Sums of a step over the nodes.
struct NodeAccount {
  PieceSums piece;
  double external = 0;    ///< work of gravity and tractions [J]
  double pore_water = 0;  ///< work of the pore pressures, see Work [J]

  TALUS_PORTABLE void add(const NodeAccount& next) {
    piece.add(next.piece);
    external += next.external;
    pore_water += next.pore_water;
  }
};

/// Sums of a step over the elements.
struct ElementAccount {
  double dissipated = 0;  ///< plastic work [J]
  double shared = 0;      ///< elastic energy lost where points share their stress [J]
  double pressed_in = 0;  ///< added to Water::pressed_in [kg]
  double transpired = 0;  ///< root uptake [kg]

  TALUS_PORTABLE void add(const ElementAccount& next) {
    dissipated += next.dissipated;
    shared += next.shared;
    pressed_in += next.pressed_in;
    transpired += next.transpired;
  }
};

/// Grid solve: solve_momentum() of a node.
template <int D>
struct SolveNode {
  ThreadBody<D> body;
  StepOptions<D> options;
  View<NodeAccount> accounts;

  TALUS_PORTABLE void operator()(int i) const {
    ThreadBody<D> mine = body;
    NodeAccount account;
    solve_nodes(mine, options, i, i + 1, account.piece);
    accounts[static_cast<std::size_t>(i)] = account;
  }
};

/// Remap: Δt Σ_j M_ij a_j of an element.
template <int D>
struct RemapElement {
  ThreadBody<D> body;
  double dt;

  TALUS_PORTABLE void operator()(int e) const {
    ThreadBody<D> mine = body.for_element(e);
    if (count_slots(mine.points, e / device_width) > 0) remap_block(mine, e / device_width, dt);
  }
};

/// Grid solve, second mapping: remap_momentum() of a node.
template <int D>
struct RemapNode {
  ThreadBody<D> body;
  StepOptions<D> options;
  View<NodeAccount> accounts;

  TALUS_PORTABLE void operator()(int i) const {
    ThreadBody<D> mine = body;
    std::array<double, 2> works{};
    remap_nodes(mine, options, i, i + 1, works);
    NodeAccount& account = accounts[static_cast<std::size_t>(i)];
    account.external = works[0];
    account.piece.mapping += works[1];
  }
};

/// Contribution of an element to the averages of its nodes: `parts` [element][2].
template <int D>
struct AverageElement {
  ThreadBody<D> body;
  StepOptions<D> options;
  View<double> parts;

  TALUS_PORTABLE void operator()(int e) const {
    const ThreadBody<D> mine = body.for_element(e);
    double* own = &parts[2 * static_cast<std::size_t>(e)];
    own[0] = own[1] = 0;
    if (count_slots(mine.points, e / device_width) > 0) find_average_parts(mine, e / device_width, options, own);
  }
};

template <int D>
struct AverageNode {
  ThreadBody<D> body;
  View<const double> parts;

  TALUS_PORTABLE void operator()(int i) const {
    double sum[2] = {};
    for (int r = body.layout->row_start[i]; r < body.layout->row_start[i + 1]; ++r) {
      const double* of_element = &parts[2 * static_cast<std::size_t>(body.layout->node_rows[r] / (D + 1))];
      sum[0] += of_element[0];
      sum[1] += of_element[1];
    }
    body.nodes.smoothed[static_cast<std::size_t>(i)] = sum[1] > 0 ? sum[0] / sum[1] : 0;
  }
};

/// The pass over the points of a thread's element. Wet: with pore water (Darcy formulation).
template <int D, bool Wet>
struct ThreadPass {
  static constexpr int dimension = D;
  using B = ThreadBody<D>;
  template <class Law>
  using Block = std::conditional_t<Wet, DarcyBlock<ThreadPass, Law>, DryBlock<ThreadPass, Law>>;
  B& body;
  const StepOptions<D>& options;
  double dissipated = 0;  ///< plastic work [J]
  double pressed_in = 0;  ///< added to Water::pressed_in [kg]
  int leaving = 0;        ///< points that left the element

  TALUS_PORTABLE ThreadPass(B& b, const StepOptions<D>& o) : body(b), options(o) {}
  TALUS_KERNEL bool is_stable() const { return options.smoothing == input::Smoothing::stable; }
  TALUS_KERNEL void note_full(const BlockPlace<B>&, bool) {}
  TALUS_KERNEL void note_movers(const BlockPlace<B>&, int, bool) { ++leaving; }
  /// P2G: writes the element's sums to its rows, in place of those of the last step.
  TALUS_KERNEL void add_to_nodes(const BlockPlace<B>& at, const double out[D + 1][1 + 2 * D]) const {
    TALUS_UNROLL
    for (int k = 0; k <= D; ++k) {
      double* row = sums_row(body, at.b * device_width + body.lane, k);
      TALUS_UNROLL
      for (int c = 0; c < 1 + 2 * D; ++c) row[c] = out[k][c];
    }
  }
};

/// Tag for elements whose points follow laws of several kinds, or one kind with several parameter sets.
struct AnyLaw {};

/// G2P and P2G: advance_points() of the elements whose points all follow one law of kind `L`, or AnyLaw. The first
/// kernel of a step also zeroes the accounts of elements without points.
template <int D, class L, bool Mixed, bool Wet>
struct AdvanceElement {
  ThreadBody<D> body;
  StepOptions<D> options;
  bool first;
  View<int> leaving;
  View<ElementAccount> accounts;

  TALUS_PORTABLE void operator()(int e) const {
    const int soil = body.points.soil[static_cast<std::size_t>(e)];
    if (!is_for_me(soil)) return;
    ThreadBody<D> mine = body.for_element(e);
    const int b = e / device_width;
    Pass pass(mine, options);
    if (soil != no_soil) {
      if constexpr (std::is_same_v<L, AnyLaw>)
        advance(pass, ManyLaws<DeviceLaws>{&mine.laws, ~std::uint32_t{0}, mine.laws.states}, b);
      else
        advance(pass, OneLaw<L, const L&>{mine.laws[soil].template get<L>()}, b);
    }
    leaving[static_cast<std::size_t>(e)] = pass.leaving;
    ElementAccount& account = accounts[static_cast<std::size_t>(e)];  // keeps the root uptake
    account.dissipated = pass.dissipated;
    account.shared = 0;
    account.pressed_in = pass.pressed_in;
  }

 private:
  using Pass = ThreadPass<D, Wet>;
  TALUS_PORTABLE bool is_for_me(int soil) const {
    if (soil == no_soil) return first;
    if constexpr (std::is_same_v<L, AnyLaw>)
      return soil == many_soils;
    else
      return soil != many_soils && body.laws[soil].kind == find_kind<L>();
  }
  TALUS_PORTABLE void advance(Pass& pass, const auto& law, int b) const {
    const bool apart = is_apart(pass.body, static_cast<std::size_t>(b) * device_width);
    apart ? advance_block<Mixed, true>(pass, law, b) : advance_block<Mixed, false>(pass, law, b);
  }
};

/// average_softening() of an element: nonlocal correction, then reset of the softening sums.
template <int D>
struct LendSoftening {
  ThreadBody<D> body;
  SofteningList reach;

  TALUS_PORTABLE void operator()(int e) const {
    body.elements.nonlocal_correction[static_cast<std::size_t>(e)] =
        find_nonlocal_correction(reach, body.elements, static_cast<std::size_t>(e));
  }
};
struct ClearSoftening {
  DeviceElements elements;

  TALUS_PORTABLE void operator()(int e) const {
    elements.softened[static_cast<std::size_t>(e)] = elements.softening_volume[static_cast<std::size_t>(e)] = 0;
  }
};

// Summands: operator()(i) returns the i-th term of a sum (`sum` of a grid).

template <class S>
struct Listed {
  View<const S> list;

  TALUS_PORTABLE S operator()(int i) const { return list[static_cast<std::size_t>(i)]; }
};

/// find_critical_step() of an element.
template <int D>
struct StepOfElement {
  ThreadBody<D> body;
  int more_mass;  ///< field of a mass that moves with the points (pore water); -1: none

  TALUS_PORTABLE StepSquare operator()(int e) const { return find_step_square(body, e, more_mass); }
};

/// Largest squared displacement of the points of an element; NaN wins over any number.
struct Farthest {
  double square = 0;  ///< [m²]
  TALUS_PORTABLE void add(const Farthest& other) {
    if (!(other.square <= square) && !std::isnan(square)) square = other.square;
  }
};

/// Sums over the points for histories.
template <int D>
struct Seen {
  Totals<D> totals;
  WaterState<D> water;
  Farthest farthest;

  TALUS_PORTABLE void add(const Seen& other) {
    totals.add(other.totals);
    water.add(other.water);
    farthest.add(other.farthest);
  }
};

/// Calls work(id) for the points of element `e`.
template <int D, class Work>
TALUS_PORTABLE void for_points(const ThreadBody<D>& body, int e, Work&& work) {
  const std::int64_t first = body.points.block_start[static_cast<std::size_t>(e / device_width)];
  for (int k = 0; k < static_cast<int>(body.points.count[static_cast<std::size_t>(e)]); ++k)
    work(body.points.id[static_cast<std::size_t>((first + k) * device_width + e % device_width)]);
}

template <int D>
struct FarthestOfElement {
  ThreadBody<D> body;

  TALUS_PORTABLE Farthest operator()(int e) const {
    Farthest most;
    for_points(body, e, [&](int id) {
      const Vec<D> u = find_displacement(body, id, read_xi(body, find_fields(body, id)));
      most.add({dot(u, u)});
    });
    return most;
  }
};
template <int D>
struct SeenInElement {
  ThreadBody<D> body;
  Vec<D> gravity;

  TALUS_PORTABLE Seen<D> operator()(int e) const {
    Seen<D> seen;
    for_points(body, e, [&](int id) {
      const PointView<D> p = look_at_point(body, id);
      add_point(body, p, gravity, seen.totals);
      seen.water.add_point(p);
      seen.farthest.add({dot(p.displacement, p.displacement)});
    });
    return seen;
  }
};

/// Reads points by number; those that left the grid have no element.
template <int D>
struct SeePoint {
  ThreadBody<D> body;
  View<const int> points;
  View<PointView<D>> views;

  TALUS_PORTABLE void operator()(int i) const {
    const int id = points[static_cast<std::size_t>(i)];
    const bool is_there = body.points.element[static_cast<std::size_t>(id)] >= 0;
    views[static_cast<std::size_t>(i)] = is_there ? look_at_point(body, id) : PointView<D>();
  }
};

/// Sums the rows of a node, for the host.
template <int D>
struct SumNode {
  ThreadBody<D> body;
  View<double> sums;  ///< [node][sums_stride]

  TALUS_PORTABLE void operator()(int i) const {
    double* t = &sums[static_cast<std::size_t>(i) * sums_stride];
    for (int q = 0; q < sums_stride; ++q) t[q] = 0;
    const int first = body.layout->row_start[i], count = body.layout->row_start[i + 1] - first;
    if (count > 0) sum_rows<1 + 2 * D, sums_stride>(body.nodes.sums, &body.layout->node_rows[first], count, t);
  }
};

}  // namespace talus::mpm::device
