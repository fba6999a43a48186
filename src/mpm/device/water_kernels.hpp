// SPDX-License-Identifier: MIT
#pragma once
// Pore water of the mixture thread by thread, but for the equation of the pressures: contents, surface, coefficients
// of the flow, and forces.

#include "base/flag.hpp"
#include "mpm/coupled/root_lines.hpp"
#include "mpm/coupled/surface_lines.hpp"
#include "mpm/device/device_kernels.hpp"
#include "mpm/mixture/contents_lines.hpp"
#include "mpm/mixture/flow_lines.hpp"

namespace talus::mpm::device {

/// What the host is told.
struct WaterSignals {
  int turned = 0;  ///< an element has lost its last wet point or received its first one
  int spread = 0;  ///< the outside has reached a further element
};

template <int D>
struct SumContents {
  ThreadBody<D> body;
  bool mixed;
  View<WaterSignals> signals;

  TALUS_PORTABLE void operator()(int e) const {
    const bool was = body.water.volume[static_cast<std::size_t>(e)] > 0;
    if (sum_element(body, e, mixed) != was) raise(signals[0].turned);
  }
};

template <int D>
struct StartNode {
  ThreadBody<D> body;
  bool first;

  TALUS_PORTABLE void operator()(int i) const { start_node(body, i, first); }
};

// The surface.

/// Of each node whether it touches a wet element.
template <int D>
struct MarkWetNode {
  ThreadBody<D> body;
  View<std::uint8_t> touches;

  TALUS_PORTABLE void operator()(int i) const {
    const auto& graph = *body.water.darcy.graph;
    bool wet = false;
    for (int t = graph.touch_start[i]; t < graph.touch_start[i + 1]; ++t)
      wet = wet || body.water.volume[graph.element[t]] > 0;
    touches[static_cast<std::size_t>(i)] = wet;
  }
};

/// Elements that are outside by themselves.
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

/// Elements without wet soil beside one that is outside. What is outside in the end does not depend on how far each
/// launch comes.
template <int D>
struct SpreadOutside {
  ThreadBody<D> body;
  View<std::uint8_t> outside;
  View<WaterSignals> signals;

  TALUS_PORTABLE void operator()(int e) const {
    if (is_raised(outside[static_cast<std::size_t>(e)]) || body.water.volume[static_cast<std::size_t>(e)] > 0) return;
    for (int n : body.mesh().neighbours[static_cast<std::size_t>(e)]) {
      if (n < 0 || !is_raised(outside[static_cast<std::size_t>(n)])) continue;
      raise(outside[static_cast<std::size_t>(e)]);
      raise(signals[0].spread);
      return;
    }
  }
};

/// Bit k of an element: its side opposite node k is open.
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

/// Area of the open sides that touch a node, outwards.
template <int D>
struct FindArea {
  ThreadBody<D> body;
  View<const std::uint8_t> open;

  TALUS_PORTABLE void operator()(int i) const {
    const auto& graph = *body.water.darcy.graph;
    Vec<D> area{};
    for (int t = graph.touch_start[i]; t < graph.touch_start[i + 1]; ++t) {
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

/// Forces of the water outside on the mixture at the nodes of an element: `rows` [element][D+1].
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

/// Forces of tractions and of the water outside.
template <int D>
struct LoadNode {
  ThreadBody<D> body;
  View<const Vec<D>> tractions;  ///< [node]; empty: none
  View<const Vec<D>> rows;       ///< of LoadElement; empty: there is no water outside
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
  TableView relative;

  TALUS_PORTABLE void operator()(int i) const { relative[soil][i] = find_relative_at_node(body, soil, i); }
};

template <int D>
struct FindFlow {
  ThreadBody<D> body;
  StepOptions<D> options;
  TableView relative;

  TALUS_PORTABLE void operator()(int e) const { find_flow_through(body, options, relative, e); }
};

template <int D>
struct PressNode {
  ThreadBody<D> body;

  TALUS_PORTABLE void operator()(int i) const { press_node(body, i); }
};

/// What the forces of the pressures take in `seconds`, as the mapping counts it.
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
  View<std::array<double, D + 1>> own_mass;

  TALUS_PORTABLE void operator()(int e) const { own_mass[static_cast<std::size_t>(e)] = find_own_mass(body, e); }
};

template <int D>
struct PredictNode {
  ThreadBody<D> body;
  StepOptions<D> options;
  View<const std::array<double, D + 1>> own_mass;

  TALUS_PORTABLE void operator()(int i) const { predict_node(body, options, own_mass, i); }
};

/// What roots draw.
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

}  // namespace talus::mpm::device
