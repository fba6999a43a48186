// SPDX-License-Identifier: MIT
#pragma once
// The one pass over the points, block by block: G2P (velocity, position, strain, stress, volume) and the P2G of the
// next step (nodal sums). Pore water is added by the hooks of the block and of its slots, which the pass selects: those
// of DryBlock (end of this file) are empty, WetBlock (two_velocity/advance_points.cpp) and DarcyBlock
// (darcy/darcy_block.hpp) implement them. All of it is forced inline into advance_block(), so that the packs stay in
// registers. B is the body: Body, whose lanes are packs, or the body of one GPU thread.
// thread of a GPU.

#include "base/rows.hpp"
#include "mpm/kernels/averages.hpp"
#include "mpm/kernels/full_element.hpp"
#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Position of block `b` in the arrays of a body, and the quantities that are the same for all its points.
template <class B>
struct BlockPlace {
  using T = typename B::Lanes;
  static constexpr int D = B::dimension;
  int b;
  std::size_t first;  ///< index of its first lane
  const int* rows;
  T g[D * D], count;

  TALUS_KERNEL BlockPlace(const B& body, int index) : b(index), first(static_cast<std::size_t>(index) * B::width) {
    rows = &body.layout->connectivity[first * (D + 1)];
    TALUS_UNROLL
    for (int i = 0; i < D * D; ++i) g[i] = load<T>(&body.layout->gradients[first * D * D + i * B::width]);
    count = load<T>(&body.points.count[first]);
  }
};

/// The first Count vectors of the node rows of a block, gathered by node and direction.
template <class B, int Count, int Stride>
struct NodeVectors {
  using T = typename B::Lanes;
  static constexpr int D = B::dimension;
  T of[Count][D + 1][D];

  TALUS_KERNEL NodeVectors(const double* base, const int* rows) {
    TALUS_UNROLL
    for (int k = 0; k <= D; ++k) {
      T row[Count * D];
      load_rows<Count * D, Stride>(base, rows + k * B::width, row);
      TALUS_UNROLL
      for (int c = 0; c < Count; ++c) {
        TALUS_UNROLL
        for (int d = 0; d < D; ++d) of[c][k][d] = row[c * D + d];
      }
    }
  }
};

/// The points of one slot of a block, one point per lane.
template <class B>
struct SlotPoints {
  using T = typename B::Lanes;
  static constexpr int D = B::dimension, width = B::width;
  using P = PointFields<D>;
  double* p;
  const int* ids;
  MaskOf<T> active;
  T xi[D], u[D], s[P::stress_size], q[material::max_state_size], volume, mass, material{0.0}, softened{0.0};

  TALUS_KERNEL SlotPoints(B& body, const BlockPlace<B>& at, int k) {
    auto& points = body.points;
    const std::int64_t slot = points.block_start[at.b] + k;
    p = points.slot(slot);
    ids = &points.id[static_cast<std::size_t>(slot * width)];
    active = at.count > T(static_cast<double>(k));
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      xi[d] = load<T>(p + (P::xi + d) * width);
      u[d] = load<T>(p + (P::velocity + d) * width);
    }
    volume = load<T>(p + P::volume * width);
    mass = load<T>(p + P::mass * width);
  }

  TALUS_KERNEL void store_fields(bool moving) const {
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      store(p + (P::velocity + d) * width, u[d]);
      if (moving) store(p + (P::xi + d) * width, xi[d]);
    }
    TALUS_UNROLL
    for (int i = 0; i < P::stress_size; ++i) store(p + (P::stress + i) * width, s[i]);
    if (moving) store(p + P::volume * width, volume);
  }
  TALUS_KERNEL void store_state(int state_size) const {
    for (int i = 0; i < state_size; ++i) store(p + (P::state + i) * width, q[i]);
  }

  /// Zeroes the lanes that do not stay; these may hold any value, also NaN.
  TALUS_KERNEL void keep(MaskOf<T> stays) {
    mass = select(stays, mass, T(0.0));
    volume = select(stays, volume, T(0.0));
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      xi[d] = select(stays, xi[d], T(0.0));
      u[d] = select(stays, u[d], T(0.0));
    }
    TALUS_UNROLL
    for (int i = 0; i < P::stress_size; ++i) s[i] = select(stays, s[i], T(0.0));
  }
};

/// Sums over the points of a block, by lane (element).
template <class B>
struct BlockSums {
  using T = typename B::Lanes;
  ElementSums<B::dimension, T> solid;
  T staying_volume{0.0}, all_volume{0.0}, plastic_dilation{0.0}, dissipated{0.0}, softened{0.0}, softening_volume{0.0},
      first_material{-1.0};
  MaskOf<T> uniform{true};

  TALUS_KERNEL void add_plastic(MaskOf<T> active, T volume, const material::Response<T>& response) {
    const T v_p = select(active, volume, T(0.0));
    dissipated += v_p * select(active, response.dissipation, T(0.0));
    plastic_dilation += v_p * select(active, response.plastic_dilation, T(0.0));
  }
  TALUS_KERNEL void add_softening(MaskOf<T> softens, T volume, T dilation) {
    const T v_p = select(softens, volume, T(0.0));
    softening_volume += v_p;
    softened += v_p * select(softens, lane_max(dilation, T(0.0)), T(0.0));
  }
  TALUS_KERNEL void add_material(MaskOf<T> stays, T material) {
    uniform = uniform && (!stays || first_material < T(0.0) || material == first_material);
    first_material = select(stays && first_material < T(0.0), material, first_material);
  }
};

/// Computes strain increment and rotation of the elements of a block, smoothed where requested, and adds the increment
/// to elements.strain. Sets block.volumetric.
template <bool Apart, class Pass, class Block, class B = typename Pass::B>
TALUS_KERNEL auto strain_elements(Pass& pass, const BlockPlace<B>& at, Block& block) {
  constexpr int D = B::dimension, NS = material::stress_size<D>, width = B::width;
  using T = typename B::Lanes;
  StressIncrement<D, T> increment{{}, {}, pass.body.time};
  T* d_epsilon = increment.d_epsilon;
  if (pass.options.objective) increment.rotation = Rotation<D, T>(block.motion.grad);
  block.motion.strain(d_epsilon);
  block.volumetric = d_epsilon[0] + d_epsilon[1] + d_epsilon[2];
  if (pass.options.smoothing != input::Smoothing::none) {  // (2.95), recomposed over the components that move
    const T own = block.volumetric;
    block.smooth(pass, at);
    if (pass.is_stable()) {
      T rough;
      block.volumetric = join_dilation(pass.body, at.first, own, block.volumetric, rough);
      store(&pass.body.elements.rough[at.first], rough);
    }
    if constexpr (Apart) block.volumetric = select(is_apart(pass.body, at.first), own, block.volumetric);
    const T correction = (block.volumetric - own) * (1.0 / D);
    TALUS_UNROLL
    for (int i = 0; i < D; ++i) d_epsilon[i] += correction;
  }
  double* strain = &pass.body.elements.strain[at.first * NS];
  TALUS_UNROLL
  for (int i = 0; i < NS; ++i) store(strain + i * width, load<T>(strain + i * width) + d_epsilon[i]);
  return increment;
}

/// Marks elements with a gap directly in elements.apart: they are few, and a sum over the slots would cost every block
/// a register.
template <class B, class T = typename B::Lanes>
TALUS_KERNEL void note_apart(B& body, const BlockPlace<B>& at, MaskOf<T> apart) {
  if (!any(apart)) return;
  double* noted = &body.elements.apart[at.first];
  store(noted, select(apart, T(1.0), load<T>(noted)));
}

/// G2P for the points of slot `k`; adds the points that stay in their element to the sums of the block.
template <class Pass, class Block, class Update, class B = typename Pass::B>
TALUS_KERNEL void advance_slot(Pass& pass, const BlockPlace<B>& at, Block& block, const Update& update,
                               BlockSums<B>& sums, int k) {
  constexpr int D = B::dimension;
  using T = typename B::Lanes;
  using Law = typename Update::Law;
  const StepOptions<D>& o = pass.options;
  SlotPoints<B> points(pass.body, at, k);
  typename Block::Slot slot(block, points);
  block.motion.advance_velocity(points.xi, points.u);
  slot.advance_velocity(block, points);
  if (o.moving) {
    block.motion.advance_position(points.xi);
    points.volume *= block.growth;
  }
  if constexpr (!Law::is_single) points.material = lane_materials(pass.body, pass.body.points.block_start[at.b] + k);
  const T saturation = slot.update_water(pass, block, update, points);
  const material::Response<T> response = update_point_stress(update, saturation, points);
  if constexpr (Law::is_plastic) {
    if (o.moving && (Update::apart || any(response.opened > T(0.0)))) {
      points.volume *= slot.find_solid_share(response.opened);
      note_apart(pass.body, at, points.active && response.gap > T(0.0));
    }
    if (response.any_plastic) sums.add_plastic(points.active, points.volume, response);
    if constexpr (Law::softens)
      if (update.increment.is_nonlocal)
        sums.add_softening(points.active && update.law.find_softening(points.material), points.volume, points.softened);
    if (pass.is_stable()) sums.all_volume += select(points.active, points.volume, T(0.0));
  }
  points.store_fields(o.moving);
  slot.store_fields();
  if (Update::mixed || response.any_plastic)
    points.store_state(Update::apart || (o.moving && response.any_plastic) ? update.law.state_size
                                                                           : update.law.core_size);

  MaskOf<T> stays = points.active;
  if (o.moving) {
    const MaskOf<T> outside = points.active && smallest_shape<D>(points.xi) < T(0.0);
    if (any(outside)) {
      pass.note_movers(at, k, outside);
      stays = points.active && !outside;
    }
  }
  if (!all(stays)) {
    points.keep(stays);
    slot.keep(stays);
  }
  if constexpr (!Law::is_single) sums.add_material(stays, points.material);
  sums.staying_volume += points.volume;
  slot.add_to(block, points);
  sums.solid.add(points.mass, points.volume, points.xi, points.u, points.s);
}

/// P2G: adds the sums of the block to its elements and nodes. `weight` is V_e/Σ V_p where the internal force of this
/// step was integrated over V_e, so that the plastic work is that of the same force.
template <bool Mixed, class Law, class Pass, class Block, class B = typename Pass::B, class T = typename B::Lanes>
TALUS_KERNEL void scatter_sums(Pass& pass, const BlockPlace<B>& at, const Block& block, const MaskOf<T>& was_full,
                               T weight, BlockSums<B>& sums) {
  constexpr int D = B::dimension, width = B::width;
  auto& elements = pass.body.elements;
  T stretch(1.0);
  if constexpr (Mixed) {  // a full element's internal force is taken over its whole volume (2.92)
    const T V_e = load<T>(&pass.body.layout->volumes[at.first]);
    const MaskOf<T> full = sums.staying_volume > load<T>(&elements.fill_limit[at.first]) && sums.uniform;
    stretch = select(full, V_e / select(full, sums.staying_volume, T(1.0)), T(1.0));
    TALUS_UNROLL
    for (int i = 0; i < force_size<D>; ++i) sums.solid.stress[i] *= stretch;
    pass.note_full(at, full && !was_full);
  }
  if (pass.is_stable()) {
    const MaskOf<T> some = sums.all_volume > T(0.0);
    store(&elements.plastic_dilation[at.first],
          select(some, sums.plastic_dilation / select(some, sums.all_volume, T(1.0)), T(0.0)));
  }
  if constexpr (Law::is_plastic) {
    pass.dissipated += sums.dissipated * weight;
  }
  if constexpr (Law::softens) {
    if (!elements.nonlocal_correction.empty()) {
      store(&elements.softened[at.first], sums.softened);
      store(&elements.softening_volume[at.first], sums.softening_volume);
    }
  }
  T out[D + 1][1 + 2 * D];
  sums.solid.to_nodes(at.g, out);
  block.add_to_nodes(pass, at, stretch, out);
  double* moments = &elements.moments[at.first * moment_size<D>];
  TALUS_UNROLL
  for (int i = 0; i < moment_size<D>; ++i) store(moments + i * width, sums.solid.moments[i]);
}

/// Takes block `b` through the pass. `Mixed` (mixed integration) and `Apart` (a point of the block keeps a gap) are
/// template parameters because the second source of stress and the closing of gaps cost registers that other points
/// need.
template <bool Mixed, bool Apart, class Pass, class Law>
TALUS_PORTABLE void advance_block(Pass& pass, const Law& law, int b) {
  using B = typename Pass::B;
  using T = typename B::Lanes;
  B& body = pass.body;
  const BlockPlace<B> at(body, b);
  typename Pass::template Block<Law> block(pass, at);
  auto increment = strain_elements<Apart>(pass, at, block);
  if constexpr (Law::softens) {
    increment.is_nonlocal = !body.elements.nonlocal_correction.empty();
    if (increment.is_nonlocal) increment.nonlocal_correction = load<T>(&body.elements.nonlocal_correction[at.first]);
  }
  FullElement<B, Law> element;
  if constexpr (Mixed) {
    element = gather_full_elements<Apart>(body, law, b, at.count);
    const T saturation = block.distribute_water(pass, at, element);
    update_full_elements<Apart>(body, pass.options, law, b, increment, saturation, element);
  }
  block.find_growth();
  const bool none_partial = Mixed && all(element.full || !(at.count > T(0.0)));
  const StressUpdate<Mixed, Apart, B, Law> update{pass.options, law, increment, element, none_partial};
  if constexpr (Apart) store(&body.elements.apart[at.first], T(0.0));
  BlockSums<B> sums;
  for (int k = 0; k < count_slots(body.points, b); ++k) advance_slot(pass, at, block, update, sums, k);
  T weight(1.0);
  if constexpr (Mixed && Law::is_plastic)
    weight = select(element.full,
                    load<T>(&body.layout->volumes[at.first]) / select(element.full, element.volume, weight), weight);
  scatter_sums<Mixed, Law>(pass, at, block, element.full, weight, sums);
}

// The hooks of the pass for soil of one phase.

/// A block of dry soil, or of soil with hydrostatic water of given saturation.
template <class Pass, class Law>
struct DryBlock {
  using B = typename Pass::B;
  using T = typename B::Lanes;
  using Place = BlockPlace<B>;
  static constexpr int D = B::dimension;
  using Nodes = NodeVectors<B, 2, motion_stride<D>>;
  ElementMotion<D, T> motion;
  T volumetric, growth, saturation;

  TALUS_KERNEL DryBlock(const Pass& pass, const Place& at)
      : DryBlock(pass, at, Nodes(pass.body.nodes.motion.data(), at.rows)) {}
  TALUS_KERNEL DryBlock(const Pass& pass, const Place& at, const Nodes& nodes)
      : motion(nodes.of[0], nodes.of[1], at.g, pass.options.dt) {
    const auto& held = pass.body.elements.held_saturation;
    saturation = held.empty() ? T(1.0) : load<T>(&held[at.first]);
  }
  TALUS_KERNEL void smooth(const Pass& pass, const Place& at) {
    volumetric = find_node_mean<B, 1>(pass.body.nodes.smoothed.data(), at.rows);
  }
  TALUS_KERNEL T distribute_water(const Pass&, const Place&, const FullElement<B, Law>&) const { return saturation; }
  TALUS_KERNEL void find_growth() { growth = 1.0 + volumetric; }
  TALUS_KERNEL void add_to_nodes(const Pass& pass, const Place& at, T, const T out[D + 1][1 + 2 * D]) const {
    pass.add_to_nodes(at, out);
  }

  /// Hooks of a slot. The points have no water of their own.
  struct Slot {
    TALUS_KERNEL Slot(const DryBlock&, const SlotPoints<B>&) {}
    TALUS_KERNEL void advance_velocity(const DryBlock&, const SlotPoints<B>&) {}
    TALUS_KERNEL T update_water(const Pass&, const DryBlock& block, const auto&, const SlotPoints<B>&) {
      return block.saturation;
    }
    /// Fraction of the new volume that is soil; gaps do not count as volume of the soil.
    TALUS_KERNEL T find_solid_share(T opened) const { return 1.0 - opened; }
    TALUS_KERNEL void store_fields() const {}
    TALUS_KERNEL void keep(MaskOf<T>) {}
    TALUS_KERNEL void add_to(DryBlock&, SlotPoints<B>&) {}
  };
};

}  // namespace talus::mpm
