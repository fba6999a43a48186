// SPDX-License-Identifier: MIT
#pragma once
// The equation of the nodal pressures thread by thread. What the conjugate gradients need of sums stays on the device:
// once they have come near enough, the launches that follow do nothing, and the host looks now and then.

#include "mpm/device/water_kernels.hpp"
#include "mpm/mixture/pressure_lines.hpp"

namespace talus::mpm::device {

/// A number to be summed.
struct Total {
  double value = 0;
  TALUS_PORTABLE void add(const Total& other) { value += other.value; }
};

/// Where the gradients stand.
struct Gradients {
  Total scale, residual, curvature;  ///< as they were summed last
  double wanted = 0;                 ///< square of the residual that is near enough
  double rz = 0, last = 0;           ///< that of now, and that of the iteration before
  int iterations = 0;
  int unsettled = 0;  ///< a line or the surface does not fit the solution

  TALUS_PORTABLE bool go_on() const { return rz > wanted && iterations < most_iterations; }
  TALUS_PORTABLE bool are_there() const { return rz <= wanted; }
};

/// When a launch does what it is for.
enum class When { always, on_the_way, there };

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
  TALUS_PORTABLE bool is_now(When when) const {
    return when == When::always || (when == When::there ? gradients[0].are_there() : gradients[0].go_on());
  }
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
  When when;

  TALUS_PORTABLE void operator()(int j) const {
    if (system.is_wet(j) && system.is_now(when)) system.lines().push(x, j);
  }
};
template <int D>
struct MultiplyNode {
  PressureSystem<D> system;
  View<double> x;
  bool whole;
  When when;

  TALUS_PORTABLE void operator()(int i) const {
    if (system.is_wet(i) && system.is_now(when)) system.lines().multiply(x, whole, i);
  }
};

/// Sums over the wet nodes that the gradients need.
enum class Scalar { scale, residual, curvature };

template <int D, Scalar Meaning>
struct OfNode {
  PressureSystem<D> system;

  TALUS_PORTABLE Total operator()(int i) const {
    if (!system.is_wet(i)) return {};
    const auto lines = system.lines();
    if constexpr (Meaning == Scalar::scale) return {lines.find_scale(i)};
    if constexpr (Meaning == Scalar::residual) return {lines.find_residual(i)};
    if constexpr (Meaning == Scalar::curvature) return {lines.find_curvature(i)};
  }
};

/// Takes the residual as that of now; one thread. First: before the first iteration.
struct TakeResidual {
  View<Gradients> gradients;
  bool first;
  double tolerance;

  TALUS_PORTABLE void operator()(int) const {
    Gradients& g = gradients[0];
    if (first) {
      g.wanted = tolerance * tolerance * g.scale.value;
      g.iterations = g.unsettled = 0;
    } else if (g.go_on()) {
      g.last = g.rz;
      ++g.iterations;
    } else {
      return;
    }
    g.rz = g.residual.value;
  }
};

template <int D>
struct GoOn {
  PressureSystem<D> system;

  TALUS_PORTABLE void operator()(int i) const {
    const Gradients& g = system.gradients[0];
    if (system.is_wet(i) && g.go_on()) system.lines().go_on(g.rz / g.curvature.value, i);
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

/// What passes the surface, and surface and lines after a solution, once it is there.
template <int D>
struct SettleNode {
  PressureSystem<D> system;
  int round;

  TALUS_PORTABLE void operator()(int i) const {
    if (!system.is_wet(i) || !system.is_now(When::there)) return;
    const auto lines = system.lines();
    lines.find_passed(i);
    const bool settled = lines.settle_surface(i), right = lines.bend_line(i, round);
    if (!settled || !right) raise(system.gradients[0].unsettled);
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

/// Water that passes the surface with the condition `surface` at a node, a summand.
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
