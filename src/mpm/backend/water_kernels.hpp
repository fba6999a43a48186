// SPDX-License-Identifier: MIT
#pragma once
// Kernels of pore water in the Darcy formulation, one thread per element or node: contents, surface, coefficients of
// the flow and forces, and the conjugate gradients of the pressure equation.

#include "base/portable.hpp"
#include "mpm/backend/device_kernels.hpp"
#include "mpm/kernels/flow_kernels.hpp"
#include "mpm/kernels/pressure_kernels.hpp"
#include "mpm/kernels/surface_kernels.hpp"

namespace talus::mpm::device {

/// Flags that the host reads.
struct WaterSignals {
  int turned = 0;  ///< an element lost its last wet point or received its first one
  int spread = 0;  ///< the outside reached a further element
};

template <int D>
struct SumContents {
  ThreadBody<D> body;
  bool mixed;
  View<WaterSignals> signals;

  TALUS_PORTABLE void operator()(int e) const {
    const bool was = body.water.volume[static_cast<std::size_t>(e)] > 0;
    if (sum_element(body, e, mixed) != was) raise_flag(signals[0].turned);
  }
};

template <int D>
struct StartNode {
  ThreadBody<D> body;
  bool first;

  TALUS_PORTABLE void operator()(int i) const { start_nodes<double>(body, i, first); }
};

// The surface.

/// Marks nodes that touch a wet element.
template <int D>
struct MarkWetNode {
  ThreadBody<D> body;
  View<std::uint8_t> touches;

  TALUS_PORTABLE void operator()(int i) const {
    const auto& graph = *body.water.darcy.graph;
    bool wet = false;
    for (int t = graph.touch_start[i]; t < graph.touch_end(i); ++t)
      wet = wet || body.water.volume[graph.element[t]] > 0;
    touches[static_cast<std::size_t>(i)] = wet;
  }
};

/// Marks elements that are outside regardless of their neighbours.
template <int D>
struct StartOutside {
  ThreadBody<D> body;
  View<const std::uint8_t> touches;
  View<std::uint8_t> outside;

  TALUS_PORTABLE void operator()(int e) const {
    const Content content = find_content(body, e);
    outside[static_cast<std::size_t>(e)] =
        content != Content::wet_soil && is_outside_by_itself(body, e, content, touches);
  }
};

/// Marks elements without wet soil beside one that is outside. The final set does not depend on how far each launch
/// reaches.
template <int D>
struct SpreadOutside {
  ThreadBody<D> body;
  View<std::uint8_t> outside;
  View<WaterSignals> signals;

  TALUS_PORTABLE void operator()(int e) const {
    if (is_raised(outside[static_cast<std::size_t>(e)]) || body.water.volume[static_cast<std::size_t>(e)] > 0) return;
    for (int n : body.mesh().neighbours[static_cast<std::size_t>(e)]) {
      if (n < 0 || !is_raised(outside[static_cast<std::size_t>(n)])) continue;
      raise_flag(outside[static_cast<std::size_t>(e)]);
      raise_flag(signals[0].spread);
      return;
    }
  }
};

/// Sets bit k of an element if its side opposite node k is open.
template <int D>
struct FindOpenSides {
  ThreadBody<D> body;
  View<const std::uint8_t> outside;
  View<std::uint8_t> open;

  TALUS_PORTABLE void operator()(int e) const {
    unsigned sides = 0;
    for (int k = 0; k <= D && body.water.volume[static_cast<std::size_t>(e)] > 0; ++k)
      if (is_open(body, e, k, outside)) sides |= 1u << k;
    open[static_cast<std::size_t>(e)] = static_cast<std::uint8_t>(sides);
  }
};

/// Area vector of the open sides that touch a node, outwards [m²].
template <int D>
struct FindArea {
  ThreadBody<D> body;
  View<const std::uint8_t> open;

  TALUS_PORTABLE void operator()(int i) const {
    const auto& graph = *body.water.darcy.graph;
    Vec<D> area{};
    for (int t = graph.touch_start[i]; t < graph.touch_end(i); ++t) {
      const int e = graph.element[t];
      for (int side = 0; side <= D; ++side) {
        if (!(open[static_cast<std::size_t>(e)] >> side & 1) || !has_share(body, e, side, graph.local[t])) continue;
        const Vec<D> share = find_side_share(body.mesh(), e, side);
        for (int d = 0; d < D; ++d) area[d] += share[d];
      }
    }
    body.water.darcy.area[i] = area;
  }
};

/// Forces of outside water on the mixture at the nodes of an element: `rows` [element][D+1].
template <int D>
struct LoadElement {
  ThreadBody<D> body;
  StepOptions<D> options;
  View<const std::uint8_t> open;
  View<Vec<D>> rows;

  TALUS_PORTABLE void operator()(int e) const {
    Vec<D>* own = &rows[static_cast<std::size_t>(e) * (D + 1)];
    for (int k = 0; k <= D; ++k) own[k] = Vec<D>{};
    const OuterWater<D> outer(body.water.density, options.gravity);
    const auto add = [own](int k, const Vec<D>&, const Vec<D>& on_darcy) {
      for (int d = 0; d < D; ++d) own[k][d] += on_darcy[d];
    };
    bool first = true;
    for (int side = 0; side <= D; ++side) {
      if (!(open[static_cast<std::size_t>(e)] >> side & 1)) continue;
      const PressedSide<D> pressed = find_pressed_side(body, e, side, outer);
      if (pressed.like < 0) continue;
      if (first) {
        first = false;
        const Filling<D> filling = find_filling(body, e, options.mixed);
        if (!filling.is_full()) load_inside(body, pressed, filling, outer, add);
      }
      load_side(pressed, find_side_share(body.mesh(), e, side), add);
    }
  }
};

/// Sum of the forces of tractions and of outside water at a node.
template <int D>
struct LoadNode {
  ThreadBody<D> body;
  View<const Vec<D>> tractions;  ///< [node]; empty: none
  View<const Vec<D>> rows;       ///< of LoadElement; empty: there is no outside water
  View<Vec<D>> load;

  TALUS_PORTABLE void operator()(int i) const {
    Vec<D> sum{};
    if (!tractions.empty()) sum = tractions[static_cast<std::size_t>(i)];
    for (int r = body.layout->row_start[i]; r < body.layout->row_start[i + 1] && !rows.empty(); ++r) {
      const Vec<D>& of_element = rows[static_cast<std::size_t>(body.layout->node_rows[r])];
      for (int d = 0; d < D; ++d) sum[d] += of_element[d];
    }
    load[static_cast<std::size_t>(i)] = sum;
  }
};

// Flow and forces.

template <int D>
struct FindRelative {
  ThreadBody<D> body;
  std::size_t soil;
  double full;  ///< k_r without suction
  TableView relative;

  TALUS_PORTABLE void operator()(int i) const {
    relative[soil][i] = find_relative_at_node<double>(body, soil, full, i);
  }
};

template <int D>
struct FindFlow {
  ThreadBody<D> body;
  StepOptions<D> options;
  TableView relative;

  TALUS_PORTABLE void operator()(int e) const { find_flow_through<double>(body, options, relative, e); }
};

template <int D>
struct PressNode {
  ThreadBody<D> body;

  TALUS_PORTABLE void operator()(int i) const { press_nodes_at<double>(body, i); }
};

/// Work of the pressure forces over `seconds`, counted as for the mapping loss [J].
template <int D>
struct CountPorePower {
  ThreadBody<D> body;
  double seconds;
  View<NodeAccount> accounts;

  TALUS_PORTABLE void operator()(int i) const {
    accounts[static_cast<std::size_t>(i)].pore_water -= 0.5 * seconds * find_pore_power_at(body, i);
  }
};

template <int D>
struct FindOwnMass {
  ThreadBody<D> body;

  TALUS_PORTABLE void operator()(int e) const { find_own_mass<double>(body, e, body.water.darcy.own_mass); }
};

template <int D>
struct PredictNode {
  ThreadBody<D> body;
  StepOptions<D> options;

  TALUS_PORTABLE void operator()(int i) const { predict_nodes<double>(body, options, body.water.darcy.own_mass, i); }
};

/// Root uptake of an element.
template <int D>
struct DrawElement {
  ThreadBody<D> body;
  View<const DeviceUptake> uptakes;
  View<const double> rates;
  double dt;
  View<ElementAccount> accounts;

  TALUS_PORTABLE void operator()(int e) const {
    const auto& m = body.water.darcy;
    const double volume = find_draw(body, uptakes, rates, dt, e, [&] { return m.water[e]; });
    m.drawn[e] = volume;
    accounts[static_cast<std::size_t>(e)].transpired = body.water.density * volume;
  }
};

// The equation of the nodal pressures (T22.5). The sums of the conjugate gradients stay on the device: after
// convergence the launches that follow return at once, and the host checks only now and then.

/// A number to be summed.
struct Total {
  double value = 0;
  TALUS_PORTABLE void add(const Total& other) { value += other.value; }
};

/// State of the conjugate gradients.
struct Gradients {
  Total scale, residual, curvature, error;  ///< latest sums
  double wanted = 0, goal = 0;              ///< square of the residual at the end of the step, and of the round
  double rz = 0, last = 0;                  ///< r·z now, and in the iteration before
  int iterations = 0, last_iterations = 0;  ///< of this round, and of the one before
  int rounds = 0;                           ///< that have ended
  int unsettled = 0;                        ///< 1 if the surface state of a node did not fit the solution
  int unfit = 0;                            ///< 1 if the contents did not fit

  TALUS_PORTABLE bool is_running() const { return rz > goal && iterations < most_iterations; }
  TALUS_PORTABLE bool are_there() const { return rz <= goal; }
};

/// State of the iteration in which a launch does its work.
enum class When { always, on_the_way, there };

/// Arguments of the kernels of the equation.
template <int D>
struct PressureSystem {
  using Arrays = PressureArrays<D, View>;
  using Lines = PressureLines<const ThreadBody<D>, const Arrays>;
  ThreadBody<D> body;
  StepOptions<D> options;
  Arrays arrays;
  View<Gradients> gradients;

  TALUS_PORTABLE Lines lines() const { return {body, arrays, options}; }
  TALUS_PORTABLE bool is_wet(int i) const { return arrays.pores[i] > 0; }
  TALUS_PORTABLE bool is_now(When when) const {
    return when == When::always || (when == When::there ? gradients[0].are_there() : gradients[0].is_running());
  }
};

// Kernels by name, because the stubs of nvcc do not support pointers to members.
enum class NodeLine {
  find_surface,
  find_source,
  assemble,
  find_diagonal,
  start_line,
  fix,
  start_residual,
  find_passed,
  find_out,
  keep_own
};
enum class ElementLine { assemble, distribute_water, find_end };

/// Runs a kernel of PressureLines for each wet node.
template <int D, NodeLine Line>
struct ForWetNodes {
  PressureSystem<D> system;

  TALUS_PORTABLE void operator()(int i) const {
    if (!system.is_wet(i)) return;
    const auto lines = system.lines();
    if constexpr (Line == NodeLine::find_surface) lines.find_surface(i);
    if constexpr (Line == NodeLine::find_source) lines.template find_source<double>(i);
    if constexpr (Line == NodeLine::assemble) lines.assemble_node(i);
    if constexpr (Line == NodeLine::find_diagonal) lines.template find_diagonal<double>(i);
    if constexpr (Line == NodeLine::start_line) lines.start_line(i);
    if constexpr (Line == NodeLine::fix) lines.fix_node(i);
    if constexpr (Line == NodeLine::start_residual) lines.template start_residual<double>(i);
    if constexpr (Line == NodeLine::find_passed) lines.find_passed(i);
    if constexpr (Line == NodeLine::find_out) lines.find_out(i);
    if constexpr (Line == NodeLine::keep_own) lines.template keep_own<double>(i);
  }
};
/// Runs a kernel of PressureLines for each element.
template <int D, ElementLine Line>
struct ForElements {
  PressureSystem<D> system;

  TALUS_PORTABLE void operator()(int e) const {
    const auto lines = system.lines();
    if constexpr (Line == ElementLine::assemble) lines.template assemble_elements<double>(e);
    if constexpr (Line == ElementLine::distribute_water) lines.template distribute_water<double>(e);
    if constexpr (Line == ElementLine::find_end) lines.template find_end<double>(e);
  }
};

template <int D>
struct SumPores {
  PressureSystem<D> system;

  TALUS_PORTABLE void operator()(int i) const { system.lines().sum_pores(i); }
};

/// Products with the matrix, for `x` the change of the pressures or the search direction.
template <int D>
struct PushNode {
  PressureSystem<D> system;
  View<double> x;
  When when;

  TALUS_PORTABLE void operator()(int j) const {
    if (system.is_wet(j) && system.is_now(when)) system.lines().template push<double>(x, j);
  }
};
template <int D>
struct MultiplyNode {
  PressureSystem<D> system;
  View<double> x;
  When when;

  TALUS_PORTABLE void operator()(int i) const {
    if (system.is_wet(i) && system.is_now(when)) system.lines().template multiply<double>(x, i);
  }
};
/// Flow between the nodes with the pressures `x`.
template <int D>
struct FlowOfNode {
  PressureSystem<D> system;
  View<double> x;

  TALUS_PORTABLE void operator()(int i) const {
    if (system.is_wet(i)) system.lines().template find_flow<double>(x, i);
  }
};

/// Sums over the wet nodes in the conjugate gradients.
enum class Scalar { scale, residual, curvature, error };

template <int D, Scalar Meaning>
struct OfNode {
  PressureSystem<D> system;

  TALUS_PORTABLE Total operator()(int i) const {
    if (!system.is_wet(i)) return {};
    const auto& a = system.arrays;
    if constexpr (Meaning == Scalar::scale) return {system.lines().template find_scale<double>(i)};
    if constexpr (Meaning == Scalar::residual) return {a.r[i] * a.z[i]};
    if constexpr (Meaning == Scalar::curvature) return {a.d[i] * a.q[i]};
    if constexpr (Meaning == Scalar::error) return {a.q[i]};
  }
};

/// Starts a round with the latest sums; one thread. `round`: the round that ends, -1: none.
struct StartRound {
  View<Gradients> gradients;
  int round;
  double tolerance;

  TALUS_PORTABLE void operator()(int) const {
    Gradients& g = gradients[0];
    if (round >= 0 && !g.are_there()) return;
    g.unfit = !(g.error.value <= g.wanted);
    g.rounds = round + 1;
    g.last_iterations = g.iterations;
    g.iterations = 0;
    g.wanted = tolerance * tolerance * g.scale.value;
    g.rz = g.residual.value;
    const double reduced = round_reduction * round_reduction * g.rz;
    g.goal = g.wanted > reduced ? g.wanted : reduced;
  }
};
struct ClearUnsettled {
  View<Gradients> gradients;

  TALUS_PORTABLE void operator()(int) const { gradients[0].unsettled = 0; }
};
/// Updates r·z after an iteration; one thread.
struct TakeResidual {
  View<Gradients> gradients;

  TALUS_PORTABLE void operator()(int) const {
    Gradients& g = gradients[0];
    if (!g.is_running()) return;
    g.last = g.rz;
    ++g.iterations;
    g.rz = g.residual.value;
  }
};

template <int D>
struct GoOn {
  PressureSystem<D> system;

  TALUS_PORTABLE void operator()(int i) const {
    const Gradients& g = system.gradients[0];
    if (system.is_wet(i) && g.is_running())
      system.lines().template advance_solution<double>(g.rz / g.curvature.value, i);
  }
};
template <int D>
struct Turn {
  PressureSystem<D> system;

  TALUS_PORTABLE void operator()(int i) const {
    const Gradients& g = system.gradients[0];
    if (system.is_wet(i) && g.is_running()) system.lines().template update_direction<double>(g.rz / g.last, i);
  }
};

/// After convergence: water that passes the surface, and update of surface state and line of a node.
template <int D>
struct SettleNode {
  PressureSystem<D> system;
  int round;

  TALUS_PORTABLE void operator()(int i) const {
    if (!system.is_wet(i) || !system.is_now(When::there)) return;
    const auto lines = system.lines();
    lines.find_passed(i);
    if (!lines.settle_surface(i)) raise_flag(system.gradients[0].unsettled);
    system.arrays.q[i] = system.arrays.r[i] * system.arrays.z[i] + lines.bend_line(i, round);
    lines.template start_direction<double>(i);
  }
};

/// The pressure of a node at the end of the step.
template <int D>
struct EndNode {
  PressureSystem<D> system;

  TALUS_PORTABLE void operator()(int i) const {
    const auto& m = system.body.water.darcy;
    if (system.is_wet(i)) m.pressure[i] += m.change[i];
  }
};

/// Summand: water that passes the surface with the condition `surface` at a node.
template <int D>
struct WaterOfNode {
  PressureSystem<D> system;
  int surface;

  TALUS_PORTABLE SurfaceBudget operator()(int i) const {
    const bool counts = system.is_wet(i) && system.body.water.surface_of_node[i] == surface;
    return counts ? system.lines().count_water(i) : SurfaceBudget();
  }
};

}  // namespace talus::mpm::device
