// SPDX-License-Identifier: MIT
#pragma once
// The equation of the nodal pressures thread by thread. What the conjugate gradients need of sums stays on the device:
// once they have come near enough, the launches that follow do nothing, and the host looks now and then.

#include "mpm/device/fixed_sums.hpp"
#include "mpm/device/water_kernels.hpp"
#include "mpm/mixture/pressure_lines.hpp"

namespace talus::mpm::device {

/// Where the gradients stand.
struct Gradients {
  double wanted = 0;        ///< square of the residual that is near enough
  double rz = 0, last = 0;  ///< that of now, and that of the iteration before
  double curvature = 0;
  int iterations = 0;

  TALUS_PORTABLE bool go_on() const { return rz > wanted && iterations < most_iterations; }
};

/// What the kernels of the equation work on.
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
};

// The lines by their names: the stubs of nvcc do not know pointers to members.
enum class NodeLine {
  find_surface,
  assemble,
  find_diagonal,
  start_line,
  find_source,
  fix,
  start_gradients,
  find_passed,
  find_out,
  keep_own
};
enum class ElementLine { assemble, share_water, find_end };

/// A line of the equation for each wet node.
template <int D, NodeLine Line>
struct ForWetNodes {
  PressureSystem<D> system;

  TALUS_PORTABLE void operator()(int i) const {
    if (!system.is_wet(i)) return;
    const auto lines = system.lines();
    if constexpr (Line == NodeLine::find_surface) lines.find_surface(i);
    if constexpr (Line == NodeLine::assemble) lines.assemble_node(i);
    if constexpr (Line == NodeLine::find_diagonal) lines.find_diagonal(i);
    if constexpr (Line == NodeLine::start_line) lines.start_line(i);
    if constexpr (Line == NodeLine::find_source) lines.find_source(i);
    if constexpr (Line == NodeLine::fix) lines.fix_node(i);
    if constexpr (Line == NodeLine::start_gradients) lines.start_gradients(i);
    if constexpr (Line == NodeLine::find_passed) lines.find_passed(i);
    if constexpr (Line == NodeLine::find_out) lines.find_out(i);
    if constexpr (Line == NodeLine::keep_own) lines.keep_own(i);
  }
};
/// For each element.
template <int D, ElementLine Line>
struct ForElements {
  PressureSystem<D> system;

  TALUS_PORTABLE void operator()(int e) const {
    const auto lines = system.lines();
    if constexpr (Line == ElementLine::assemble) lines.assemble_element(e);
    if constexpr (Line == ElementLine::share_water) lines.share_water(e);
    if constexpr (Line == ElementLine::find_end) lines.find_end(e);
  }
};

template <int D>
struct SumPores {
  PressureSystem<D> system;

  TALUS_PORTABLE void operator()(int i) const { system.lines().sum_pores(i); }
};

/// The products with the matrix: of `x`, the change of the pressures or the direction of the gradients.
template <int D>
struct PushNode {
  PressureSystem<D> system;
  View<double> x;
  bool searches;  ///< only while the gradients go on

  TALUS_PORTABLE void operator()(int j) const {
    if (system.is_wet(j) && (!searches || system.gradients[0].go_on())) system.lines().push(x, j);
  }
};
template <int D>
struct MultiplyNode {
  PressureSystem<D> system;
  View<double> x;
  bool whole, searches;

  TALUS_PORTABLE void operator()(int i) const {
    if (system.is_wet(i) && (!searches || system.gradients[0].go_on())) system.lines().multiply(x, whole, i);
  }
};

/// Sums that the gradients need.
enum class Scalar { scale, first_residual, curvature, residual };

/// One over the wet nodes, as the first round of FixedSums: of thread t of `threads`.
template <int D, Scalar Meaning>
struct SumOverNodes {
  PressureSystem<D> system;
  View<Total> sums;
  int threads;

  TALUS_PORTABLE void operator()(int t) const {
    const auto lines = system.lines();
    Total sum;
    for (int i = t; i < system.body.node_count; i += threads) {
      if (!system.is_wet(i)) continue;
      if constexpr (Meaning == Scalar::scale)
        sum.add({lines.find_scale(i)});
      else if constexpr (Meaning == Scalar::curvature)
        sum.add({lines.find_curvature(i)});
      else
        sum.add({lines.find_residual(i)});
    }
    sums[static_cast<std::size_t>(t)] = sum;
  }
};

/// Notes what a sum says; one thread.
struct TakeSum {
  View<Gradients> gradients;
  View<const Total> sum;
  Scalar meaning;
  double tolerance;

  TALUS_PORTABLE void operator()(int) const {
    Gradients& g = gradients[0];
    const double value = sum[0].value;
    switch (meaning) {
      case Scalar::scale:
        g.wanted = tolerance * tolerance * value;
        break;
      case Scalar::first_residual:
        g.rz = value;
        g.iterations = 0;
        break;
      case Scalar::curvature:
        g.curvature = value;
        break;
      case Scalar::residual:
        if (!g.go_on()) break;
        g.last = g.rz;
        g.rz = value;
        ++g.iterations;
        break;
    }
  }
};

template <int D>
struct GoOn {
  PressureSystem<D> system;

  TALUS_PORTABLE void operator()(int i) const {
    const Gradients& g = system.gradients[0];
    if (system.is_wet(i) && g.go_on()) system.lines().go_on(g.rz / g.curvature, i);
  }
};
template <int D>
struct Turn {
  PressureSystem<D> system;

  TALUS_PORTABLE void operator()(int i) const {
    const Gradients& g = system.gradients[0];
    if (system.is_wet(i) && g.go_on()) system.lines().turn(g.rz / g.last, i);
  }
};

/// Surface and lines after a solution.
template <int D>
struct SettleNode {
  PressureSystem<D> system;
  int round;
  View<WaterSignals> signals;

  TALUS_PORTABLE void operator()(int i) const {
    if (!system.is_wet(i)) return;
    const bool settled = system.lines().settle_surface(i), right = system.lines().bend_line(i, round);
    if (!settled || !right) signals[0].settled = 0;
  }
};

/// The pressure of a node at the end of the step.
template <int D>
struct EndNode {
  PressureSystem<D> system;

  TALUS_PORTABLE void operator()(int i) const {
    const auto& m = system.body.water.mixture;
    if (system.is_wet(i)) m.pressure[i] += m.change[i];
  }
};

/// Water that passes the surface with the condition `surface`, as the first round of FixedSums.
template <int D>
struct CountWater {
  PressureSystem<D> system;
  int surface;
  View<SurfaceBudget> sums;
  int threads;

  TALUS_PORTABLE void operator()(int t) const {
    SurfaceBudget sum;
    for (int i = t; i < system.body.node_count; i += threads)
      if (system.is_wet(i) && system.body.water.surface_of_node[i] == surface) sum.add(system.lines().count_water(i));
    sums[static_cast<std::size_t>(t)] = sum;
  }
};

}  // namespace talus::mpm::device
